import { expect } from '@esm-bundle/chai';
import { maxSubsteps } from '../../src/optics/segment.ts';
import { allSubsteps } from '../../src/optics/substeps.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import { measureError } from '../../src/viewer/measure-quality.ts';
import { errorScenes } from '../accuracy/error-scenes.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import { comparePictures, withScene } from '../helpers/picture.ts';
import { readPixels } from '../helpers/read-pixels.ts';

const [width, height] = [144, 108];

/** Of 8 bits, which the probes' floats do not have: RMS, 1/255. */
const rounding = 1 / Math.sqrt(12);

describe('the error that a lit picture states', () => {
  it('is within a factor of two of the true one in nine of ten scenes; and rays are spared as in any picture', async function () {
    this.timeout(180_000);
    // Of all 32 it is 30: these take half the time.
    const scenes = errorScenes().filter((_, i) => i % 4 === 0 || i % 4 === 3);
    const ratios: number[] = [];
    await withScene({}, async (gpu) => {
      await gpu.setStyle({ lit: true });
      gpu.resize(width, height);
      for (const { name, volume, transferFunction, camera, steps } of scenes) {
        gpu.setVolume(volume);
        void gpu.setOptics({ transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 });
        gpu.setCamera(camera);
        gpu.setSubsteps(allSubsteps);
        gpu.draw(stepLengthOf(volume.grid, steps));
        const stated = measureError(gpu, volume.grid, { steps, substeps: maxSubsteps })!;
        // The twin takes too long at 16 times the steps, and is what the GPU draws: see scene-lit.test.ts.
        const lattice = { stride: 4, first: [1, 2], width: width / 4, height: height / 4 } as const;
        const [shown, limit] = gpu.probe([steps, 16 * steps].map((n) => stepLengthOf(volume.grid, n)), lattice, { width, height })!;
        const known = Math.hypot(compareCovered(shown, limit, 255).rms, rounding);
        ratios.push(stated.rms / known);
        console.log(`lit ${name}: stated ${stated.rms.toFixed(2)}, true ${known.toFixed(2)}, ratio ${ratios.at(-1)!.toFixed(2)}, order ${stated.order.toFixed(2)}`);
      }
      const [smooth] = scenes;
      gpu.setVolume(smooth.volume);
      void gpu.setOptics({ transferFunction: smooth.transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 });
      gpu.setCamera(smooth.camera);
      gpu.draw(stepLengthOf(smooth.volume.grid, 60));
      const all = readPixels(gpu);
      expect(gpu.adaptive).to.equal(true);
      gpu.setMaxCurvature(6);
      gpu.draw(stepLengthOf(smooth.volume.grid, 60));
      const { rmse } = comparePictures(readPixels(gpu), all);
      console.log(`lit, adaptive: rmse ${rmse.toFixed(2)}`);
      expect(rmse).to.be.within(0.01, 1);
    });
    const good = ratios.filter((ratio) => ratio > 0.5 && ratio < 2).length;
    expect(scenes.length).to.equal(16);
    expect(good / scenes.length, `${good} of ${scenes.length}`).to.be.at.least(0.9);
  });
});
