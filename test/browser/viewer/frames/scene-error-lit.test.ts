import { expect } from '@esm-bundle/chai';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import { withScene } from '../../../helpers/picture.ts';
import { compareSpared, compareStated, expectMostWithinTwo } from '../../../helpers/stated-error.ts';

const size = { width: 96, height: 72 };

/** Where smooth parts are large enough for rays to be spared. */
const large = { width: 144, height: 108 };

/** One pixel in so many, across and down, gets full rays: as in scene-error.test.ts. */
const every = 4;

describe('the error that a lit picture states', () => {
  it('is within a factor of two of the true one in nine of ten scenes; and rays are spared as in any picture', async function () {
    this.timeout(180_000);
    // Of all 32 it is 30: these take half the time.
    const scenes = errorScenes().filter((_, i) => i % 4 === 0 || i % 4 === 3);
    let ratios: number[] = [];
    await withScene({}, async (gpu) => {
      await gpu.setAppearance({ style: { lit: true } });
      // The GPU draws what the twin does: see scene-lit.test.ts.
      const lattice = { stride: every, first: [2, 3], width: size.width / every, height: size.height / every } as const;
      ratios = scenes.map((scene) => compareStated(gpu, scene, { size, lattice, times: 16 }));
      expect(compareSpared(gpu, scenes[0], large)).to.be.within(0.01, 1);
    });
    expect(ratios.length).to.equal(16);
    expectMostWithinTwo(ratios);
  });

  it('is within a factor of two with ambient occlusion too', async function () {
    this.timeout(180_000);
    const scenes = errorScenes().filter((_, i) => i % 4 === 1);
    let ratios: number[] = [];
    await withScene({}, async (gpu) => {
      await gpu.setAppearance({ style: { lit: 'ambient-occlusion' } });
      // The GPU draws what the twin does: see scene-ambient.test.ts.
      const lattice = { stride: every, first: [2, 3], width: size.width / every, height: size.height / every } as const;
      ratios = scenes.map((scene) => compareStated(gpu, scene, { size, lattice, times: 16 }));
    });
    expect(ratios.length).to.equal(8);
    expectMostWithinTwo(ratios);
  });
});
