import { expect } from '@esm-bundle/chai';
import { interpolate } from '../../../../src/optics/rays/interpolate.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const dimensions: Vector3 = [5, 4, 7];

/** A field that is linear in each of x, y and z alone, in voxel indices: tri-linear interpolation has it exactly. */
const trilinear = (x: number, y: number, z: number): number =>
  3 + 2 * x - y + 0.5 * z + 0.25 * x * y - 0.125 * y * z + x * z + 0.0625 * x * y * z;

function sample(field: (i: number, j: number, k: number) => number): Float32Array<ArrayBuffer> {
  const samples = new Float32Array(5 * 4 * 7);
  for (let at = 0; at < samples.length; at++) samples[at] = field(at % 5, Math.floor(at / 5) % 4, Math.floor(at / 20));
  return samples;
}

/** Unit-cube coordinates of a (fractional) voxel index. */
const unit = (i: number, j: number, k: number): Vector3 => [(i + 0.5) / 5, (j + 0.5) / 4, (k + 0.5) / 7];

describe('interpolation', () => {
  it('is exact for tri-linear fields between voxel centres', () => {
    const samples = sample(trilinear);
    const random = randomNumbers(4);
    for (let n = 0; n < 200; n++) {
      const [i, j, k] = [random() * 4, random() * 3, random() * 6];
      // Samples are whole multiples of 1/16 and exact in float32; what is left is float64 rounding of values below 100.
      expect(interpolate(samples, dimensions, unit(i, j, k))).to.be.closeTo(trilinear(i, j, k), 1e-12);
    }
  });

  it('gives the voxels themselves at their centres, the last ones too', () => {
    const samples = sample((i, j, k) => i + 10 * j + 100 * k);
    for (const [i, j, k] of [
      [0, 0, 0],
      [4, 3, 6],
      [2, 3, 0],
      [4, 0, 5],
    ]) {
      expect(interpolate(samples, dimensions, unit(i, j, k))).to.be.closeTo(i + 10 * j + 100 * k, 1e-12);
    }
  });

  it('is constant in the outer half voxels and beyond', () => {
    const samples = sample(trilinear);
    const random = randomNumbers(5);
    for (let n = 0; n < 100; n++) {
      const at = [random() * 7 - 1.5, random() * 6 - 1.5, random() * 9 - 1.5];
      const clamped = at.map((x, axis) => Math.min(Math.max(x, 0), dimensions[axis] - 1));
      const got = interpolate(samples, dimensions, unit(at[0], at[1], at[2]));
      expect(got).to.be.closeTo(trilinear(clamped[0], clamped[1], clamped[2]), 1e-12);
    }
  });

  it('works on a single voxel and on a single slice', () => {
    expect(interpolate(new Uint8Array([9]), [1, 1, 1], [0.1, 0.9, 0.5])).to.equal(9);
    expect(interpolate(new Uint16Array([10, 20]), [2, 1, 1], [0.5, 0, 1])).to.equal(15);
  });

  it('leaves out voxels without data: the others are scaled up', () => {
    const samples = sample(trilinear);
    samples[0] = NaN;
    // At (0.5, 0.5, 0.25) the missing corner weighs 0.5 * 0.5 * 0.75; the mean of the other seven is what is left.
    let sum = 0;
    for (let corner = 1; corner < 8; corner++) {
      const [i, j, k] = [corner & 1, (corner >> 1) & 1, corner >> 2];
      sum += 0.25 * (k ? 0.25 : 0.75) * trilinear(i, j, k);
    }
    expect(interpolate(samples, dimensions, unit(0.5, 0.5, 0.25))).to.be.closeTo(sum / (1 - 0.1875), 1e-12);
  });

  it('has no data where voxels with data weigh less than half', () => {
    const samples = sample((i) => (i === 0 ? NaN : 7));
    expect(interpolate(samples, dimensions, unit(0.49, 1, 1))).to.eql(NaN);
    expect(interpolate(samples, dimensions, unit(0.51, 1, 1))).to.equal(7);
    expect(interpolate(samples, dimensions, unit(-0.4, 1, 1))).to.eql(NaN);
    expect(
      interpolate(
        sample(() => NaN),
        dimensions,
        unit(2, 2, 2),
      ),
    ).to.eql(NaN);
  });
});
