// Transfer functions of groups of labels, in float64.
import { expect } from '@esm-bundle/chai';
import { castRay } from '../../../src/optics/rays/cast-ray.ts';
import { rangeEmission } from '../../../src/optics/transfer/emission-range.ts';
import { labelledDetail, appearanceOfCells } from '../../../src/optics/cells/label-detail.ts';
import { stagesOf } from '../../../src/optics/reference.ts';
import { labelStages } from '../../../src/optics/attachments/labels.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { pickRay } from '../../../src/optics/pick-ray.ts';
import type { PickAt } from '../../../src/optics/pick-ray.ts';
import type { RayStages } from '../../../src/optics/rays/ray-stages.ts';
import type { RaySetup } from '../../../src/optics/rays/rays.ts';
import { storedField } from '../../../src/optics/rays/ray-field.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import type { LabelCells } from '../../../src/volume/label-cells.ts';
import type { ShownLabels } from '../../../src/volume/labels.ts';
import { labelMap, plainAppearance } from '../../helpers/labels.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const edge = 32;
const grid = cartesianGrid([edge, edge, edge], axialIndexToWorld([edge, edge, edge], [1, 1, 1]));
/** One parallel ray along x; lengths are of the cube's edge. */
const setup = {
  eyeT: -1e9,
  diameter: edge,
  unitToRegion: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
} as unknown as RaySetup;
const ray = { point: [0, 0.51, 0.52], direction: [1, 0, 0], lengthPerT: 1 } as const;

const read = (text: string) => parseTransferFunction(text, [0, 1]);
const air = read('0 #000 0, 1 #000 0');
const extinction = (opacity: number): number => -Math.log1p(-opacity);

/** A slab from the 8th to the 24th voxel has a group of its own; values rise from 0 to 1 along the ray. */
function stagesAlong(
  functions: ShownLabels['functions'],
  { own = air, step = 0.5, factor = 1, value = (x: number) => x } = {},
): RayStages {
  const map = labelMap([edge, edge, edge], (i) => Number(i >= 8 && i < 24), 2);
  const labels = {
    map,
    styles: [plainAppearance, { color: [1, 1, 1], opacityFactor: factor, group: 1 }],
    functions,
  } as const;
  const scene = {
    grid,
    samples: new Uint8Array(0),
    slope: 1,
    intercept: 0,
    transferFunction: own,
    referenceLength: 1,
    opacityFactor: 1,
    lightFactor: 1,
    stepLength: step,
    maxSubsteps: 1,
    field: storedField(([x]) => value(x), { slope: 1, intercept: 0 }),
    ...labelStages(labels, false),
  } as const;
  return stagesOf({ ...scene, functions }, setup);
}

