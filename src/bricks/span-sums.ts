import { emission } from '../optics/transfer/emission.ts';
import type { Premultiplied, TransferFunction } from '../optics/transfer/transfer-function.ts';

/** Bins over the range of values. */
const bins = 2048;

/**
 * Sums over one step: red, green, blue and opacity of a step, premultiplied; then the squares of the colours, their products with the
 * opacity, and the square of the opacity.
 */
export const sumCount = 11;

/** Running sums over the values of a volume of what a step of a ray adds, so that means over spans of values take one subtraction. */
export interface SpanSums {
  /** Adds `weight` times the means over the values between two (stored values) to 11 numbers. */
  addMeans(from: number, to: number, weight: number, into: Float64Array): void;
  /** The mean of the opacity over the values between two. */
  meanOpacity(from: number, to: number): number;
}

/** What stored values are, and how long a step is. */
export interface StepScale {
  readonly slope: number;
  readonly intercept: number;
  /** Length of a step in reference lengths, times the opacity factor. */
  readonly stepRatio: number;
}

/** @param transferFunction - already brightened @param range - of the stored values */
export function sumSpans(
  transferFunction: TransferFunction,
  range: readonly [number, number],
  scale: StepScale,
): SpanSums {
  return sumEmission((value) => emission(transferFunction, value), range, scale);
}

/** The same for any emission. @param emissionOf - of a data value: extinction times colour, and extinction, per reference length */
export function sumEmission(
  emissionOf: (value: number) => Premultiplied,
  [low, high]: readonly [number, number],
  { slope, intercept, stepRatio }: StepScale,
): SpanSums {
  const width = Math.max(high - low, 1e-30) / bins;
  const running = new Float64Array((bins + 1) * sumCount);
  for (let bin = 0; bin < bins; bin++) {
    const [red, green, blue, extinction] = emissionOf(slope * (low + (bin + 0.5) * width) + intercept);
    const opacity = 1 - Math.exp(-extinction * stepRatio);
    const share = extinction > 0 ? opacity / extinction : 0;
    const seen = [red * share, green * share, blue * share, opacity];
    const at = bin * sumCount;
    for (let c = 0; c < 4; c++) {
      running[at + sumCount + c] = running[at + c] + seen[c];
      running[at + sumCount + 4 + c] = running[at + 4 + c] + seen[c] ** 2;
      if (c < 3) running[at + sumCount + 8 + c] = running[at + 8 + c] + seen[c] * opacity;
    }
  }
  const placeOf = (value: number): number => Math.min(bins, Math.max(0, (value - low) / width));
  /** In bins: at least one, so that the difference of the sums is not lost. */
  const spanOf = (from: number, to: number): [begin: number, end: number] => {
    const [a, b] = [placeOf(Math.min(from, to)), placeOf(Math.max(from, to))];
    if (b - a >= 1) return [a, b];
    const begin = Math.min(bins - 1, Math.max(0, (a + b) / 2 - 0.5));
    return [begin, begin + 1];
  };
  const opacityUpTo = (place: number): number => {
    const bin = Math.min(bins - 1, Math.floor(place));
    const at = bin * sumCount + 3;
    return running[at] + (place - bin) * (running[at + sumCount] - running[at]);
  };
  return {
    meanOpacity: (from, to) => {
      const [begin, end] = spanOf(from, to);
      return (opacityUpTo(end) - opacityUpTo(begin)) / (end - begin);
    },
    addMeans: (from, to, weight, into) => {
      const [begin, end] = spanOf(from, to);
      const factor = weight / (end - begin);
      const [i, j] = [Math.min(bins - 1, Math.floor(begin)), Math.min(bins - 1, Math.floor(end))];
      const [p, q] = [begin - i, end - j];
      for (let c = 0, at = i * sumCount, to = j * sumCount; c < sumCount; c++, at++, to++)
        into[c] +=
          factor *
          (running[to] +
            q * (running[to + sumCount] - running[to]) -
            running[at] -
            p * (running[at + sumCount] - running[at]));
    },
  };
}
