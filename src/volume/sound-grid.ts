import type { GridFrame } from './grid.ts';
import { longest, maxVoxelsPerAxis } from './grid-limits.ts';
import { invertAffine } from './matrix.ts';

/** Whether a camera can look at a grid: it is finite, not flat, and neither too large nor too small for float32. */
export function isSoundGrid({ dimensions, indexToWorld, spacing }: GridFrame): boolean {
  return (
    invertAffine(indexToWorld) !== null &&
    indexToWorld.every((n) => Math.abs(n) <= longest) &&
    dimensions.every((n, axis) => n <= maxVoxelsPerAxis && spacing[axis] >= 1 / longest && n * spacing[axis] <= longest)
  );
}
