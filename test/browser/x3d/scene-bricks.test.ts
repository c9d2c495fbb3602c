// Bricks of finer levels over a volume: the whole volume's picture where all are there, and the twin's where some are.
import { expect } from '@esm-bundle/chai';
import { halvingsOf } from '../../../src/bricks/brick-layout.ts';
import type { Brick } from '../../../src/bricks/pyramid.ts';
import { ResidentBricks } from '../../../src/bricks/resident-bricks.ts';
import { minSubsteps } from '../../../src/optics/cells/min-substeps.ts';
import { wholeSteps } from '../../../src/optics/cells/substeps.ts';
import type { Substeps } from '../../../src/optics/cells/substeps.ts';
import type { RayStages, Sample } from '../../../src/optics/rays/ray-stages.ts';
import type { RayStyle } from '../../../src/optics/rays/ray-style.ts';
import { renderStages } from '../../../src/optics/reference.ts';
import { outlinePatches } from '../../../src/optics/transfer/patches.ts';
import type { Patch } from '../../../src/optics/transfer/patches.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { composeTwins, loadTwins } from '../../../src/renderer/ray/compose-twins.ts';
import { cutSteps } from '../../../src/quality/levels.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { cutIntoBricks, readBrick } from '../../helpers/bricks.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { cutBox, keep } from '../../helpers/clips.ts';
import { blocks, mixedAppearances, mixedGroups } from '../../helpers/labels.ts';
import { askew, overlayOf, waves } from '../../helpers/overlays.ts';
import { comparePictures, drawPicture, height, plainOptics, raysOf, shareScene, width } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';
import { fieldWithHole, smoothField, syntheticVolume } from '../../helpers/synthetic.ts';
import type { SyntheticOptions } from '../../helpers/synthetic.ts';
import { viewFromAbove } from '../../helpers/views.ts';

/** Detail that a level of half the voxels does not have. */
const withGrain = (x: number, y: number, z: number): number =>
  0.8 * smoothField(x, y, z) + 0.1 * Math.sin(70 * x + 20 * y) * Math.sin(64 * z) * Math.sin(57 * y - 11 * z) + 0.1;

const cliff: TransferFunction = [
  { value: 0.5, color: [0.2, 0.5, 1], opacity: 0 },
  { value: 0.5, color: [0.2, 0.5, 1], opacity: 1 },
  { value: 1, color: [1, 0.8, 0.4], opacity: 1 },
];

/** Places without data that only bricks next to them have in their halos. */
const besideFace = (x: number, y: number, z: number): number => {
  const [i, j] = [Math.floor(40 * x), Math.floor(72 * y)];
  return (i === 32 && j % 5 > 1) || (j === 31 && i < 20) ? NaN : withGrain(x, y, z);
};

/** Where values change by more than those of half the voxels do. */
const patches: readonly Patch[] = [
  { kind: 'box', values: [0.1, 1], gradients: [0.08, 10], color: [1, 0.7, 0.3], opacity: 0.5 },
];

interface Case {
  readonly name: string;
  readonly data?: Partial<SyntheticOptions>;
  readonly style?: RayStyle | null;
  readonly more?: (view: View) => Partial<View>;
  /** The largest difference of a pixel from the whole volume's: samples of both lie at the same places. */
  readonly worst?: number;
  /** What is attached has the voxels of the coarse level, and does not lie over the whole volume. */
  readonly isCoarse?: boolean;
}

const ofCoarse = blocks([10, 18, 10], 9, 3);

