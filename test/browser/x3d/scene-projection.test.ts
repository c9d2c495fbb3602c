import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Ray } from '../../../src/optics/rays/rays.ts';
import { projectionKinds } from '../../../src/optics/rays/ray-style.ts';
import type { ProjectionKind } from '../../../src/optics/rays/ray-style.ts';
import type { Slice } from '../../../src/radar/slices.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { stagesOf } from '../../../src/optics/reference.ts';
import { fitOrder } from '../../accuracy/orders.ts';
import { casesIn, takesAll } from '../../helpers/cases.ts';
import { changePlan } from '../../helpers/change-plan.ts';
import {
  bothWalks,
  comparePictures,
  drawPicture,
  drawReference,
  height,
  meetBox,
  plainOptics,
  raysOf,
  referenceOf,
  shareScene,
  walksIn,
  width,
  withScene,
  walksOf,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { isEdge, listOff, rayAt } from '../../helpers/edges.ts';
import { remember } from '../../helpers/remember.ts';
import { fieldWithHole, syntheticVolume } from '../../helpers/synthetic.ts';
import type { SyntheticOptions } from '../../helpers/synthetic.ts';
import { evenAzimuths, radarVolume } from '../../helpers/synthetic-radar.ts';
import type { RadarOptions, SweepOptions } from '../../helpers/synthetic-radar.ts';
import { probe } from '../../helpers/probe.ts';

/** Colour tells the value; the lowest is clear. */
const ramp: NonNullable<View['optics']>['transferFunction'] = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 0.5, color: [0, 1, 0.3], opacity: 0.2 },
  { value: 1, color: [1, 0.9, 0.6], opacity: 0.5 },
];

interface Case {
  readonly name: string;
  readonly view: () => View;
}

function cartesian(
  data: Partial<SyntheticOptions>,
  more: (volume: Volume) => Partial<View> = () => ({}),
  steps = 50,
): View {
  const volume = syntheticVolume({ dimensions: [24, 20, 16], ...data });
  const diagonal = longestDiagonal(volume.grid);
  const camera = orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6);
  return {
    volume,
    camera,
    stepLength: diagonal / steps,
    optics: { ...plainOptics, transferFunction: ramp },
    ...more(volume),
  };
}

/** Smooth over gates, with a dry south-west; -32 to 95.5 dBZ. */
const rolling: SweepOptions['stored'] = (azimuth, gate) =>
  azimuth > 200 && azimuth < 250
    ? 0
    : Math.round(130 + 60 * Math.sin((azimuth * Math.PI) / 60) + 50 * Math.sin(gate / 9));

const radar = (
  change: (i: number) => Partial<SweepOptions> = () => ({}),
  more: Partial<RadarOptions> = {},
): RadarOptions => ({
  ...more,
  sweeps: [0.5, 1.5, 3, 6, 12].map((elevation, i) => ({
    elevation,
    gates: 60,
    azimuths: evenAzimuths(72),
    stored: rolling,
    ...change(i),
  })),
});

function polar(options: RadarOptions, more: Partial<View> = {}): View {
  const volume = radarVolume(options, { verticalExaggeration: 4 });
  const diagonal = longestDiagonal(volume.grid);
  const [low, high] = volume.range;
  const transferFunction = ramp.map((stop) => ({ ...stop, value: low + stop.value * (high - low) }));
  const camera = orbitCamera({ theta: 0.6, phi: 1.1, radius: 1.2 * diagonal }, boundingSphere(volume.grid).center, 0.6);
  return { volume, camera, stepLength: diagonal / 150, optics: { ...plainOptics, transferFunction }, ...more };
}

const slices: readonly Slice[] = [
  { kind: 'upright', from: [0, 0], direction: [Math.SQRT1_2, -Math.SQRT1_2], length: Infinity },
  { kind: 'cone', sweep: 1 },
];
const waves =
  (elevation: number, i: number) =>
  (azimuth: number): number =>
    elevation + 0.3 * Math.sin((3 * azimuth * Math.PI) / 180 + i);

