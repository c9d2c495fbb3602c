import { transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Matrix4 } from '../volume/matrix.ts';
import type { SlicePixels } from './fill-slice.ts';

/**
 * Goes through some rows of a slice's pixels.
 * @param worldToIndex - of the grid in whose indices the points are given
 * @param rows - the first, and the one after the last
 * @param visit - receives the offset of the pixel in an RGBA picture, and its index in the grid
 */
export function visitPixels(
  { width, first, across, down }: SlicePixels,
  worldToIndex: Matrix4,
  [begin, end]: readonly [number, number],
  visit: (at: number, x: number, y: number, z: number) => void,
): void {
  const [ax, ay, az] = transformDirection(worldToIndex, across);
  const [dx, dy, dz] = transformDirection(worldToIndex, down);
  const [x0, y0, z0] = transformPoint(worldToIndex, first);
  for (let row = begin; row < end; row++) {
    for (let column = 0, at = 4 * row * width; column < width; column++, at += 4)
      visit(at, x0 + row * dx + column * ax, y0 + row * dy + column * ay, z0 + row * dz + column * az);
  }
}
