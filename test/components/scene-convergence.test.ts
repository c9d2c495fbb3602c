import { expect } from '@esm-bundle/chai';
import { describeOrder, minOrder, measureOrders } from '../accuracy/orders.ts';
import type { DrawPicture } from '../accuracy/orders.ts';
import { withScene } from '../helpers/picture.ts';
import type { VolumeScene } from '../../src/x3d/scene.ts';

/** Pictures in floats: errors far below 1/255 are to be seen. */
function drawOn(scene: VolumeScene): DrawPicture {
  return ({ volume, transferFunction, referenceLength, camera, stepLength, maxSubsteps, width, height }) => {
    scene.resize(width, height);
    scene.setVolume(volume);
    scene.setOptics({ transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 });
    scene.setCamera(camera);
    scene.setMaxSubsteps(maxSubsteps);
    scene.draw(stepLength);
    const [upsideDown] = scene.probe([stepLength], { stride: 1, first: 0, width, height }, { width, height })!;
    const pixels = new Float32Array(upsideDown.length);
    for (let row = 0; row < height; row++) {
      pixels.set(upsideDown.subarray(row * width * 4, (row + 1) * width * 4), (height - 1 - row) * width * 4);
    }
    return pixels;
  };
}

for (const version of [2, 1] as const) {
  describe(`the picture in WebGL ${version} converges`, () => {
    it('with step length, grid spacing and pixel size, as theory has it', () => withScene({ webgl1: version === 1 }, (scene) => {
      const rows = measureOrders(drawOn(scene), `WebGL ${version}`);
      for (const row of rows) console.log(describeOrder(row));
      for (const row of rows) {
        const { study, transferFunction, order } = row;
        expect(order, `${study}, ${transferFunction}`).to.be.at.least(minOrder(row));
      }
    }));
  });
}
