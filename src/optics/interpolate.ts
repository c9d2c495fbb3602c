import type { Samples } from '../volume/volume.ts';
import type { Vector3 } from '../volume/matrix.ts';

/**
 * Tri-linear interpolation of stored samples, voxel centres at (i + 0.5) / n, constant in the outer half voxels.
 * Voxels without data (NaN; infinities too) are left out: the weights of the others are scaled up, and where these make
 * up less than half there is no data.
 * @param p - point in the unit cube
 * @returns stored value, or NaN for no data
 */
export function interpolate(samples: Samples, dimensions: Vector3, p: Vector3): number {
  const [nx, ny] = dimensions;
  const x = locate(p[0], dimensions[0]);
  const y = locate(p[1], dimensions[1]);
  const z = locate(p[2], dimensions[2]);
  // Summed as differences from one of the voxels, so that a constant stays exact to the last digit: a jump may be there.
  let base = NaN;
  let sum = 0;
  let weights = 0;
  for (let corner = 0; corner < 8; corner++) {
    const i = corner & 1;
    const j = (corner >> 1) & 1;
    const k = corner >> 2;
    const value = samples[x.index[i] + nx * (y.index[j] + ny * z.index[k])];
    if (!Number.isFinite(value)) continue;
    if (weights === 0) base = value;
    const weight = x.weight[i] * y.weight[j] * z.weight[k];
    sum += weight * (value - base);
    weights += weight;
  }
  return weights >= 0.5 ? base + sum / weights : NaN;
}

function locate(u: number, n: number): { index: [number, number]; weight: [number, number] } {
  const x = Math.min(Math.max(u * n - 0.5, 0), n - 1);
  const low = Math.floor(x);
  return { index: [low, Math.min(low + 1, n - 1)], weight: [1 - (x - low), x - low] };
}
