import { edgeLengths } from './grid.ts';
import type { Grid } from './volume.ts';

/** A volume whose longest edge is more than so many times its shortest is thin: few scans are. */
const maxUsualRatio = 5;

/** Edges are products of numbers of voxels and lengths. */
const rounding = 1e-9;

/** 1 % of a volume's longest edge: with it, pictures are as dense at any size. */
export function longestEdgeShare(grid: Grid): number {
  return Math.max(...edgeLengths(grid)) / 100;
}

/**
 * The world length over which a stop's opacity holds, where nobody says another: 1 % of the longest edge. A ray straight through a thin
 * volume would meet next to nothing in it; there, it meets as much as in one that is just not thin: 100 / 5 of these lengths.
 * A radar's cells are no box: its file suggests a length of its own.
 * Derived in docs/maths.md, "Opacity per reference length".
 */
export function defaultReferenceLength(grid: Grid): number {
  const usual = longestEdgeShare(grid);
  const atThin = (maxUsualRatio * Math.min(...edgeLengths(grid))) / 100;
  return grid.kind === 'polar' || usual <= atThin * (1 + rounding) ? usual : atThin;
}
