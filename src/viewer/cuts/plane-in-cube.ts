import { unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { dot, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/**
 * A plane of the world, normal . p = at, in the unit cube of a grid: the normal gets a size that suits float arithmetic.
 * @param normal - of any length except zero
 */
export function planeInCube(
  normal: Vector3,
  at: number,
  grid: GridFrame,
): { readonly normal: Vector3; readonly offset: number } {
  const m = unitToWorld(grid);
  const turned = [0, 1, 2].map((column) =>
    dot(normal, [m[column], m[4 + column], m[8 + column]]),
  ) as unknown as Vector3;
  const size = Math.max(...turned.map(Math.abs));
  return { normal: scale(turned, 1 / size), offset: (at - dot(normal, [m[3], m[7], m[11]])) / size };
}

/** The middle of a grid's box, along a normal. */
export function middleAlong(normal: Vector3, places: readonly Vector3[]): number {
  const along = places.map((place) => dot(normal, place));
  return (Math.min(...along) + Math.max(...along)) / 2;
}
