/** Pairs of neighbours that are looked at: enough to see where most of them lie. */
const mostPairs = 4096;

/** What two neighbours differ by matters to the picture if it is this share of their value or less: half of float32's 24 bits. */
const fine = 2 ** -12;

/**
 * What to take off values before they become float32, which tells values best near 0: the median of those that differ
 * from their neighbours by little. It is 0 where hardly any do. A few values that lie far away do not matter to it. Doubles have all
 * of its digits taken off: the last of theirs would be lost to a rounded one.
 */
export function chooseOffset(values: ArrayLike<number>): number {
  const detail: number[] = [];
  let pairs = 0;
  for (let i = 1, stride = Math.max(1, Math.floor(values.length / mostPairs)); i < values.length; i += stride) {
    const difference = Math.abs(values[i] - values[i - 1]);
    if (!(difference > 0 && difference < Infinity)) continue;
    pairs++;
    if (difference < fine * Math.abs(values[i])) detail.push(values[i]);
  }
  const sorted = Float64Array.from(detail);
  sorted.sort();
  return detail.length * 4 > pairs ? (values instanceof Float64Array ? sorted[detail.length >> 1] : Math.fround(sorted[detail.length >> 1])) : 0;
}
