import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Orbit } from '../../../src/optics/rays/camera.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { casesIn } from '../../helpers/cases.ts';
import { evenAzimuths, polarScenes, radarVolume } from '../../helpers/synthetic-radar.ts';
import type { RadarOptions, SweepOptions } from '../../helpers/synthetic-radar.ts';
import { drawAsExpected, expectWalks } from '../../helpers/compare-with-twin.ts';
import { comparePictures, drawPicture, drawReference, shareScene, withScene } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

/** A storm north-east of the radar and a band of rain across the north, smooth over gates; stored 1 to 255. */
function storm(elevation: number): SweepOptions['stored'] {
  return (azimuth, gate) => {
    const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
    const range = gate + 0.5;
    const [x, y, z] = [range * Math.cos(e) * Math.sin(a), range * Math.cos(e) * Math.cos(a), range * Math.sin(e)];
    const cell = Math.exp(-(((x - 8) / 4) ** 2 + ((y - 7) / 4) ** 2 + ((z - 2) / 3) ** 2));
    const band = 0.6 * Math.exp(-(((y - 2 - 0.2 * x) / 3) ** 2 + (z / 2.5) ** 2));
    return 1 + Math.round(254 * Math.min(1, Math.max(cell, band)));
  };
}

/** Where the storm is not: a row of gates that get brighter. */
const ramp: SweepOptions['stored'] = (_azimuth, gate) => 100 + 7 * gate;

/** As stored in each type: 8-bit values, 257 times as much in 16 bits, half as much in floats. */
const withStorm = ({ sweeps, ...rest }: RadarOptions): RadarOptions => ({
  ...rest,
  sweeps: sweeps.map((sweep) => {
    const value = (sweep.azimuths?.length ?? 24) < 8 ? ramp : storm(sweep.elevation)!;
    const isHole = (a: number, g: number, r: number): boolean =>
      sweep.stored !== undefined && !(sweep.stored(a, g, r) > 0);
    const [scale, nothing] = sweep.kind === 'uint16' ? [257, 0] : sweep.kind === 'float32' ? [0.5, NaN] : [1, 0];
    return { ...sweep, stored: (a, g, r) => (isHole(a, g, r) ? nothing : scale * value(a, g, r)) };
  }),
});

/** Rain that is clear, a storm that is not, in dBZ. */
const rain = [
  { value: -20, color: [0.1, 0.3, 1], opacity: 0 },
  { value: 20, color: [0.1, 0.8, 0.3], opacity: 0.1 },
  { value: 60, color: [1, 0.4, 0.1], opacity: 0.4 },
] as const;

interface Case {
  readonly name: string;
  readonly scene: string;
  /** Radius in diagonals. */
  readonly orbit?: Orbit;
  readonly exaggeration?: number;
  readonly beamModel?: 'standard' | 'straight';
  readonly opacityFactor?: number;
}

/** A thin sector, seen from above and near, and denser. */
const thin = { orbit: { theta: 0.2, phi: 0.3, radius: 0.5 }, opacityFactor: 40 };

const cases: Case[] = [
  ...Object.keys(polarScenes).map((scene) => ({
    name: scene,
    scene,
    ...(['a sector of one degree', 'one ray'].includes(scene) ? thin : {}),
  })),
  { name: 'straight beams', scene: 'five sweeps', beamModel: 'straight' },
  { name: 'heights five times', scene: 'five sweeps', exaggeration: 5 },
  { name: 'from above', scene: 'five sweeps', orbit: { theta: 0, phi: 0.01, radius: 1.5 } },
  { name: 'along the ground', scene: 'five sweeps', orbit: { theta: 1, phi: 1.54, radius: 1 } },
  { name: 'from inside', scene: 'five sweeps', orbit: { theta: 2, phi: 1.3, radius: 0.1 }, exaggeration: 3 },
];

/** Scenes whose own values are what they are about. */
const asTheyAre = new Set(['folds', 'kinds of echo']);

