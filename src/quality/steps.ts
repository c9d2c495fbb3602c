import { finestSpacing, longestDiagonal } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';

/** Maximum for `steps="auto"` with any grid: an error is measured with four times the steps, and rays have an end. */
export const maxAutoSteps = 4096;

/** Voxels of the grid's finest axis that the longest ray is long. */
export function voxelsAlong(grid: GridFrame): number {
  return Math.max(1, Math.ceil(longestDiagonal(grid) / finestSpacing(grid)));
}

/** Samples along the longest ray that give one sample per voxel, or as many as there may be. */
export function autoSteps(grid: GridFrame): number {
  return Math.min(maxAutoSteps, voxelsAlong(grid));
}

/** World length of a step if the longest ray has so many. */
export function stepLengthOf(grid: GridFrame, steps: number): number {
  return longestDiagonal(grid) / steps;
}
