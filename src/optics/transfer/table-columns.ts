import { domainOf } from './emission.ts';
import { mostOpacity } from './usual-columns.ts';
import type { Stop, TransferFunction } from './transfer-function.ts';

/** Columns of the pre-integration table: as many as bring the stops of a usual transfer function onto columns. */
const fewest = 1024;
const most = 2048;

/** Stops that differ are at least this share of the domain apart: 10 to 20 columns. */
const narrowest = 0.01;

/** What a kink between two columns may change of the opacity there, relative. Along any ray that is below 1/510. */
const invisible = 4e-3;

/**
 * How many columns the pre-integration table needs to hold a transfer function, so that each value looks as it should
 * even where much of a ray has that value: kinks have to be on columns. Null where none does: with jumps, narrow pieces,
 * opacities near 1, or stops that are on no columns.
 */
export function findColumns(stops: TransferFunction): number | null {
  const [low, high] = domainOf(stops);
  const gaps = stops.slice(1).map(({ value }, i) => (value - stops[i].value) / (high - low));
  if (stops.some(({ opacity }) => opacity > mostOpacity) || gaps.some((gap, i) => gap < narrowest && !looksSame(stops[i], stops[i + 1]))) return null;
  const rises = gaps.map((gap, i) => (stops[i + 1].opacity - stops[i].opacity) / (gap || 1));
  const fits = (columns: number): boolean => stops.slice(1, -1).every(({ value, opacity }, i) => {
    const beside = (((value - low) / (high - low)) * (columns - 1)) % 1;
    const off = beside * (1 - beside);
    return off < 1e-6 || (off * Math.abs(rises[i + 1] - rises[i])) / columns <= invisible * opacity * Math.min(1, 25 * Math.min(gaps[i], gaps[i + 1]));
  });
  for (let columns = most; columns >= fewest; columns--) if (fits(columns)) return columns;
  return null;
}

export function looksSame(a: Stop, b: Stop): boolean {
  return a.opacity === b.opacity && (a.opacity === 0 || a.color.join() === b.color.join());
}
