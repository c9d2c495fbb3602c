import type { Histogram } from '../volume/histogram.ts';
import { boxHeight, boxLength } from './paint-curve.ts';
import { toShare } from './transfer-function-axes.ts';

/** Binomial weights of a bar and two neighbours on either side. */
const kernel = [1 / 16, 4 / 16, 6 / 16, 4 / 16, 1 / 16];

/**
 * Bars without gaps, on a logarithmic scale of counts: air and nothing are most of every volume. Each is mixed with its
 * neighbours, as whole numbers in bins that are not whole numbers wide make a comb.
 */
export function drawHistogram({ low, high, counts }: Histogram, domain: readonly [number, number]): string {
  if (!(high > low)) return '';
  const place = (value: number) => Math.min(boxLength, Math.max(0, toShare(value, domain) * boxLength)).toFixed(2);
  const smooth = Array.from(counts, (_, i) => kernel.reduce((sum, weight, k) => sum + weight * (counts[i + k - 2] ?? 0), 0));
  const top = Math.log1p(Math.max(...smooth));
  const bars = smooth.map((count, i) => `V${(boxHeight * (1 - (0.92 * Math.log1p(count)) / top)).toFixed(2)}H${place(low + (high - low) * ((i + 1) / counts.length))}`);
  return `M${place(low)} ${boxHeight}${bars.join('')}V${boxHeight}Z`;
}
