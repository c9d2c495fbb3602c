import { corners, finestSpacing, unitToWorld } from './grid.ts';
import type { CartesianGrid } from './grid.ts';
import { scaleAndTranslate } from './matrix.ts';
import type { Vector3 } from './matrix.ts';
import type { Volume } from './volume.ts';

/**
 * The part of a volume inside a box along the world's axes, as a grid with the volume's spacing: rays end at it,
 * cameras frame it, and steps depend on it. Its dimensions need not be whole numbers.
 * @param box - x, y and z of two opposite corners: world units; of a radar volume metres east, north and above the
 * antenna, before heights are exaggerated
 * @returns null if the box holds nothing of the volume
 */
export function cutRegion(volume: Pick<Volume, 'dimensions' | 'indexToWorld' | 'polar'>, box: readonly number[]): CartesianGrid | null {
  const stretch = [1, 1, stretchOf(volume)];
  const all = corners(volume);
  const bounds = [0, 1, 2].map((axis) => {
    const ends = [box[axis] * stretch[axis], box[axis + 3] * stretch[axis]];
    const own = all.map((corner) => corner[axis]);
    return [Math.max(Math.min(...ends), Math.min(...own)), Math.min(Math.max(...ends), Math.max(...own))];
  });
  const spacing = finestSpacing(volume);
  const size = bounds.map(([low, high]) => high - low);
  if (!size.every((edge) => edge > 0)) return null;
  const first = bounds.map(([low]) => low + spacing / 2) as unknown as Vector3;
  return {
    dimensions: size.map((edge) => edge / spacing) as unknown as Vector3,
    indexToWorld: scaleAndTranslate([spacing, spacing, spacing], first),
  };
}

/** World length of a metre of height; 1 for volumes that are not a radar's. */
export function stretchOf(volume: Pick<Volume, 'dimensions' | 'indexToWorld' | 'polar'>): number {
  if (!volume.polar) return 1;
  const { low, high } = volume.polar.box;
  return unitToWorld(volume)[10] / (high[2] - low[2]);
}
