// The halos of bricks that are there: bricks are read without the voxels next to them.
import { interpolate } from '../optics/rays/interpolate.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Samples, VolumeData } from '../volume/volume.ts';
import { brickHalo, brickSide, slotSide } from './brick-data.ts';
import { slotDimensions } from './brick-layout.ts';
import type { BrickLayout } from './brick-layout.ts';
import type { CellNumbers } from './cell-numbers.ts';
import type { Brick } from './pyramid.ts';

/** A brick with its halo. */
interface BrickWithHalo extends Brick {
  readonly samples: Samples;
}

/** The bricks, and the volume over which they lie. */
export interface HaloSources {
  readonly volume: Pick<VolumeData, 'grid' | 'samples'>;
  readonly layout: BrickLayout;
  /** By cell: 1 + the slot of the brick that is shown there, or 0 where it is the volume itself. */
  readonly pages: CellNumbers;
  inSlot(slot: number): BrickWithHalo | undefined;
  find(brick: Brick): BrickWithHalo | undefined;
}

/** From a brick to those next to it, over faces, edges and corners. */
export const waysToNeighbours: readonly Vector3[] = Array.from({ length: 27 }, (_, n): Vector3 => [
  (n % 3) - 1,
  (Math.floor(n / 3) % 3) - 1,
  Math.floor(n / 9) - 1,
]).filter((way) => way.some((n) => n !== 0));

/** The brick of the same level that has the voxels of a halo on a way from a brick; beyond the ends of the level these are like the last ones, so it may be the brick itself. */
export function neighbourOf({ levels }: BrickLayout, { level, at }: Brick, way: Vector3): Brick {
  const { bricks } = levels[level];
  return {
    level,
    at: at.map((n, axis) => Math.min(bricks[axis] - 1, Math.max(0, n + way[axis]))) as unknown as Vector3,
  };
}

/** Numbers of a voxel in a slot, along each axis. */
type SlotPlace = [number, number, number];

/** Places along an axis of a brick with its halo. */
interface AxisPlaces {
  /** By number in the slot: the voxel of the level, within its ends; and the cell in which its middle lies. */
  readonly voxels: Int32Array;
  readonly cells: Int32Array;
  /** By level, then by number in the slot: its middle in voxels of the level from the first one's middle on, within the ends. The volume comes last. */
  readonly places: readonly Float64Array[];
}

/**
 * Fills a brick's halo in place: with the voxels of the neighbours of its level that are there; elsewhere with what is shown there, which has been settled if it is
 * of a coarser level.
 * @returns whether any of them has another value now
 */
export function fillHalo(sources: HaloSources, brick: BrickWithHalo): boolean {
  const axes = [0, 1, 2].map((axis) => placesAlong(sources, brick, axis));
  const shownAt = samplerOf(sources, brick.level, axes);
  const { samples } = brick;
  const slot: SlotPlace = [0, 0, 0];
  const isWhole = !(samples instanceof Float32Array);
  let isChanged = false;
  for (const way of waysToNeighbours) {
    const neighbour = neighbourOf(sources.layout, brick, way);
    const found = sources.find(neighbour);
    const ranges = way.map(slotRange);
    if (found) {
      if (copyVoxels(found, samples, axes, ranges)) isChanged = true;
      continue;
    }
    const [[i0, i1], [j0, j1], [k0, k1]] = ranges;
    for (slot[2] = k0; slot[2] < k1; slot[2]++)
      for (slot[1] = j0; slot[1] < j1; slot[1]++)
        for (slot[0] = i0; slot[0] < i1; slot[0]++) {
          const value = shownAt(slot);
          const stored = isWhole ? Math.round(value) : Math.fround(value);
          const at = slot[0] + slotSide * (slot[1] + slotSide * slot[2]);
          if (Object.is(samples[at], stored)) continue;
          samples[at] = stored;
          isChanged = true;
        }
  }
  return isChanged;
}

/**
 * Copies voxels of a brick of the same level.
 * @param ranges - of the slot that is written
 * @returns whether any of them was another one
 */
