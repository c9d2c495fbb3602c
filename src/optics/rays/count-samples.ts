import { countSteps } from './count-steps.ts';
import { crossVolume, rayThrough } from './rays.ts';
import type { RaySetup } from './rays.ts';

/** Number of rays along each side of the picture that are tried. */
const side = 32;

/**
 * Number of samples of a picture if no ray stops early: the mean over a grid of rays, times the
 * number of pixels.
 * @param stepLength - world length
 */
export function countSamples(rays: RaySetup, stepLength: number, pixels: number): number {
  let steps = 0;
  for (let row = 0; row < side; row++) {
    for (let column = 0; column < side; column++) {
      const ray = rayThrough(rays, ((column + 0.5) / side) * 2 - 1, ((row + 0.5) / side) * 2 - 1);
      const [entry, exit] = crossVolume(rays, ray);
      const total = (exit - Math.max(entry, rays.eyeT)) * ray.lengthPerT;
      if (total > 0) steps += countSteps(total, stepLength / rays.diameter);
    }
  }
  return Math.round((steps / side ** 2) * pixels);
}
