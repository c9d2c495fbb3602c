import { noHeight } from './hgt.ts';
import type { TerrainRaster } from './terrain-raster.ts';

/**
 * A square of 2^k + 1 heights a side: every n-th height of a raster, without heights where the raster ends or is
 * hidden.
 */
export interface Lattice {
  readonly size: number;
  /** The distance of neighbours, in samples of the raster. */
  readonly stride: number;
  readonly heights: Int16Array;
}

/** @param isSeen - whether a sample of the raster is used, by its row and column */
export function makeLattice(
  { rows, columns, heights }: TerrainRaster,
  stride: number,
  isSeen: (row: number, column: number) => boolean,
): Lattice {
  const [down, across] = [rows, columns].map((count) => Math.floor((count - 1) / stride) + 1);
  let size = 3;
  while (size < Math.max(down, across)) size = 2 * size - 1;
  const own = new Int16Array(size * size).fill(noHeight);
  for (let y = 0; y < down; y++) {
    for (let x = 0; x < across; x++) {
      const height = heights[y * stride * columns + x * stride];
      if (height !== noHeight && isSeen(y * stride, x * stride)) own[y * size + x] = height;
    }
  }
  return { size, stride, heights: own };
}