const cases: Case[] = [
  { name: 'fog, 8 bit' },
  { name: 'fog, 16 bit, skewed', data: { kind: 'uint16', spacing: [1, 0.7, 1.4] } },
  { name: 'floats with a hole', data: { kind: 'float32', field: (x, y, z) => fieldWithHole(x, y, z) } },
  { name: 'floats, lit', data: { kind: 'float32' }, style: { lit: true } },
  {
    name: 'floats without data next to faces, lit',
    data: { kind: 'float32', field: besideFace },
    style: { lit: true },
  },
  { name: 'lit, 16 bit', data: { kind: 'uint16' }, style: { lit: true } },
  { name: 'maximum', style: { projection: 'max' } },
  { name: 'a surface alone', style: { clear: true, surfaces: [{ value: 0.5, color: [1, 0.8, 0.6], opacity: 1 }] } },
  {
    name: 'patches of values and gradients',
    style: { patches },
    more: ({ volume: { range } }) => ({ optics: { ...plainOptics, transferFunction: outlinePatches(patches, range) } }),
  },
  {
    name: 'with a layer',
    more: ({ volume }) => {
      const size: Vector3 = [20, 24, 22];
      const layer = syntheticVolume({
        dimensions: size,
        kind: 'float32',
        field: waves,
        indexToWorld: askew(volume, size),
      });
      return { overlay: overlayOf(volume, layer) };
    },
  },
  { name: 'with labels', more: () => ({ labels: mixedAppearances(ofCoarse) }), isCoarse: true },
  { name: 'with functions of labels', more: () => ({ labels: mixedGroups(ofCoarse) }), isCoarse: true },
  { name: 'opaque at once', more: () => ({ optics: { ...plainOptics, transferFunction: cliff } }) },
  {
    name: 'cut, lit',
    style: { lit: true },
    more: ({ volume: { grid } }) => ({
      clips: { kept: [keep(grid, [1, -0.4, 0.3], -8)], cutout: cutBox(grid, [4, -8, -6], [18, 8, 40]) },
    }),
  },
];

const dimensions = [40, 72, 40] as const;

function viewOf({ data, more }: Case): View {
  const volume = syntheticVolume({ dimensions, field: withGrain, ...data });
  const view = viewFromAbove(volume, {
    stepLength: longestDiagonal(volume.grid) / 90,
    optics: { ...plainOptics, referenceLength: 4 },
  });
  return { ...view, ...more?.(view) };
}

async function draw(scene: VolumeScene, { style = null }: Case, view: View): Promise<Uint8ClampedArray> {
  await scene.prepare(view.volume, view.optics);
  await scene.setLabels(view.labels ?? null);
  await scene.setOverlay(view.overlay ? { ...view.overlay, over: view.volume } : null);
  await scene.setAppearance({ style, optics: view.optics });
  return drawPicture(scene, { ...view, maxSubsteps: 8 });
}

async function castInFloat64(scene: VolumeScene, view: View): Promise<Float64Array> {
  const twins = scene.layers[0].twins(false, true)!;
  const frame = { ...twins, rays: raysOf(view), placesOnly: false };
  await loadTwins(twins, frame);
  const stages = composeTwins(twins, frame, { stepLength: view.stepLength, maxSubsteps: 8 });
  return renderStages(stages, frame.rays, width, height).map((x) => 255 * x);
}

/** The finest level in a half of the volume, the next one in a part of the rest, and nothing finer in what is left. */
const some = ({ level, at: [i, j] }: Brick): boolean => (level === 0 ? i === 0 : j === 0);

