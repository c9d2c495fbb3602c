import type { Vector3 } from '../volume/matrix.ts';
import type { Volume } from '../volume/volume.ts';

/** A voxel, and its data value. */
export interface Voxel {
  readonly index: Vector3;
  readonly value: number;
}

/**
 * Of the eight voxels around a place the nearest one that has data.
 * @param place - in the unit cube
 * @returns null where none has any
 */
export function nearestVoxel({ grid: { dimensions }, samples, slope, intercept }: Pick<Volume, 'grid' | 'samples' | 'slope' | 'intercept'>, place: Vector3): Voxel | null {
  let nearest: Voxel | null = null;
  let most = 0;
  const inside = place.map((p, axis) => Math.min(dimensions[axis] - 1, Math.max(0, p * dimensions[axis] - 0.5)));
  for (let corner = 0; corner < 8; corner++) {
    const upper = [corner & 1, (corner >> 1) & 1, corner >> 2];
    const index = inside.map((p, axis) => Math.min(dimensions[axis] - 1, Math.floor(p) + upper[axis])) as unknown as Vector3;
    const weight = inside.reduce((product, p, axis) => product * (upper[axis] ? p - Math.floor(p) : 1 - (p - Math.floor(p))), 1);
    const stored = samples[index[0] + dimensions[0] * (index[1] + dimensions[1] * index[2])];
    // In the middle between two it is the upper one, as where labels are looked up.
    if (!Number.isFinite(stored) || weight === 0 || weight < most) continue;
    most = weight;
    nearest = { index, value: slope * stored + intercept };
  }
  return nearest;
}