const cases: Case[] = [
  { name: '8 bit', view: () => cartesian({}) },
  { name: '16 bit, half the steps of a voxel', view: () => cartesian({ kind: 'uint16' }, undefined, 20) },
  { name: 'floats with a hole', view: () => cartesian({ kind: 'float32', field: fieldWithHole }) },
  { name: 'a region', view: () => cartesian({}, ({ grid }) => ({ region: cutRegion(grid, [-5, -6, -4, 9, 5, 3]) })) },
  {
    name: 'a window in the middle',
    view: () =>
      cartesian({ kind: 'uint16' }, () => ({
        optics: { ...plainOptics, transferFunction: ramp.map((stop) => ({ ...stop, value: 0.25 + 0.4 * stop.value })) },
      })),
  },
  { name: 'polar', view: () => polar(radar()) },
  {
    name: 'polar floats',
    view: () =>
      polar(
        radar(() => ({ kind: 'float32', slope: 1, intercept: 0, stored: (a, g, r) => rolling(a, g, r) / 255 || NaN })),
      ),
  },
  {
    name: 'polar, radials of their own elevations',
    view: () => polar(radar((i) => ({ rayElevation: waves([0.5, 1.5, 3, 6, 12][i], i) }))),
  },
  { name: 'polar with slices', view: () => polar(radar(), { slices }) },
];

const storedOtherwise = new Set(['16 bit, half the steps of a voxel', 'floats with a hole', 'polar with slices']);
/** One volume in each projection, and others, from other textures, in one. */
const isDrawnInWebGl1 = ({ one, i, kind }: { one: Case; i: number; kind: ProjectionKind }): boolean =>
  i === 0 || (kind === 'max' && storedOtherwise.has(one.name));

const expectationOf = remember((one: Case) =>
  remember((projection: ProjectionKind) => {
    return walksOf({ ...one.view(), projection }, cases.indexOf(one)).map((view) => ({
      view,
      expected: drawReference(view),
    }));
  }),
);

