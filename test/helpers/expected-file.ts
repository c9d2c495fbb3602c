import { expect } from '@esm-bundle/chai';
import type { Volume } from '../../src/volume/volume.ts';
import { fetchFixture } from './decode.ts';

/** The data that another program reads from a file: its place, and its values. The programs in test/fixtures write it. */
export interface ExpectedFile {
  readonly path: string;
  readonly dimensions: readonly number[];
  readonly range: readonly [number, number];
  readonly sum: number;
  /** The number of voxels without data; 0 if absent. */
  readonly noData?: number;
  /** Some voxels: number and value; the value is null if there is no data, and a text if JSON has no such number. */
  readonly samples: readonly (readonly [number, number | string | null])[];
}

/** Read a list of expected files from the fixtures. */
export async function readExpected<T extends ExpectedFile>(name: string): Promise<T[]> {
  return (JSON.parse(new TextDecoder().decode(await fetchFixture(name))) as { files: T[] }).files;
}

/**
 * The stored types keep integers of up to 25 bits exactly. The error of floats is float32's half unit: 2^-24 of the largest stored
 * magnitude. That is at most half the range if an offset is subtracted, else the largest end of the range.
 */
function toleranceOf(volume: Volume): number {
  let farthest = 0;
  for (const sample of volume.samples) if (Math.abs(sample) > farthest) farthest = Math.abs(sample);
  const stored = volume.samples instanceof Float32Array ? Math.abs(volume.slope) * farthest * 2 ** -24 : 0;
  // The rounding of doubles of this size, twice: in the other program and in ours.
  return stored + 4 * Math.max(Math.abs(volume.range[0]), Math.abs(volume.range[1])) * Number.EPSILON;
}

/** Compare a volume's size and values with the expected ones. */
export function compareValues(volume: Volume, { dimensions, range, sum, noData = 0, samples }: ExpectedFile): void {
  expect(volume.grid.dimensions).to.deep.equal(dimensions);
  const valueOf = (sample: number): number => volume.slope * sample + volume.intercept;
  const tolerance = toleranceOf(volume);
  expect(volume.samples.length).to.equal(dimensions.reduce((product, count) => product * count, 1));
  for (const [i, value] of samples) {
    const got = valueOf(volume.samples[i]);
    if (value === null) expect(Number.isNaN(got), `sample ${i}: ${got}`).to.equal(true);
    else expect(Math.abs(got - Number(value)), `sample ${i}: ${got} for ${value}`).to.be.at.most(tolerance);
  }
  // Millions of voxels: a loop takes a tenth of the time of lists.
  let [total, without] = [0, 0];
  for (const sample of volume.samples) {
    const value = valueOf(sample);
    if (Number.isNaN(value)) without++;
    else total += value;
  }
  expect(without).to.equal(noData);
  expect(volume.hasNoData).to.equal(noData > 0);
  range.forEach((end, i) => expect(Math.abs(volume.range[i] - end), `end ${i} of the range`).to.be.at.most(tolerance));
  expect(Math.abs(total - sum)).to.be.at.most(tolerance * volume.samples.length + 1e-9 * Math.abs(sum));
}
