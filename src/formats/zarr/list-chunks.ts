import type { Vector3 } from '../../volume/matrix.ts';
import type { ZarrArray } from './zarr-array.ts';

/** What is read of an array: a box of voxels along its axes of space, and one index along each other axis. */
export interface ArrayBox {
  /** Which axis of the array is i, j and k; null for an axis that it does not have. */
  readonly axes: readonly [number, number, number | null];
  /** The first voxel along i, j and k. */
  readonly first: Vector3;
  readonly dimensions: Vector3;
  /** For each axis of the array that is none of these: the index. */
  readonly at: readonly number[];
}

/** Places of the chunks along each axis that a box needs. */
export function chunkSpans(
  { shape, chunk }: Pick<ZarrArray, 'shape' | 'chunk'>,
  box: ArrayBox,
): { first: number; count: number }[] {
  return shape.map((_, axis) => {
    const which = box.axes.indexOf(axis);
    const start = which < 0 ? box.at[axis] : box.first[which];
    const end = which < 0 ? start + 1 : start + box.dimensions[which];
    const first = Math.floor(start / chunk[axis]);
    return { first, count: Math.ceil(end / chunk[axis]) - first };
  });
}

/** How many chunks a box needs. */
export function countChunks(array: Pick<ZarrArray, 'shape' | 'chunk'>, box: ArrayBox): number {
  return chunkSpans(array, box).reduce((product, { count }) => product * count, 1);
}

/** The places of all chunks that a box needs, those of its middle first. */
export function listChunks(array: Pick<ZarrArray, 'shape' | 'chunk'>, box: ArrayBox): (readonly number[])[] {
  const spans = chunkSpans(array, box);
  let places: (readonly number[])[] = [[]];
  for (const { first, count } of spans)
    places = places.flatMap((place) => Array.from({ length: count }, (_, i) => [...place, first + i]));
  const away = (place: readonly number[]): number =>
    spans.reduce((sum, { first, count }, axis) => sum + ((place[axis] - first - (count - 1) / 2) / count) ** 2, 0);
  const ranked = places.map((place) => ({ place, from: away(place) }));
  ranked.sort((a, b) => a.from - b.from);
  return ranked.map(({ place }) => place);
}
