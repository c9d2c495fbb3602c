import type { Samples } from './samples.ts';
import type { Vector3 } from './matrix.ts';

/**
 * Tri-linear values between two samples a voxel apart leave the straight line between these by no more than this share of the
 * roughness around them: kinks at up to three faces of voxels, each met half way, and the twist inside of a voxel.
 */
export const offLine = 0.7;

/** A cell that is this rough, as a share of its range, needs no closer look: all of its range counts. */
const enough = 0.6;

/** Ranges of stored values in blocks of voxels. */
interface Ranges {
  readonly dimensions: Vector3;
  readonly low: Samples;
  readonly high: Samples;
  /** Voxels along the edge of a block. */
  readonly cellSize: number;
}

/**
 * How far the samples of each macrocell are from lying in straight lines with those next to them: the largest second
 * difference along any axis, |v(i - 1) - 2 v(i) + v(i + 1)|, stored units; beyond the grid the last sample goes on. Places
 * without data are left out. A cell of which most of the range could be off is said to be as rough as makes all of it count.
 * @param roughness - filled, a number for each cell
 */
export function measureRoughness(
  { samples, dimensions }: { readonly samples: Samples; readonly dimensions: Vector3 }, { dimensions: [cx, cy], low, high, cellSize }: Ranges, roughness: Float32Array,
): void {
  for (let cell = 0; cell < roughness.length; cell++) {
    const range = high[cell] - low[cell];
    if (!(range > 0)) continue;
    const first = [cell % cx, Math.floor(cell / cx) % cy, Math.floor(cell / (cx * cy))].map((i) => i * cellSize) as unknown as Vector3;
    const most = (enough * range) / offLine;
    const found = findRoughness(samples, dimensions, { first, most, cellSize });
    roughness[cell] = found >= most ? range / offLine : found;
  }
}

/** @param most - the search ends with a row that is as rough as this */
function findRoughness(samples: Samples, [nx, ny, nz]: Vector3, { first, most, cellSize }: { first: Vector3; most: number; cellSize: number }): number {
  const to = [nx, ny, nz].map((n, axis) => Math.min(n, first[axis] + cellSize));
  let largest = 0;
  for (let k = first[2]; k < to[2]; k++) {
    const back = k > 0 ? -nx * ny : 0;
    const forth = k < nz - 1 ? nx * ny : 0;
    for (let j = first[1]; j < to[1]; j++) {
      const row = nx * (j + ny * k);
      const down = j > 0 ? -nx : 0;
      const up = j < ny - 1 ? nx : 0;
      const end = row + to[0];
      let at = row + first[0];
      let value = samples[at];
      let left = first[0] > 0 ? samples[at - 1] : value;
      for (; at < end; at++) {
        const right = at + 1 < row + nx ? samples[at + 1] : value;
        const twice = value + value;
        const x = left + right - twice;
        const y = samples[at + down] + samples[at + up] - twice;
        const z = samples[at + back] + samples[at + forth] - twice;
        // NaN is not larger than anything.
        if (x > largest) largest = x;
        else if (-x > largest) largest = -x;
        if (y > largest) largest = y;
        else if (-y > largest) largest = -y;
        if (z > largest) largest = z;
        else if (-z > largest) largest = -z;
        left = value;
        value = right;
      }
      if (largest >= most) return largest;
    }
  }
  return largest;
}
