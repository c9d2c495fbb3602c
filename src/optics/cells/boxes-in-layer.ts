// Where the macrocells of a volume lie in a layer over it, and which values the layer has there.
import { transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Grid, VolumeData } from '../../volume/volume.ts';
import { toOverlay } from '../attachments/overlay.ts';

/** A box along the axes of a layer's unit cube. It may reach beyond the cube. */
export interface UnitBox {
  readonly low: Vector3;
  readonly high: Vector3;
}

/** Allowance for rounding of places in the unit cube. */
const rounding = 1e-6;

/** Allowance for rounding of places among voxels. */
const voxelRounding = 1e-3;

/** Maps a macrocell of a volume (by its whole-number index) to the box of the layer that contains it. Null if one of the two is flat. */
export function boxesIn(
  { grid, macrocells: { size } }: Pick<VolumeData, 'grid' | 'macrocells'>,
  layer: Grid,
): ((cell: Vector3) => UnitBox) | null {
  const matrix = toOverlay(grid, layer);
  if (!matrix) return null;
  const { dimensions } = grid;
  return (cell) => {
    const edge = (at: number, axis: number): number => Math.min(1, (at * size) / dimensions[axis]);
    const middle = cell.map((at, axis) => (edge(at, axis) + edge(at + 1, axis)) / 2) as unknown as Vector3;
    const half = cell.map((at, axis) => (edge(at + 1, axis) - edge(at, axis)) / 2);
    const center = transformPoint(matrix, middle);
    const reach = [0, 1, 2].map(
      (row) => half.reduce((sum, h, axis) => sum + h * Math.abs(matrix[4 * row + axis]), 0) + rounding,
    );
    const [low, high] = [-1, 1].map((side) => center.map((x, axis) => x + side * reach[axis]) as unknown as Vector3);
    return { low, high };
  };
}

/** Whether a box lies wholly outside the layer. */
export function isOutside({ low, high }: UnitBox): boolean {
  return low.some((x) => x > 1) || high.some((x) => x < 0);
}

/** Whether a box reaches beyond the layer by more than the boxes were enlarged for rounding. */
export function reachesBeyond({ low, high }: UnitBox): boolean {
  return low.some((x) => x < -2 * rounding) || high.some((x) => x > 1 + 2 * rounding);
}

/** Number of voxels that the samples in a box interpolate, as if there were voxels everywhere. */
export function countTouched({ low, high }: UnitBox, dimensions: Vector3): number {
  return dimensions.reduce((product, n, axis) => product * ((high[axis] - low[axis]) * n + 2), 1);
}

/**
 * Smallest and largest data value of the voxels that the samples in a box interpolate. If these have no data, the smallest
 * is above the largest.
 */
export function boxReader({
  samples,
  grid: { dimensions },
  slope,
  intercept,
}: VolumeData): (box: UnitBox) => readonly [low: number, high: number] {
  const [nx, ny] = dimensions;
  const inside = (index: number, axis: number): number => Math.min(dimensions[axis] - 1, Math.max(0, index));
  return ({ low, high }) => {
    const first = low.map((x, axis) => inside(Math.floor(x * dimensions[axis] - 0.5 - voxelRounding), axis));
    const last = high.map((x, axis) => inside(Math.ceil(x * dimensions[axis] - 0.5 + voxelRounding), axis));
    let [min, max] = [Infinity, -Infinity];
    for (let z = first[2]; z <= last[2]; z++)
      for (let y = first[1]; y <= last[1]; y++) {
        const row = nx * (y + ny * z);
        for (let at = row + first[0]; at <= row + last[0]; at++) {
          const stored = samples[at];
          if (stored < min) min = stored; // Both comparisons are false for NaN.
          if (stored > max) max = stored;
        }
      }
    if (!(min <= max)) return [Infinity, -Infinity];
    const ends = [slope * min + intercept, slope * max + intercept];
    return [Math.min(...ends), Math.max(...ends)];
  };
}
