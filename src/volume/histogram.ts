import type { Samples } from './samples.ts';

/** Counts of values in equal bins over [low, high]. */
export interface Histogram {
  readonly low: number;
  readonly high: number;
  readonly counts: Uint32Array;
}

/** Number of bins: one for every 16 values of a 12-bit CT, and few enough to scan at once. */
export const histogramBins = 256;

/**
 * Counts samples in data units. NaN and infinities are left out.
 * @param options - minValid: smaller stored values are no data, and left out too; known: how often each whole number occurs, if
 *   that was counted before
 * @returns histogram over the range of the valid values, that range, and whether any sample was left out
 */
export function summarize(
  samples: Samples,
  slope: number,
  intercept: number,
  { minValid = -Infinity, known }: { readonly minValid?: number; readonly known?: Uint32Array } = {},
): { histogram: Histogram; range: [number, number]; hasNoData: boolean } {
  const { low, high, counts, hasNoData } =
    samples instanceof Float32Array ? countFloats(samples, minValid) : countIntegers(samples, minValid, known);
  const ends = [slope * low + intercept, slope * high + intercept];
  if (slope < 0) {
    ends.reverse();
    counts.reverse();
  }
  return { histogram: { low: ends[0], high: ends[1], counts }, range: [ends[0], ends[1]], hasNoData };
}

/** Statistics of stored values: their range, counts in equal bins over it, and whether any sample was no data. */
interface Count {
  readonly low: number;
  readonly high: number;
  readonly counts: Uint32Array<ArrayBuffer>;
  readonly hasNoData: boolean;
}

function countFloats(samples: Float32Array, minValid: number): Count {
  let low = Infinity;
  let high = -Infinity;
  let valid = 0;
  for (let i = 0; i < samples.length; i++) {
    const value = samples[i];
    if (!Number.isFinite(value) || value < minValid) continue;
    valid++;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) low = high = 0;
  const counts = new Uint32Array(histogramBins);
  const binOf = chooseBins(low, high);
  for (let i = 0; i < samples.length; i++) {
    const value = samples[i];
    if (Number.isFinite(value) && value >= minValid) counts[binOf(value)]++;
  }
  return { low, high, counts, hasNoData: valid < samples.length };
}

/** Integers have few different values: one pass counts each, and the counts go into bins afterwards. */
function countIntegers(samples: Uint8Array | Uint16Array, minValid: number, exact = countEach(samples)): Count {
  const values = Array.from(exact.keys()).filter((value) => exact[value] > 0 && value >= minValid);
  const low = values[0] ?? 0;
  const high = values.at(-1) ?? 0;
  const counts = new Uint32Array(histogramBins);
  const binOf = chooseBins(low, high);
  let valid = 0;
  for (const value of values) {
    valid += exact[value];
    counts[binOf(value)] += exact[value];
  }
  return { low, high, counts, hasNoData: valid < samples.length };
}

function countEach(samples: Uint8Array | Uint16Array): Uint32Array {
  const exact = new Uint32Array(samples instanceof Uint8Array ? 256 : 65536);
  for (let i = 0; i < samples.length; i++) exact[samples[i]]++;
  return exact;
}

/** @returns a function that gives the bin of a value from `low` to `high`, the last one for `high` itself */
function chooseBins(low: number, high: number): (value: number) => number {
  const toBin = high > low ? histogramBins / (high - low) : 0;
  return (value) => Math.min(histogramBins - 1, Math.floor((value - low) * toBin));
}
