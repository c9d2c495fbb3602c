// Labels while the picture moves: few steps, and pixels between rays.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import { predictSampling } from '../../../../src/quality/adaptive-sampling.ts';
import { stepLengthOf } from '../../../../src/quality/steps.ts';
import { boundingSphere, longestDiagonal } from '../../../../src/volume/grid.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { labelMap } from '../../../helpers/labels.ts';
import { comparePictures, plainOptics, shareScene } from '../../../helpers/picture.ts';
import { readPixels } from '../../../helpers/read-pixels.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** Odd both ways: lattices end beyond the last pixel. */
const [width, height] = [151, 117];
const maxCurvature = 32;

/** A red ball and a blue one in what is hidden; all of it is dense. */
const volume = syntheticVolume({ dimensions: [40, 36, 32], field: (x) => 0.5 + 0.2 * x });
const balls = [
  [13, 18, 16],
  [28, 18, 16],
] as const;
const map = labelMap(
  [40, 36, 32],
  (...at) => 1 + balls.findIndex((ball) => Math.hypot(...at.map((x, axis) => x - ball[axis])) < 6.5),
  3,
);
const styles = [
  { color: [1, 1, 1], opacityFactor: 0 },
  { color: [1, 0, 0], opacityFactor: 1 },
  { color: [0, 0, 1], opacityFactor: 1 },
] as const;
const white = [
  { value: 0, color: [1, 1, 1], opacity: 0.12 },
  { value: 1, color: [1, 1, 1], opacity: 0.2 },
] as const;

describe('labels in motion', () => {
  const scene = shareScene({});
  const draw = (steps: number, curvature: number): Uint8ClampedArray => {
    changePlan(scene(), { maxCurvature: curvature, edgeCurvature: Infinity });
    drawAt(scene(), stepLengthOf(volume.grid, steps));
    return readPixels(scene());
  };

  before(async () => {
    changePlan(scene(), { picture: { width, height } });
    scene().setVolume(volume);
    await scene().setAppearance({ optics: { ...plainOptics, transferFunction: white } });
    await scene().setLabels({ map, styles });
    changePlan(scene(), {
      camera: orbitCamera(
        { theta: 0.7, phi: 1.1, radius: 1.1 * longestDiagonal(volume.grid) },
        boundingSphere(volume.grid).center,
        0.6,
      ),
    });
  });

  it('are off by what was predicted for pixels between rays', () => {
    const all = draw(40, 0);
    const foretold = predictSampling(scene().readPicture()).find((one) => one.maxCurvature === maxCurvature)!;
    const adaptive = draw(40, maxCurvature);
    const { rmse } = comparePictures(adaptive, all);
    console.log(
      `share ${foretold.share.toFixed(2)}, error foretold ${foretold.error.toFixed(2)}, true ${rmse.toFixed(2)}`,
    );
    expect(scene().adaptive).to.equal(true);
    expect(rmse, 'some pixels have no rays').to.be.within(0.05, 1.3 * foretold.error + 0.2);
  });

  for (const steps of [12, 40]) {
    it(`with ${steps} steps have no colour that no label has, and nothing of what is hidden`, () => {
      const [fine, moved] = [draw(320, 0), draw(steps, maxCurvature)];
      const alphaAt = (column: number, row: number): number =>
        fine[4 * (Math.min(height - 1, Math.max(0, row)) * width + Math.min(width - 1, Math.max(0, column))) + 3];
      let [shown, clear] = [0, 0];
      for (let at = 0; at < width * height; at++) {
        const [red, green, blue, alpha] = moved.subarray(4 * at, 4 * at + 4);
        expect(green, 'green').to.be.at.most(1);
        expect(red + blue, 'as bright as white, or less').to.be.at.most(alpha + 4);
        if (alpha > 60) shown++;
        // Interpolated pixels reach as far as three pixels around a lattice of fours.
        let around = 0;
        for (let y = -8; y <= 8; y += 2)
          for (let x = -8; x <= 8; x += 2)
            around = Math.max(around, alphaAt((at % width) + x, Math.floor(at / width) + y));
        if (around > 0) continue;
        clear++;
        expect(alpha, `pixel ${at % width}, ${Math.floor(at / width)}`).to.be.at.most(1);
      }
      expect(shown, 'pixels of both balls').to.be.above(500);
      expect(clear, 'pixels beside them').to.be.above(3000);
    });
  }
});
