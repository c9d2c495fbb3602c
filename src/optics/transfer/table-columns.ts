import { domainOf } from './emission.ts';
import { maxOpacity } from './usual-columns.ts';
import type { Stop, TransferFunction } from './transfer-function.ts';

/** Range of the number of columns of the pre-integration table: enough to place the stops of a usual transfer function on columns. */
const fewest = 1024;
const max = 2048;

/** Different stops are at least this share of the domain apart: 10 to 20 columns. */
const narrowest = 0.01;

/** A kink between two columns may change the opacity there by at most this, relative. Along any ray, the effect is below 1/510. */
const invisible = 4e-3;

/**
 * The number of columns that the pre-integration table needs to hold a transfer function. Kinks must lie on columns, so that each value
 * appears as it should even if much of a ray has that value. Null if no number fits: with jumps, narrow pieces,
 * opacities near 1, or stops that lie on no columns.
 */
export function findColumns(stops: TransferFunction): number | null {
  const [low, high] = domainOf(stops);
  const gaps = stops.slice(1).map(({ value }, i) => (value - stops[i].value) / (high - low));
  if (
    stops.some(({ opacity }) => opacity > maxOpacity) ||
    gaps.some((gap, i) => gap < narrowest && !looksSame(stops[i], stops[i + 1]))
  )
    return null;
  const rises = gaps.map((gap, i) => (stops[i + 1].opacity - stops[i].opacity) / (gap || 1));
  const fits = (columns: number): boolean =>
    stops.slice(1, -1).every(({ value, opacity }, i) => {
      const attached = (((value - low) / (high - low)) * (columns - 1)) % 1;
      const off = attached * (1 - attached);
      return (
        off < 1e-6 ||
        (off * Math.abs(rises[i + 1] - rises[i])) / columns <=
          invisible * opacity * Math.min(1, 25 * Math.min(gaps[i], gaps[i + 1]))
      );
    });
  for (let columns = max; columns >= fewest; columns--) if (fits(columns)) return columns;
  return null;
}

export function looksSame(a: Stop, b: Stop): boolean {
  return a.opacity === b.opacity && (a.opacity === 0 || a.color.join() === b.color.join());
}
