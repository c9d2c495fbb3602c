import { castRay } from '../../src/optics/rays/cast-ray.ts';
import type { RayStages } from '../../src/optics/rays/ray-stages.ts';
import type { Ray, RaySetup } from '../../src/optics/rays/rays.ts';
import { height, width } from './picture.ts';
import { rayOfPixel } from './pixel-rays.ts';

/** The ray of a test picture's pixel, top row first. @param shift - from the pixel's centre, in pixels */
export function rayAt(rays: RaySetup, pixel: number, shift: [number, number] = [0, 0]): Ray {
  return rayOfPixel(rays, [width, height], pixel, shift);
}

/** Pixels of a picture that are off by more than 2/255. */
export function listOff(got: ArrayLike<number>, expected: ArrayLike<number>): Set<number> {
  return new Set(Array.from(got).flatMap((x, i) => (Math.abs(x - expected[i]) > 2 ? [i >> 2] : [])));
}

/** Whether a tiny shift changes the colour at a pixel's centre, as at an edge: compares rays that are a thousandth of a pixel away. */
export function isEdge(stages: RayStages, rays: RaySetup, pixel: number): boolean {
  const colors = [
    [0, 0],
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ].map(([dx, dy]) => castRay(stages, rayAt(rays, pixel, [dx * 1e-3, dy * 1e-3])));
  return colors.some((color) => color.some((channel, c) => Math.abs(channel - colors[0][c]) > 0.004));
}
