import type { ShareMap, StoredValues } from './share-map.ts';

/**
 * Relative error of a stored number that is constant around a place, as a GPU computes it: four units in the last place.
 * Measured: one unit.
 */
const rounding = 2 ** -22;

/** A sample can have a stored number if it is this near to it, relative: float32 cannot distinguish them. */
const sameNumber = 1e-6;

/** Stored values, and which numbers can be stored. */
export interface StoredSamples extends StoredValues {
  /** Whole numbers only, else any float32. */
  readonly whole: boolean;
}

/** The place of a data value among the shares that a GPU computes. */
export interface Threshold {
  readonly share: number;
  /**
   * The GPU changes here from the values below to this value and those above. It differs from `share` by as much as rounding may
   * change a constant.
   */
  readonly edge: number;
}

/**
 * A sample of exactly that value must be on the right side, as on the CPU. If such a sample can occur, the edge lies a few units in the
 * last place below it. If slope and intercept bring it below the value by rounding, it is on the left side on both.
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