function viewOf({
  scene,
  orbit = { theta: 0.6, phi: 1.1, radius: 1.2 },
  exaggeration,
  beamModel,
  opacityFactor = 2,
}: Case): View {
  const options = asTheyAre.has(scene) ? polarScenes[scene] : withStorm(polarScenes[scene]);
  const volume = radarVolume(options, {
    ...(exaggeration ? { verticalExaggeration: exaggeration } : {}),
    ...(beamModel ? { beamModel } : {}),
  });
  const diagonal = longestDiagonal(volume.grid);
  // Stored 8-bit values v are v / 2 - 32, 16-bit ones 257 times as far above -32, floats v / 2.
  const scale = volume.samples instanceof Uint16Array ? 257 : 1;
  const toData = (value: number): number => (value + 32) * scale - (volume.samples instanceof Float32Array ? 0 : 32);
  return {
    volume,
    camera: orbitCamera({ ...orbit, radius: orbit.radius * diagonal }, boundingSphere(volume.grid).center, 0.6),
    stepLength: diagonal / 150,
    optics: {
      transferFunction: rain.map((stop) => ({ ...stop, value: toData(stop.value) })),
      referenceLength: diagonal / 40,
      opacityFactor,
      lightFactor: 1,
    },
  };
}

const expectationOf = remember((one: Case) => expectWalks(viewOf(one)));

/** How gates are stored and found; test/browser/shaders/polar.test.ts compares the samples of all scenes in both versions. */
const fromTextures = new Set([
  'five sweeps',
  '16 bit',
  'floats without data',
  'rays that crowd',
  'rays of their own elevations',
  'folds',
  'kinds of echo',
]);

for (const version of [2, 1] as const) {
  describe(`the picture of a radar volume in WebGL ${version} is the reference's`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const one of casesIn(version, cases, ({ name }) => fromTextures.has(name))) {
      it(one.name, async () => {
        expect(scene().device.webgl2).to.equal(version === 2);
        for (const expectation of expectationOf(one)) {
          await scene().prepare(expectation.view.volume);
          drawAsExpected(scene(), expectation, { name: `WebGL ${version} ${one.name}`, minShown: 20 });
        }
      });
    }
  });
}

describe('a radar volume in a scene', () => {
  for (const webgl1 of [false, true]) {
    it(`looks the same with and without skipping empty air in WebGL ${webgl1 ? 1 : 2}`, () =>
      withScene({ webgl1 }, async (scene) => {
        const sparse: SweepOptions['stored'] = (azimuth, gate) =>
          azimuth > 20 && azimuth < 70 && gate > 24 && gate < 34 ? 100 + 10 * (gate - 24) : 0;
        const sweeps = [0.5, 1.5, 3, 6, 12].map((elevation) => ({
          elevation,
          gates: 60,
          azimuths: evenAzimuths(72),
          stored: sparse,
        }));
        const { optics, volume: any } = viewOf({ name: '', scene: 'five sweeps' });
        await scene.prepare(any);
        for (const verticalExaggeration of [1, 4]) {
          const volume = radarVolume({ sweeps }, { verticalExaggeration });
          const diagonal = longestDiagonal(volume.grid);
          for (const [theta, phi, radius] of [
            [0, 1.4, 1.2],
            [0.7, 1.1, 0.5],
            [3, 0.01, 1.2],
            [2, 1.5, 0.01],
          ]) {
            const camera = orbitCamera(
              { theta, phi, radius: radius * diagonal },
              boundingSphere(volume.grid).center,
              0.9,
            );
            for (const steps of [20, 300]) {
              const view = { volume, camera, stepLength: diagonal / steps, optics: { ...optics!, opacityFactor: 8 } };
              scene.layers[0].skipping = true;
              const skipped = drawPicture(scene, view);
              scene.layers[0].skipping = false;
              expect(
                comparePictures(skipped, drawPicture(scene, view)).worst,
                `theta ${theta}, ${steps} steps`,
              ).to.be.at.most(1);
              if (radius > 0.1 && steps > 100) expect(Math.max(...skipped)).to.be.above(60);
            }
          }
        }
      }));
  }

  it('wants to be prepared, and takes turns with cartesian ones', () =>
    withScene({}, async (scene) => {
      const polar = viewOf({ name: '', scene: 'five sweeps' });
      expect(() => scene.setVolume(polar.volume)).to.throw(TypeError, 'prepare()');
      await scene.prepare(polar.volume);
      const volume = syntheticVolume({ dimensions: [12, 10, 8] });
      const cartesian = {
        volume,
        camera: orbitCamera({ theta: 1, phi: 1, radius: 25 }, [0, 0, 0], 0.6),
        stepLength: 0.3,
      };
      const views = [polar, cartesian, viewOf({ name: '', scene: 'rays and gates that differ' }), cartesian, polar];
      for (const view of views) {
        const { worst } = comparePictures(drawPicture(scene, view), drawReference(view));
        expect(worst).to.be.at.most(2);
      }
    }));
});
