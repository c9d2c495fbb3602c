import { spanAround } from '../../optics/transfer/span-around.ts';
import type { Samples } from '../../volume/samples.ts';

/** So many of the darkest and of the brightest pixels may be black and white. */
const beyond = 0.005;

/** The most frequent value is far from the others if it is so many times as far away as they are from each other. */
const farTimes = 4;

/**
 * At most so many pixels are looked at, evenly over the picture. A prime number: with it, they are not all in the same
 * columns.
 */
const lookedAt = 262_139;

/** The values of some pixels, ascending. Pixels without data are left out. */
export function sortValues(samples: Samples, slope: number, intercept: number): Float64Array {
  const count = Math.min(lookedAt, samples.length);
  const values = Float64Array.from(
    { length: count },
    (_, i) => slope * samples[Math.floor((i * samples.length) / count)] + intercept,
  ).filter(Number.isFinite);
  values.sort();
  return values;
}

/** The value that occurs most often: where it begins in ascending values, and how often it occurs. */
export function findMostFrequent(sorted: Float64Array): { readonly first: number; readonly count: number } {
  let [first, count] = [0, 0];
  for (let from = 0, i = 1; i <= sorted.length; i++) {
    if (sorted[i] === sorted[from]) continue;
    if (i - from > count) [first, count] = [from, i - from];
    from = i;
  }
  return { first, count };
}

/**
 * Black and white of a picture: from its darkest to its brightest value, without the few that lie apart. The most frequent value is mostly the background, so
 * it is none of those that count: else it would leave nothing of a few bright spots. Where it is far from all others, it stands for no data.
 */
export function pictureWindow(sorted: Float64Array): readonly [number, number] {
  const [low, high] = [sorted[0] ?? 0, sorted[sorted.length - 1] ?? 0];
  // Nothing but 0 is black; any other value alone is between black and white.
  if (!(high > low)) return low === 0 ? [0, 1] : spanAround(low);
  const { first, count } = findMostFrequent(sorted);
  const others = sorted.length - count;
  const few = Math.floor(beyond * others);
  const other = (i: number): number => sorted[i < first ? i : i + count];
  const [black, white] = [other(few), other(others - 1 - few)];
  if (!(white > black)) return [low, high];
  const background = sorted[first];
  const isFar = Math.max(black - background, background - white) > farTimes * (white - black);
  return isFar ? [black, white] : [Math.min(black, background), Math.max(white, background)];
}
