import type { Macrocells } from '../../volume/macrocells.ts';
import type { TransferFunction } from '../transfer/transfer-function.ts';

/** The largest number of rings that is stored, so that it fits a byte. */
const maxRings = 255;

/** Whether any value of a range (both ends included) can be visible in a macrocell. Data units. */
export type Contribution = (low: number, high: number, cell: number) => boolean;

/**
 * How far each macrocell is from anything visible. It is 0 for a cell in which something can be visible. Else it is the number of
 * rings of cells (the cell itself is the first) in which nothing can be. A ray may cross these rings without sampling.
 *
 * A ray that crosses several empty cells at once misses nothing: neighbouring cells share voxels, so the ranges of connected empty
 * cells overlap and lie in the same gap of the transfer function. Cells that are empty for different reasons are not crossed
 * together: a piece of a ray may begin at values that are not visible and end in a hidden label, and be slightly visible.
 * @param contributions - a value is visible if all of them let it through
 * @param slope - data value = slope * stored value + intercept
 * @returns one byte per cell, i fastest
 * Source: the distance field of Deakin and Knoll, *Efficient ray casting of volumetric images using distance maps for
 * empty space skipping*, 2020
 */
export function measureEmptySpace(
  cells: Macrocells,
  contributions: readonly Contribution[],
  { slope, intercept }: { slope: number; intercept: number },
): Uint8Array<ArrayBuffer> {
  const measure = (shows: Contribution): Uint8Array<ArrayBuffer> => {
    const distances = new Uint8Array(cells.low.length).fill(maxRings);
    for (let cell = 0; cell < distances.length; cell++) {
      if (!(cells.low[cell] <= cells.high[cell])) continue; // no data
      const a = slope * cells.low[cell] + intercept;
      const b = slope * cells.high[cell] + intercept;
      if (shows(Math.min(a, b), Math.max(a, b), cell)) distances[cell] = 0;
    }
    return spread(distances, cells.dimensions);
  };
  const [farthest, ...others] = (contributions.length > 0 ? contributions : [() => true]).map(measure);
  for (const other of others) other.forEach((rings, cell) => (farthest[cell] = Math.max(farthest[cell], rings)));
  return farthest;
}

/** The largest code of a cell in which something is visible: see `readCode` in optics/cells/cell-detail.ts. */
export const lastCode = 63;

/**
 * What the shader reads for each cell: how far it is from anything visible or, if something in it is visible, how finely to sample it.
 * @param distances - from `measureEmptySpace`; they are overwritten
 * @param codes - up to `lastCode`; if absent, all are 0
 */
export function encodeCells(
  distances: Uint8Array<ArrayBuffer>,
  codes: Uint8Array = distances,
): Uint8Array<ArrayBuffer> {
  for (let cell = 0; cell < distances.length; cell++) {
    distances[cell] = distances[cell] > 0 ? Math.min(maxRings, distances[cell] + lastCode) : codes[cell];
  }
  return distances;
}

/** A range of values of which some are visible. At an open end, the end value itself is not. */
interface VisibleSpan {
  low: number;
  high: number;
  openLow: boolean;
  openHigh: boolean;
}

/** In ascending order. Neighbours that touch are joined, so the list is short for any number of stops. */
function listVisibleSpans(transferFunction: TransferFunction): VisibleSpan[] {
  const last = transferFunction.length - 1;
  const spans: VisibleSpan[] = [];
  const add = (span: VisibleSpan): void => {
    const before = spans.at(-1);
    if (before?.high !== span.low) {
      spans.push(span);
      return;
    }
    before.openLow &&= span.openLow || span.low > before.low;
    before.openHigh = span.openHigh && (span.high > before.high || before.openHigh);
    before.high = span.high;
  };
  if (transferFunction[0].opacity > 0)
    add({ low: -Infinity, high: transferFunction[0].value, openLow: false, openHigh: true });
  for (let i = 0; i < last; i++) {
    const [from, to] = [transferFunction[i], transferFunction[i + 1]];
    if (from.opacity === 0 && to.opacity === 0) continue;
    add({ low: from.value, high: to.value, openLow: from.opacity === 0, openHigh: to.opacity === 0 });
  }
  if (transferFunction[last].opacity > 0)
    add({ low: transferFunction[last].value, high: Infinity, openLow: false, openHigh: false });
  return spans;
}

function meets(spans: readonly VisibleSpan[], low: number, high: number): boolean {
  // Binary search for the first span that ends behind `low`: labels may have tens of thousands of spans.
  let [from, to] = [0, spans.length];
  while (from < to) {
    const middle = (from + to) >> 1;
    const isBehind = spans[middle].openHigh ? low < spans[middle].high : low <= spans[middle].high;
    if (isBehind) to = middle;
    else from = middle + 1;
  }
  const span = spans[from];
  return span !== undefined && (span.openLow ? high > span.low : high >= span.low);
}

/** Which values a transfer function makes visible. */
export function contributionOf(transferFunction: TransferFunction): (low: number, high: number) => boolean {
  const spans = listVisibleSpans(transferFunction);
  return (low, high) => meets(spans, low, high);
}

/**
 * Chebyshev distances by two passes, forward and backward. Each pass looks at half of the 26 neighbours. A frame of cells without data
 * surrounds the grid.
 */
function spread(distances: Uint8Array, [nx, ny, nz]: readonly [number, number, number]): Uint8Array<ArrayBuffer> {
  const [row, slice] = [nx + 2, (nx + 2) * (ny + 2)];
  const framed = new Uint8Array(slice * (nz + 2)).fill(maxRings);
  const copyRows = (copy: (at: number, from: number) => void): void => {
    for (let z = 0; z < nz; z++)
      for (let y = 0; y < ny; y++) copy((z + 1) * slice + (y + 1) * row + 1, nx * (y + ny * z));
  };
  copyRows((at, from) => framed.set(distances.subarray(from, from + nx), at));
  const before = Int32Array.from(half, ([dx, dy, dz]) => -(dx + dy * row + dz * slice));
  const relax = (cell: number, direction: 1 | -1): void => {
    let min = framed[cell];
    for (let i = 0; i < before.length; i++) {
      const near = framed[cell + direction * before[i]] + 1;
      if (near < min) min = near;
    }
    framed[cell] = min;
  };
  for (let z = 1; z <= nz; z++)
    for (let y = 1; y <= ny; y++)
      for (let x = 1, cell = z * slice + y * row + 1; x <= nx; x++, cell++) if (framed[cell] > 0) relax(cell, 1);
  for (let z = nz; z >= 1; z--)
    for (let y = ny; y >= 1; y--)
      for (let x = nx, cell = z * slice + y * row + nx; x >= 1; x--, cell--) if (framed[cell] > 0) relax(cell, -1);
  const spreadOut = new Uint8Array(distances.length);
  copyRows((at, from) => spreadOut.set(framed.subarray(at, at + nx), from));
  return spreadOut;
}

/** The neighbours that a pass in the order of the cells has already visited. */
const half: readonly (readonly [number, number, number])[] = [-1, 0, 1]
  .flatMap((dz) => [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => [dx, dy, dz] as const)))
  .filter(([dx, dy, dz]) => dz > 0 || (dz === 0 && (dy > 0 || (dy === 0 && dx > 0))));
