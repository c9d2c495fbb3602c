import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/samples.ts';
import { brickSide } from './brick-data.ts';
import { slotSide } from './brick-layout.ts';

/** From a brick to those next to it, over faces, edges and corners. */
export const waysToNeighbours: readonly Vector3[] = Array.from({ length: 27 }, (_, n): Vector3 => [
  (n % 3) - 1,
  (Math.floor(n / 3) % 3) - 1,
  Math.floor(n / 9) - 1,
]).filter((way) => way.some((n) => n !== 0));

/** Where a brick lies among those of its level, along each axis. */
export interface BrickPlace {
  readonly at: Vector3;
  /** Of the level. */
  readonly bricks: Vector3;
}

/** The way to the neighbour that has the voxels of this part of the halo: beyond the ends of a level, values stay as they are at its end. */
export function wayWithin({ at, bricks }: BrickPlace, way: Vector3): Vector3 {
  return way.map((n, axis) => (at[axis] + n < 0 || at[axis] + n >= bricks[axis] ? 0 : n)) as unknown as Vector3;
}

/**
 * Fills the part of a brick's halo that lies on a way from it, in place.
 * @param samples - of the brick with its halo, see `BrickSamples`
 * @param from - the samples of the neighbour that has these voxels; the brick's own where that is not there: then its outermost voxels are repeated
 * @param step - the way to this neighbour; 0 0 0 for the brick itself
 */
export function fillHalo(samples: Samples, way: Vector3, from: Samples, step: Vector3): void {
  const [x, y, z] = way.map((n, axis) => partOfSlot(n, step[axis]));
  for (let k = 0; k < z.count; k++)
    for (let j = 0; j < y.count; j++) {
      const to = slotSide * (y.to + j + slotSide * (z.to + k));
      const source = slotSide * (y.from + j + slotSide * (z.from + k));
      for (let i = 0; i < x.count; i++) samples[to + x.to + i] = from[source + x.from + i];
    }
}

/** Voxels along an axis of slots: so many, where they go, and where they come from. */
function partOfSlot(way: number, step: number): { readonly to: number; readonly from: number; readonly count: number } {
  if (way === 0) return { to: 1, from: 1, count: brickSide };
  const [first, last] = [1, brickSide];
  const own = way < 0 ? first : last;
  return { to: way < 0 ? 0 : slotSide - 1, from: step < 0 ? last : step > 0 ? first : own, count: 1 };
}
