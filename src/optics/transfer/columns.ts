import { emission, meanOverSpan } from './emission.ts';
import { looksSame } from './table-columns.ts';
import type { Threshold } from './threshold.ts';
import type { Premultiplied, Stop, TransferFunction } from './transfer-function.ts';

/**
 * A transfer function cut into columns. In each, its emission is linear in the value. A column ends at each stop, so
 * a jump lies between two columns and belongs to neither. The first and the last column are everything below and
 * above the stops. The integral between any two values has a closed form, however near or far they are.
 */
export interface Columns {
  /** Where each column begins, and where the last one ends: shares, float32, count + 1. */
  readonly edges: Float32Array;
  /** Shape [count, 4]: extinction times colour, and extinction, per reference length, at each column's start and end. */
  readonly starts: Float32Array;
  readonly ends: Float32Array;
  /**
   * Shape [count, 4]: the integral over the share, up to each column's start and end. It is counted from the exact places of stops, as
   * if the lines ended there and not at edges, so jumps are exact to the last digit.
   */
  readonly sumsAtStart: Float64Array;
  readonly sumsAtEnd: Float64Array;
}

/** Beyond all shares that occur. */
const endless = 1e35;

/** The smallest share that floats distinguish from 0. */
const smallest = 1e-30;

/**
 * A line may deviate by this share of the extinction, plus the same share of the smallest extinction that is visible along a
 * long ray (`least`).
 */
const usualTolerance = 3e-3;
const min = 3e-4;

/** If there would be more columns, lines are made coarser; but there are never fewer columns than pieces. */
const maxColumns = 4096;

/** Halvings towards opacity 1, where extinction has a logarithmic pole. */
const maxHalvings = 12;

/** The function between two stops, over values from 0 to 1. */
type Piece = readonly [Stop, Stop];

/** A column, and where its line begins and ends: at stops, which lie next to edges. */
interface Column {
  readonly start: Premultiplied;
  readonly end: Premultiplied;
  readonly from: Threshold;
  readonly to: Threshold;
}

/**
 * @param transferFunction - already brightened; at least one stop
 * @param threshold - maps a data value to its share
 */
export function cutColumns(
  transferFunction: TransferFunction,
  threshold: (value: number) => Threshold,
  tolerance = usualTolerance,
): Columns {
  const columns: Column[] = [];
  const add = (to: Threshold, start: Premultiplied, end: Premultiplied): void => {
    const from = columns.at(-1)?.to ?? { share: -endless, edge: -endless };
    if (Math.fround(to.edge) > Math.fround(from.edge)) columns.push({ start, end, from, to });
  };
  const stops = transferFunction.map((stop, i) => ({
    stop,
    at: placeEdge(transferFunction, i, threshold(stop.value)),
  }));
  const below = emission(transferFunction, -Infinity);
  add(stops[0].at, below, below);
  stops.slice(1).forEach((to, i) => {
    const from = stops[i];
    if (from.stop.value === to.stop.value) return;
    const piece: Piece = [
      { ...from.stop, value: 0 },
      { ...to.stop, value: 1 },
    ];
    // Only exactly this value is fully opaque: extinction falls from there at once.
    if (from.stop.opacity >= 1 && to.stop.opacity < 1) {
      const { share, edge } = from.at;
      add({ share, edge: share + Math.abs(share - edge) + smallest }, emission(piece, 0), emission(piece, 0));
    }
    for (const [end, start, last] of straighten(piece, tolerance)) {
      const share = from.at.share + end * (to.at.share - from.at.share);
      add(end < 1 ? { share, edge: share } : to.at, start, last);
    }
  });
  const above = emission(transferFunction, Infinity);
  add({ share: endless, edge: endless }, above, above);
  if (columns.length > Math.max(maxColumns, 2 * transferFunction.length))
    return cutColumns(transferFunction, threshold, 4 * tolerance);
  const edges = Float32Array.from([-endless, ...columns.map(({ to }) => to.edge)]);
  return {
    edges,
    starts: Float32Array.from(columns.flatMap(({ start }) => start)),
    ends: Float32Array.from(columns.flatMap(({ end }) => end)),
    ...sumUp(columns),
  };
}

/**
 * If nothing jumps at a stop, a sample of the stop's value belongs to the side that is level, if one is. So next to where opacity begins,
 * matter is transparent, whatever rounding does.
 */
function placeEdge(transferFunction: TransferFunction, at: number, { share, edge }: Threshold): Threshold {
  const { value } = transferFunction[at];
  let [first, last] = [at, at];
  while (transferFunction[first - 1]?.value === value) first--;
  while (transferFunction[last + 1]?.value === value) last++;
  const [before, left, right, after] = [
    transferFunction[first - 1],
    transferFunction[first],
    transferFunction[last],
    transferFunction[last + 1],
  ];
  if (!looksSame(left, right) || right.opacity >= 1) return { share, edge };
  const reach = Math.abs(share - edge);
  if (!after || looksSame(right, after)) return { share, edge: share - reach };
  return { share, edge: !before || looksSame(before, left) ? share + reach : share };
}

