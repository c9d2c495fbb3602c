import type { Samples } from './samples.ts';

// The measures of the cells along some rows of voxels: this many numbers for each cell, one cell after the other.
export const perCell = 11;
/** Its range, including the voxels before and after the cell's own. */
export const low = 0;
export const high = 1;
/** The largest second difference along x. */
export const alongX = 2;
/** The largest second difference along y and along z: of rows in one cell, and after it of those in the next. */
export const alongY = 3;
export const alongZ = 5;
/**
 * This offset gives the same measures at the seam along x, where they count for two cells: at the last voxel of the
 * cell and the first of the next one.
 */
export const seam = 4;

/** Whole numbers if the samples are. */
export type Measures = Int32Array<ArrayBuffer> | Float64Array<ArrayBuffer>;

/** A row of voxels, and the offsets to its neighbours' samples, 0 if there is none. */
export interface Row {
  at: number;
  end: number;
  down: number;
  up: number;
  back: number;
  forth: number;
  /** Which measures along y and z belong to its cell: `alongY` and `alongZ`, or the ones after these. */
  ofY: number;
  ofZ: number;
}

/**
 * Adds a row to the measures of its cells. Comparisons with NaN are false, so NaN changes nothing.
 * The same code is repeated in five places: twice in the loop over pairs of voxels, once for a voxel without a pair,
 * and for the two voxels at a seam. One loop for all took 1.27 to 1.37 times as long, no pairs 1.05 times, and the
 * three differences before their comparisons 1.03 times. `| 0` avoids a check for numbers too large for an index (Node
 * 20).
 */
export function measureRow(samples: Samples, row: Row, size: number, found: Measures): void {
  const { end, down, up, back, forth, ofY, ofZ } = row;
  let at = row.at;
  let value = samples[at];
  let left = value;
  let right = value;
  let after = value;
  let twice = 0;
  let x = 0;
  let y = 0;
  let z = 0;
  let cell = 0;
  let next = at + size;
  let min = found[low];
  let max = found[high];
  let maxX = found[alongX];
  for (;;) {
    let maxY = found[cell + ofY];
    let maxZ = found[cell + ofZ];
    for (const to = next < end ? next : end; at + 2 < to; at += 2) {
      right = samples[(at + 1) | 0];
      after = samples[(at + 2) | 0];
      if (value < min) min = value;
      if (value > max) max = value;
      twice = value + value;
      x = left + right - twice;
      if (x > maxX) maxX = x;
      else if (0 - x > maxX) maxX = 0 - x;
      y = samples[(at + down) | 0] + samples[(at + up) | 0] - twice;
      if (y > maxY) maxY = y;
      else if (0 - y > maxY) maxY = 0 - y;
      z = samples[(at + back) | 0] + samples[(at + forth) | 0] - twice;
      if (z > maxZ) maxZ = z;
      else if (0 - z > maxZ) maxZ = 0 - z;
      if (right < min) min = right;
      if (right > max) max = right;
      twice = right + right;
      x = value + after - twice;
      if (x > maxX) maxX = x;
      else if (0 - x > maxX) maxX = 0 - x;
      y = samples[(at + 1 + down) | 0] + samples[(at + 1 + up) | 0] - twice;
      if (y > maxY) maxY = y;
      else if (0 - y > maxY) maxY = 0 - y;
      z = samples[(at + 1 + back) | 0] + samples[(at + 1 + forth) | 0] - twice;
      if (z > maxZ) maxZ = z;
      else if (0 - z > maxZ) maxZ = 0 - z;
      left = right;
      value = after;
    }
    for (const own = next < end ? next - 1 : end; at < own; at++) {
      right = at + 1 < end ? samples[(at + 1) | 0] : value;
      if (value < min) min = value;
      if (value > max) max = value;
      twice = value + value;
      x = left + right - twice;
      if (x > maxX) maxX = x;
      else if (0 - x > maxX) maxX = 0 - x;
      y = samples[(at + down) | 0] + samples[(at + up) | 0] - twice;
      if (y > maxY) maxY = y;
      else if (0 - y > maxY) maxY = 0 - y;
      z = samples[(at + back) | 0] + samples[(at + forth) | 0] - twice;
      if (z > maxZ) maxZ = z;
      else if (0 - z > maxZ) maxZ = 0 - z;
      left = value;
      value = right;
    }
    found[cell + ofY] = maxY;
    found[cell + ofZ] = maxZ;
    if (next >= end) break;
    maxY = found[cell + seam + ofY];
    maxZ = found[cell + seam + ofZ];
    right = samples[next];
    if (value < min) min = value;
    if (value > max) max = value;
    if (right < min) min = right;
    if (right > max) max = right;
    twice = value + value;
    x = left + right - twice;
    if (x > maxX) maxX = x;
    else if (0 - x > maxX) maxX = 0 - x;
    y = samples[(at + down) | 0] + samples[(at + up) | 0] - twice;
    if (y > maxY) maxY = y;
    else if (0 - y > maxY) maxY = 0 - y;
    z = samples[(at + back) | 0] + samples[(at + forth) | 0] - twice;
    if (z > maxZ) maxZ = z;
    else if (0 - z > maxZ) maxZ = 0 - z;
    found[cell + low] = min;
    found[cell + high] = max;
    found[cell + alongX] = maxX;
    min = found[cell + perCell + low];
    max = found[cell + perCell + high];
    maxX = found[cell + perCell + alongX];
    if (value < min) min = value;
    if (value > max) max = value;
    if (right < min) min = right;
    if (right > max) max = right;
    after = next + 1 < end ? samples[(next + 1) | 0] : right;
    twice = right + right;
    x = value + after - twice;
    if (x > maxX) maxX = x;
    else if (0 - x > maxX) maxX = 0 - x;
    y = samples[(next + down) | 0] + samples[(next + up) | 0] - twice;
    if (y > maxY) maxY = y;
    else if (0 - y > maxY) maxY = 0 - y;
    z = samples[(next + back) | 0] + samples[(next + forth) | 0] - twice;
    if (z > maxZ) maxZ = z;
    else if (0 - z > maxZ) maxZ = 0 - z;
    found[cell + seam + ofY] = maxY;
    found[cell + seam + ofZ] = maxZ;
    left = right;
    value = after;
    at = next + 1;
    next += size;
    cell += perCell;
  }
  found[cell + low] = min;
  found[cell + high] = max;
  found[cell + alongX] = maxX;
}
