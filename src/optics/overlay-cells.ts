import { cellSize, offLine } from '../volume/cell-size.ts';
import { finestSpacing } from '../volume/grid.ts';
import { transformPoint } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import type { SeenVolume } from './cell-detail.ts';
import { emission } from './emission.ts';
import { rangeEmission } from './emission-range.ts';
import { contributionOf } from './empty-space-distance.ts';
import { fullColor, overlayColors, toOverlay } from './overlay.ts';
import type { ShownOverlay } from './overlay.ts';

/** What values a layer has in each macrocell of the volume that it is over. */
export interface OverlayCells {
  /** Data values; the least lies above the largest where there are none. */
  readonly low: Float64Array;
  readonly high: Float64Array;
  /** See `Macrocells`, in data values. */
  readonly roughness: Float64Array;
  /** 1 where the layer ends in the cell. */
  readonly ends: Uint8Array;
}

export function listOverlayCells(over: Volume, volume: Volume): OverlayCells {
  const { dimensions: [nx, ny, nz], low: { length } } = over.macrocells;
  const cells = { low: new Float64Array(length).fill(Infinity), high: new Float64Array(length).fill(-Infinity), roughness: new Float64Array(length), ends: new Uint8Array(length) };
  const { macrocells, slope, intercept } = volume;
  const include = (cell: number, from: number): void => {
    if (!(macrocells.low[from] <= macrocells.high[from])) return;
    const ends = [slope * macrocells.low[from] + intercept, slope * macrocells.high[from] + intercept];
    cells.low[cell] = Math.min(cells.low[cell], ...ends);
    cells.high[cell] = Math.max(cells.high[cell], ...ends);
    cells.roughness[cell] = Math.max(cells.roughness[cell], Math.abs(slope) * macrocells.roughness[from]);
  };
  if (isPolar(over)) {
    // The same gates in the same box.
    for (let cell = 0; cell < length; cell++) include(cell, cell);
    return cells;
  }
  const spanOf = boxesIn(over, volume);
  const [mx, my] = macrocells.dimensions;
  for (let k = 0, cell = 0; k < nz; k++) for (let j = 0; j < ny; j++) for (let i = 0; i < nx; i++, cell++) {
    const { first, last, isInside } = spanOf([i, j, k]);
    cells.ends[cell] = Number(!isInside);
    for (let z = first[2]; z <= last[2]; z++) for (let y = first[1]; y <= last[1]; y++) for (let x = first[0]; x <= last[0]; x++) include(cell, x + mx * (y + my * z));
  }
  return cells;
}

/** Macrocells of the layer, from the first to the last along each axis. */
interface CellSpan {
  readonly first: Vector3;
  readonly last: Vector3;
  /** Whether all of the box lies in the layer's grid. */
  readonly isInside: boolean;
}

/** Which macrocells of a layer the box around a macrocell of the volume meets. */
function boxesIn({ grid }: Volume, volume: Volume): (cell: Vector3) => CellSpan {
  const matrix = toOverlay(grid, volume.grid);
  const none: CellSpan = { first: [0, 0, 0], last: [-1, -1, -1], isInside: true };
  if (!matrix) return () => none;
  const { dimensions } = volume.grid;
  return (cell) => {
    const edge = (at: number, axis: number): number => Math.min(1, (at * cellSize) / grid.dimensions[axis]);
    const middle = cell.map((at, axis) => (edge(at, axis) + edge(at + 1, axis)) / 2) as unknown as Vector3;
    const half = cell.map((at, axis) => (edge(at + 1, axis) - edge(at, axis)) / 2);
    const center = transformPoint(matrix, middle);
    const reach = [0, 1, 2].map((row) => half.reduce((sum, h, axis) => sum + h * Math.abs(matrix[4 * row + axis]), 0) + 1e-6);
    const [low, high] = [-1, 1].map((side) => center.map((x, axis) => x + side * reach[axis]));
    if (low.some((x) => x > 1) || high.some((x) => x < 0)) return none;
    const toCell = (x: number, axis: number): number => Math.min(volume.macrocells.dimensions[axis] - 1, Math.max(0, Math.floor((x * dimensions[axis]) / cellSize)));
    const slack = 2e-6;
    return {
      first: low.map(toCell) as unknown as Vector3,
      last: high.map(toCell) as unknown as Vector3,
      isInside: low.every((x) => x >= -slack) && high.every((x) => x <= 1 + slack),
    };
  };
}

/** Where a layer shows something of its own, whatever the volume has there: a byte a macrocell. Null for one that only colours. */
export function shownByOverlay({ low, high }: OverlayCells, { blend, transferFunction }: ShownOverlay): Uint8Array | null {
  if (blend === 'color') return null;
  const shows = contributionOf(transferFunction);
  return Uint8Array.from(low, (least, cell) => Number(least <= high[cell] && shows(least, high[cell])));
}

/**
 * What a layer adds to the optical depth that could be missed in a cell: see `SeenVolume`. One whose voxels are larger than the volume's is
 * the straighter between its samples, and one with smaller ones may do anything between its least and its largest value.
 */
export function overlaidDetail(cells: OverlayCells, overlay: ShownOverlay, { seen, lightFactor }: {
  readonly seen: Omit<SeenVolume, 'cells'>;
  readonly lightFactor: number;
}): NonNullable<SeenVolume['more']> {
  const { grid, macrocells, slope, intercept } = seen.volume;
  const colors = overlayColors(overlay, lightFactor);
  const range = rangeEmission(colors);
  const own = rangeEmission(seen.transferFunction);
  const before: NonNullable<SeenVolume['more']> = seen.more ?? ((_, depthIn) => depthIn(own));
  const finest = finestSpacing(grid);
  const ratio = finest / finestSpacing(overlay.volume.grid);
  const straight = offLine * (ratio > 1 ? ratio ** 2 : ratio);
  const length = 2 * finest * seen.opticalScale;
  return (cell, depthIn, kind) => {
    const missed = before(cell, depthIn, kind);
    const [low, high] = [cells.low[cell], cells.high[cell]];
    if (!(low <= high)) return missed;
    const largest = cells.ends[cell] ? Math.max(...emission(colors, low), ...emission(colors, high)) : 0;
    const change = Math.max(largest, range[kind](low, high, Math.min(high - low, straight * cells.roughness[cell])));
    if (overlay.blend === 'mix') return missed + change * length * overlay.opacityFactor;
    const ends = [slope * macrocells.low[cell] + intercept, slope * macrocells.high[cell] + intercept];
    const [from, to] = [Math.min(...ends), Math.max(...ends)];
    if (!Number.isFinite(to - from)) return missed;
    const most = Math.min(...ends.map((value) => emission(seen.transferFunction, value)[3])) + own.among(from, to, to - from);
    return missed + Math.min(1, change / fullColor) * most * length;
  };
}
