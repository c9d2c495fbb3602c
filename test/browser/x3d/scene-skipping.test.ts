import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { outlinePatches } from '../../../src/optics/transfer/patches.ts';
import type { Patch } from '../../../src/optics/transfer/patches.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { casesIn } from '../../helpers/cases.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { comparePictures, withScene } from '../../helpers/picture.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';
import { readPixels } from '../../helpers/read-pixels.ts';

const peak: TransferFunction = [
  { value: 0.3, color: [1, 0.3, 0.1], opacity: 0 },
  { value: 0.35, color: [1, 0.3, 0.1], opacity: 0.5 },
  { value: 0.4, color: [1, 0.3, 0.1], opacity: 0 },
  { value: 0.8, color: [1, 1, 1], opacity: 0 },
  { value: 0.8, color: [1, 1, 1], opacity: 0.6 },
];

const shell = (x: number, y: number, z: number): number =>
  Math.exp(-30 * (Math.hypot(x - 0.5, y - 0.5, z - 0.5) - 0.3) ** 2);
const specks = (share = 0.002): (() => number) => {
  const random = randomNumbers(40);
  return () => (random() < share ? 1 : 0);
};

const volumes: Record<string, () => Volume> = {
  'a shell': () => syntheticVolume({ dimensions: [60, 44, 52], field: shell }),
  specks: () => syntheticVolume({ dimensions: [48, 48, 48], kind: 'uint16', field: specks() }),
  'a thin one': () => syntheticVolume({ dimensions: [70, 50, 3], kind: 'float32', field: shell, spacing: [1, 1, 4] }),
};

/** What is flat shows nothing, whatever its value. */
const patches: readonly Patch[] = [
  { kind: 'box', values: [-0.1, 1.1], gradients: [0.1, 0.3], color: [1, 0.6, 0.2], opacity: 0.5 },
  { kind: 'gaussian', value: 0.5, gradient: 0.4, widths: [0.3, 0.05], color: [0.4, 0.7, 1], opacity: 0.7 },
];

describe('skipping empty space', () => {
  it('crosses what is too flat for a transfer function of value and gradient, and changes nothing', async () => {
    const volume = syntheticVolume({ dimensions: [48, 44, 52], field: specks(0.0001) });
    const diagonal = longestDiagonal(volume.grid);
    await withScene({}, async (scene) => {
      changePlan(scene, { picture: { width: 48, height: 36 } });
      scene.setVolume(volume);
      await scene.setAppearance({ style: { patches } });
      void scene.setAppearance({
        optics: {
          transferFunction: outlinePatches(patches, volume.range),
          referenceLength: 1,
          opacityFactor: 1,
          lightFactor: 1,
        },
      });
      let brightest = 0;
      for (const [theta, phi, distance] of [
        [0.7, 1.1, 1.5],
        [3, 0.2, 1.6],
        [1.2, 2.4, 0.1],
      ]) {
        changePlan(scene, { camera: orbitCamera({ theta, phi, radius: distance * diagonal }, [0, 0, 0], 0.8) });
        for (const steps of [60, 200]) {
          scene.layers[0].skipping = true;
          drawAt(scene, diagonal / steps);
          const skipped = readPixels(scene);
          scene.layers[0].skipping = false;
          drawAt(scene, diagonal / steps);
          expect(comparePictures(skipped, readPixels(scene)).worst, `theta ${theta}, ${steps} steps`).to.be.at.most(1);
          brightest = Math.max(brightest, ...skipped);
        }
      }
      expect(brightest).to.be.above(60);
      const { cells } = scene.layers[0].whatIsSeen()!;
      const seen = cells.reduce((sum, x) => sum + x, 0);
      expect(seen / cells.length, 'cells in which something may show').to.be.within(0.05, 0.5);
    });
  });

  for (const webgl1 of [false, true]) {
    for (const [name, make] of casesIn(webgl1 ? 1 : 2, Object.entries(volumes), ([one]) => one === 'specks')) {
      it(`changes nothing in the picture of ${name} in WebGL ${webgl1 ? 1 : 2}, for long and short steps, from all sides and inside`, async () => {
        const volume = make();
        const diagonal = longestDiagonal(volume.grid);
        await withScene({ webgl1 }, (scene) => {
          changePlan(scene, { picture: { width: 48, height: 36 } });
          scene.setVolume(volume);
          void scene.setAppearance({
            optics: { transferFunction: peak, referenceLength: 1, opacityFactor: 1, lightFactor: 1 },
          });
          let brightest = 0;
          for (const [theta, phi, distance] of [
            [0, Math.PI / 2, 1.4],
            [0.7, 1.1, 1.5],
            [3, 0, 1.6],
            [1.2, 2.4, 0.1],
            [5, 1.5, 1e-4],
          ]) {
            changePlan(scene, { camera: orbitCamera({ theta, phi, radius: distance * diagonal }, [0, 0, 0], 0.8) });
            for (const steps of [5, 60, 240]) {
              scene.layers[0].skipping = true;
              drawAt(scene, diagonal / steps);
              const skipped = readPixels(scene);
              scene.layers[0].skipping = false;
              drawAt(scene, diagonal / steps);
              const { worst } = comparePictures(skipped, readPixels(scene));
              expect(worst, `theta ${theta}, ${steps} steps`).to.be.at.most(1);
              brightest = Math.max(brightest, ...skipped);
            }
          }
          expect(brightest).to.be.above(60);
        });
      });
    }
  }
});
