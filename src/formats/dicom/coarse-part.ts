// A small volume of some slices, which is shown until all are there, and the order in which slices are read for it.
import { cartesianGrid } from '../../volume/grid.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import { multiply, scaleAndTranslate } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { arrayOf } from './decode-frame.ts';
import type { FrameNumbers } from './decode-frame.ts';
import type { StoredType } from './picture.ts';

/** One slice of so many is read first. */
const apart = 8;

/** Stacks of fewer slices are read at once. */
export const minSlices = 32;

/** Voxels of the small volume, of which one in a row and in a column is taken for several. */
const maxVoxels = 2 ** 21;

/** Slices that come first, in equal steps over the whole stack, by their numbers; none for a stack of few. */
export function chooseFirst(slices: number): number[] {
  return slices < minSlices ? [] : choosePlaces(slices, Math.ceil(slices / apart));
}

/** In what order slices are read: those that come first, then the others, of both the middle ones first. @param first - by their numbers */
export function orderSlices(slices: number, first: readonly number[]): number[] {
  const early = new Set(first);
  const middle = (slices - 1) / 2;
  const all = Array.from({ length: slices }, (_, k) => k);
  all.sort((a, b) => Number(early.has(b)) - Number(early.has(a)) || Math.abs(a - middle) - Math.abs(b - middle));
  return all;
}

/**
 * The numbers of those slices, fewer in a row and in a column.
 * @param numbers - of the whole volume, of which only those slices are there
 */
export function cutCoarsePart(
  { type, numbers }: { readonly type: StoredType; readonly numbers: FrameNumbers },
  dimensions: Vector3,
): FrameNumbers {
  const [nx, ny, nz] = dimensions;
  const to = coarseDimensions(dimensions);
  const [columns, rows] = [choosePlaces(nx, to[0]), choosePlaces(ny, to[1])];
  const part = new arrayOf[type](to[0] * to[1] * to[2]);
  let at = 0;
  for (const k of chooseFirst(nz))
    for (const j of rows) for (const i of columns) part[at++] = numbers[(k * ny + j) * nx + i];
  return part;
}

/** The grid of those numbers. Its outer faces are those of the whole one. */
export function coarsenGrid({ dimensions, indexToWorld }: CartesianGrid): CartesianGrid {
  const to = coarseDimensions(dimensions);
  const scale = to.map((n, axis) => dimensions[axis] / n) as unknown as Vector3;
  const offset = scale.map((s) => (s - 1) / 2) as unknown as Vector3;
  return cartesianGrid(to, multiply(indexToWorld, scaleAndTranslate(scale, offset)));
}

function coarseDimensions([nx, ny, nz]: Vector3): Vector3 {
  const slices = chooseFirst(nz).length;
  for (let step = 1; ; step++) {
    const [columns, rows] = [Math.ceil(nx / step), Math.ceil(ny / step)];
    if (columns * rows * slices <= maxVoxels || columns * rows === 1) return [columns, rows, slices];
  }
}

/** The middles of equal parts of a row. */
function choosePlaces(length: number, parts: number): number[] {
  return Array.from({ length: parts }, (_, i) => Math.floor(((i + 0.5) * length) / parts));
}
