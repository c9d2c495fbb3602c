import type { Samples, VolumeData } from '../../volume/volume.ts';

/** Missing data are stored as this, because GLSL ES need not support NaN. The shader reads all values below -3e38 as no data. */
const noDataSentinel = -3.4028234e38;

/** GPUs treat floats below 2^-126 as 0. If the largest value is this one, 24 bits are left for each value. */
const smallestMagnitude = 2 ** -100;

/** Sums and differences of floats up to this stay far from the largest float, and from the sentinel. */
const largestMagnitude = 2 ** 100;

/** The divisor of floats: a power of two that brings extreme values into a range where a GPU computes well; 1 for all other values. */
export function chooseFloatScale({ range, slope, intercept }: VolumeData): number {
  const largest = Math.max(...range.map((value) => Math.abs((value - intercept) / slope)));
  if (!(largest > 0) || largest === Infinity) return 1;
  const power = 2 ** Math.floor(Math.log2(largest));
  if (largest < smallestMagnitude) return power;
  return largest > largestMagnitude ? power / largestMagnitude : 1;
}

export function prepareFloats(samples: Float32Array, scale: number): Float32Array<ArrayBuffer> {
  return Float32Array.from(samples, (value) => (Number.isFinite(value) ? value / scale : noDataSentinel));
}

/** Changes a volume's floats like that, if they need it. */
export function packFloats({ hasNoData }: Pick<VolumeData, 'hasNoData'>, scale: number): (samples: Samples) => Samples {
  return (samples) => (hasNoData || scale !== 1 ? prepareFloats(samples as Float32Array, scale) : samples);
}
