// Numbers of files that samples or colours can't hold: nothing of them is left out without a word.
import { expect } from '@esm-bundle/chai';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { niftiTypes } from '../../../../src/formats/base/number-types.ts';
import { storeSamples } from '../../../../src/formats/base/store-samples.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../../src/volume/grid.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeBytes, roomyLimits } from '../../../helpers/decode.ts';
import { niftiBytes } from '../../../helpers/nifti-bytes.ts';

const codes = { Float32Array: 16, Float64Array: 64 };

/** The volume of a file with eight floats. */
async function read(numbers: Float32Array | Float64Array): Promise<Volume> {
  const type = niftiTypes.get(codes[numbers.constructor.name as keyof typeof codes])!;
  const { scale, offset, ...stored } = storeSamples(new Uint8Array(numbers.slice().buffer), type, true, {
    slope: 1,
    intercept: 0,
  });
  const grid = cartesianGrid([2, 2, 2], axialIndexToWorld([2, 2, 2], [1, 1, 1]));
  const decoded = { grid, ...stored, slope: scale, intercept: offset, unit: '', format: 'NIfTI-1' };
  return finishVolume(decoded, roomyLimits);
}

const valuesOf = ({ samples, slope, intercept }: Volume): number[] =>
  Array.from(samples, (stored) => slope * stored + intercept);

describe('a file of floats', () => {
  it('of usual values has nothing to report', async () => {
    for (const numbers of [Float32Array.of(0, 1, 2, 3, 4, 5, NaN, 7.5), Float64Array.of(0, 1, 2, 3, 4, 5, NaN, 7.5)])
      expect((await read(numbers)).left).to.equal(undefined);
  });

  it('says how many of its values are infinite, and so no data', async () => {
    for (const numbers of [
      Float32Array.of(0, 1, 2, 3, Infinity, -Infinity, NaN, 7.5),
      Float64Array.of(0, 1, 2, 3, Infinity, -Infinity, NaN, 7.5),
    ]) {
      const volume = await read(numbers);
      expect(volume.left).to.deep.equal(['2 values are infinite, and shown as no data']);
      expect(valuesOf(volume)).to.deep.equal([0, 1, 2, 3, NaN, NaN, NaN, 7.5]);
    }
    expect((await read(Float32Array.of(0, 1, 2, 3, 4, 5, 6, Infinity))).left).to.deep.equal([
      '1 value is infinite, and shown as no data',
    ]);
  });

  it('says where colours end before its values, and how many values the largest one drowns', async () => {
    const { left } = await read(Float64Array.of(0, 1, 2, 3, 4, 5, 6, 1.5e308));
    expect(left).to.deep.equal([
      '6 values differ too little from 0 to be kept with values as large as 1.50e+308',
      'the values go from 0.00 to 1.50e+308, and colours end at 9e+299',
    ]);
    expect((await read(Float64Array.of(0, 1e299, 2e299, 3e299, 4e299, 5e299, 6e299, 8e299))).left).to.equal(undefined);
  });

  it('of 32 bits that are all too small for a graphics processor is stored as shares, and keeps its values', async () => {
    const numbers = Float32Array.from({ length: 8 }, (_, i) => (i + 1) * 1e-40);
    const volume = await read(numbers);
    expect(Math.max(...volume.samples)).to.be.within(0.5, 2);
    expect(valuesOf(volume)).to.deep.equal([...numbers]);
    expect(volume.left).to.equal(undefined);
  });

  it('reports it through the reader', async () => {
    const numbers = Float32Array.of(0, 1, 2, 3, 4, 5, 6, Infinity);
    const bytes = niftiBytes({ ...(await read(numbers)), samples: numbers });
    expect((await decodeBytes(bytes, 'a.nii')).left).to.deep.equal(['1 value is infinite, and shown as no data']);
  });
});
