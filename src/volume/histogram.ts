import type { Samples } from './volume.ts';

/** Counts of values in equal bins over [low, high]. */
export interface Histogram {
  readonly low: number;
  readonly high: number;
  readonly counts: Uint32Array;
}

/** Bins: enough to tell 12-bit CT values apart by 16, few enough to scan at once. */
export const histogramBins = 256;

/**
 * Count samples in data units. NaN and infinities are left out.
 * @param leastValid - stored values below this are no data, and left out too
 * @returns histogram over the range of the valid values, that range, and whether any sample was left out
 */
export function summarize(
  samples: Samples,
  slope: number,
  intercept: number,
  leastValid = -Infinity,
): { histogram: Histogram; range: [number, number]; hasNoData: boolean } {
  let low = Infinity;
  let high = -Infinity;
  let hasNoData = false;
  for (let i = 0; i < samples.length; i++) {
    const value = samples[i];
    if (!Number.isFinite(value) || value < leastValid) {
      hasNoData = true;
      continue;
    }
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) low = high = 0;
  const counts = new Uint32Array(histogramBins);
  const toBin = high > low ? histogramBins / (high - low) : 0;
  for (let i = 0; i < samples.length; i++) {
    const value = samples[i];
    if (Number.isFinite(value) && value >= leastValid) counts[Math.min(histogramBins - 1, Math.floor((value - low) * toBin))]++;
  }
  const ends = [slope * low + intercept, slope * high + intercept];
  if (slope < 0) {
    ends.reverse();
    counts.reverse();
  }
  return { histogram: { low: ends[0], high: ends[1], counts }, range: [ends[0], ends[1]], hasNoData };
}
