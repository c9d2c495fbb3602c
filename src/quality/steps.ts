import { finestSpacing, longestDiagonal } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';

/** Maximum for `steps="auto"` with any grid. There is a limit because an error is measured with four times the steps. */
export const maxAutoSteps = 4096;

/** Length of the longest ray, in voxels of the grid's finest axis. */
export function voxelsAlong(grid: GridFrame): number {
  return Math.max(1, Math.ceil(longestDiagonal(grid) / finestSpacing(grid)));
}

/** Number of samples along the longest ray that gives one sample per voxel, or the maximum. */
export function autoSteps(grid: GridFrame): number {
  return Math.min(maxAutoSteps, voxelsAlong(grid));
}

/** World length of a step if the longest ray has this many steps. */
export function stepLengthOf(grid: GridFrame, steps: number): number {
  return longestDiagonal(grid) / steps;
}
