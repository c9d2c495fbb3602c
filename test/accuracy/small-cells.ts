// Macrocells of any size, made plainly: what would be known of a volume if they were smaller.
import { offLine } from '../../src/volume/cell-size.ts';
import type { Macrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Samples } from '../../src/volume/volume.ts';

/** A cell that is this rough, as a share of its range, counts with all of it, as in volume/macrocells.ts. */
const enough = 0.6;

/**
 * Each voxel counts for its own cell and for those next to it, with its value and its second differences; in the package's own cells some of
 * the latter do not count, so these are as rough or rougher.
 * @param size - voxels along each edge of a cell
 */
export function buildCells(samples: Samples, dimensions: Vector3, size: number): Macrocells {
  const [nx, ny, nz] = dimensions;
  const cells = dimensions.map((n) => Math.ceil(n / size)) as unknown as Vector3;
  const count = cells[0] * cells[1] * cells[2];
  const low = new Float32Array(count).fill(Infinity);
  const high = new Float32Array(count).fill(-Infinity);
  const roughness = new Float32Array(count);
  const clamp = (x: number, n: number): number => Math.min(n - 1, Math.max(0, x));
  const at = (i: number, j: number, k: number): number =>
    samples[clamp(i, nx) + nx * (clamp(j, ny) + ny * clamp(k, nz))];
  const touched = (x: number, axis: number): [number, number] => [
    Math.max(0, Math.floor((x - 1) / size)),
    Math.min(cells[axis] - 1, Math.floor((x + 1) / size)),
  ];
  for (let k = 0; k < nz; k++) {
    const [c0, c1] = touched(k, 2);
    for (let j = 0; j < ny; j++) {
      const [b0, b1] = touched(j, 1);
      for (let i = 0; i < nx; i++) {
        const [a0, a1] = touched(i, 0);
        const value = at(i, j, k);
        const bend = Math.max(
          Math.abs(at(i - 1, j, k) - 2 * value + at(i + 1, j, k)),
          Math.abs(at(i, j - 1, k) - 2 * value + at(i, j + 1, k)),
          Math.abs(at(i, j, k - 1) - 2 * value + at(i, j, k + 1)),
        );
        for (let c = c0; c <= c1; c++)
          for (let b = b0; b <= b1; b++)
            for (let a = a0; a <= a1; a++) {
              const cell = a + cells[0] * (b + cells[1] * c);
              low[cell] = Math.min(low[cell], value);
              high[cell] = Math.max(high[cell], value);
              roughness[cell] = Math.max(roughness[cell], bend);
            }
      }
    }
  }
  for (let cell = 0; cell < count; cell++) {
    const all = (high[cell] - low[cell]) / offLine;
    if (roughness[cell] >= enough * all) roughness[cell] = all;
  }
  return { dimensions: cells, size, low, high, roughness };
}
