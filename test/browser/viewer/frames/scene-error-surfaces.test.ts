import { expect } from '@esm-bundle/chai';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import { withScene } from '../../../helpers/picture.ts';
import { compareSpared, compareStated, expectMostWithinTwo } from '../../../helpers/stated-error.ts';

/** All of its pixels are compared. */
const size = { width: 108, height: 81 };

/** Where smooth parts are large enough for rays to be spared. */
const large = { width: 144, height: 108 };

describe('the error that a picture of surfaces states', () => {
  it('is within a factor of two of the true one in nine of ten scenes, with fog and without; and rays are spared as in any picture', async function () {
    this.timeout(240_000);
    // Of all 32 it is 31: these take a fifth of the time.
    const scenes = errorScenes().filter((_, i) => i % 5 === 0);
    const ratios: number[] = [];
    await withScene({}, async (gpu) => {
      for (const [i, scene] of scenes.entries()) {
        const { volume, transferFunction } = scene;
        // Two surfaces among the values that show, the first translucent.
        const [low, high] = [transferFunction[0], transferFunction.at(-1)!].map(({ value }) =>
          Math.min(volume.range[1], Math.max(volume.range[0], value)),
        );
        const at = (share: number): number => low + share * (high - low);
        await gpu.setAppearance({
          style: {
            surfaces: [
              { value: at(0.35), color: [1, 0.6, 0.4], opacity: 0.4 },
              { value: at(0.7), color: [0.8, 0.9, 1], opacity: 1 },
            ],
            ...(i % 2 === 0 && { clear: true }),
          },
        });
        // All pixels: those few at which a ray passes a surface here and not there make most of the error.
        ratios.push(compareStated(gpu, scene, { size, times: 10 }));
      }
      expect(compareSpared(gpu, scenes[0], large)).to.be.within(0.01, 1.5);
    });
    expectMostWithinTwo(ratios);
  });
});
