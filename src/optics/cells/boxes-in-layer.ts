// Where the macrocells of a volume lie in a layer over it, and what values the layer has there.
import { cellSize } from '../../volume/cell-size.ts';
import { transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Grid, Volume } from '../../volume/volume.ts';
import { toOverlay } from '../attachments/overlay.ts';

/** Along the axes of a layer's unit cube, which it may reach beyond. */
export interface UnitBox {
  readonly low: Vector3;
  readonly high: Vector3;
}

/** Of places in the unit cube, for rounding. */
const rounding = 1e-6;

/** Of places among voxels, for rounding. */
const voxelRounding = 1e-3;

/** The box of a layer that a macrocell of a volume is in, by the cell's whole numbers. Null where one of the two is flat. */
export function boxesIn(over: Grid, layer: Grid): ((cell: Vector3) => UnitBox) | null {
  const matrix = toOverlay(over, layer);
  if (!matrix) return null;
  const { dimensions } = over;
  return (cell) => {
    const edge = (at: number, axis: number): number => Math.min(1, (at * cellSize) / dimensions[axis]);
    const middle = cell.map((at, axis) => (edge(at, axis) + edge(at + 1, axis)) / 2) as unknown as Vector3;
    const half = cell.map((at, axis) => (edge(at + 1, axis) - edge(at, axis)) / 2);
    const center = transformPoint(matrix, middle);
    const reach = [0, 1, 2].map((row) => half.reduce((sum, h, axis) => sum + h * Math.abs(matrix[4 * row + axis]), 0) + rounding);
    const [low, high] = [-1, 1].map((side) => center.map((x, axis) => x + side * reach[axis]) as unknown as Vector3);
    return { low, high };
  };
}

/** Whether a box lies beside the layer altogether. */
export function isBeside({ low, high }: UnitBox): boolean {
  return low.some((x) => x > 1) || high.some((x) => x < 0);
}

/** Whether a box reaches beyond the layer, by more than boxes are made larger for rounding. */
export function reachesBeyond({ low, high }: UnitBox): boolean {
  return low.some((x) => x < -2 * rounding) || high.some((x) => x > 1 + 2 * rounding);
}

/** Voxels that samples in a box lie between, as if there were voxels everywhere. */
export function countTouched({ low, high }: UnitBox, dimensions: Vector3): number {
  return dimensions.reduce((product, n, axis) => product * ((high[axis] - low[axis]) * n + 2), 1);
}

/** Least and largest data value of the voxels that samples in a box lie between; the least lies above the largest where these have no data. */
export function boxReader({ samples, grid: { dimensions }, slope, intercept }: Volume): (box: UnitBox) => readonly [low: number, high: number] {
  const [nx, ny] = dimensions;
  const inside = (index: number, axis: number): number => Math.min(dimensions[axis] - 1, Math.max(0, index));
  return ({ low, high }) => {
    const first = low.map((x, axis) => inside(Math.floor(x * dimensions[axis] - 0.5 - voxelRounding), axis));
    const last = high.map((x, axis) => inside(Math.ceil(x * dimensions[axis] - 0.5 + voxelRounding), axis));
    let [least, most] = [Infinity, -Infinity];
    for (let z = first[2]; z <= last[2]; z++) for (let y = first[1]; y <= last[1]; y++) {
      const row = nx * (y + ny * z);
      for (let at = row + first[0]; at <= row + last[0]; at++) {
        const stored = samples[at];
        if (stored < least) least = stored; // NaN is neither.
        if (stored > most) most = stored;
      }
    }
    if (!(least <= most)) return [Infinity, -Infinity];
    const ends = [slope * least + intercept, slope * most + intercept];
    return [Math.min(...ends), Math.max(...ends)];
  };
}
