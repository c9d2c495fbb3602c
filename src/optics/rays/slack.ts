import type { Ray } from './rays.ts';

/** Rounding of places in the unit cube in float32, with a margin; far less than a voxel. */
const rounding = 1e-5;

/**
 * If two things that end a ray are nearer to each other than this, in its t, they count as one place.
 * Twin: shaders/chunks/walk/slack.glsl
 */
export function slackOf({ direction }: Pick<Ray, 'direction'>): number {
  return rounding / Math.max(...direction.map(Math.abs));
}

/**
 * The same where a ray meets a plane: the smaller the angle, the larger the error along the ray.
 * @param slope - normal . direction; the largest part of the normal is 1
 */
export function slackAt(slope: number): number {
  return (0.5 * rounding) / Math.abs(slope);
}