describe('bricks over a volume', () => {
  const scene = shareScene({});

  it('are sampled by the length of the voxels that a ray is in, like the twin, with skipping and without', async () => {
    const whole = viewOf({ name: 'fog', data: { dimensions: [96, 64, 64] } });
    const view = {
      ...whole,
      volume: cutIntoBricks(whole.volume, 3, ({ at: [i] }) => i === 0).volume,
    };
    await draw(scene(), { name: 'fog' }, view);
    const layer = scene().layers[0];
    const oneAVoxel = longestDiagonal(view.volume.grid) / view.stepLength;
    const byLength = cutSteps({ steps: oneAVoxel, substeps: 1 }, oneAVoxel, 1);
    const drawAgain = (substeps: Substeps): Uint8ClampedArray => {
      changePlan(scene(), { substeps });
      drawAt(scene(), view.stepLength);
      return readPixels(scene());
    };
    const drawn = drawAgain(byLength);
    const codes = layer.detail()!;
    expect([...new Set(codes)]).to.have.members([0, 4, 8]);
    layer.skipping = false;
    expect(comparePictures(drawAgain(byLength), drawn).worst, 'skipping changes nothing').to.equal(0);
    layer.skipping = true;
    let samples = 0;
    const twin = async (min: RayStages['minSubsteps']): Promise<Float64Array> => {
      samples = 0;
      const twins = layer.twins(false, true)!;
      const frame = { ...twins, rays: raysOf(view), placesOnly: false };
      await loadTwins(twins, frame);
      const stages = composeTwins(twins, frame, { stepLength: view.stepLength, maxSubsteps: 1, minSubsteps: min });
      const sampleAt = (place: Vector3): Sample => (samples++, stages.field.sampleAt(place));
      const counted = { ...stages, field: { ...stages.field, sampleAt } };
      return renderStages(counted, frame.rays, width, height).map((x) => 255 * x);
    };
    const cast = await twin(minSubsteps(view.volume, codes, byLength.voxelsPerStep));
    const few = samples;
    const { worst, rmse } = comparePictures(drawn, cast);
    const finest = comparePictures(drawn, await twin(undefined));
    console.log(
      `${few} of ${samples} samples; against the twin ${worst.toFixed(2)}, against steps of the finest voxels ${finest.worst.toFixed(2)}`,
    );
    expect(worst).to.be.at.most(1);
    expect(rmse).to.be.below(0.4);
    expect(finest.worst, 'what one sample a voxel leaves').to.be.at.most(4);
    expect(finest.rmse).to.be.below(0.5);
    expect(few / samples).to.be.below(0.8);
    // Moving pictures, whose steps have nothing to do with cells.
    expect(comparePictures(drawAgain(wholeSteps), await twin(undefined)).worst, 'the whole').to.be.at.most(1);
  });

  for (const one of cases) {
    it(`${one.name}: all of them give the picture of the whole, some that of the twin`, async function () {
      this.timeout(120_000);
      const view = viewOf(one);
      const whole = await draw(scene(), one, view);
      const all = { ...view, volume: cutIntoBricks(view.volume, 3).volume };
      const bricked = await draw(scene(), one, all);
      const none = await draw(scene(), one, { ...view, volume: cutIntoBricks(view.volume, 3, () => false).volume });
      const half = { ...view, volume: cutIntoBricks(view.volume, 3, some).volume };
      const mixed = await draw(scene(), one, half);
      const inGroups = { ...half, volume: cutIntoBricks(view.volume, 3, some, 4).volume };
      const { worst: byGroups } = comparePictures(await draw(scene(), one, inGroups), mixed);
      const twin = await castInFloat64(scene(), half);
      const [same, coarse, between, off] = [
        comparePictures(bricked, whole),
        comparePictures(none, whole),
        comparePictures(mixed, whole),
        comparePictures(mixed, twin),
      ];
      const say = ({ worst, rmse }: typeof same): string => `${worst.toFixed(1)} (${rmse.toFixed(2)})`;
      console.log(
        `${one.name}: all ${say(same)}, none ${say(coarse)}, some ${say(between)}, some against the twin ${say(off)}`,
      );
      if (!one.isCoarse) expect(same.worst, 'all bricks').to.be.at.most(one.worst ?? 1);
      expect(coarse.rmse, 'no brick shows less').to.be.above(1);
      expect(byGroups, 'a table in groups').to.equal(0);
      expect(inGroups.volume.finer.pages.blockCount, 'blocks of the table').to.be.above(0);
      expect(off.rmse, 'some bricks, against the twin').to.be.at.most(0.5);
      expect(off.worst, 'some bricks, against the twin').to.be.at.most(2);
    });
    it(`${one.name}: bricks that come later give the same picture as those that were there before`, async function () {
      this.timeout(120_000);
      const view = viewOf(one);
      const { volume, pyramid } = cutIntoBricks(view.volume, 3, () => false);
      await draw(scene(), one, { ...view, volume });
      for (const { level, at } of [...cutIntoBricks(view.volume, 3, some).volume.finer.bricks])
        volume.finer.add({ level, at }, readBrick(pyramid, { level, at }));
      scene().draw();
      const later = readPixels(scene());
      const before = await draw(scene(), one, { ...view, volume: cutIntoBricks(view.volume, 3, some).volume });
      expect(comparePictures(later, before).worst).to.equal(0);
    });
  }

  for (const [name, times, isHalved] of [
    ['not exactly twice as long', [0.97, 0.97, 0.97], false],
    ['twice as long along x and z, and four times along y', [1, 0.5, 1], true],
  ] as const)
    for (const style of [null, { lit: true }] as const)
      it(`are drawn as the twin casts them where a level's voxels are ${name}${style ? ', lit' : ''}`, async () => {
        const one: Case = { name: 'fog', style };
        const view = viewOf(one);
        const { pyramid, layout, volume } = cutIntoBricks(view.volume, 3, some);
        const [finest, next] = layout.levels;
        const scale = next.scale.map((n, axis) => times[axis] * n) as unknown as Vector3;
        const other = { ...layout, levels: [finest, { ...next, scale }] };
        expect([layout, other].map((all) => halvingsOf(all, volume.grid.dimensions) !== null)).to.deep.equal([
          true,
          isHalved,
        ]);
        const finer = new ResidentBricks(volume, other, volume.finer.upload);
        for (const { level, at } of volume.finer.bricks) finer.add({ level, at }, readBrick(pyramid, { level, at }));
        const { macrocells } = finer.current(volume);
        const changed = { ...view, volume: { ...volume, macrocells, finer } };
        const mixed = await draw(scene(), one, { ...view, volume });
        const drawn = await draw(scene(), one, changed);
        expect(comparePictures(drawn, mixed).worst, 'the other scale is seen').to.be.above(5);
        const { worst, rmse } = comparePictures(drawn, await castInFloat64(scene(), changed));
        expect(rmse).to.be.at.most(0.5);
        expect(worst).to.be.at.most(2);
      });

  it('of an opaque thing: no pixel at a border of theirs shows what lies below its surface', async () => {
    const stone = (x: number, y: number, z: number): number => {
      const rough = 0.03 * Math.sin(61 * x + 9 * y) * Math.sin(53 * y - 7 * z) * Math.sin(57 * z + 5 * x);
      return Math.min(1, Math.max(0, 0.5 + 8 * (0.4 + rough - Math.hypot(x - 0.5, y - 0.5, z - 0.5))));
    };
    const one: Case = {
      name: 'a stone: dark at its surface, light inside',
      data: { field: stone },
      more: () => ({
        optics: {
          ...plainOptics,
          transferFunction: [
            { value: 0.3, color: [0.2, 0.1, 0], opacity: 0 },
            { value: 0.4, color: [0.2, 0.1, 0], opacity: 1 },
            { value: 1, color: [1, 1, 1], opacity: 1 },
          ],
        },
      }),
    };
    const view = viewOf(one);
    const whole = await draw(scene(), one, view);
    const mixed = await draw(scene(), one, { ...view, volume: cutIntoBricks(view.volume, 3, some).volume });
    const opaque = Array.from({ length: width * height }, (_, i) => i).filter(
      (i) => Math.min(whole[4 * i + 3], mixed[4 * i + 3]) > 250,
    );
    const off = opaque.map((i) => Math.abs(mixed[4 * i + 1] - whole[4 * i + 1]));
    const brightest = Math.max(...opaque.map((i) => whole[4 * i + 1]));
    console.log(
      `green up to ${brightest}; off by ${Math.max(...off)} at most, by more than 10 in ${off.filter((x) => x > 10).length} of ${off.length} pixels`,
    );
    expect(off.length).to.be.above(200);
    expect(Math.max(...off)).to.be.at.most(3);
  });

  it('make tables again only when bricks have come: where values are opaque at once, with their larger range', async () => {
    const opaque = cases.find(({ name }) => name === 'opaque at once')!;
    const view = viewOf(opaque);
    const [low, high] = view.volume.range;
    const volume = { ...cutIntoBricks(view.volume, 3, some).volume, range: [low + 0.1, high - 0.1] as const };
    await draw(scene(), opaque, { ...view, volume });
    expect(scene().layers[0].volume!.range, 'means have other values').to.not.deep.equal(volume.range);
    const { gl } = scene().layers[0];
    const { texImage2D } = gl;
    let uploads = 0;
    gl.texImage2D = (...given: unknown[]): void => {
      uploads++;
      (texImage2D as (...all: unknown[]) => void).apply(gl, given);
    };
    for (let n = 0; n < 3; n++) scene().draw();
    gl.texImage2D = texImage2D;
    expect(uploads).to.equal(0);
  });
});
