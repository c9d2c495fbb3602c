import type { Histogram } from '../volume/histogram.ts';
import { boxHeight, boxLength } from './paint-curve.ts';
import { toShare } from './transfer-function-axes.ts';

/** Binomial weights of a bar and two neighbours on either side. */
const kernel = [1 / 16, 4 / 16, 6 / 16, 4 / 16, 1 / 16];

/**
 * Bars without gaps, on a logarithmic scale of counts, because air and background are most of every volume. Each bar is
 * mixed with its neighbours: integers in bins whose width is not an integer would look like a comb.
 */
export function drawHistogram({ low, high, counts }: Histogram, domain: readonly [number, number]): string {
  if (!(high > low)) return '';
  const place = (value: number) => Math.min(boxLength, Math.max(0, toShare(value, domain) * boxLength)).toFixed(2);
  const smooth = Array.from(counts, (_, i) =>
    kernel.reduce((sum, weight, k) => sum + weight * (counts[i + k - 2] ?? 0), 0),
  );
  const top = Math.log1p(Math.max(...smooth));
  const bars = smooth.map(
    (count, i) =>
      `V${(boxHeight * (1 - (0.92 * Math.log1p(count)) / top)).toFixed(2)}H${place(low + (high - low) * ((i + 1) / counts.length))}`,
  );
  return `M${place(low)} ${boxHeight}${bars.join('')}V${boxHeight}Z`;
}
