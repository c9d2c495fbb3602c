import { cartesianGrid, corners, finestSpacing } from './grid.ts';
import type { CartesianGrid, GridFrame } from './grid.ts';
import { scaleAndTranslate } from './matrix.ts';
import type { Vector3 } from './matrix.ts';

/**
 * The part of a volume inside a box along the world's axes, as a grid with the volume's spacing: rays end at it,
 * cameras frame it, and steps depend on it. Its dimensions need not be whole numbers.
 * @param box - x, y and z of two opposite corners: world units, with heights before exaggeration
 * @param stretch - world length of one unit of the box's heights
 * @returns null if the box holds nothing of the volume
 */
export function cutRegion(grid: GridFrame, box: readonly number[], stretch = 1): CartesianGrid | null {
  const scale = [1, 1, stretch];
  const all = corners(grid);
  const bounds = [0, 1, 2].map((axis) => {
    const ends = [box[axis] * scale[axis], box[axis + 3] * scale[axis]];
    const own = all.map((corner) => corner[axis]);
    return [Math.max(Math.min(...ends), Math.min(...own)), Math.min(Math.max(...ends), Math.max(...own))];
  });
  const spacing = finestSpacing(grid);
  const size = bounds.map(([low, high]) => high - low);
  if (!size.every((edge) => edge > 0)) return null;
  const first = bounds.map(([low]) => low + spacing / 2) as unknown as Vector3;
  const dimensions = size.map((edge) => edge / spacing) as unknown as Vector3;
  return cartesianGrid(dimensions, scaleAndTranslate([spacing, spacing, spacing], first));
}
