// Bricks of finer levels over a volume: the whole volume's picture where all are there, and the twin's where some are.
import { expect } from '@esm-bundle/chai';
import type { Brick } from '../../../src/bricks/pyramid.ts';
import type { RayStyle } from '../../../src/optics/rays/ray-style.ts';
import { renderStages } from '../../../src/optics/reference.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { composeTwins, loadTwins } from '../../../src/renderer/ray/compose-twins.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { cutIntoBricks } from '../../helpers/bricks.ts';
import { cutBox, keep } from '../../helpers/clips.ts';
import { comparePictures, drawPicture, height, plainOptics, raysOf, shareScene, width } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
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

interface Case {
  readonly name: string;
  readonly data?: Partial<SyntheticOptions>;
  readonly style?: RayStyle | null;
  readonly more?: (view: View) => Partial<View>;
  /** The largest difference of a pixel from the whole volume's: samples of both lie at the same places. */
  readonly worst?: number;
}

const cases: Case[] = [
  { name: 'fog, 8 bit' },
  { name: 'fog, 16 bit, skewed', data: { kind: 'uint16', spacing: [1, 0.7, 1.4] } },
  { name: 'floats with a hole', data: { kind: 'float32', field: (x, y, z) => fieldWithHole(x, y, z) } },
  { name: 'lit, 16 bit', data: { kind: 'uint16' }, style: { lit: true } },
  { name: 'maximum', style: { projection: 'max' } },
  { name: 'a surface alone', style: { clear: true, surfaces: [{ value: 0.5, color: [1, 0.8, 0.6], opacity: 1 }] } },
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
      expect(same.worst, 'all bricks').to.be.at.most(one.worst ?? 1);
      expect(coarse.rmse, 'no brick shows less').to.be.above(1);
      expect(byGroups, 'a table in groups').to.equal(0);
      expect(inGroups.volume.finer.pages.blockCount, 'blocks of the table').to.be.above(0);
      expect(off.rmse, 'some bricks, against the twin').to.be.at.most(0.5);
      expect(off.worst, 'some bricks, against the twin').to.be.at.most(2);
    });
  }
});
