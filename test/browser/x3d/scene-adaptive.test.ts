import { expect } from '@esm-bundle/chai';
import { predictSampling } from '../../../src/quality/adaptive-sampling.ts';
import { stepLengthOf } from '../../../src/quality/steps.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { errorScenes } from '../../accuracy/error-scenes.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { comparePictures, withScene } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';

const { volume, transferFunction, camera } = errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!;

/** Odd both ways: lattices end beyond the last pixel. */
const size = { width: 251, height: 187 };

const maxCurvature = 12;

async function withShells(webgl1: boolean, use: (scene: VolumeScene) => void): Promise<void> {
  await withScene({ webgl1 }, (scene) => {
    changePlan(scene, { picture: size });
    scene.setVolume(volume);
    void scene.setAppearance({ optics: { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 } });
    changePlan(scene, { camera });
    use(scene);
  });
}

function draw(scene: VolumeScene, maxCurvature: number): Uint8ClampedArray {
  changePlan(scene, { maxCurvature, edgeCurvature: Infinity });
  drawAt(scene, stepLengthOf(volume.grid, 60));
  return readPixels(scene);
}

describe('a picture with adaptive ray sampling', () => {
  for (const webgl1 of [false, true]) {
    it(`is off by what was predicted, in WebGL ${webgl1 ? 1 : 2}`, () =>
      withShells(webgl1, (scene) => {
        const all = draw(scene, 0);
        const foretold = predictSampling(scene.readPicture()).find((one) => one.maxCurvature === maxCurvature)!;
        const adaptive = draw(scene, maxCurvature);
        const { rmse, worst } = comparePictures(adaptive, all);
        expect(foretold.share).to.be.below(0.8);
        expect(rmse).to.be.within(0.05, 1.3 * foretold.error + 0.2);
        expect(worst).to.be.below(40);
        expect(comparePictures(draw(scene, 0), all).worst, 'afterwards').to.equal(0);
        expect(
          comparePictures(draw(scene, 0.5), all).worst,
          'where only what is straight is interpolated',
        ).to.be.at.most(2);
      }));
  }

  it('is the same in pieces', () =>
    withShells(false, (scene) => {
      const atOnce = draw(scene, maxCurvature);
      const passes = scene.startGathering({}, size);
      expect(passes.map(({ stride }) => stride)).to.deep.equal([4, 2, 1]);
      for (const pass of passes) {
        for (let firstRow = 0; firstRow < pass.height; firstRow += 30) {
          scene.gather({}, { pass, firstRow, rows: Math.min(30, pass.height - firstRow) }, size);
        }
      }
      scene.drawGathered();
      expect(comparePictures(readPixels(scene), atOnce).worst).to.be.at.most(1);
    }));

  it('gets all its rays where vertex shaders read no textures', async () => {
    const original = WebGL2RenderingContext.prototype.getParameter;
    WebGL2RenderingContext.prototype.getParameter = function (name: number) {
      return name === this.MAX_VERTEX_TEXTURE_IMAGE_UNITS ? 0 : (original.call(this, name) as unknown);
    };
    try {
      await withShells(false, (scene) => {
        expect(comparePictures(draw(scene, 64), draw(scene, 0)).worst).to.equal(0);
        expect(scene.adaptive).to.equal(false);
      });
    } finally {
      WebGL2RenderingContext.prototype.getParameter = original;
    }
  });
});
