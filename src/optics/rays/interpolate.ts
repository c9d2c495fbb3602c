import type { Samples } from '../../volume/volume.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/**
 * Tri-linear interpolation of stored samples, voxel centres at (i + 0.5) / n, constant in the outer half voxels.
 * Voxels without data (NaN; infinities too) are left out, and the weights of the others are scaled up. If these weights make
 * up less than half, there is no data.
 * @param p - point in the unit cube
 * @returns stored value, or NaN for no data
 */
export function interpolate(samples: Samples, dimensions: Vector3, p: Vector3): number {
  const [nx, ny, nz] = dimensions;
  const [x, y, z] = [clampToCentres(p[0], nx), clampToCentres(p[1], ny), clampToCentres(p[2], nz)];
  const [i, j, k] = [Math.floor(x), Math.floor(y), Math.floor(z)];
  // Summed as differences from one of the voxels, so that a constant stays exact to the last digit: the transfer function may jump there.
  let base = NaN;
  let sum = 0;
  let weights = 0;
  for (let corner = 0; corner < 8; corner++) {
    const [right, up, back] = [corner & 1, (corner >> 1) & 1, corner >> 2];
    const value =
      samples[Math.min(i + right, nx - 1) + nx * (Math.min(j + up, ny - 1) + ny * Math.min(k + back, nz - 1))];
    if (!Number.isFinite(value)) continue;
    if (weights === 0) base = value;
    const weight = (right ? x - i : 1 - (x - i)) * (up ? y - j : 1 - (y - j)) * (back ? z - k : 1 - (z - k));
    sum += weight * (value - base);
    weights += weight;
  }
  return weights >= 0.5 ? base + sum / weights : NaN;
}

/** In voxels from the first one's centre; places beyond the outermost centres move to these. */
function clampToCentres(u: number, n: number): number {
  return Math.min(Math.max(u * n - 0.5, 0), n - 1);
}
