import type { SpanMeans } from './emission.ts';
import type { Premultiplied } from './transfer-function.ts';

/** From this optical depth on, what stands in front within a segment visibly hides what stands behind in it. */
export const orderMattersFromDepth = 0.1;

/** Narrower spans, as shares of the transfer function's domain, hold nothing that could stand in an order. */
export const orderMattersFromSpan = 1 / 512;

/**
 * What a length of constant mean emission and extinction emits and hides.
 * @param mean - extinction times colour, and extinction, per reference length
 * @param ratio - length / reference length, times the opacity factor
 * @param lightFactor - multiplies the colour, which saturates at white
 */
export function attenuate(mean: Premultiplied, ratio: number, lightFactor: number): Premultiplied {
  const depth = mean[3] * ratio;
  if (!(depth > 0)) return [0, 0, 0, 0];
  const alpha = -Math.expm1(-depth);
  const light = (channel: number): number => Math.min(1, (channel / mean[3]) * lightFactor) * alpha;
  return [light(mean[0]), light(mean[1]), light(mean[2]), alpha];
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
  lightFactor: number,
): Premultiplied {
  const mean = means.mean(from, to);
  const span = Math.abs(to - from) / (means.high - means.low);
  if (mean[3] * ratio < orderMattersFromDepth || span < orderMattersFromSpan) return attenuate(mean, ratio, lightFactor);
  const accumulated: Premultiplied = [0, 0, 0, 0];
  for (let i = 0; i < 4; i++) {
    const begin = from + ((to - from) * i) / 4;
    const end = from + ((to - from) * (i + 1)) / 4;
    composite(accumulated, attenuate(means.mean(begin, end), ratio / 4, lightFactor));
  }
  return accumulated;
}

/** Put a sample behind what has been gathered so far. */
export function composite(accumulated: Premultiplied, behind: Premultiplied): void {
  const visible = 1 - accumulated[3];
  for (let c = 0; c < 4; c++) accumulated[c] += visible * behind[c];
}
