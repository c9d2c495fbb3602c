import type { Samples } from './samples.ts';

// What is known of the cells of some rows of voxels: so many numbers of each cell, one cell after the other.
export const perCell = 11;
/** Its range, with the voxels before and after the cell's own. */
export const low = 0;
export const high = 1;
/** The largest second difference along x. */
export const alongX = 2;
/** The largest along y and along z: of rows in one cell, and after it of those in the next. */
export const alongY = 3;
export const alongZ = 5;
/** So much further on, the same at the seam along x: at the last voxel of the cell and the first of the one after it, where they count for both. */
export const seam = 4;

/** Whole numbers where samples are. */
export type Measures = Int32Array<ArrayBuffer> | Float64Array<ArrayBuffer>;

/** A row of voxels, and offsets of the samples next to its own, 0 where there is none. */
export interface Row {
  at: number;
  end: number;
  down: number;
  up: number;
  back: number;
  forth: number;
  /** Which measures along y and z are those of its cell: `alongY` and `alongZ`, or the ones after these. */
  ofY: number;
  ofZ: number;
}

/**
 * Add what a row has to what is known of its cells. NaN is neither less nor more than anything.
 *
 * Five places have the same text, as every voxel between the seams has it for itself, and every other one. One text for all took 1.27 to
 * 1.37 times as long, no pairs 1.05 times, and the three differences before their comparisons 1.03 times. `| 0` spares a check for numbers
 * too large for an index (Node 20).
 */
export function measureRow(samples: Samples, row: Row, cellSize: number, found: Measures): void {
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
  let next = at + cellSize;
  let least = found[low];
  let most = found[high];
  let mostX = found[alongX];
  for (;;) {
    let mostY = found[cell + ofY];
    let mostZ = found[cell + ofZ];
    for (const to = next < end ? next : end; at + 2 < to; at += 2) {
      right = samples[(at + 1) | 0];
      after = samples[(at + 2) | 0];
      if (value < least) least = value;
      if (value > most) most = value;
      twice = value + value;
      x = left + right - twice;
      if (x > mostX) mostX = x;
      else if (0 - x > mostX) mostX = 0 - x;
      y = samples[(at + down) | 0] + samples[(at + up) | 0] - twice;
      if (y > mostY) mostY = y;
      else if (0 - y > mostY) mostY = 0 - y;
      z = samples[(at + back) | 0] + samples[(at + forth) | 0] - twice;
      if (z > mostZ) mostZ = z;
      else if (0 - z > mostZ) mostZ = 0 - z;
      if (right < least) least = right;
      if (right > most) most = right;
      twice = right + right;
      x = value + after - twice;
      if (x > mostX) mostX = x;
      else if (0 - x > mostX) mostX = 0 - x;
      y = samples[(at + 1 + down) | 0] + samples[(at + 1 + up) | 0] - twice;
      if (y > mostY) mostY = y;
      else if (0 - y > mostY) mostY = 0 - y;
      z = samples[(at + 1 + back) | 0] + samples[(at + 1 + forth) | 0] - twice;
      if (z > mostZ) mostZ = z;
      else if (0 - z > mostZ) mostZ = 0 - z;
      left = right;
      value = after;
    }
    for (const own = next < end ? next - 1 : end; at < own; at++) {
      right = at + 1 < end ? samples[(at + 1) | 0] : value;
      if (value < least) least = value;
      if (value > most) most = value;
      twice = value + value;
      x = left + right - twice;
      if (x > mostX) mostX = x;
      else if (0 - x > mostX) mostX = 0 - x;
      y = samples[(at + down) | 0] + samples[(at + up) | 0] - twice;
      if (y > mostY) mostY = y;
      else if (0 - y > mostY) mostY = 0 - y;
      z = samples[(at + back) | 0] + samples[(at + forth) | 0] - twice;
      if (z > mostZ) mostZ = z;
      else if (0 - z > mostZ) mostZ = 0 - z;
      left = value;
      value = right;
    }
    found[cell + ofY] = mostY;
    found[cell + ofZ] = mostZ;
    if (next >= end) break;
    mostY = found[cell + seam + ofY];
    mostZ = found[cell + seam + ofZ];
    right = samples[next];
    if (value < least) least = value;
    if (value > most) most = value;
    if (right < least) least = right;
    if (right > most) most = right;
    twice = value + value;
    x = left + right - twice;
    if (x > mostX) mostX = x;
    else if (0 - x > mostX) mostX = 0 - x;
    y = samples[(at + down) | 0] + samples[(at + up) | 0] - twice;
    if (y > mostY) mostY = y;
    else if (0 - y > mostY) mostY = 0 - y;
    z = samples[(at + back) | 0] + samples[(at + forth) | 0] - twice;
    if (z > mostZ) mostZ = z;
    else if (0 - z > mostZ) mostZ = 0 - z;
    found[cell + low] = least;
    found[cell + high] = most;
    found[cell + alongX] = mostX;
    least = found[cell + perCell + low];
    most = found[cell + perCell + high];
    mostX = found[cell + perCell + alongX];
    if (value < least) least = value;
    if (value > most) most = value;
    if (right < least) least = right;
    if (right > most) most = right;
    after = next + 1 < end ? samples[(next + 1) | 0] : right;
    twice = right + right;
    x = value + after - twice;
    if (x > mostX) mostX = x;
    else if (0 - x > mostX) mostX = 0 - x;
    y = samples[(next + down) | 0] + samples[(next + up) | 0] - twice;
    if (y > mostY) mostY = y;
    else if (0 - y > mostY) mostY = 0 - y;
    z = samples[(next + back) | 0] + samples[(next + forth) | 0] - twice;
    if (z > mostZ) mostZ = z;
    else if (0 - z > mostZ) mostZ = 0 - z;
    found[cell + seam + ofY] = mostY;
    found[cell + seam + ofZ] = mostZ;
    left = right;
    value = after;
    at = next + 1;
    next += cellSize;
    cell += perCell;
  }
  found[cell + low] = least;
  found[cell + high] = most;
  found[cell + alongX] = mostX;
}
