import { noHeight } from './hgt.ts';
import type { Lattice } from './lattice.ts';
import type { TerrainRaster } from './terrain-raster.ts';

/** The error of some triangles at all samples below them. */
export interface TerrainError {
  /** Metres. */
  largest: number;
  squares: number;
  count: number;
}

/** Adds the error of one triangle of a lattice. Its corners are indices in the lattice. */
export function addError(
  raster: TerrainRaster,
  { size, stride, heights }: Lattice,
  corners: readonly [number, number, number],
  sum: TerrainError,
): void {
  const [xs, ys] = [
    corners.map((corner) => (corner % size) * stride),
    corners.map((corner) => Math.floor(corner / size) * stride),
  ];
  const [ha, hb, hc] = corners.map((corner) => heights[corner]);
  const area = (xs[1] - xs[0]) * (ys[2] - ys[0]) - (xs[2] - xs[0]) * (ys[1] - ys[0]);
  for (let y = Math.min(...ys); y <= Math.min(raster.rows - 1, Math.max(...ys)); y++) {
    for (let x = Math.min(...xs); x <= Math.min(raster.columns - 1, Math.max(...xs)); x++) {
      const b = ((x - xs[0]) * (ys[2] - ys[0]) - (xs[2] - xs[0]) * (y - ys[0])) / area;
      const c = ((xs[1] - xs[0]) * (y - ys[0]) - (x - xs[0]) * (ys[1] - ys[0])) / area;
      const height = raster.heights[y * raster.columns + x];
      if (b < 0 || c < 0 || b + c > 1 || height === noHeight) continue;
      const off = Math.abs(height - ((1 - b - c) * ha + b * hb + c * hc));
      if (off > sum.largest) sum.largest = off;
      sum.squares += off * off;
      sum.count++;
    }
  }
}
