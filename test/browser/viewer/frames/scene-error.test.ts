import { expect } from '@esm-bundle/chai';
import { measureError } from '../../../../src/viewer/frames/measure-quality.ts';
import { projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { castSceneRay, opticsOf } from '../../../../src/optics/reference.ts';
import { allSubsteps } from '../../../../src/optics/cells/substeps.ts';
import { maxSubsteps } from '../../../../src/optics/rays/segment.ts';
import { stepLengthOf } from '../../../../src/quality/steps.ts';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import type { ErrorScene } from '../../../accuracy/error-scenes.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { withScene } from '../../../helpers/picture.ts';
import { readPixels } from '../../../helpers/read-pixels.ts';

/** The picture whose error is stated, by probing it. */
const size = { width: 96, height: 72 };

/** The same view in few pixels: the reference takes 16 times the samples in float64. */
const [width, height] = [24, 18];

/** The same over the pixels that the volume covers, of the canvas and the reference at 16 times the samples, 1/255: root mean square. */
function trueError(scene: ErrorScene, pixels: Uint8ClampedArray): number {
  const { volume, transferFunction, camera, steps } = scene;
  const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, width / height, 1, 2))!;
  const reference = {
    ...volume,
    transferFunction,
    referenceLength: 1,
    opacityFactor: 1,
    lightFactor: 1,
    stepLength: stepLengthOf(volume.grid, steps * 16),
  };
  const optics = opticsOf(reference);
  let [sum, count] = [0, 0];
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const ray = rayThrough(rays, ((column + 0.5) / width) * 2 - 1, 1 - ((row + 0.5) / height) * 2);
      const color = castSceneRay(reference, rays, ray, optics);
      if (color[3] === 0 && pixels[(row * width + column) * 4 + 3] === 0) continue;
      color.forEach((x, c) => {
        sum += (pixels[(row * width + column) * 4 + c] - x * 255) ** 2;
        count++;
      });
    }
  }
  return Math.sqrt(sum / count);
}

describe('the error that a picture states', () => {
  it('is within a factor of two of the true one in nine of ten scenes', async function () {
    this.timeout(180_000);
    const scenes = errorScenes();
    const ratios: number[] = [];
    await withScene({}, (gpu) => {
      for (const scene of scenes) {
        changePlan(gpu, { picture: { width, height } });
        gpu.setVolume(scene.volume);
        void gpu.setAppearance({
          optics: {
            transferFunction: scene.transferFunction,
            referenceLength: 1,
            opacityFactor: 1,
            lightFactor: 1,
          },
        });
        changePlan(gpu, { camera: scene.camera });
        changePlan(gpu, { substeps: allSubsteps });
        drawAt(gpu, stepLengthOf(scene.volume.grid, scene.steps));
        const pixels = readPixels(gpu);
        const estimate = measureError(gpu, scene.volume.grid, { steps: scene.steps, substeps: maxSubsteps }, size);
        expect(estimate, scene.name).to.not.equal(null);
        const known = trueError(scene, pixels);
        ratios.push(estimate!.rms / known);
        console.log(
          `${scene.name}: stated ${estimate!.rms.toFixed(2)}, true ${known.toFixed(2)}, ratio ${ratios.at(-1)!.toFixed(2)}, order ${estimate!.order.toFixed(2)}`,
        );
      }
    });
    const good = ratios.filter((ratio) => ratio > 0.5 && ratio < 2).length;
    expect(scenes.length).to.be.at.least(30);
    expect(good / scenes.length, `${good} of ${scenes.length}`).to.be.at.least(0.9);
  });
});
