import { expect } from '@esm-bundle/chai';
import { allSubsteps } from '../../../src/optics/cells/substeps.ts';
import { describeOrder, fitOrder, measureOrders, minOrder } from '../../accuracy/orders.ts';
import type { DrawPicture } from '../../accuracy/orders.ts';
import { casesOf } from '../../helpers/cases.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { withScene } from '../../helpers/picture.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { probe } from '../../helpers/probe.ts';

/** World length of steps that cost little: a fifth of the cube's edge. */
const fewSteps = 0.2;

/** Pictures in floats: errors far below 1/255 are to be seen. */
function drawOn(scene: VolumeScene): DrawPicture {
  return ({ volume, transferFunction, referenceLength, camera, stepLength, maxSubsteps, width, height }) => {
    changePlan(scene, { picture: { width, height } });
    scene.setVolume(volume);
    void scene.setAppearance({ optics: { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 } });
    changePlan(scene, { camera });
    changePlan(scene, { substeps: { ...allSubsteps, max: maxSubsteps } });
    drawAt(scene, fewSteps); // Only a view that was drawn can be probed.
    const [upsideDown] = probe(scene, [stepLength], { stride: 1, first: [0, 0], width, height }, { width, height })!;
    const pixels = new Float32Array(upsideDown.length);
    for (let row = 0; row < height; row++) {
      pixels.set(upsideDown.subarray(row * width * 4, (row + 1) * width * 4), (height - 1 - row) * width * 4);
    }
    return pixels;
  };
}

// In one file with the pictures: what all are held against takes long, and is worked out once.
describe('the reference converges', () => {
  it('with step length, grid spacing and pixel size, as theory has it', () => {
    const rows = measureOrders();
    for (const row of rows) console.log(describeOrder(row));
    expect(rows.length).to.equal(8);
    for (const row of rows) {
      const { study, transferFunction, order, errors } = row;
      expect(order, `${study}, ${transferFunction}`).to.be.at.least(minOrder(row));
      // From what one sees to what nobody does.
      expect(errors[0], `${study}, ${transferFunction}`).to.be.above(0.05 / 255);
      expect(errors.at(-1), `${study}, ${transferFunction}`).to.be.below(errors[0] / 3);
    }
  });

  it('by orders that are what they are of errors with a known order', () => {
    expect(fitOrder([10, 20, 40], [1, 0.25, 0.0625])).to.be.closeTo(2, 1e-12);
    expect(fitOrder([3, 30], [5, 0.5])).to.be.closeTo(1, 1e-12);
  });
});

for (const version of casesOf([2, 1] as const, (one) => one === 2)) {
  describe(`the picture in WebGL ${version} converges`, () => {
    it('with step length, grid spacing and pixel size, as theory has it', () =>
      withScene({ webgl1: version === 1 }, (scene) => {
        const rows = measureOrders(drawOn(scene), `WebGL ${version}`);
        for (const row of rows) console.log(describeOrder(row));
        for (const row of rows) {
          const { study, transferFunction, order } = row;
          expect(order, `${study}, ${transferFunction}`).to.be.at.least(minOrder(row));
        }
      }));
  });
}
