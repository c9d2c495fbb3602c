import { emission } from './emission.ts';
import type { SpanMeans } from './emission.ts';
import { integrateEmission } from './running-integral.ts';
import type { RunningIntegral } from './running-integral.ts';
import type { Premultiplied, TransferFunction } from './transfer-function.ts';

/**
 * The pre-integration table: a transfer function averaged over spans of data values, for the ray-caster's look-up
 * texture. Between two samples of a ray the value is assumed to change linearly, so the segment emits and absorbs the
 * mean of the transfer function over that span of values, and a narrow peak between two samples is never missed.
 * Column: the middle of the span; row: its width, by the square root, so that narrow spans are well resolved.
 *
 * It depends neither on the step length nor on the opacity and light factors.
 * Source: the idea of pre-integration, Engel et al. 2001; indexed by middle and width instead of by both ends, because
 * the mean gets smoother with wider spans, and a table by both ends cannot use that.
 */
export interface PreintegrationTable {
  /**
   * Shape [rows, columns, 4], row-major: mean of extinction times colour, and mean extinction, per reference length.
   */
  readonly texels: Float32Array<ArrayBuffer>;
  readonly columns: number;
  readonly rows: number;
  /** Data values of the centres of the first and the last column. */
  readonly low: number;
  readonly high: number;
  /** The same for all values below and above those. If there is a jump at an end, this is the side that no column has. */
  readonly first: Premultiplied;
  readonly last: Premultiplied;
}

/**
 * A peak of half a percent of the domain covers ten columns. Where a span is about as wide as a peak of one percent, the widths of
 * neighbouring rows differ by a fifth.
 */
export const preintegrationTableSize = { columns: 2048, rows: 64 } as const;

/** Cells of the running integral per column. */
const cellsPerColumn = 4;

/** The running integral from which a table of the usual size is made. */
export function integrateForTable(
  transferFunction: TransferFunction,
  columns: number = preintegrationTableSize.columns,
): RunningIntegral {
  return integrateEmission(transferFunction, (columns - 1) * cellsPerColumn);
}

/**
 * Averages a transfer function over spans. A span of width 0 has the emission of its value.
 * @throws {RangeError} if the transfer function has no stop
 */
export function buildPreintegrationTable(
  transferFunction: TransferFunction,
  { columns, rows }: { columns: number; rows: number } = preintegrationTableSize,
): PreintegrationTable {
  const integral = integrateForTable(transferFunction, columns);
  const { cells, low, high, first, last } = integral;
  const texels = new Float32Array(columns * rows * 4);
  for (let column = 0; column < columns; column++) {
    // If there is a jump at the high end, the last column has the emission before it.
    texels.set(
      emission(transferFunction, low + (high - low) * Math.min(column / (columns - 1), 1 - 2 ** -30)),
      column * 4,
    );
  }
  for (let row = 1; row < rows; row++) {
    const reach = Math.max((spanOfRow(row, rows) * cells) / 2, 0.5);
    averageSpans(integral, reach, texels.subarray(row * columns * 4, (row + 1) * columns * 4));
  }
  return { texels, columns, rows, low, high, first, last };
}

/**
 * The means over a row of spans, as `sumUpTo` gives them. It is one loop without a call: most pages make one table, before the browser has
 * optimised this code.
 * @param reach - half of the width of the spans, in cells
 * @param means - shape [columns, 4], is filled
 */
function averageSpans({ sums, cells }: RunningIntegral, reach: number, means: Float32Array): void {
  const width = 2 * reach;
  for (let at = 0, middle = 0; at < means.length; at += 4, middle += cellsPerColumn) {
    const from = middle - reach;
    const to = middle + reach;
    const fromCell = Math.min(cells - 1, Math.max(0, Math.floor(from)));
    const toCell = Math.min(cells - 1, Math.max(0, Math.floor(to)));
    for (let c = 0; c < 4; c++) {
      const before = sums[fromCell * 4 + c];
      const after = sums[toCell * 4 + c];
      const upTo = after + (to - toCell) * (sums[toCell * 4 + 4 + c] - after);
      const upFrom = before + (from - fromCell) * (sums[fromCell * 4 + 4 + c] - before);
      means[at + c] = (upTo - upFrom) / width;
    }
  }
}

/** Width of a row's spans, as a share of the domain. */
export function spanOfRow(row: number, rows: number): number {
  return (row / (rows - 1)) ** 2;
}

/** The means from a table, sampled as the shader samples it. */
export function tableMeans(table: PreintegrationTable): SpanMeans {
  return { low: table.low, high: table.high, mean: (from, to) => lookUpSpan(table, from, to) };
}

/** Bilinear between texels. The parts of a span outside of the table's domain count as the domain's ends. */
function lookUpSpan(table: PreintegrationTable, from: number, to: number): Premultiplied {
  const width = table.high - table.low;
  const a = (Math.min(from, to) - table.low) / width;
  const b = (Math.max(from, to) - table.low) / width;
  if (a >= 1) return [...table.last];
  if (b < 0) return [...table.first];
  const start = Math.min(1, Math.max(0, a));
  const end = Math.min(1, Math.max(0, b));
  const inside = fetchMean(table, (start + end) / 2, end - start);
  if (a >= 0 && b <= 1) return inside;
  const below = Math.max(0, Math.min(b, 0) - a) / (b - a);
  const above = Math.max(0, b - Math.max(a, 1)) / (b - a);
  const within = Math.max(0, 1 - below - above);
  return inside.map((mean, c) => mean * within + table.first[c] * below + table.last[c] * above) as Premultiplied;
}

function fetchMean({ texels, columns, rows }: PreintegrationTable, middle: number, width: number): Premultiplied {
  const x = middle * (columns - 1);
  const y = Math.sqrt(width) * (rows - 1);
  const column = Math.min(columns - 2, Math.floor(x));
  const row = Math.min(rows - 2, Math.floor(y));
  const [u, v] = [x - column, y - row];
  const narrow = (row * columns + column) * 4;
  const wide = narrow + columns * 4;
  const mean = (c: number): number =>
    (texels[narrow + c] * (1 - u) + texels[narrow + 4 + c] * u) * (1 - v) +
    (texels[wide + c] * (1 - u) + texels[wide + 4 + c] * u) * v;
  return [mean(0), mean(1), mean(2), mean(3)];
}
