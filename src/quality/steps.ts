import { finestSpacing, longestDiagonal } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';

/** `steps="auto"` goes no further, whatever the grid: beyond it pictures get slow and hardly better. */
const maxAutoSteps = 2000;

/** Samples along the longest ray that give one sample per voxel, by the grid's finest axis. */
export function autoSteps(grid: GridFrame): number {
  return Math.min(maxAutoSteps, Math.max(1, Math.ceil(longestDiagonal(grid) / finestSpacing(grid))));
}

/** World length of a step that cuts the longest ray into so many. */
export function stepLengthOf(grid: GridFrame, steps: number): number {
  return longestDiagonal(grid) / steps;
}
