import type { Samples } from './samples.ts';
import type { Vector3 } from './matrix.ts';

/**
 * How far samples of a block of a cartesian grid are from lying in straight lines: the largest second difference along any
 * axis, |v(i - 1) - 2 v(i) + v(i + 1)|, stored units; the edge samples go on outside of the grid. Places without data are
 * left out.
 * @param first - voxel of the block's corner
 * @param size - voxels along its edges
 */
export function measureRoughness(samples: Samples, [nx, ny, nz]: Vector3, first: Vector3, size: number): number {
  let largest = 0;
  const end = [nx, ny, nz].map((n, axis) => Math.min(n, first[axis] + size));
  for (let k = first[2]; k < end[2]; k++) {
    for (let j = first[1]; j < end[1]; j++) {
      const row = nx * (j + ny * k);
      const down = j > 0 ? -nx : 0;
      const up = j < ny - 1 ? nx : 0;
      const back = k > 0 ? -nx * ny : 0;
      const forth = k < nz - 1 ? nx * ny : 0;
      for (let i = first[0]; i < end[0]; i++) {
        const at = row + i;
        const twice = 2 * samples[at];
        const x = Math.abs(samples[i > 0 ? at - 1 : at] + samples[i < nx - 1 ? at + 1 : at] - twice);
        const y = Math.abs(samples[at + down] + samples[at + up] - twice);
        const z = Math.abs(samples[at + back] + samples[at + forth] - twice);
        // NaN is not larger than anything.
        if (x > largest) largest = x;
        if (y > largest) largest = y;
        if (z > largest) largest = z;
      }
    }
  }
  return largest;
}
