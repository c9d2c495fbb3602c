// What light adds to the estimate of what coarse bricks hide: hidden values turn the direction in which values change.
import type { Vector3 } from '../volume/matrix.ts';
import type { DetailField } from './detail-field.ts';
import type { HiddenValues } from './hidden-values.ts';

/** Light from the eye. */
export interface DetailLight {
  /** The share of a colour that goes with the cosine between the direction to the eye and that in which values change. */
  readonly diffuse: number;
  /** Edges of a voxel of the finest level, as shares of the unit cube. */
  readonly voxel: Vector3;
}

/**
 * Values of a level's own detail change so many times as much with one of its voxels as their root mean square between voxels. As measured in a volume of noise (1.36), in
 * noise of several octaves (1.36) and in waves of three to eight voxels (1.5 to 1.8).
 */
const changeOfOctave = 1.36;

/** By how much values change along each axis with a voxel of the finest level. Differences are taken as far apart as the voxels that are there, as a picture's are. */
export function changeAlong(field: DetailField, [x, y, z]: Vector3, voxel: Vector3): Vector3 {
  const [a, b, c] = field.voxelAt?.(x, y, z) ?? voxel;
  const change = (before: number, after: number, axis: number, apart: number): number => {
    const difference = ((after - before) / 2) * (voxel[axis] / apart);
    return Number.isNaN(difference) ? 0 : difference;
  };
  return [
    change(field.valueAt(x - a, y, z), field.valueAt(x + a, y, z), 0, a),
    change(field.valueAt(x, y - b, z), field.valueAt(x, y + b, z), 1, b),
    change(field.valueAt(x, y, z - c), field.valueAt(x, y, z + c), 2, c),
  ];
}

/** How values change at a place: by how much with a voxel of the finest level, and the cosine, 0..1, between that direction and a ray's. */
export function changeIn(
  field: DetailField,
  place: Vector3,
  [i, j, k]: readonly number[],
  { voxel }: DetailLight,
): readonly [change: number, facing: number] {
  const change = changeAlong(field, place, voxel);
  const [a, b, c] = voxel;
  const way = [i / a, j / b, k / c];
  const along = change[0] * way[0] + change[1] * way[1] + change[2] * way[2];
  const total = Math.hypot(...change);
  return [total, total > 0 ? Math.abs(along) / total / Math.hypot(...way) : 0];
}

/** How values that a level hides in a block may change with a voxel of the finest level: root of the mean square. @param due - the finest level that counts */
export function hiddenChange(hidden: HiddenValues, block: number, due: number, level: number): number {
  let sum = 0;
  for (let at = due; at < level; at++) {
    const ofOctave = hidden.rms(block, at + 1) ** 2 - (at > 0 ? hidden.rms(block, at) ** 2 : 0);
    sum += Math.max(0, ofOctave) / 4 ** at;
  }
  return changeOfOctave * Math.sqrt(sum);
}

/**
 * What happens to the cosine between the eye and the direction in which values change, where others are added to these changes that go anywhere.
 * @param ratio - of the added changes to those that are shown
 * @returns how much smaller it is in the mean, and its variance. Where the others are much larger, the mean is a half, and the variance a twelfth
 */
export function turnedLight(facing: number, ratio: number): { readonly darker: number; readonly variance: number } {
  const added = ratio ** 2;
  const share = added / (1 + added);
  return {
    darker: facing - Math.sqrt((facing ** 2 + added / 4) / (1 + added)),
    variance: (share * (1 - share) * (1 - facing ** 2)) / 3 + share ** 2 / 12,
  };
}
