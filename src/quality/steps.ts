import { finestSpacing, longestDiagonal } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';

/** Maximum for `steps="auto"` with any grid: an error is measured with four times the steps, and rays have an end. */
export const maxAutoSteps = 4096;

/** Samples along the longest ray that give one sample per voxel, by the grid's finest axis. */
export function autoSteps(grid: GridFrame): number {
  return Math.min(maxAutoSteps, Math.max(1, Math.ceil(longestDiagonal(grid) / finestSpacing(grid))));
}

/** World length of a step if the longest ray has so many. */
export function stepLengthOf(grid: GridFrame, steps: number): number {
  return longestDiagonal(grid) / steps;
}
