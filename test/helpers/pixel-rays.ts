import { rayThrough } from '../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../src/optics/rays/rays.ts';

/** Pixels across and down. */
type Size = readonly [width: number, height: number];

/** The ray of a picture's pixel, top row first; dx and dy shift it from the pixel's centre, in pixels. */
export function rayOfPixel(rays: RaySetup, [width, height]: Size, pixel: number, [dx, dy] = [0, 0]): Ray {
  const [column, row] = [pixel % width, Math.floor(pixel / width)];
  return rayThrough(rays, ((column + 0.5 + dx) / width) * 2 - 1, 1 - ((row + 0.5 + dy) / height) * 2);
}

/** Cast the ray of each pixel, and return the picture. */
export function castPixels(rays: RaySetup, size: Size, cast: (ray: Ray) => readonly number[]): number[] {
  return Array.from({ length: size[0] * size[1] }, (_, pixel) => cast(rayOfPixel(rays, size, pixel))).flat();
}
