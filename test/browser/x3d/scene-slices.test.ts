import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Orbit } from '../../../src/optics/rays/camera.ts';
import { rayThrough } from '../../../src/optics/rays/rays.ts';
import { sliceMeeter } from '../../../src/radar/slices.ts';
import type { Slice } from '../../../src/radar/slices.ts';
import { stretchOf } from '../../../src/radar/polar-geometry.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import { casesIn } from '../../helpers/cases.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { asPolar, evenAzimuths, polarScenes, radarVolume } from '../../helpers/synthetic-radar.ts';
import type { RadarOptions, SweepOptions } from '../../helpers/synthetic-radar.ts';
import {
  bothWalks,
  comparePictures,
  drawPicture,
  drawReference,
  height,
  raysOf,
  shareScene,
  width,
  withScene,
  walksOf,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';

/** Smooth over gates, with a dry south-west. */
const rolling: SweepOptions['stored'] = (azimuth, gate) =>
  azimuth > 200 && azimuth < 250
    ? 0
    : Math.round(130 + 60 * Math.sin((azimuth * Math.PI) / 60) + 50 * Math.sin(gate / 4));

const radarFrom = (lowest: number): RadarOptions => ({
  sweeps: [lowest, 1.5, 3, 6, 12].map((elevation) => ({
    elevation,
    gates: 60,
    azimuths: evenAzimuths(72),
    stored: rolling,
  })),
});

const radar = radarFrom(0.5);

/** Nothing below 0 dBZ, and clear enough that slices are seen through all that is before them. */
const rain = [
  { value: 0, color: [0.1, 0.3, 1], opacity: 0 },
  { value: 30, color: [0.1, 0.8, 0.3], opacity: 0.1 },
  { value: 70, color: [1, 0.4, 0.1], opacity: 0.4 },
] as const;

const diagonally: Slice = { kind: 'upright', from: [-20_000, 30_000], direction: [0.6, -0.8], length: 50_000 };
const rhi: Slice = { kind: 'upright', from: [0, 0], direction: [Math.SQRT1_2, Math.SQRT1_2], length: Infinity };

interface Case {
  readonly name: string;
  readonly slices: readonly Slice[];
  readonly options?: RadarOptions;
  readonly orbit?: Orbit;
  readonly beamModel?: 'straight';
  readonly opacityFactor?: number;
}

const cases: Case[] = [
  { name: 'the lowest sweep', slices: [{ kind: 'cone', sweep: 0 }] },
  { name: 'a sweep from below', slices: [{ kind: 'cone', sweep: 3 }], orbit: { theta: 2, phi: 2.4, radius: 1.2 } },
  {
    name: 'a steep sweep from the side, seen through',
    slices: [{ kind: 'cone', sweep: 4 }],
    orbit: { theta: 1, phi: 1.5, radius: 1.1 },
  },
  { name: 'straight beams', slices: [{ kind: 'cone', sweep: 2 }], beamModel: 'straight' },
  { name: 'a height', slices: [{ kind: 'level', height: 3000 }] },
  { name: 'an azimuth', slices: [rhi], orbit: { theta: 0.9, phi: 1.2, radius: 1.1 } },
  { name: 'between two points', slices: [diagonally], orbit: { theta: -0.7, phi: 1.3, radius: 1 } },
  {
    name: 'four at once',
    slices: [diagonally, { kind: 'cone', sweep: 1 }, rhi, { kind: 'level', height: 5000 }],
    orbit: { theta: 0.3, phi: 1, radius: 1 },
  },
  { name: 'nothing but slices', slices: [rhi, { kind: 'cone', sweep: 2 }], opacityFactor: 0 },
  { name: 'from inside', slices: [{ kind: 'cone', sweep: 2 }, rhi], orbit: { theta: 2, phi: 1.2, radius: 0.1 } },
  {
    name: 'sweeps to the poles',
    slices: [
      { kind: 'cone', sweep: 3 },
      { kind: 'cone', sweep: 1 },
    ],
    options: polarScenes['to the poles'],
  },
  {
    name: 'a sweep whose rays go up and down, beside another that does',
    slices: [{ kind: 'cone', sweep: 1 }, rhi],
    options: {
      sweeps: [1, 4, 8].map((elevation, i) => ({
        elevation,
        gates: 90,
        azimuths: evenAzimuths(36),
        stored: rolling,
        rayElevation: (azimuth) => elevation + Math.sin(azimuth / 20 + i),
      })),
    },
  },
  {
    name: 'below the horizon',
    slices: [{ kind: 'cone', sweep: 0 }],
    options: {
      sweeps: [-0.8, 0.4, 2].map((elevation) => ({
        elevation,
        gates: 90,
        azimuths: evenAzimuths(36),
        stored: rolling,
      })),
    },
  },
];

function viewOf({
  slices,
  options = radar,
  orbit = { theta: 0.6, phi: 1.1, radius: 1.2 },
  beamModel,
  opacityFactor = 1,
}: Case): View {
  const volume = radarVolume(options, {
    verticalExaggeration: options === polarScenes['to the poles'] ? 1 : 4,
    ...(beamModel ? { beamModel } : {}),
  });
  const diagonal = longestDiagonal(volume.grid);
  return {
    volume,
    camera: orbitCamera({ ...orbit, radius: orbit.radius * diagonal }, boundingSphere(volume.grid).center, 0.6),
    stepLength: diagonal / 80,
    optics: { transferFunction: rain, referenceLength: diagonal / 10, opacityFactor, lightFactor: 1 },
    slices,
  };
}

/**
 * Pixels at whose centre it hangs by a thread which slice is seen, if any, or what of it: float32 may see the other side.
 * Asked of rays a thousandth of a pixel beside.
 */
function findEdges(view: View): (pixel: number) => boolean {
  const rays = raysOf(view);
  const meet = sliceMeeter(asPolar(view.volume), view.slices!, view.optics!);
  const edges = new Set<number>();
  for (let pixel = 0; pixel < width * height; pixel++) {
    const [x, y] = [(((pixel % width) + 0.5) / width) * 2 - 1, 1 - ((Math.floor(pixel / width) + 0.5) / height) * 2];
    const seen = [
      [0, 0],
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ].map(([dx, dy]) => meet(rayThrough(rays, x + (dx * 2e-3) / width, y + (dy * 2e-3) / height), [-10, 10]));
    const isEdge = seen.some(
      (hit) =>
        (hit === null) !== (seen[0] === null) ||
        (hit &&
          seen[0] &&
          (Math.abs(hit.t - seen[0].t) > 1e-3 ||
            hit.color.some((channel, c) => Math.abs(channel - seen[0]!.color[c]) > 0.004))),
    );
    if (isEdge) edges.add(pixel);
  }
  return (pixel) => edges.has(pixel);
}

const expectationOf = remember((one: Case) => {
  const isEdge = findEdges(viewOf(one));
  return walksOf(viewOf(one), cases.indexOf(one)).map((view) => ({ view, expected: drawReference(view), isEdge }));
});

for (const version of [2, 1] as const) {
  describe(`slices of a radar volume in WebGL ${version} are the reference's`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const one of casesIn(version, cases, ({ name }) => name === 'four at once' || name.includes('up and down'))) {
      it(one.name, async () => {
        expect(scene().device.webgl2).to.equal(version === 2);
        for (const { view, expected, isEdge } of expectationOf(one)) {
          await scene().prepare(view.volume);
          const got = drawPicture(scene(), view);
          const without = drawPicture(scene(), { ...view, slices: [] });
          const edges = Array.from({ length: width * height }, (_, pixel) => pixel).filter(isEdge).length;
          const painted = Array.from({ length: width * height }, (_, pixel) => pixel).filter(
            (pixel) => got[pixel * 4 + 3] === 255 && without[pixel * 4 + 3] < 255,
          ).length;
          const { worst, rmse } = comparePictures(got, expected, isEdge);
          console.log(
            `WebGL ${version} ${one.name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}; ${painted} pixels show a slice, ${edges} left out`,
          );
          expect(painted, 'pixels that show a slice').to.be.above(40);
          expect(edges, 'pixels left out').to.be.below(0.02 * width * height);
          expect(worst, 'worst pixel').to.be.at.most(2);
          expect(rmse, 'RMSE').to.be.at.most(0.5);
        }
      });
    }
  });
}

