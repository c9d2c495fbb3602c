import { allocateLike } from '../volume/samples.ts';
import type { Samples } from '../volume/samples.ts';
import type { Vector3 } from '../volume/matrix.ts';

/** One level of a pyramid: level 0 has all voxels, each further one half as many along each axis, rounded up. */
export interface PyramidLevel {
  readonly dimensions: Vector3;
  /** Stored values, i fastest; NaN (float only) means no data. */
  readonly samples: Samples;
}

/** Levels from the finest one on, cut into bricks of `side` voxels along each axis. */
export interface Pyramid {
  readonly levels: readonly PyramidLevel[];
  readonly side: number;
}

/**
 * Halves a volume until it fits into one brick. A voxel is the mean of those below it that have data; it has none where
 * fewer than half of them do. The means of whole numbers are rounded.
 *
 * Voxel i of level L covers voxels 2^L i to 2^L (i + 1) of level 0, so its centre is at 2^L (i + 0.5) - 0.5 there. At the upper
 * ends of an axis that 2^L does not divide, voxels reach over the end of the volume.
 */
export function buildPyramid(finest: PyramidLevel, side: number): Pyramid {
  const levels = [finest];
  for (let last = finest; last.dimensions.some((n) => n > side); levels.push(last)) last = halve(last);
  return { levels, side };
}

/** The next coarser level. */
export function halve({ dimensions: [nx, ny, nz], samples }: PyramidLevel): PyramidLevel {
  const dimensions: Vector3 = [Math.ceil(nx / 2), Math.ceil(ny / 2), Math.ceil(nz / 2)];
  const [mx, my, mz] = dimensions;
  const halved = allocateLike(samples, mx * my * mz);
  const isFloat = samples instanceof Float32Array;
  for (let k = 0, at = 0; k < mz; k++) {
    const backs = Math.min(2, nz - 2 * k);
    for (let j = 0; j < my; j++) {
      const rows = Math.min(2, ny - 2 * j);
      for (let i = 0; i < mx; i++, at++) {
        const columns = Math.min(2, nx - 2 * i);
        let [sum, count] = [0, 0];
        for (let c = 0; c < backs; c++) {
          for (let b = 0; b < rows; b++) {
            const row = 2 * i + nx * (2 * j + b + ny * (2 * k + c));
            for (let a = 0; a < columns; a++) {
              const value = samples[row + a];
              if (Number.isNaN(value)) continue;
              sum += value;
              count++;
            }
          }
        }
        const mean = 2 * count >= columns * rows * backs ? sum / count : NaN;
        halved[at] = isFloat ? mean : Math.round(mean);
      }
    }
  }
  return { dimensions, samples: halved };
}

/** Factors from a place in level 0's unit cube to the same place in another level's, whose upper ends may reach farther. */
export function toLevel({ levels }: Pyramid, level: number): Vector3 {
  const of = levels[level].dimensions;
  return levels[0].dimensions.map((n, axis) => n / (2 ** level * of[axis])) as unknown as Vector3;
}

/** Number of bricks of a level along each axis. */
export function countBricks({ levels, side }: Pyramid, level: number): Vector3 {
  return levels[level].dimensions.map((n) => Math.ceil(n / side)) as unknown as Vector3;
}

/** A brick of a pyramid: its level, and its number along each axis. */
export interface Brick {
  readonly level: number;
  readonly at: Vector3;
}

/** All bricks of a level, i fastest. */
export function listBricks(pyramid: Pyramid, level: number): Brick[] {
  const [nx, ny, nz] = countBricks(pyramid, level);
  return Array.from({ length: nx * ny * nz }, (_, n) => ({
    level,
    at: [n % nx, Math.floor(n / nx) % ny, Math.floor(n / (nx * ny))],
  }));
}

/**
 * The cells (bricks of level 0) that a brick covers, as their numbers, i fastest. A brick of level L covers 2^L of them along each axis, or
 * as many as there are.
 */
export function cellsOf(pyramid: Pyramid, { level, at }: Brick): number[] {
  const cells = countBricks(pyramid, 0);
  const [low, high] = [at, at.map((n) => n + 1)].map((ends) =>
    ends.map((n, axis) => Math.min(cells[axis], n * 2 ** level)),
  );
  const found: number[] = [];
  for (let k = low[2]; k < high[2]; k++)
    for (let j = low[1]; j < high[1]; j++)
      for (let i = low[0]; i < high[0]; i++) found.push(i + cells[0] * (j + cells[1] * k));
  return found;
}

/** The voxels of a brick, i fastest, as they lie in a chunk: what reaches over the end of the level is 0. */
export function copyBrick({ levels, side }: Pyramid, { level, at }: Brick): Samples {
  const {
    dimensions: [nx, ny, nz],
    samples,
  } = levels[level];
  const brick = allocateLike(samples, side ** 3);
  const [x, y, z] = at.map((n) => n * side);
  const width = Math.min(side, nx - x);
  for (let k = 0; k < Math.min(side, nz - z); k++)
    for (let j = 0; j < Math.min(side, ny - y); j++) {
      const from = x + nx * (y + j + ny * (z + k));
      brick.set(samples.subarray(from, from + width), side * (j + side * k));
    }
  return brick;
}
