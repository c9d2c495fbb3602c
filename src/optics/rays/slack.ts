import type { Ray } from './rays.ts';

/** What floats make of places in the unit cube, and more; far less than a voxel. */
const rounding = 1e-5;

/** Where two things that end a ray are nearer to each other than this, in its t, they are at one place. Twin: shaders/chunks/walk/slack.glsl */
export function slackOf({ direction }: Pick<Ray, 'direction'>): number {
  return rounding / Math.max(...direction.map(Math.abs));
}

/** The same where a ray meets a plane: the flatter it does, the farther it is off. @param slope - normal . direction, the largest part of the normal being 1 */
export function slackAt(slope: number): number {
  return (0.5 * rounding) / Math.abs(slope);
}
