import { finestSpacing, longestDiagonal } from '../volume/grid.ts';
import type { CartesianGrid } from '../volume/grid.ts';

/** `steps="auto"` goes no further, whatever the grid: beyond it pictures get slow and hardly better. */
const maxAutoSteps = 2000;

/** Fewer steps than this show bands instead of a volume, also for the moment of a turn. */
const minMovingSteps = 32;

/** Samples along the longest ray that give one sample per voxel, by the grid's finest axis. */
export function autoSteps(grid: CartesianGrid): number {
  return Math.min(maxAutoSteps, Math.max(1, Math.ceil(longestDiagonal(grid) / finestSpacing(grid))));
}

/** World length of a step that cuts the longest ray into so many. */
export function stepLengthOf(grid: CartesianGrid, steps: number): number {
  return longestDiagonal(grid) / steps;
}

/**
 * Steps for a picture that should be there within a time, from how long the last one took. The time is taken to grow
 * in proportion to the steps; half of the change is made at once, so that one slow frame does no harm.
 * @param budgetMs - time wished for
 * @param full - steps of the still picture: never exceeded
 */
export function movingSteps(
  { steps, frameMs }: { steps: number; frameMs: number },
  budgetMs: number,
  full: number,
): number {
  const fitting = frameMs > 0 ? (steps * budgetMs) / frameMs : full;
  const next = fitting < steps ? fitting : (fitting + steps) / 2;
  return Math.round(Math.min(full, Math.max(Math.min(minMovingSteps, full), next)));
}