function copyVoxels(
  { at: [bi, bj, bk], samples: from }: BrickWithHalo,
  samples: Samples,
  [x, y, z]: readonly AxisPlaces[],
  [[i0, i1], [j0, j1], [k0, k1]]: readonly SlotRange[],
): boolean {
  // Where the first voxel of the level would lie, if all of it were in that brick.
  const [di, dj, dk] = [bi, bj, bk].map((n) => brickHalo - brickSide * n);
  let isChanged = false;
  for (let k = k0; k < k1; k++)
    for (let j = j0; j < j1; j++) {
      const row = di + slotSide * (y.voxels[j] + dj + slotSide * (z.voxels[k] + dk));
      for (let i = i0, to = i0 + slotSide * (j + slotSide * k); i < i1; i++, to++) {
        const value = from[row + x.voxels[i]];
        if (Object.is(samples[to], value)) continue;
        samples[to] = value;
        isChanged = true;
      }
    }
  return isChanged;
}

/** Numbers along an axis of a slot, without the last one. */
type SlotRange = readonly [first: number, end: number];

function slotRange(way: number): SlotRange {
  if (way === 0) return [brickHalo, brickHalo + brickSide];
  return way < 0 ? [0, brickHalo] : [brickHalo + brickSide, slotSide];
}

function placesAlong({ layout, volume }: HaloSources, { level, at }: Brick, axis: number): AxisPlaces {
  const { levels, cells: counts } = layout;
  const { scale, shift, dimensions } = levels[level];
  const clamp = (x: number, last: number): number => Math.min(last, Math.max(0, x));
  const numbers = Array.from({ length: slotSide }, (_, n) => n);
  const voxels = Int32Array.from(numbers, (n) => clamp(brickSide * at[axis] + n - brickHalo, dimensions[axis] - 1));
  // In the unit cube of the volume.
  const middles = Float64Array.from(voxels, (voxel) => (voxel + 0.5 - shift[axis]) / scale[axis]);
  const [finest] = levels;
  const cells = Int32Array.from(middles, (x) =>
    clamp(Math.floor((x * finest.scale[axis] + finest.shift[axis]) / brickSide), counts[axis] - 1),
  );
  const places = levels.map((frame) =>
    middles.map((x) => clamp(x * frame.scale[axis] + frame.shift[axis] - 0.5, frame.dimensions[axis] - 1)),
  );
  const count = volume.grid.dimensions[axis];
  places.push(middles.map((x) => clamp(x * count - 0.5, count - 1)));
  return { voxels, cells, places };
}

/**
 * The value that is shown at the middle of a voxel of a level, as `ResidentBricks.storedAt`, but with nothing of halos that may depend on this one: where levels lie up to half a
 * voxel away from each other, a finer brick, or the brick itself, may be shown a little outside of its voxels.
 */
function samplerOf(
  { pages, inSlot, volume, layout }: HaloSources,
  level: number,
  axes: readonly AxisPlaces[],
): (slot: SlotPlace) => number {
  const [x, y, z] = axes;
  const ofVolume = layout.levels.length;
  const { dimensions } = volume.grid;
  const place: [number, number, number] = [0, 0, 0];
  // Along a row, the cell changes seldom.
  let [ci, cj, ck] = [-1, -1, -1];
  let brick: BrickWithHalo | undefined;
  return (slot) => {
    const [i, j, k] = [x.cells[slot[0]], y.cells[slot[1]], z.cells[slot[2]]];
    if (i !== ci || j !== cj || k !== ck) {
      [ci, cj, ck] = [i, j, k];
      brick = inSlot(pages.at(i, j, k) - 1);
    }
    for (let axis = 0; axis < 3; axis++) {
      const middle = axes[axis].places[brick?.level ?? ofVolume][slot[axis]] + 0.5;
      if (!brick) place[axis] = middle / dimensions[axis];
      else {
        const own = middle - brickSide * brick.at[axis];
        const inside = brick.level <= level ? Math.min(brickSide - 0.5, Math.max(0.5, own)) : own;
        place[axis] = (inside + brickHalo) / slotSide;
      }
    }
    return brick ? interpolate(brick.samples, slotDimensions, place) : interpolate(volume.samples, dimensions, place);
  };
}
