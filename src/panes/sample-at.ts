import { interpolate } from '../optics/rays/interpolate.ts';
import type { Samples } from '../volume/samples.ts';
import type { Vector3 } from '../volume/matrix.ts';

/** The block of samples that is read. */
export interface SampledBlock {
  readonly samples: Samples;
  readonly dimensions: Vector3;
  /** Whether any sample has no data. */
  readonly hasNoData: boolean;
}

/** Stored value at an index, whole numbers at voxel centres; NaN outside of the voxels and where there is no data. */
export type SampleAt = (x: number, y: number, z: number) => number;

/** The value of the nearest voxel. */
export function nearestSampler({ samples, dimensions: [nx, ny, nz] }: Omit<SampledBlock, 'hasNoData'>): SampleAt {
  return (x, y, z) => {
    const i = Math.floor(x + 0.5);
    const j = Math.floor(y + 0.5);
    const k = Math.floor(z + 0.5);
    if (!(i >= 0 && i < nx && j >= 0 && j < ny && k >= 0 && k < nz)) return NaN;
    const value = samples[i + nx * (j + ny * k)];
    return Number.isFinite(value) ? value : NaN;
  };
}

/**
 * Tri-linear, constant in the outer half voxels: the same as `interpolate`, but written out, because it is called for
 * every pixel. The weights apply to differences of samples, so a constant stays exact to the last digit.
 */
export function linearSampler({ samples, dimensions, hasNoData }: SampledBlock): SampleAt {
  const [nx, ny, nz] = dimensions;
  const [lastX, lastY, lastZ] = [nx - 1, ny - 1, nz - 1];
  const slice = nx * ny;
  return (x, y, z) => {
    if (!(x >= -0.5 && x <= lastX + 0.5 && y >= -0.5 && y <= lastY + 0.5 && z >= -0.5 && z <= lastZ + 0.5)) return NaN;
    const cx = x < 0 ? 0 : x > lastX ? lastX : x;
    const cy = y < 0 ? 0 : y > lastY ? lastY : y;
    const cz = z < 0 ? 0 : z > lastZ ? lastZ : z;
    const i = cx | 0; // Integers from the start, because an integer index is faster.
    const j = cy | 0;
    const k = cz | 0;
    const fx = cx - i;
    const fy = cy - j;
    const fz = cz - k;
    const right = i < lastX ? 1 : 0;
    const up = j < lastY ? nx : 0;
    const at = i + nx * j + slice * k;
    const above = at + (k < lastZ ? slice : 0);
    const a = samples[at];
    const low = a + fx * (samples[at + right] - a);
    const b = samples[at + up];
    const c = samples[above];
    const d = samples[above + up];
    const near = low + fy * (b + fx * (samples[at + up + right] - b) - low);
    const high = c + fx * (samples[above + right] - c);
    const far = high + fy * (d + fx * (samples[above + up + right] - d) - high);
    const value = near + fz * (far - near);
    // A voxel without data makes this sum NaN. If the other voxels have enough weight, only they count.
    return hasNoData && !Number.isFinite(value)
      ? interpolate(samples, dimensions, [(cx + 0.5) / nx, (cy + 0.5) / ny, (cz + 0.5) / nz])
      : value;
  };
}
