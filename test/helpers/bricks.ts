// Bricks over a volume, of a pyramid that is made here.
import { brickHalo, brickSide, slotSide } from '../../src/bricks/brick-data.ts';
import type { BrickLevel, BrickSamples } from '../../src/bricks/brick-data.ts';
import { layBricks } from '../../src/bricks/brick-layout.ts';
import type { BrickLayout } from '../../src/bricks/brick-layout.ts';
import { buildPyramid, countBricks, listBricks } from '../../src/bricks/pyramid.ts';
import type { Brick, Pyramid } from '../../src/bricks/pyramid.ts';
import { ResidentBricks } from '../../src/bricks/resident-bricks.ts';
import { uploadBricks } from '../../src/renderer/ray/modules/bricks.ts';
import { cartesianGrid } from '../../src/volume/grid.ts';
import type { CartesianGrid } from '../../src/volume/grid.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import { multiply, scaleAndTranslate } from '../../src/volume/matrix.ts';
import { allocateLike } from '../../src/volume/samples.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A volume in levels. The last level is the one that is always there. */
export interface Bricked {
  readonly pyramid: Pyramid;
  readonly layout: BrickLayout;
  /** The coarsest level as a volume, with what is there of the finer ones. */
  readonly volume: Volume & { readonly finer: ResidentBricks };
}

/** The grid of a level, whose voxels are means of 2 x 2 x 2 of the one before. */
export function gridOf(whole: Volume, { levels }: Pyramid, level: number): CartesianGrid {
  const n = 2 ** level;
  const middle = (n - 1) / 2;
  return cartesianGrid(
    levels[level].dimensions,
    multiply(whole.grid.indexToWorld, scaleAndTranslate([n, n, n], [middle, middle, middle])),
  );
}

/**
 * @param isThere - which bricks of the finer levels are there
 * @param groupSide - as the layout chooses it, if undefined
 */
export function cutIntoBricks(
  whole: Volume,
  count: number,
  isThere: (brick: Brick) => boolean = () => true,
  groupSide?: number,
): Bricked {
  const all = buildPyramid({ dimensions: whole.grid.dimensions, samples: whole.samples }, brickSide);
  const pyramid = { ...all, levels: all.levels.slice(0, count) };
  const last = count - 1;
  const { samples, dimensions } = pyramid.levels[last];
  const grid = gridOf(whole, pyramid, last);
  const coarse: Volume = { ...whole, grid, samples, macrocells: buildMacrocells(samples, dimensions) };
  const levels = pyramid.levels.slice(0, last).map((_, level): BrickLevel => {
    const n = 2 ** level;
    return { ...gridOf(whole, pyramid, level), bricks: countBricks(pyramid, level), factors: [n, n, n] };
  });
  const found = layBricks(grid, levels)!;
  const layout = { ...found, groupSide: groupSide ?? found.groupSide };
  const finer = new ResidentBricks(coarse, layout, uploadBricks);
  for (let level = 0; level < last; level++)
    for (const brick of listBricks(pyramid, level)) if (isThere(brick)) finer.add(brick, readBrick(pyramid, brick));
  return { pyramid, layout, volume: { ...coarse, macrocells: finer.current(coarse).macrocells, finer } };
}

/** A brick, as a store reads it. @param isAlone - its halo repeats its outermost voxels */
export function readBrick({ levels }: Pyramid, { level, at }: Brick, isAlone = true): BrickSamples {
  const {
    dimensions: [nx, ny, nz],
    samples: from,
  } = levels[level];
  const samples = allocateLike(from, slotSide ** 3);
  const inside = (n: number, size: number): number => Math.min(size - 1, Math.max(0, n));
  let [low, high, hasNoData] = [Infinity, -Infinity, false];
  for (let k = 0, to = 0; k < slotSide; k++)
    for (let j = 0; j < slotSide; j++)
      for (let i = 0; i < slotSide; i++, to++) {
        const own = [i, j, k].map((n) => (isAlone ? inside(n - brickHalo, brickSide) : n - brickHalo));
        const [x, y, z] = own.map((n, axis) => inside(at[axis] * brickSide + n, [nx, ny, nz][axis]));
        const value = (samples[to] = from[x + nx * (y + ny * z)]);
        if (Number.isNaN(value)) hasNoData = true;
        else [low, high] = [Math.min(low, value), Math.max(high, value)];
      }
  return { samples, low, high, hasNoData };
}
