import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../src/optics/rays/camera.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { forecastSampling } from '../../../src/quality/adaptive-sampling.ts';
import { atOnce } from '../../../src/core/waiting.ts';
import { stepLengthOf } from '../../../src/quality/steps.ts';
import { boundingSphere } from '../../../src/volume/grid.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { errorScenes } from '../../accuracy/error-scenes.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { comparePictures, withScene } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';
import { shapesAmong } from '../../helpers/shapes-among.ts';
import { evenAzimuths, radarVolume } from '../../helpers/synthetic-radar.ts';

/** Odd both ways: lattices end beyond the last pixel. */
const size = { width: 151, height: 113 };

interface Shown {
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly camera: Camera;
  readonly referenceLength: number;
}

const shells: Shown = { ...errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!, referenceLength: 1 };

const storm: Shown = (() => {
  const stored = (azimuth: number, gate: number): number =>
    Math.round(130 + 60 * Math.sin((azimuth * Math.PI) / 60) + 50 * Math.sin(gate / 9));
  const volume = radarVolume({
    sweeps: [0.5, 2, 5, 10, 20].map((elevation) => ({ elevation, gates: 60, azimuths: evenAzimuths(72), stored })),
  });
  const { center, radius } = boundingSphere(volume.grid);
  return {
    volume,
    referenceLength: radius / 20,
    transferFunction: [
      { value: 0, color: [0.1, 0.3, 1], opacity: 0 },
      { value: 30, color: [0.1, 0.8, 0.3], opacity: 0.1 },
      { value: 70, color: [1, 0.4, 0.1], opacity: 0.4 },
    ],
    camera: orbitCamera({ theta: 0.6, phi: 1, radius: 2.2 * radius }, center, 0.8),
  };
})();

/** Draw with all rays, and then with as few as leave an error. */
interface Drawn {
  readonly draw: (maxCurvature: number) => Uint8ClampedArray;
  readonly scene: VolumeScene;
}

async function withShapes(
  { volume, transferFunction, camera, referenceLength }: Shown,
  options: { webgl1: boolean; children: string },
  use: (drawn: Drawn) => void,
): Promise<void> {
  await withScene(options, async (scene) => {
    changePlan(scene, { picture: size });
    await scene.prepare(volume);
    scene.setVolume(volume);
    await scene.setAppearance({ optics: { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 } });
    changePlan(scene, { camera });
    use({
      scene,
      draw: (maxCurvature) => {
        changePlan(scene, { maxCurvature, edgeCurvature: Infinity });
        drawAt(scene, stepLengthOf(volume.grid, 60));
        return readPixels(scene);
      },
    });
  });
}

/** The share of pixels that differ by more than `most` in any channel. */
function shareBeyond(a: Uint8ClampedArray, b: Uint8ClampedArray, max: number): number {
  let beyond = 0;
  for (let i = 0; i < a.length; i += 4) if ([0, 1, 2, 3].some((c) => Math.abs(a[i + c] - b[i + c]) > max)) beyond++;
  return beyond / (a.length / 4);
}

/** Tested for: their error, and what docs/guide/quality.md promises of it. */
const [maxError, outliers] = [1, 8];

/** Each kind of shape once; those of all sorts with each kind of volume and of WebGL. */
const cases = [
  { name: 'cartesian', shown: shells, webgl1: false, kinds: Object.keys(shapesAmong(shells.volume.grid)) },
  { name: 'cartesian', shown: shells, webgl1: true, kinds: ['several of them'] },
  { name: 'polar', shown: storm, webgl1: false, kinds: ['several of them'] },
  { name: 'polar', shown: storm, webgl1: true, kinds: ['several of them'] },
];

for (const { name, shown, webgl1, kinds } of cases) {
  describe(`adaptive rays among shapes, ${name}, WebGL ${webgl1 ? 1 : 2}`, function () {
    this.timeout(120_000);

    for (const kind of kinds) {
      const children = shapesAmong(shown.volume.grid)[kind];
      it(`are off by no more than was predicted: ${kind}`, () =>
        withShapes(shown, { webgl1, children }, ({ scene, draw }) => {
          const all = draw(0);
          expect(scene.adaptive).to.equal(true);
          const volumePicture = scene.readVolume()!;
          const jumps = volumePicture.startJumps(1, false)();
          expect(
            Array.from(jumps.data).some((x, i) => i % 4 === 0 && x > 0),
            'shapes end rays',
          ).to.equal(true);
          const [outcomes] = atOnce(forecastSampling(scene.readPicture(), [1], volumePicture));
          const foretold = outcomes.filter(({ error }) => error <= maxError / 2).at(-1)!;
          const adaptive = draw(foretold.maxCurvature);
          const { rmse } = comparePictures(adaptive, all);
          expect(rmse, 'rays are spared').to.be.above(0.03);
          expect(rmse, `curvature ${foretold.maxCurvature}`).to.be.within(
            foretold.error / 2 - 0.2,
            2 * foretold.error + 0.2,
          );
          expect(shareBeyond(adaptive, all, outliers * maxError), 'pixels far off').to.be.at.most(0.001);
          expect(comparePictures(draw(0), all).worst, 'afterwards').to.equal(0);
        }));
    }
  });
}

describe('thin lines across a volume', function () {
  this.timeout(120_000);
  const lines = shapesAmong(shells.volume.grid)['thin lines'];

  it('end the same rays as with all rays even where all other pixels are interpolated: they have no gaps, and no halos', async () => {
    const without: ArrayLike<number>[] = [];
    await withShapes(shells, { webgl1: false, children: '' }, ({ scene, draw }) => {
      for (const maxCurvature of [0, 256]) {
        draw(maxCurvature);
        without.push(scene.readPicture().data);
      }
    });
    const [all, adaptive] = without;
    await withShapes(shells, { webgl1: false, children: lines }, ({ scene, draw }) => {
      const [allLines, adaptiveLines] = [0, 256].map((maxCurvature) => {
        draw(maxCurvature);
        return scene.readVolume()!.picture.data;
      });
      const isCut = (pixel: number): boolean =>
        [0, 1, 2, 3].some((c) => Math.abs(all[4 * pixel + c] - allLines[4 * pixel + c]) > 3);
      expect(Array.from({ length: all.length / 4 }, (_, pixel) => pixel).filter(isCut).length).to.be.above(50);
      expect(comparePictures(adaptiveLines, allLines, (pixel) => !isCut(pixel)).worst, 'the lines').to.be.at.most(2);
      expect(comparePictures(adaptiveLines, allLines).worst, 'what is beside them').to.be.at.most(
        comparePictures(adaptive, all).worst + 1,
      );
    });
  });
});
