/** Maximum number of pairs of neighbours that are examined: enough to see where most of them lie. */
const maxPairs = 4096;

/**
 * The difference of two neighbours counts as small if it is this share of their value or less: half of float32's 24
 * bits.
 */
const fine = 2 ** -12;

/**
 * The offset to subtract from values before they become float32, which resolves values best near 0. It is the median of
 * those that differ from their neighbours by little, and 0 if hardly any do. A few values that lie far away do not
 * matter. The offset is not rounded: then the last digits of double values would be lost.
 */
export function chooseOffset(values: ArrayLike<number>): number {
  const detail: number[] = [];
  let pairs = 0;
  for (let i = 1, stride = Math.max(1, Math.floor(values.length / maxPairs)); i < values.length; i += stride) {
    const difference = Math.abs(values[i] - values[i - 1]);
    if (!(difference > 0 && difference < Infinity)) continue;
    pairs++;
    if (difference < fine * Math.abs(values[i])) detail.push(values[i]);
  }
  const sorted = Float64Array.from(detail);
  sorted.sort();
  return detail.length * 4 > pairs
    ? values instanceof Float64Array
      ? sorted[detail.length >> 1]
      : Math.fround(sorted[detail.length >> 1])
    : 0;
}
