import type { RaySetup } from '../optics/rays/rays.ts';
import { length, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';

/** A level is fine enough where a pixel covers so many of its voxels: what is finer would only be noise from one pixel to the next. */
const voxelsAPixel = 2;

/**
 * The coarsest level that is fine enough for the pixels of a picture, at a place of a ray; 0 is the finest.
 * @param rays - over the unit cube of the volume
 * @param pixels - across and down
 * @param voxels - by level, finest first: along each axis of the unit cube
 * @returns of a ray's parameter t
 */
export function levelOfPixels(
  { point, direction, eyeT }: RaySetup,
  pixels: readonly [number, number],
  voxels: readonly Vector3[],
): (t: number) => number {
  const isParallel = eyeT === -Infinity;
  // From one pixel's ray to the next, across and down: anywhere, or at t = eyeT + 1; it grows from the eye on.
  const apart = [1, 2].map((way) => scale((isParallel ? point : direction)[way], 2 / pixels[way - 1]));
  const from = voxels.map((counts) => {
    const covered = Math.min(...apart.map((d) => length(d.map((x, axis) => x * counts[axis]) as unknown as Vector3)));
    if (isParallel) return covered >= voxelsAPixel ? -Infinity : Infinity;
    return eyeT + voxelsAPixel / covered;
  });
  return (t) => {
    let level = 0;
    while (level + 1 < from.length && t >= from[level + 1]) level++;
    return level;
  };
}
