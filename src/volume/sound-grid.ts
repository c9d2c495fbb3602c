import type { GridFrame } from './grid.ts';
import { invertAffine } from './matrix.ts';

/** World units: a box that is this long has a volume that float32 holds, and so has a voxel that is 1 / this long. */
export const longest = 1e12;

/** Most voxels along an axis: far more than any device shows, and few enough to be counted by their rows. */
export const maxVoxelsPerAxis = 2 ** 20;

/** Whether a grid lies where a camera can look at it: finite, not flat, neither too large nor too small for float32. */
export function isSoundGrid({ dimensions, indexToWorld, spacing }: GridFrame): boolean {
  return (
    invertAffine(indexToWorld) !== null &&
    indexToWorld.every((n) => Math.abs(n) <= longest) &&
    dimensions.every((n, axis) => n <= maxVoxelsPerAxis && spacing[axis] >= 1 / longest && n * spacing[axis] <= longest)
  );
}
