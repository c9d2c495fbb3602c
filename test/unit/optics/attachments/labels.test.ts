// Labels in float64: the vote of eight corners, looks, cells and reduction, against closed forms.
import { expect } from '@esm-bundle/chai';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { appearanceOfCells } from '../../../../src/optics/cells/label-detail.ts';
import { labelField, labelShade, labelStages } from '../../../../src/optics/attachments/labels.ts';
import { pickRay } from '../../../../src/optics/pick-ray.ts';
import type { PickAt } from '../../../../src/optics/pick-ray.ts';
import type { Ray } from '../../../../src/optics/rays/rays.ts';
import { cartesianField, storedField } from '../../../../src/optics/rays/ray-field.ts';
import type { RayStages } from '../../../../src/optics/rays/ray-stages.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import type { RaySetup } from '../../../../src/optics/rays/rays.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { voteOfCorners } from '../../../../src/optics/rays/vote.ts';
import { chooseCellSize } from '../../../../src/volume/cell-size.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../../src/volume/grid.ts';
import { listLabels } from '../../../../src/volume/label-cells.ts';
import type { LabelCells } from '../../../../src/volume/label-cells.ts';
import type { LabelMap, ShownLabels } from '../../../../src/volume/labels.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { reduceLabels } from '../../../../src/volume/reduce-labels.ts';
import { labelMap, mixedAppearances, plainAppearance } from '../../../helpers/labels.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const random = randomNumbers(3);
const randomPlace = (): Vector3 => [random(), random(), random()];
const noise = (dimensions: Vector3, count: number): LabelMap =>
  labelMap(dimensions, () => Math.floor(random() * count), count);

describe('the vote of eight corners', () => {
  it('gives one of the ids around a place, and at a voxel its own', () => {
    const map = noise([7, 5, 6], 300);
    for (let n = 0; n < 500; n++) {
      const place = randomPlace();
      const around = new Set<number>();
      const low = place.map((x, axis) =>
        Math.min(map.dimensions[axis] - 1, Math.max(0, Math.floor(x * map.dimensions[axis] - 0.5))),
      );
      for (let c = 0; c < 8; c++) {
        const [i, j, k] = low.map((x, axis) => Math.min(map.dimensions[axis] - 1, x + ((c >> axis) & 1)));
        around.add(map.numbers[i + 7 * (j + 5 * k)]);
      }
      expect([...around]).to.include(voteOfCorners(map.numbers, map.dimensions, place));
    }
    for (let k = 0, at = 0; k < 6; k++)
      for (let j = 0; j < 5; j++)
        for (let i = 0; i < 7; i++, at++) {
          expect(voteOfCorners(map.numbers, map.dimensions, [(i + 0.5) / 7, (j + 0.5) / 5, (k + 0.5) / 6])).to.equal(
            map.numbers[at],
          );
        }
  });

  it('has the largest sum of tri-linear weights', () => {
    const map = noise([4, 4, 4], 3);
    for (let n = 0; n < 500; n++) {
      const place = randomPlace();
      // The share of each label is the interpolation of where it is.
      const shares = [0, 1, 2].map(
        (number) =>
          cartesianField({
            samples: Float32Array.from(map.numbers, (x) => Number(x === number)),
            dimensions: [4, 4, 4],
            slope: 1,
            intercept: 0,
          }).sampleAt(place).value,
      );
      expect(shares[voteOfCorners(map.numbers, [4, 4, 4], place)]).to.be.closeTo(Math.max(...shares), 1e-12);
    }
  });

  it('puts the face between two halves midway, and there the smaller one wins, whichever side it is on', () => {
    for (const axis of [0, 1, 2]) {
      for (const [below, above] of [
        [4, 9],
        [9, 4],
      ]) {
        const { numbers } = labelMap([6, 6, 6], (...at) => (at[axis] < 3 ? below : above));
        const at = (x: number): number =>
          voteOfCorners(
            numbers,
            [6, 6, 6],
            [0.31, 0.62, 0.47].map((y, a) => (a === axis ? x : y)) as unknown as Vector3,
          );
        expect([at(0.5 - 1e-9), at(0.5), at(0.5 + 1e-9)], `axis ${axis}`).to.deep.equal([below, 4, above]);
      }
    }
  });

  it('counts no data as one thing', () => {
    const samples = new Float32Array([NaN, NaN, 5, 6, NaN, 5, 5, NaN]);
    expect(voteOfCorners(samples, [2, 2, 2], [0.5, 0.5, 0.5])).to.deep.equal(NaN);
    expect(voteOfCorners(samples, [2, 2, 2], [0.3, 0.7, 0.6])).to.equal(5);
  });

  it('is what a volume of labels has as its field', () => {
    const map = noise([5, 6, 4], 9);
    const field = cartesianField({
      samples: map.numbers,
      dimensions: map.dimensions,
      slope: 2,
      intercept: -1,
      isDiscrete: true,
    });
    for (let n = 0; n < 50; n++) {
      const place = randomPlace();
      expect(field.sampleAt(place).value).to.equal(2 * voteOfCorners(map.numbers, map.dimensions, place) - 1);
    }
    expect(field.isFolded(1, 3)).to.equal(true);
  });
});

