import type { Volume } from '../../volume/volume.ts';

/** No data are stored as this, as GLSL ES need not know NaN. The shader takes all below -3e38 for no data. */
const noDataSentinel = -3.4028234e38;

/** GPUs take floats below 2^-126 for 0; with this as the largest, 24 bits are left of each. */
const smallestMagnitude = 2 ** -100;

/** Sums and differences of floats up to this stay far from the largest float, and from the sentinel. */
const largestMagnitude = 2 ** 100;

/** What floats are divided by: a power of two that brings extreme ones where a GPU computes well; 1 for all others. */
export function chooseFloatScale({ range, slope, intercept }: Volume): number {
  const largest = Math.max(...range.map((value) => Math.abs((value - intercept) / slope)));
  if (!(largest > 0) || largest === Infinity) return 1;
  const power = 2 ** Math.floor(Math.log2(largest));
  if (largest < smallestMagnitude) return power;
  return largest > largestMagnitude ? power / largestMagnitude : 1;
}

export function prepareFloats(samples: Float32Array, scale: number): Float32Array<ArrayBuffer> {
  return Float32Array.from(samples, (value) => (Number.isFinite(value) ? value / scale : noDataSentinel));
}
