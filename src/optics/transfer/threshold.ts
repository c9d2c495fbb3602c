import type { ShareMap, StoredValues } from './share-map.ts';

/**
 * Relative error of what a GPU makes of a stored number that is constant around a place: four units in the last place.
 * Measured: one.
 */
const rounding = 2 ** -22;

/** A stored number is one that a sample can be if it is this near to it, relative: float32 does not tell them apart. */
const sameNumber = 1e-6;

/** And which numbers can be stored. */
export interface StoredSamples extends StoredValues {
  /** Whole numbers only, else any float32. */
  readonly whole: boolean;
}

/** Where a data value lies among the shares that a GPU computes. */
export interface Threshold {
  readonly share: number;
  /** Where the GPU passes from before it to it and what is above: beside it by what rounding may do to a constant. */
  readonly edge: number;
}

/**
 * As on the CPU a sample of just that value is on the right side: where one can be, the edge lies a few units in the
 * last place below it. Where slope and intercept bring it below the value by rounding, it is on the left there and here.
 */
export function placeThreshold(values: StoredSamples, { from, scale }: ShareMap, value: number): Threshold {
  const stored = (value - values.intercept) / values.slope;
  const sample = values.whole ? Math.round(stored) : Math.fround(stored);
  if (values.whole && Math.abs(sample - stored) > sameNumber * Math.max(1, Math.abs(stored))) {
    const between = (stored / values.storedScale - from) * scale;
    return { share: between, edge: between };
  }
  const number = Math.fround(sample / values.storedScale);
  const share = Math.fround(Math.fround(number - from) * scale);
  const reach = rounding * (Math.abs(number * scale) + Math.abs(share));
  const isRight = values.slope * sample + values.intercept >= value;
  return { share, edge: share + (isRight ? -reach : reach) };
}