describe('transfer functions of groups of labels', () => {
  it("have their exact opacity and colour in a slab whose faces lie midway between samples, and the volume's own has it around", () => {
    const [own, group] = [read('0 #00f 2%, 1 #00f 2%'), read('0 #f00 0, 0.5 #f00 10%, 1 #f00 10%')];
    for (const step of [16, 16 / 3, 16 / 7]) {
      const [red, green, blue, alpha] = castRay(stagesAlong([group], { own, step, value: () => 0.5 }), ray);
      const [fog, slab] = [Math.exp(-8 * extinction(0.02)), Math.exp(-16 * extinction(0.1))];
      expect(alpha, `step ${step}`).to.be.closeTo(1 - fog * slab * fog, 1e-12);
      expect(red).to.be.closeTo(fog * (1 - slab), 1e-12);
      expect(blue).to.be.closeTo((1 - fog) * (1 + fog * slab), 1e-12);
      expect(green).to.equal(0);
    }
  });

  it('classify each half of a piece by itself where its ends are of two groups: nothing of what is hidden is left at its face, however opaque', () => {
    const opaque = read('0 #fff 100%, 1 #fff 100%');
    for (const step of [0.5, 0.7, 3]) {
      expect(castRay(stagesAlong([opaque], { step, factor: 0 }), ray), `hidden, step ${step}`).to.deep.equal([
        0, 0, 0, 0,
      ]);
      expect(
        castRay(stagesAlong([air], { step, own: opaque, value: () => 0.5, factor: 1 }), {
          ...ray,
          point: [0.3, 0.51, 0.52],
          direction: [0.3, 0, 0],
        })[3],
        `the other way, step ${step}`,
      ).to.be.above(0.99);
    }
  });

  it('show values up to the middle of both ends at a face, as far as each function shows them', () => {
    // In front of the face, which is at 8, nothing shows, and behind it what is above 0.25.
    const rises = read('0.25 #fff 0, 0.25 #fff 50%, 1 #fff 50%');
    const piece = stagesAlong([rises], { step: 32, value: (x) => x });
    const [near, far] = [6, 10].map((x) => ({
      value: x / 32,
      valid: true,
      style: x < 8 ? plainAppearance : { ...plainAppearance, group: 1 },
    }));
    const seen = piece.shades[0]({ front: near, back: far, begin: 0, span: 4 }, [0, 0, 0, 0], ray);
    // Half of the piece, 2 voxels long in units of the cube's edge, from 8/32 to 10/32: all of it is above 0.25.
    expect(seen[3]).to.be.closeTo(1 - 0.5 ** (2 * 32), 1e-9);
    const higher = stagesAlong([read('0.28125 #fff 0, 0.28125 #fff 1%, 1 #fff 1%')], { step: 32 });
    const half = higher.shades[0]({ front: near, back: far, begin: 0, span: 4 / 32 }, [0, 0, 0, 0], ray);
    expect(half[3], 'half of that half').to.be.closeTo(1 - 0.99 ** 1, 1e-9);
  });

  it('cut steps by what either end shows', () => {
    const { classify } = stagesAlong([read('0 #fff 90%, 1 #fff 90%')]);
    const [plain, own] = [
      { value: 0.5, valid: true, style: plainAppearance },
      { value: 0.5, valid: true, style: { ...plainAppearance, group: 1 } },
    ];
    const count = (front: typeof plain, back: typeof plain): number =>
      classify.countSubsteps([0.5, 0.5], 1, [front, back]);
    expect(count(plain, plain)).to.equal(1);
    expect(count(plain, own)).to.equal(count(own, own));
    expect(count(own, plain)).to.be.above(1);
    expect(count({ ...own, valid: false, value: NaN }, plain), 'without data').to.equal(1);
  });

  it('lead picks to what they show', () => {
    const pickAt = (at: PickAt): number => {
      const functions = [read('0.4 #fff 0, 0.5 #fff 60%, 0.6 #fff 0')];
      return (
        32 *
        pickRay(stagesAlong(functions), ray, { at, look: { transferFunction: air, functions, projection: null } })!
          .place[0]
      );
    };
    expect(pickAt('jump')).to.be.within(14, 17);
    expect(pickAt('max'), 'the largest value that the group shows').to.be.within(18, 19.2);
  });

  it('are what could be missed in the cells that have them', () => {
    // Four cells: without groups, one group, both, and one whose label is hidden.
    const cells: LabelCells = {
      size: 4,
      starts: Uint32Array.of(0, 1, 2, 4, 5),
      numbers: Uint16Array.of(0, 1, 0, 1, 2),
    };
    const looks = appearanceOfCells(cells, [
      plainAppearance,
      { ...plainAppearance, group: 1 },
      { ...plainAppearance, opacityFactor: 0, group: 1 },
    ]);
    expect([...looks.groups]).to.deep.equal([1, 2, 3, 0]);
    const volume = syntheticVolume({ dimensions: [32, 8, 8] });
    const functions = [read('0 #fff 1%, 1 #fff 50%')];
    const more = labelledDetail(looks, {
      volume,
      transferFunction: read('0 #fff 1%, 1 #fff 10%'),
      functions,
      opticalScale: 1,
    });
    const missed = [0, 1, 2, 3].map((cell) => more(cell, (range) => range.among(0, 1, 1), 'among', 1));
    const [low, high] = [0.1, 0.5].map((opacity) =>
      rangeEmission(read(`0 #fff 1%, 1 #fff ${100 * opacity}%`)).among(0, 1, 1),
    );
    expect(missed.slice(0, 2)).to.deep.equal([low, high]);
    expect(missed[2], 'and how the two differ').to.be.above(high + 0.05);
    expect(missed[3]).to.equal(0);
  });
});