for (const version of [2, 1] as const) {
  describe(`projection in WebGL ${version} is the reference's`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    const drawn = cases.flatMap((one, i) => projectionKinds.map((kind) => ({ one, i, kind })));
    for (const { one, i, kind } of casesIn(version, drawn, isDrawnInWebGl1)) {
      it(`${kind}: ${one.name}; and skipping changes no byte`, async () => {
        await scene().setAppearance({ style: { projection: kind } });
        for (const { view, expected } of walksIn(version, i, expectationOf(one)(kind))) {
          await scene().prepare(view.volume);
          const got = drawPicture(scene(), view);
          const rays = raysOf(view);
          const stages = stagesOf(referenceOf(view), rays);
          const edges = new Set([...listOff(got, expected)].filter((pixel) => isEdge(stages, rays, pixel)));
          const { worst, rmse } = comparePictures(got, expected, (pixel) => edges.has(pixel));
          console.log(
            `WebGL ${version} ${kind} ${one.name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)} of ${Math.max(...expected).toFixed(0)}; ${edges.size} pixels left out`,
          );
          expect(Math.max(...expected), 'the picture shows something').to.be.above(60);
          expect(edges.size, 'pixels left out').to.be.below(0.01 * width * height);
          expect(worst, 'worst pixel').to.be.at.most(2);
          expect(rmse, 'RMSE').to.be.at.most(0.5);
          scene().layers[0].skipping = false;
          expect(comparePictures(got, drawPicture(scene(), view)).worst, 'skipping').to.equal(0);
          scene().layers[0].skipping = true;
          if (view.slices)
            expect(
              comparePictures(got, drawPicture(scene(), { ...view, slices: [] })).rmse,
              'slices are seen',
            ).to.be.above(10);
        }
      });
    }
  });

  describe(`projection in WebGL ${version}`, () => {
    it("is the first local extreme from a threshold on, as the reference's; and skipping changes no byte", () =>
      withScene({ webgl1: version === 1 }, async (scene) => {
        const lumps = (x: number, y: number, z: number): number =>
          0.5 + 0.3 * Math.sin(9 * x) * Math.cos(7 * y) + 0.2 * Math.sin(11 * z + 3 * x);
        for (const [projection, intensityThreshold] of [
          ['max', 0.55],
          ['min', 0.45],
        ] as const) {
          const view = cartesian({ kind: 'float32', field: lumps }, () => ({ projection, intensityThreshold }), 120);
          await scene.setAppearance({ style: { projection, intensityThreshold } });
          for (const one of bothWalks(view)) {
            const [got, expected] = [drawPicture(scene, one), drawReference(one)];
            // Where a lump just reaches the threshold it may be seen here and not there.
            const off = listOff(got, expected);
            const { worst, rmse } = comparePictures(got, expected, (pixel) => off.has(pixel));
            const whole = comparePictures(got, drawReference({ ...one, intensityThreshold: undefined }));
            console.log(
              `WebGL ${version} local ${projection}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}; ${off.size} pixels left out; to that of the whole ray ${whole.rmse.toFixed(1)}`,
            );
            expect(off.size, 'pixels left out').to.be.below(0.01 * width * height);
            expect(rmse, 'RMSE').to.be.at.most(0.5);
            expect(whole.rmse, 'it is another picture than that of the whole ray').to.be.above(5);
            scene.layers[0].skipping = false;
            expect(comparePictures(got, drawPicture(scene, one)).worst, 'skipping').to.equal(0);
            scene.layers[0].skipping = true;
          }
        }
      }));

    if (takesAll || version === 2)
      it('converges with order 1.9 and more, down to what kinks between voxels leave', () =>
        withScene({ webgl1: version === 1 }, async (scene) => {
          // A peak of a few steps, and something that is cut off at the faces: else a mean by trapezoids has next to no error.
          const peak =
            (width: number) =>
            (x: number, y: number, z: number): number =>
              Math.exp(-(((x - 0.45) ** 2 + (y - 0.52) ** 2 + (z - 0.5) ** 2) / width ** 2)) + 0.2 * x;
          const gray = [
            { value: 0, color: [0, 0, 0], opacity: 1 },
            { value: 1.2, color: [1, 1, 1], opacity: 1 },
          ] as const;
          for (const [kind, counts, peakWidth, floor] of [
            ['max', [6, 7, 8, 9, 11, 16], 0.16, 6e-4],
            ['average', [6, 8, 11, 15, 21, 30], 0.4, 1e-3],
          ] as const) {
            // Pictures in motion take steps.
            const view = {
              ...cartesian({
                dimensions: [96, 96, 96],
                spacing: [0.2, 0.2, 0.2],
                kind: 'float32',
                field: peak(peakWidth),
              }),
              maxSubsteps: 1,
            };
            const diagonal = longestDiagonal(view.volume.grid);
            await scene.setAppearance({ style: { projection: kind } });
            drawPicture(scene, { ...view, optics: { ...plainOptics, transferFunction: gray } });
            // Rays in the middle of the picture, which go through two opposite faces.
            const lattice = { stride: 1, first: [width / 2 - 7, height / 2 - 7] as const, width: 15, height: 15 };
            const [limit, ...pictures] = probe(
              scene,
              [diagonal / 3000, ...counts.map((count) => diagonal / count)],
              lattice,
              { width, height },
            )!;
            const errors = pictures.map(
              (picture) => Math.hypot(...limit.map((x, i) => picture[i] - x)) / Math.sqrt(limit.length),
            );
            const order = fitOrder(counts, errors);
            const stated = Math.min(...scene.layers[0].modules(false).map((module) => module.order));
            console.log(
              `WebGL ${version} ${kind}: ${errors.map((error) => error.toExponential(1)).join(' ')}, order ${order.toFixed(2)}`,
            );
            expect(stated, 'what the modules say').to.equal(2);
            expect(order, kind).to.be.at.least(stated - 0.1);
            expect(errors.at(-1), kind).to.be.below(floor);
          }
        }));

    it('ends at shapes, which are seen behind it', () => {
      const [center, size] = [[4, 2, 3] as Vector3, 6];
      const box = `<transform translation="${center.join(' ')}" scale="${[size, size, size].map((x) => x / 2).join(' ')}"><shape><appearance><material diffusecolor="0 0 0" emissivecolor="0 1 0"></material></appearance><box></box></shape></transform>`;
      return withScene({ webgl1: version === 1, children: box }, async (scene) => {
        for (const view of projectionKinds.flatMap((projection, i) => walksOf({ ...cartesian({}), projection }, i))) {
          const projection = view.projection!;
          await scene.setAppearance({ style: { projection } });
          const got = drawPicture(scene, view);
          const surfaceT = (ray: Ray): number => meetBox(view.volume, ray, { center, size });
          const front = drawReference(view, surfaceT);
          const rays = raysOf(view);
          let hidden = 0;
          const behind = Array.from({ length: width * height }, (_, pixel) =>
            Number.isFinite(surfaceT(rayAt(rays, pixel))),
          );
          const isOutline = (pixel: number): boolean =>
            [1, -1, width, -width].some((step) => behind[pixel + step] !== behind[pixel]);
          const expected = front.map(
            (x, i) =>
              x +
              (behind[i >> 2] && (i & 3) === 1 ? 255 - front[i | 3] : behind[i >> 2] && (i & 3) === 3 ? 255 - x : 0),
          );
          for (const is of behind) hidden += Number(is);
          const { worst } = comparePictures(got, expected, isOutline);
          console.log(`WebGL ${version} ${projection} before a box: worst ${worst.toFixed(2)}, ${hidden} pixels`);
          expect(hidden).to.be.above(30);
          expect(worst).to.be.at.most(3);
        }
      });
    });

    it('shows no value that data do not have, and no mean of both sides of a fold', () =>
      withScene({ webgl1: version === 1 }, async (scene) => {
        const folds = radar(
          () => ({
            nyquist: 30,
            slope: 0.5,
            intercept: -30,
            stored: (azimuth) => (Math.floor(azimuth / 10) % 2 ? 1 : 119),
          }),
          { moments: [['VRAD', 'velocity']] },
        );
        // Only what is between the two velocities would be seen.
        const transferFunction = [-29, -28, 28, 29].map((value, i) => ({
          value,
          color: [1, 1, 1] as const,
          opacity: i === 1 || i === 2 ? 1 : 0,
        }));
        const view = polar(folds, { optics: { ...plainOptics, transferFunction } });
        await scene.prepare(view.volume);
        for (const kind of ['max', 'min'] as const) {
          await scene.setAppearance({ style: { projection: kind } });
          expect(Math.max(...drawPicture(scene, view)), kind).to.equal(0);
        }
        const seen = transferFunction.map((stop) => ({ ...stop, opacity: 1 }));
        expect(
          Math.max(...drawPicture(scene, { ...view, optics: { ...view.optics!, transferFunction: seen } })),
        ).to.equal(255);
      }));

    if (takesAll || version === 2)
      it('casts fewer rays where it is smooth, as for any picture', () =>
        withScene({ webgl1: version === 1 }, async (scene) => {
          const view = cartesian({ dimensions: [40, 36, 32] });
          await scene.setAppearance({ style: { projection: 'max' } });
          changePlan(scene, { picture: { width: 181, height: 137 } });
          const all = drawPicture(scene, view);
          expect(scene.adaptive).to.equal(true);
          changePlan(scene, { maxCurvature: 6, edgeCurvature: Infinity });
          const { rmse, worst } = comparePictures(drawPicture(scene, view), all);
          console.log(`WebGL ${version} adaptive: worst ${worst} rmse ${rmse.toFixed(2)}`);
          expect(rmse).to.be.within(0.01, 1);
        }));
  });
}

describe('a scene that projects', () => {
  it('goes back to emission and absorption, and takes the last of several projections', () =>
    withScene({}, async (scene: VolumeScene) => {
      const view = cartesian({});
      const before = drawPicture(scene, view);
      const settings = [
        scene.setAppearance({ style: { projection: 'max' } }),
        scene.setAppearance({ style: { projection: 'min' } }),
        scene.setAppearance({ style: { projection: 'average' } }),
      ];
      await Promise.all(settings);
      const average = drawPicture(scene, view);
      expect(comparePictures(average, drawReference({ ...view, projection: 'average' })).worst).to.be.at.most(2);
      await scene.setAppearance({ style: null });
      expect(comparePictures(drawPicture(scene, view), before).worst).to.equal(0);
      expect(comparePictures(average, before).worst).to.be.above(20);
    }));
});
