import { valueOf } from '../../volume/index-numbers.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';

/** A voxel, and its data value; of a volume in bricks, that of the voxel of the brick there. */
export interface Voxel {
  readonly index: Vector3;
  readonly value: number;
}

/**
 * The nearest of the eight voxels around a place that have data.
 * @param place - in the unit cube
 * @returns null where none of them has data
 */
export function nearestVoxel(
  volume: Pick<Volume, 'grid' | 'samples' | 'slope' | 'intercept' | 'ids' | 'indexed' | 'finer'>,
  place: Vector3,
): Voxel | null {
  const {
    grid: { dimensions },
    samples,
  } = volume;
  let nearest: Voxel | null = null;
  let max = 0;
  const inside = place.map((p, axis) => Math.min(dimensions[axis] - 1, Math.max(0, p * dimensions[axis] - 0.5)));
  for (let corner = 0; corner < 8; corner++) {
    const upper = [corner & 1, (corner >> 1) & 1, corner >> 2];
    const index = inside.map((p, axis) =>
      Math.min(dimensions[axis] - 1, Math.floor(p) + upper[axis]),
    ) as unknown as Vector3;
    const weight = inside.reduce(
      (product, p, axis) => product * (upper[axis] ? p - Math.floor(p) : 1 - (p - Math.floor(p))),
      1,
    );
    const at = index[0] + dimensions[0] * (index[1] + dimensions[1] * index[2]);
    const stored = samples[at];
    // In the middle between two voxels it is the upper one, as in the look-up of labels.
    if (!Number.isFinite(stored) || weight === 0 || weight < max) continue;
    max = weight;
    nearest = { index, value: valueAt(volume, at) };
  }
  const finer = volume.finer?.nearestAt(place);
  return nearest && finer !== undefined ? { ...nearest, value: valueOf(volume, finer) } : nearest;
}

/** The value of a voxel; NaN where it has no data. @param at - its place among the samples */
export function valueAt(
  volume: Pick<Volume, 'samples' | 'slope' | 'intercept' | 'ids' | 'indexed'>,
  at: number,
): number {
  const { samples, indexed } = volume;
  // A value that float32 rounds is reported as the file has it.
  return indexed ? indexed.ids[indexed.samples[at]] : valueOf(volume, samples[at]);
}
