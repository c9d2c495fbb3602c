import type { SpanMeans } from './emission.ts';
import type { Premultiplied } from './transfer-function.ts';

/** From this optical depth on, what stands in front within a segment visibly hides what stands behind in it. */
export const orderMattersFromDepth = 0.1;

/** Narrower spans, as shares of the transfer function's domain, hold nothing that could stand in an order. */
export const orderMattersFromSpan = 1 / 512;

/** A step is cut into so many parts at most, each end a sample of its own. */
export const mostParts = 8;

/**
 * Parts of a step on which everything is seen. Where the opacity of a voxel is w, its cube root times this makes the
 * error least for the samples taken: the error of a part grows with w and the square of its length.
 */
export const partsPerRoot = 18;

/**
 * How far beyond the values at a step's ends those between may lie: a share of the span between the ends, and a share of
 * the transfer function's domain for where the value turns.
 */
export const reachBeyond = { ofSpan: 0.5, ofDomain: 0.02 } as const;

/**
 * Into how many parts a step is cut: the more, the more may be seen on it. That is asked of the values around those at its
 * ends, and over the length of a voxel and not of the step, so that the answer tends to one limit as steps get shorter
 * and the order of convergence stays.
 * @param ratio - length of a voxel / reference length, times the opacity factor
 * @param visible - share of what is here that reaches the eye
 */
export function countParts(means: SpanMeans, [from, to]: readonly [number, number], ratio: number, visible: number): number {
  const reach = reachBeyond.ofSpan * Math.abs(to - from) + reachBeyond.ofDomain * (means.high - means.low);
  const [, , , density] = means.mean(Math.min(from, to) - reach, Math.max(from, to) + reach);
  const seen = visible * -Math.expm1(-density * ratio);
  return Math.min(mostParts, Math.max(1, Math.ceil(partsPerRoot * Math.cbrt(seen))));
}

/**
 * What a length of constant mean emission and extinction emits and hides.
 * @param mean - extinction times colour, and extinction, per reference length
 * @param ratio - length / reference length, times the opacity factor
 */
export function attenuate(mean: Premultiplied, ratio: number): Premultiplied {
  const depth = mean[3] * ratio;
  if (!(depth > 0)) return [0, 0, 0, 0];
  const alpha = -Math.expm1(-depth);
  const toLight = alpha / mean[3];
  return [mean[0] * toLight, mean[1] * toLight, mean[2] * toLight, alpha];
}

/**
 * What a segment of a ray emits and hides on which the data value runs in a straight line from one value to another.
 * Dense segments are cut into four, front to back: a mean alone knows no order, and in a dense segment what comes first
 * hides the rest.
 */
export function classifySegment(
  means: SpanMeans,
  [from, to]: readonly [number, number],
  ratio: number,
): Premultiplied {
  const mean = means.mean(from, to);
  const span = Math.abs(to - from) / (means.high - means.low);
  if (mean[3] * ratio < orderMattersFromDepth || span < orderMattersFromSpan) return attenuate(mean, ratio);
  const accumulated: Premultiplied = [0, 0, 0, 0];
  for (let i = 0; i < 4; i++) {
    const begin = from + ((to - from) * i) / 4;
    const end = from + ((to - from) * (i + 1)) / 4;
    composite(accumulated, attenuate(means.mean(begin, end), ratio / 4));
  }
  return accumulated;
}

/** Put a sample behind what has been gathered so far. */
export function composite(accumulated: Premultiplied, behind: Premultiplied): void {
  const visible = 1 - accumulated[3];
  for (let c = 0; c < 4; c++) accumulated[c] += visible * behind[c];
}
