/** How stored samples map to data values, and how they are stored on a GPU. */
export interface StoredValues {
  /** Data value = slope * stored + intercept. */
  readonly slope: number;
  readonly intercept: number;
  /** Stored = storedScale * the number on the GPU. */
  readonly storedScale: number;
  /** Smallest and largest data value. */
  readonly range: readonly [number, number];
}

/**
 * Maps a number on the GPU to a share of a domain of data values: (number - from) * scale. Both are float32. The
 * number stored for the domain's low end equals `from` to the last bit, so its share is exactly 0. Numbers near it keep all
 * their digits: the difference of two near floats is exact.
 */
export interface ShareMap {
  readonly from: number;
  readonly scale: number;
}

/** Shares stay below this, so that their products with extinctions stay finite. */
const largestShare = 1e34;

/** Numbers in a float32 stay below this. */
const largestFloat = 1e38;

/** Factors stay above this, or a GPU may treat them as 0. */
const minFloat = 2 ** -125;

/** If a domain is tiny compared with the data's range, it is widened to what floats can distinguish. */
export function mapShares(
  { slope, intercept, storedScale, range }: StoredValues,
  [low, high]: readonly [number, number],
): ShareMap {
  const from = (low - intercept) / slope / storedScale;
  const unit = slope * storedScale;
  const width = Math.max(
    high - low,
    ...[unit, ...range.map((value) => value - low)].map((x) => Math.abs(x) / largestShare),
  );
  const shrink = Math.max(1, Math.abs(from) / largestFloat);
  const scale = (unit / width) * shrink;
  // If a domain is as wide as floats allow, scale becomes very small. A larger scale is used then: only where the domain begins matters.
  const lift = Math.max(1, minFloat / Math.abs(scale));
  return { from: Math.fround(from / shrink / lift), scale: Math.fround(scale * lift) };
}