describe('a region of a volume in a scene', () => {
  for (const version of [2, 1] as const) {
    it(`is the reference's in WebGL ${version}, with and without skipping`, () =>
      withScene({ webgl1: version === 1 }, async (scene) => {
        const plain = viewOf({ ...cases[7], opacityFactor: 20 });
        await scene.prepare(plain.volume);
        const cartesian = syntheticVolume({ dimensions: [20, 16, 12] });
        const sphere = boundingSphere(cartesian.grid);
        const views: View[] = [
          {
            ...plain,
            region: cutRegion(
              plain.volume.grid,
              [-30_000, -5000, 500, 20_000, 40_000, 4000],
              stretchOf(plain.volume.grid),
            ),
          },
          {
            ...plain,
            slices: [],
            region: cutRegion(plain.volume.grid, [-1e9, 0, 0, 1e9, 1e9, 2500], stretchOf(plain.volume.grid)),
          },
          {
            volume: cartesian,
            camera: orbitCamera({ theta: 1, phi: 1, radius: sphere.radius * 2 }, sphere.center, 0.6),
            stepLength: 0.3,
            region: cutRegion(
              cartesian.grid,
              [-4, -5, -3, 6, 3, 2].map((x, i) => x + sphere.center[i % 3]),
            ),
          },
        ];
        for (const view of views.flatMap(bothWalks)) {
          expect(view.region).not.to.equal(null);
          const got = drawPicture(scene, view);
          scene.layers[0].skipping = false;
          expect(comparePictures(got, drawPicture(scene, view)).worst, 'skipping').to.be.at.most(1);
          scene.layers[0].skipping = true;
          const isEdge = view.slices ? findEdges(view) : () => false;
          const { worst, rmse } = comparePictures(got, drawReference(view), isEdge);
          console.log(
            `WebGL ${version} region: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)} of ${Math.max(...got)}`,
          );
          expect(Math.max(...got)).to.be.above(60);
          expect(
            comparePictures(got, drawPicture(scene, { ...view, region: null })).worst,
            'it leaves something out',
          ).to.be.above(30);
          expect(worst).to.be.at.most(2);
          expect(rmse).to.be.at.most(0.5);
        }
      }));
  }
});

describe('slices in a scene', () => {
  it('are lost to no skipping of empty air, come and go, and leave cartesian volumes alone', () =>
    withScene({}, async (scene) => {
      for (const view of bothWalks(viewOf(cases[7]))) {
        await scene.prepare(view.volume);
        const skipped = drawPicture(scene, view);
        scene.layers[0].skipping = false;
        expect(comparePictures(skipped, drawPicture(scene, view)).worst).to.be.at.most(1);
        scene.layers[0].skipping = true;
        const bare = drawPicture(scene, { ...view, slices: [] });
        expect(comparePictures(bare, drawReference({ ...view, slices: [] })).worst).to.be.at.most(2);
        expect(comparePictures(skipped, bare).worst).to.be.above(60);
        expect(comparePictures(skipped, drawPicture(scene, view)).worst).to.equal(0);
      }
    }));
});
