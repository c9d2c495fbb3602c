import type { HiddenValues } from './hidden-values.ts';
import type { SpanSums } from './span-sums.ts';

/** Share of a residual's variance that a few far values have: half of it, as measured in the bench. */
const farShare = 0.5;

/** What is known of the values of a place. Stored units. */
export interface HiddenSpread {
  /** What the resident level shows. */
  readonly center: number;
  readonly rms: number;
  readonly max: number;
  readonly low: number;
  readonly high: number;
}

/**
 * @param value - what the resident level shows; NaN where it has no data: the middle of what may be there stands for it
 * @param due - the finest level that counts
 * @returns null where a level hides nothing
 */
export function spreadAt(
  hidden: HiddenValues,
  block: number,
  { value, due, level }: { readonly value: number; readonly due: number; readonly level: number },
): HiddenSpread | null {
  if (level <= due) return null;
  const [low, high, all] = [hidden.low(block), hidden.high(block), hidden.rms(block, level)];
  const rms = due > 0 ? Math.sqrt(Math.max(0, all ** 2 - hidden.rms(block, due) ** 2)) : all;
  const max = hidden.max(block, level) * (due > 0 && all > 0 ? rms / all : 1);
  if (!(max > 0) || !(low <= high)) return null;
  return { center: Number.isNaN(value) ? (low + high) / 2 : value, rms, max, low, high };
}

/** Two boxes around a value: a wide one up to the largest residual, with `far` of the weight, and one of half this `width` for the rest of the variance. */
export function boxesOf(rms: number, max: number): { readonly far: number; readonly width: number } {
  const far = Math.min(0.5, (3 * farShare * rms ** 2) / max ** 2);
  return { far, width: Math.sqrt((3 * Math.max(0, rms ** 2 - (far * max ** 2) / 3)) / (1 - far)) };
}

/**
 * Means over the values that voxels may have where a level shows `center`: two boxes around it, a wide one up to the largest residual, and a
 * narrow one for the rest of the variance.
 * @param previous - the value in front of it
 * @returns the share of the opacity's variance that is linear in the value, 0..1: it goes together as far as values do, the rest less; and whether the opacity is
 * lower at both ends of the values, so that rays pass through a peak
 */
export function meanOfHidden(
  sums: SpanSums,
  { center, rms, max, low, high }: HiddenSpread,
  previous: number,
  into: Float64Array,
): { readonly linear: number; readonly isPeaked: boolean } {
  const clamp = (value: number): number => Math.min(high, Math.max(low, value));
  const { far, width } = boxesOf(rms, max);
  const [from, to] = [Math.min(previous, center), Math.max(previous, center)];
  into.fill(0);
  sums.addMeans(clamp(center - max), clamp(center + max), far, into);
  sums.addMeans(clamp(from - width), clamp(to + width), 1 - far, into);
  const middle = (from + to) / 2;
  const half = (to - from) / 2 + width;
  const slopeOf = (at: number, reach: number): number =>
    sums.meanOpacity(at, clamp(at + reach)) - sums.meanOpacity(clamp(at - reach), at);
  const together = (far * max * slopeOf(center, max) + (1 - far) * half * slopeOf(middle, half)) / 3;
  const variance = (far * max ** 2 + (1 - far) * half ** 2) / 3;
  const ofOpacity = into[7] - into[3] ** 2;
  const opacityAt = (value: number): number => sums.meanOpacity(clamp(value), clamp(value));
  return {
    linear: ofOpacity > 1e-12 && variance > 0 ? Math.min(1, together ** 2 / (variance * ofOpacity)) : 1,
    isPeaked: into[3] > Math.max(opacityAt(center - max), opacityAt(center + max)),
  };
}