/** Straight lines that approximate a piece: where each ends, and its emission at both ends. */
function straighten(piece: Piece, tolerance: number): [number, Premultiplied, Premultiplied][] {
  const lines: [number, Premultiplied, Premultiplied][] = [];
  const follow = (from: number, to: number, halvings: number): void => {
    const [start, end] = [emission(piece, from), emission(piece, to)];
    if (halvings === maxHalvings || isStraight(piece, [from, to], [start, end], tolerance)) {
      lines.push([
        to,
        ...(halvings === maxHalvings ? withMean(piece, [from, to], [start, end]) : ([start, end] as const)),
      ]);
      return;
    }
    follow(from, (from + to) / 2, halvings + 1);
    follow((from + to) / 2, to, halvings + 1);
  };
  follow(0, 1, 0);
  return lines;
}

function isStraight(
  piece: Piece,
  [from, to]: readonly [number, number],
  [start, end]: readonly [Premultiplied, Premultiplied],
  tolerance: number,
): boolean {
  return [0.25, 0.5, 0.75].every((t) => {
    const exact = emission(piece, from + t * (to - from));
    const allowed = tolerance * (exact[3] + min);
    return exact.every((x, c) => Math.abs(start[c] + t * (end[c] - start[c]) - x) <= allowed);
  });
}

/** Next to the pole, the line continues that of its neighbour, and its end is chosen so that the mean is right. */
function withMean(
  piece: Piece,
  [from, to]: readonly [number, number],
  [start, end]: readonly [Premultiplied, Premultiplied],
): [Premultiplied, Premultiplied] {
  const mean = meanOverSpan(piece, from, to);
  const mirror = (x: number, c: number): number => Math.max(0, 2 * mean[c] - x);
  return end[3] > start[3] ? [start, start.map(mirror) as Premultiplied] : [end.map(mirror) as Premultiplied, end];
}

function sumUp(columns: readonly Column[]): Pick<Columns, 'sumsAtStart' | 'sumsAtEnd'> {
  const [sumsAtStart, sumsAtEnd] = [new Float64Array(columns.length * 4), new Float64Array(columns.length * 4)];
  columns.forEach(({ start, end, from, to }, k) => {
    for (let c = 0; c < 4; c++) {
      const [a, b] = [Math.fround(start[c]), Math.fround(end[c])];
      // The integral is 0 at the first stop; below it, the integral is negative.
      const sum =
        k < 2
          ? 0
          : sumsAtEnd[4 * k - 4 + c] + Math.fround(columns[k - 1].end[c]) * (from.share - Math.fround(from.edge));
      const width = k === 0 || k === columns.length - 1 ? 0 : Math.max(0, to.share - from.share);
      sumsAtStart[4 * k + c] = sum - a * (from.share - Math.fround(from.edge));
      sumsAtEnd[4 * k + c] = sum + 0.5 * (a + b) * width - b * (to.share - Math.fround(to.edge));
    }
  });
  return { sumsAtStart, sumsAtEnd };
}

/** The emission at a share, and the integral up to it, counted from an edge of its column. */
interface Place {
  readonly column: number;
  readonly emission: Premultiplied;
  readonly sum: Premultiplied;
}

/** Twin: shaders/chunks/classify/columns.glsl, columnsField */
export function locateShare({ edges, starts, ends, sumsAtStart, sumsAtEnd }: Columns, share: number): Place {
  let column = 0;
  while (column < edges.length - 2 && share >= edges[column + 1]) column++;
  const [low, high] = [edges[column], edges[column + 1]];
  const t = (share - low) / (high - low);
  const [edge, emissions, sums] = t > 0.5 ? [high, ends, sumsAtEnd] : [low, starts, sumsAtStart];
  const at = [0, 1, 2, 3].map(
    (c) => starts[column * 4 + c] + t * (ends[column * 4 + c] - starts[column * 4 + c]),
  ) as Premultiplied;
  const sum = at.map(
    (x, c) => sums[column * 4 + c] + 0.5 * (x + emissions[column * 4 + c]) * (share - edge),
  ) as Premultiplied;
  return { column, emission: at, sum };
}

/** The mean emission over the shares between two. Twin: shaders/chunks/classify/columns.glsl, meanOfSamples */
export function meanOverColumns(columns: Columns, from: number, to: number): Premultiplied {
  const [a, b] = [locateShare(columns, from), locateShare(columns, to)];
  if (a.column === b.column) return a.emission.map((x, c) => 0.5 * (x + b.emission[c])) as Premultiplied;
  return a.sum.map((x, c) => (b.sum[c] - x) / (to - from)) as Premultiplied;
}