const [edge, lambda] = [32, 0.1];
const grid = cartesianGrid([edge, edge, edge], axialIndexToWorld([edge, edge, edge], [1, 1, 1]));
/** One parallel ray along x; lengths are of the cube's edge. */
const setup = {
  eyeT: -1e9,
  diameter: edge,
  unitToRegion: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
} as unknown as RaySetup;

const opacity = -Math.expm1(-lambda);
const fog: TransferFunction = [
  { value: 0, color: [1, 1, 1], opacity },
  { value: 1, color: [1, 1, 1], opacity },
];

/** Rays through a fog with extinction `lambda` a voxel, in which things have looks. */
function stagesAlong(labels: ShownLabels, stepLength: number): RayStages {
  const scene = {
    grid,
    samples: new Uint8Array(0),
    slope: 1,
    intercept: 0,
    transferFunction: fog,
    referenceLength: 1,
    opacityFactor: 1,
    lightFactor: 1,
    stepLength,
    maxSubsteps: 1,
    field: storedField(() => 0.5, { slope: 1, intercept: 0 }),
    ...labelStages(labels, false),
  } as const;
  return stagesOf(scene, setup);
}

/** What a ray shows along x. */
function castAlong(labels: ShownLabels, stepLength: number): readonly number[] {
  return castRay(stagesAlong(labels, stepLength), { point: [0, 0.51, 0.52], direction: [1, 0, 0], lengthPerT: 1 });
}

const boxed = labelMap([edge, edge, edge], (...at) => Number(at.every((x) => x >= 6 && x < 18)), 2);
const orange = (opacityFactor: number): ShownLabels => ({
  map: boxed,
  styles: [plainAppearance, { color: [1, 0.5, 0], opacityFactor }],
});

describe('looks of labels', () => {
  it('give a box of labels its exact opacity and colour where its faces lie midway between samples, at any step', () => {
    for (const factor of [0, 0.25, 1, 3]) {
      // Fog, the box, and fog behind it: 6, 12 and 14 voxels.
      const [before, box, behind] = [6, 12 * factor, 14].map((voxels) => Math.exp(-lambda * voxels));
      for (const step of [4, 12 / 7, 12 / 13]) {
        const [red, green, blue, alpha] = castAlong(orange(factor), step);
        expect(alpha, `factor ${factor}, step ${step}`).to.be.closeTo(1 - before * box * behind, 1e-12);
        const fog = 1 - before + before * box * (1 - behind);
        expect(red).to.be.closeTo(alpha, 1e-12);
        expect(green).to.be.closeTo(fog + 0.5 * before * (1 - box), 1e-12);
        expect(blue).to.be.closeTo(fog, 1e-12);
      }
    }
  });

  it('are off by no more than half a step at each face elsewhere', () => {
    const exact = 1 - Math.exp(-lambda * 20);
    for (let n = 0; n < 40; n++) {
      const step = 0.3 + 2 * random();
      const [, , , alpha] = castAlong(orange(0), step);
      expect(Math.abs(Math.log1p(-alpha) - Math.log1p(-exact))).to.be.at.most(lambda * step + 1e-12);
    }
  });

  it('lead picks to what shows: through what is hidden, and to the dense things in a fog', () => {
    const ray = { point: [0, 0.51, 0.52], direction: [1, 0, 0], lengthPerT: 1 } as const;
    const pickAt = (labels: ShownLabels, at: PickAt): number =>
      32 * pickRay(stagesAlong(labels, 0.5), ray, { at, look: { transferFunction: fog, projection: null } })!.place[0];
    const dense = pickAt(orange(60), 'jump');
    expect(dense, 'in the box, near its front').to.be.within(6, 6.5);
    // The whole box is hidden, and all else: what is left is one slab.
    const slab = labelMap([edge, edge, edge], (i) => Number(i >= 20 && i < 28), 2);
    for (const at of ['jump', 'surface', 'max'] as const) {
      const place = pickAt(
        {
          map: slab,
          styles: [
            { ...plainAppearance, opacityFactor: 0 },
            { ...plainAppearance, opacityFactor: 10 },
          ],
        },
        at,
      );
      expect(place, at).to.be.within(20, 28);
    }
  });

  it('of the one end count where the other has no data', () => {
    const [style, other] = [
      { color: [1, 0, 0], opacityFactor: 2 },
      { color: [0, 0, 1], opacityFactor: 0 },
    ] as const;
    const anyRay: Ray = { point: [0, 0, 0], direction: [0, 0, 1], lengthPerT: 1 };
    const segment = (valid: boolean) => ({
      front: { value: 1, valid: true, style },
      back: { value: NaN, valid, style: other },
      begin: 0,
      span: 1,
    });
    const [red, green, blue, alpha] = labelShade(segment(false), [0.3, 0.3, 0.3, 0.3], anyRay);
    expect(alpha).to.be.closeTo(1 - 0.7 ** 2, 1e-15);
    expect([red, green, blue]).to.deep.equal([alpha, 0, 0]);
    expect(labelShade(segment(true), [0.3, 0.3, 0.3, 0.3], anyRay)[3], 'half of each').to.be.closeTo(0.3, 1e-15);
    expect(labelShade(segment(true), [0, 0, 0, 0], anyRay)).to.deep.equal([0, 0, 0, 0]);
    expect(labelShade(segment(true), [1, 1, 1, 1], anyRay)[3], 'opaque stays opaque').to.equal(1);
  });

  it('hide places from projections, and name them', () => {
    const known = { value: 4, valid: true };
    const [inside, outside] = [
      [0.3, 0.3, 0.3],
      [0.7, 0.3, 0.3],
    ] as const;
    expect(labelField(orange(0), true)(inside, known)).to.include({ valid: false, label: 7 });
    expect(labelField(orange(0), true)(outside, known)).to.include({ valid: true, value: 4, label: 0 });
    expect(labelField(orange(0))(inside, known)).to.include({ valid: true, label: 7 });
  });
});

