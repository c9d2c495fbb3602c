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
  const x = clampToCentres(p[0], nx);
  const y = clampToCentres(p[1], ny);
  const z = clampToCentres(p[2], nz);
  const i = Math.floor(x);
  const j = Math.floor(y);
  const k = Math.floor(z);
  const first = i + nx * (j + ny * k);
  // From a voxel to the next one along each axis; the last one has none.
  const toRight = i + 1 < nx ? 1 : 0;
  const toUp = j + 1 < ny ? nx : 0;
  const toBack = k + 1 < nz ? nx * ny : 0;
  // Summed as differences from one of the voxels, so that a constant stays exact to the last digit: the transfer function may jump there.
  let base = NaN;
  let sum = 0;
  let weights = 0;
  for (let corner = 0; corner < 8; corner++) {
    const right = corner & 1;
    const up = corner & 2;
    const back = corner & 4;
    const value = samples[first + (right ? toRight : 0) + (up ? toUp : 0) + (back ? toBack : 0)];
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
