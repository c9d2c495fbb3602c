import type { Vector3 } from '../../volume/matrix.ts';

/** If a whole line moves less than this share of a voxel along an axis, that is rounding. */
const drift = 1e-9;

/**
 * Where a line meets planes of voxels' centres: shares of the line, ascending, without duplicates and without the line's ends. Between two
 * planes, tri-linear values are one cubic of the length. Beyond the outermost centres values are constant, so there are no planes.
 * @param from - in voxels; whole numbers are at centres
 * @param way - the vector from the line's start to its end, also in voxels
 * @param shift - 0.5 for the planes between voxels, where the nearest voxel changes
 * Twin: shaders/chunks/walk/walk-voxels.glsl
 */
export function meetVoxelPlanes(from: Vector3, way: Vector3, dimensions: Vector3, shift = 0): number[] {
  const shares: number[] = [];
  for (let axis = 0; axis < 3; axis++) {
    const length = way[axis];
    if (Math.abs(length) < drift) continue;
    const [low, high] = length > 0 ? [from[axis], from[axis] + length] : [from[axis] + length, from[axis]];
    const last = Math.min(dimensions[axis] - 1 - 2 * shift, Math.floor(high - shift));
    for (let plane = Math.max(0, Math.ceil(low - shift)); plane <= last; plane++) {
      const share = (plane + shift - from[axis]) / length;
      if (share > 0 && share < 1) shares.push(share);
    }
  }
  shares.sort((a, b) => a - b);
  return shares.filter((share, i, all) => i === 0 || share > all[i - 1]);
}

/**
 * The part of a line that lies in the box of all voxels, as shares of the line; null if no part does.
 * @param from, way - see `meetVoxelPlanes`
 */
export function cutToVoxels(from: Vector3, way: Vector3, dimensions: Vector3): readonly [number, number] | null {
  let [begin, end] = [0, 1];
  for (let axis = 0; axis < 3; axis++) {
    const [low, high] = [-0.5 - from[axis], dimensions[axis] - 0.5 - from[axis]];
    if (Math.abs(way[axis]) < drift) {
      if (low > 0 || high < 0) return null;
      continue;
    }
    const [one, other] = [low / way[axis], high / way[axis]];
    begin = Math.max(begin, Math.min(one, other));
    end = Math.min(end, Math.max(one, other));
  }
  return begin <= end ? [begin, end] : null;
}
