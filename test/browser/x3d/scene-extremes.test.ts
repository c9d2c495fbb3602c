import { expect } from '@esm-bundle/chai';
import { describe as describeDevice } from '../../../src/renderer/probes/probe-device.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { casesIn } from '../../helpers/cases.ts';
import { extremes, storedExtremes } from '../../helpers/extremes.ts';
import { changePlan } from '../../helpers/change-plan.ts';
import type { Extreme } from '../../helpers/extremes.ts';
import {
  comparePictures,
  drawPicture,
  drawReference,
  height,
  shareScene,
  walksIn,
  width,
  walksOf,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';
import { probe } from '../../helpers/probe.ts';

const pictureSize = [width, height] as const;

/** The picture that was just drawn once more, in floats, which can hold NaN and infinity. Top row first, 0..255. */
function redrawInFloats(scene: VolumeScene, { stepLength, size: [width, height] = pictureSize }: View): Float32Array {
  const [upsideDown] = probe(scene, [stepLength], { stride: 1, first: [0, 0], width, height }, { width, height })!;
  const pixels = new Float32Array(upsideDown.length);
  for (let row = 0; row < height; row++) {
    pixels.set(upsideDown.subarray(row * width * 4, (row + 1) * width * 4), (height - 1 - row) * width * 4);
  }
  return pixels.map((x) => x * 255);
}

/** The reference is slow at very many steps; what it converges to is as good there. */
function referenceOf({ same }: Extreme, view: View): Float64Array {
  const steps =
    Math.hypot(...view.volume.grid.spacing.map((s, axis) => s * view.volume.grid.dimensions[axis])) / view.stepLength;
  return drawReference(
    steps > 5000 ? { ...(same ?? { ...view, stepLength: view.stepLength * 40 }), maxSubsteps: view.maxSubsteps } : view,
  );
}

const expectationOf = remember((one: Extreme) =>
  walksOf(one.view, extremes.indexOf(one)).map((view) => ({ view, expected: referenceOf(one, view) })),
);

for (const version of [2, 1] as const) {
  describe(`the picture in WebGL ${version} at the extremes`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const [i, one] of casesIn(version, [...extremes.entries()], ([, { name }]) => storedExtremes.has(name))) {
      it(one.name, () => {
        expect(scene().device.webgl2).to.equal(version === 2);
        const [width, height] = one.view.size ?? pictureSize;
        changePlan(scene(), { picture: { width, height } });
        for (const { view, expected } of walksIn(version, i, expectationOf(one))) {
          const got = drawPicture(scene(), view);
          const floats = redrawInFloats(scene(), view);
          const { worst, rmse } = comparePictures(got, expected);
          const inFloats = comparePictures(floats, expected).worst;
          console.log(
            `WebGL ${version} ${one.name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, in floats ${inFloats.toFixed(3)}, of ${Math.max(...expected).toFixed(0)}`,
          );
          expect(floats.every(Number.isFinite), 'finite numbers only').to.equal(true);
          expect(Math.min(...floats), 'nothing below 0').to.be.at.least(0);
          expect(worst, 'worst pixel').to.be.at.most(2);
          expect(rmse, 'RMSE').to.be.at.most(0.5);
        }
      });
    }
  });
}

describe('a device whose pixels have no highp floats', () => {
  for (const [name, format] of [
    ['says so', { precision: 10, rangeMin: 14, rangeMax: 14 }],
    ['has none', { precision: 0, rangeMin: 0, rangeMax: 0 }],
    ['says nothing', null],
  ] as const) {
    it(`is refused in words: it ${name}`, () => {
      const gl = document.createElement('canvas').getContext('webgl')!;
      Object.defineProperty(gl, 'getShaderPrecisionFormat', { value: () => format });
      expect(() => describeDevice(gl))
        .to.throw(/no highp floats.*another browser or device/)
        .with.property('code', 'webgl/unsupported');
      gl.getExtension('WEBGL_lose_context')?.loseContext();
    });
  }
});
