import { edgeLengths } from './grid.ts';
import type { Grid } from './volume.ts';

/** A volume is thin if its longest edge is more than so many times its shortest one: few scans are. */
const maxUsualRatio = 5;

/** The edges are computed as products and have rounding errors. */
const rounding = 1e-9;

/** 1 % of a volume's longest edge: with it, pictures have the same density at any size. */
export function longestEdgeShare(grid: Grid): number {
  return Math.max(...edgeLengths(grid)) / 100;
}

/**
 * The world length to which a stop's opacity applies, if nothing else sets it: 1 % of the longest edge. In a thin
 * volume that would leave almost nothing of a ray's opacity along the shortest edge. So there the length gives as much
 * as in a volume that is just not thin: 100 / 5 of these lengths. A radar's cells are not a box: its file suggests its
 * own length.
 * Derived in docs/develop/maths.md, "Opacity per reference length".
 */
export function defaultReferenceLength(grid: Grid): number {
  const usual = longestEdgeShare(grid);
  const atThin = (maxUsualRatio * Math.min(...edgeLengths(grid))) / 100;
  return grid.kind === 'polar' || usual <= atThin * (1 + rounding) ? usual : atThin;
}
