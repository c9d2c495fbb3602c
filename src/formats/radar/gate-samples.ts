import type { Numbers, NumberType } from '../base/data-tree.ts';
import type { Samples } from '../../volume/volume.ts';
import type { SweepData } from './radar-file.ts';

/** How to convert numbers of a file to values. */
export interface Packing {
  readonly type: NumberType;
  /** Data value = slope * number + intercept. */
  readonly slope: number;
  readonly intercept: number;
  /** Stored numbers that mean no data: never measured, below the threshold, … */
  readonly noData: readonly number[];
  /** Lowest and highest number, as stored, that is no rubbish; absent where all may be. */
  readonly valid?: readonly [number, number];
}

/** The largest number for float32: a larger double would become infinite. */
const highestFloat = 3.4e38;

export type PackedGates = Pick<SweepData, 'samples' | 'slope' | 'intercept' | 'invalid'>;

/** Smallest and largest numbers of the types that stay integers. */
const limits: Partial<Record<NumberType, readonly [number, number]>> = {
  int8: [-128, 127],
  uint8: [0, 255],
  int16: [-32768, 32767],
  uint16: [0, 65535],
};

/**
 * Converts gates to samples, with 0 (integers) or NaN (floats) for no data. Integers of 8 and 16 bits stay integers,
 * shifted so that all valid ones lie above 0; slope and intercept depend on the packing alone, so that all sweeps of a
 * moment have the same ones. Other types become data values in float32, with slope 1.
 */
export function packGates(numbers: Numbers, packing: Packing): PackedGates {
  const range = limits[packing.type];
  if (!range) return packFloats(numbers, packing);
  const [low, high] = range;
  const isNoData = new Set(packing.noData);
  // If the lowest number means no data, it becomes 0; else it becomes 1, and the highest may need a wider type.
  const shift = isNoData.has(low) ? -low : 1 - low;
  const mayOverflow = high + shift > high - low && !isNoData.has(high);
  const isWide = mayOverflow && numbers.includes(high);
  const samples = allocate(numbers.length, packing.type.endsWith('8') ? 8 : 16, isWide);
  const empty = emptyOf(samples);
  const [min, max] = packing.valid ?? [-Infinity, Infinity];
  let invalid = 0;
  for (let i = 0; i < numbers.length; i++) {
    const number = numbers[i];
    const isOutside = !(number >= min && number <= max);
    if (isOutside || isNoData.has(number)) samples[i] = empty;
    else samples[i] = number + shift;
    if (isOutside && !isNoData.has(number)) invalid++;
  }
  return {
    samples,
    slope: packing.slope,
    intercept: packing.intercept - packing.slope * shift,
    ...(invalid > 0 ? { invalid } : {}),
  };
}

/** The sample value that means no data. */
export function emptyOf(samples: Samples): number {
  return samples instanceof Float32Array ? NaN : 0;
}

function allocate(length: number, bits: number, isWide: boolean): Samples {
  if (bits === 8) return isWide ? new Uint16Array(length) : new Uint8Array(length);
  return isWide ? new Float32Array(length) : new Uint16Array(length);
}

function packFloats(
  numbers: Numbers,
  { slope, intercept, noData, valid: [min, max] = [-Infinity, Infinity] }: Packing,
): PackedGates {
  // What stands for no data is written in double precision, and stored in the array's.
  const isNoData = new Set(numbers instanceof Float32Array ? noData.map(Math.fround) : noData);
  const samples = new Float32Array(numbers.length);
  let invalid = 0;
  for (let i = 0; i < numbers.length; i++) {
    const number = numbers[i];
    const isOutside = number < min || number > max;
    const value = isOutside || isNoData.has(number) ? NaN : slope * number + intercept;
    samples[i] = Math.abs(value) <= highestFloat ? value : NaN;
    if (isOutside && !isNoData.has(number)) invalid++;
  }
  return { samples, slope: 1, intercept: 0, ...(invalid > 0 ? { invalid } : {}) };
}

/** Where rows lie in samples. */
export interface Rows {
  readonly starts: Float64Array;
  readonly lengths: Float64Array;
  /** Not less than any of the lengths. */
  readonly longest: number;
}

/** Copies rows of different lengths into a rectangle, with no data after the end of each row. */
export function pickRows(samples: Samples, { starts, lengths, longest }: Rows): Samples {
  const picked = allocateLike(samples, lengths.length * longest).fill(emptyOf(samples));
  lengths.forEach((length, row) => picked.set(samples.subarray(starts[row], starts[row] + length), row * longest));
  return picked;
}

/** Zeros of the same type. */
export function allocateLike(samples: Samples, length: number): Samples {
  if (samples instanceof Uint8Array) return new Uint8Array(length);
  return samples instanceof Uint16Array ? new Uint16Array(length) : new Float32Array(length);
}
