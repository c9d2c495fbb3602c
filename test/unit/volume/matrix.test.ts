import { expect } from '@esm-bundle/chai';
import { determinant } from '../../../src/volume/determinant.ts';
import {
  identity,
  invertAffine,
  multiply,
  scaleAndTranslate,
  transformDirection,
  transformPoint,
} from '../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../src/volume/matrix.ts';
import { obliqueAffine, randomNumbers } from '../../helpers/synthetic.ts';

/** Largest difference of m * p round trip, relative to what the coordinates are made of. */
function roundTripError(m: Matrix4, p: Vector3): number {
  const back = transformPoint(invertAffine(m)!, transformPoint(m, p));
  return Math.max(...back.map((x, i) => Math.abs(x - p[i])));
}

describe('matrices', () => {
  it('invert affine maps at spacings from 1e-9 to 1e9, sheared ones too', () => {
    const random = randomNumbers(1);
    for (let exponent = -9; exponent <= 9; exponent += 3) {
      for (const shape of [
        [1, 1, 1],
        [1, -3, 0.01],
        [-7, 0.5, 20],
      ]) {
        const spacing = shape.map((s) => s * 10 ** exponent) as unknown as Vector3;
        const m = obliqueAffine(random, spacing, [spacing[0] * 90, spacing[1] * -40, spacing[2] * 7]);
        // A hundred voxels to and fro, with a condition below 1e5 between axes: 1e-16 * 100 * 1e5.
        expect(roundTripError(m, [99, -3, 55]), `spacing ${spacing.join(' ')}`).to.be.below(1e-9);
      }
    }
  });

  it('invert to the closed form for scales', () => {
    const inverse = invertAffine(scaleAndTranslate([2, -4, 0.5], [10, 20, 30]))!;
    const unsigned = inverse.map((x) => x + 0); // -0 to 0
    expect(unsigned).to.deep.equal([0.5, 0, 0, -5, 0, -0.25, 0, 5, 0, 0, 2, -60, 0, 0, 0, 1]);
  });

  it('know that flat maps have no inverse, whatever their unit', () => {
    for (const unit of [1e-9, 1, 1e9]) {
      const twoEqualColumns = [1, 1, 0, 0, 2, 2, 0, 0, 3, 3, 1, 0].map((x) => x * unit).concat(0, 0, 0, 1);
      expect(invertAffine(twoEqualColumns)).to.equal(null);
      expect(invertAffine(scaleAndTranslate([unit, 0, unit], [0, 0, 0]))).to.equal(null);
    }
    expect(invertAffine(scaleAndTranslate([1, NaN, 1], [0, 0, 0]))).to.equal(null);
    expect(invertAffine(scaleAndTranslate([1, Infinity, 1], [0, 0, 0]))).to.equal(null);
  });

  it('multiply so that the right one comes first', () => {
    const scaleFirst = multiply(scaleAndTranslate([1, 1, 1], [1, 2, 3]), scaleAndTranslate([2, 2, 2], [0, 0, 0]));
    expect(transformPoint(scaleFirst, [1, 1, 1])).to.deep.equal([3, 4, 5]);
    expect(transformDirection(scaleFirst, [1, 1, 1])).to.deep.equal([2, 2, 2]);
    expect(multiply(identity, scaleFirst)).to.deep.equal([...scaleFirst]);
  });

  it('have the determinant of their volume, its sign being their handedness', () => {
    expect(determinant(scaleAndTranslate([2, 3, 4], [9, 9, 9]))).to.equal(24);
    expect(determinant(scaleAndTranslate([-2, 3, 4], [9, 9, 9]))).to.equal(-24);
    const sheared = [1, 5, -2, 0, 0, 1, 7, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    expect(determinant(sheared)).to.equal(1);
  });
});