function cellsOf(map: LabelMap): LabelCells {
  const listing = listLabels(map);
  for (;;) {
    const step = listing.next();
    if (step.done) return step.value;
  }
}

describe('cells and their labels', () => {
  it('hold the label of any place in them, once each', () => {
    const map = noise([20, 9, 17], 400);
    const { size, starts, numbers } = cellsOf(map);
    expect(size, 'as macrocells have it').to.equal(chooseCellSize(map.dimensions));
    const cells = map.dimensions.map((n) => Math.ceil(n / size));
    for (let n = 0; n < 3000; n++) {
      const place = randomPlace();
      const [i, j, k] = place.map((x, axis) => Math.floor((x * map.dimensions[axis]) / size));
      const cell = i + cells[0] * (j + cells[1] * k);
      expect([...numbers.subarray(starts[cell], starts[cell + 1])]).to.include(
        voteOfCorners(map.numbers, map.dimensions, place),
      );
    }
    for (let cell = 0; cell + 1 < starts.length; cell++)
      expect(new Set(numbers.subarray(starts[cell], starts[cell + 1])).size).to.equal(starts[cell + 1] - starts[cell]);
  });

  it('know the densest of them, and how much they differ', () => {
    const map = labelMap([4, 4, 8], (_i, _j, k) => (k < 5 ? 1 : 2), 3);
    const styles = [
      plainAppearance,
      { color: [1, 0.5, 0], opacityFactor: 0.5 },
      { color: [1, 0, 0], opacityFactor: 0.25 },
    ] as const;
    // The face is at 5: the first cell of 4 has a voxel beyond it, the second both.
    const { max, spread } = appearanceOfCells(cellsOf(map), styles);
    expect([...max]).to.deep.equal([0.5, 0.5]);
    expect([...spread]).to.deep.equal([0, 0.25]);
    expect([
      ...appearanceOfCells(
        cellsOf(map),
        mixedAppearances(map).styles.map((style) => ({ ...style, opacityFactor: 0 })),
      ).max,
    ]).to.deep.equal([0, 0]);
  });
});

describe('labels of a smaller volume', () => {
  it('are those of most of each box; of two halves the smaller number', () => {
    const map = labelMap([4, 2, 2], (i, j, k) => [5, 3, 9, 9][i] + (i === 2 && j === 0 && k === 0 ? 1 : 0), 11);
    const { numbers, dimensions, ids } = reduceLabels(map, [2, 1, 1]);
    expect(dimensions).to.deep.equal([2, 1, 1]);
    expect([...numbers]).to.deep.equal([3, 9]);
    expect(ids).to.equal(map.ids);
  });

  it('count voxels on a cut by their share', () => {
    // Three voxels in two boxes: of each, two thirds are of the outer one, and one of the middle.
    expect([
      ...reduceLabels(
        labelMap([3, 1, 1], (i) => [1, 2, 1][i]),
        [2, 1, 1],
      ).numbers,
    ]).to.deep.equal([1, 1]);
    // Five in two: 2.5 voxels each.
    expect([
      ...reduceLabels(
        labelMap([5, 1, 1], (i) => [1, 2, 2, 3, 3][i], 300),
        [2, 1, 1],
      ).numbers,
    ]).to.deep.equal([2, 3]);
  });

  it('are ids that were there', () => {
    const map = noise([13, 11, 7], 50);
    const there = new Set(map.numbers);
    expect([...reduceLabels(map, [5, 4, 7]).numbers].filter((number) => !there.has(number))).to.deep.equal([]);
  });
});
