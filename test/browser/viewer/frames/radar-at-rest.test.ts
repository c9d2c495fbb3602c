// A radar in the picture at rest: no gate is lost from any side, so that none comes and goes as the camera turns.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { allSubsteps } from '../../../../src/optics/cells/substeps.ts';
import type { PictureError } from '../../../../src/quality/error-estimate.ts';
import { autoSteps, stepLengthOf } from '../../../../src/quality/steps.ts';
import { beamToLocal } from '../../../../src/radar/polar-geometry.ts';
import { QualityControl } from '../../../../src/viewer/frames/quality-control.ts';
import type { PolarVolume } from '../../../../src/volume/volume.ts';
import type { VolumeScene } from '../../../../src/x3d/scene.ts';
import { measureThing, measureTrueError } from '../../../accuracy/compare-shown.ts';
import { findPixel } from '../../../accuracy/full-rays.ts';
import { casesIn, takesAll } from '../../../helpers/cases.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { settle } from '../../../helpers/at-rest.ts';
import type { CoveredError } from '../../../helpers/covered-error.ts';
import { shareScene } from '../../../helpers/picture.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';
import { evenAzimuths, radarVolume } from '../../../helpers/synthetic-radar.ts';
import { probe } from '../../../helpers/probe.ts';

/** About a pixel for a gate. */
const size = 128;
const picture = { width: size, height: size };

/** What full rays show with 8/255 or more is there with three quarters of it at least. */
const [minKept, minContrast] = [0.75, 8];

const elevations = [2, 4, 6, 8, 10, 12, 14];
const [gates, gateLength] = [44, 150];
const random = randomNumbers(12);
/** Single gates, none next to another. */
const specks = Array.from({ length: 40 }, (_, i) => ({
  sweep: 1 + (i % 5),
  azimuth: 9 * i + 1.5 + 3 * Math.floor(random() * 2),
  gate: 16 + Math.floor(random() * 24),
}));
const optics = {
  transferFunction: parseTransferFunction('10 #468 0.5%, 15 #468 0.5%, 62 #fa6 90%', [-32, 95]),
  referenceLength: gateLength,
  opacityFactor: 1,
  lightFactor: 1,
};

/** @param around - what is stored everywhere but in the specks; 0 for no data @param shown - the specks */
function radarOf(around: number, shown: typeof specks): PolarVolume {
  const sweeps = elevations.map((elevation, sweep) => ({
    elevation,
    gates,
    gateLength,
    firstGate: gateLength / 2,
    azimuths: evenAzimuths(120),
    stored: (azimuth: number, gate: number): number =>
      shown.some((speck) => speck.sweep === sweep && speck.gate === gate && Math.abs(speck.azimuth - azimuth) < 0.1)
        ? 190
        : around,
  }));
  return radarVolume({ sweeps });
}

async function show(scene: VolumeScene, volume: PolarVolume, camera: Camera): Promise<void> {
  changePlan(scene, { picture: { width: size, height: size } });
  await scene.prepare(volume, optics);
  scene.setVolume(volume);
  await scene.setAppearance({ optics });
  changePlan(scene, { camera });
}

/** Rays of eight steps a voxel, each with up to eight substeps, of a picture that has been drawn. */
function castFull(scene: VolumeScene, { grid }: PolarVolume): Float32Array {
  changePlan(scene, { substeps: allSubsteps });
  return probe(scene, [stepLengthOf(grid, 8 * autoSteps(grid))], { stride: 1, first: [0, 0], ...picture }, picture)![0];
}

interface SeenRadar {
  readonly stated: PictureError;
  readonly error: CoveredError;
  /** Of each speck that full rays show, the share that is left. */
  readonly kept: ReadonlyMap<number, number>;
}

async function look(
  scene: VolumeScene,
  [volume, bareVolume]: readonly [PolarVolume, PolarVolume],
  camera: Camera,
): Promise<SeenRadar> {
  await show(scene, volume, camera);
  const control = new QualityControl();
  await settle(control, scene, { volume, size: picture });
  const shown = scene.readPicture().data;
  const full = castFull(scene, volume);
  await show(scene, bareVolume, camera);
  drawAt(scene, stepLengthOf(volume.grid, 10));
  const bare = castFull(scene, bareVolume);
  const kept = new Map<number, number>();
  specks.forEach(({ sweep, azimuth, gate }, i) => {
    const place = beamToLocal(
      { range: (gate + 0.5) * gateLength, azimuth, elevation: elevations[sweep] },
      volume.grid.earthRadius,
    );
    const thing = measureThing({ shown, full, bare, size }, findPixel(camera, place, size), 1.5);
    if (thing && thing.contrast >= minContrast) kept.set(i, thing.kept);
  });
  return { stated: control.error!, error: measureTrueError(shown, full), kept };
}

for (const [version, angles] of [
  [2, takesAll ? 5 : 1],
  [1, takesAll ? 2 : 1],
] as const) {
  describe(`a radar in the picture at rest in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const [name, around] of casesIn(
      version,
      [
        ['gates in a veil', 84],
        ['gates in empty air', 0],
      ] as const,
      ([name]) => name === 'gates in empty air',
    )) {
      it(`${name}: none is lost, and the stated error holds`, async function () {
        this.timeout(120_000);
        const volumes = [radarOf(around, specks), radarOf(around, [])] as const;
        const seen: SeenRadar[] = [];
        for (let angle = 0; angle < angles; angle++) {
          const camera = orbitCamera(
            { theta: 0.6 + angle / 57.3, phi: 0.9 + (0.3 * angle) / 57.3, radius: 28_000 },
            [0, 0, 800],
            0.42,
          );
          seen.push(await look(scene(), volumes, camera));
        }
        const kept = seen.flatMap((one) => [...one.kept.values()]);
        const ratios = seen.map(({ stated, error }) => stated.rms / error.rms);
        console.log(
          `${name}: ${kept.length} gates seen, at least ${(100 * Math.min(...kept)).toFixed(0)} % kept; stated / true ${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)}`,
        );
        expect(kept.length, 'gates that full rays show').to.be.at.least(35 * angles);
        expect(
          kept.filter((share) => share < minKept),
          'dimmed',
        ).to.deep.equal([]);
        // Edges of gates in empty air are jumps: there up to three times as much is said.
        expect(
          ratios.filter((ratio) => ratio < 0.5),
          'understated',
        ).to.deep.equal([]);
        expect(
          seen.filter(({ stated, error }) => stated.max! < error.max),
          'the largest error',
        ).to.deep.equal([]);
      });
    }
  });
}
