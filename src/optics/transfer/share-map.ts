/** How stored samples mean data values, and how they lie on a GPU. */
export interface StoredValues {
  /** Data value = slope * stored + intercept. */
  readonly slope: number;
  readonly intercept: number;
  /** Stored = storedScale * what the GPU holds. */
  readonly storedScale: number;
  /** Smallest and largest data value. */
  readonly range: readonly [number, number];
}

/**
 * Share of a domain of data values that a number on the GPU means: (number - from) * scale. Both are float32. What is
 * stored for the domain's low end is `from` to the last bit, so that it comes out as 0, and the digits of what is near it
 * are all kept: the difference of two near floats is exact.
 */
export interface ShareMap {
  readonly from: number;
  readonly scale: number;
}

/** Shares stay below this, so that their products with extinctions stay numbers. */
const largestShare = 1e34;

/** Numbers that a float32 holds stay below this. */
const largestFloat = 1e38;

/** Factors that a GPU may take for 0 stay above this. */
const leastFloat = 2 ** -125;

/** A domain that is next to nothing of the data's range becomes as wide as floats can tell from it. */
export function mapShares({ slope, intercept, storedScale, range }: StoredValues, [low, high]: readonly [number, number]): ShareMap {
  const from = (low - intercept) / slope / storedScale;
  const unit = slope * storedScale;
  const width = Math.max(high - low, ...[unit, ...range.map((value) => value - low)].map((x) => Math.abs(x) / largestShare));
  const shrink = Math.max(1, Math.abs(from) / largestFloat);
  const scale = (unit / width) * shrink;
  // A domain as wide as floats go: numbers in it are so small that they may be taken for larger, as where it begins counts alone.
  const lift = Math.max(1, leastFloat / Math.abs(scale));
  return { from: Math.fround(from / shrink / lift), scale: Math.fround(scale * lift) };
}
