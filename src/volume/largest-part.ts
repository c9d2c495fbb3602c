// The largest part of a label, and its centre.
import { transformDirection } from './matrix.ts';
import type { Matrix4, Vector3 } from './matrix.ts';

/** The largest part of a label among voxels. */
export interface LargestPart {
  /** Indices of the voxel of the part that is nearest, in the world, to the part's centre of mass: the centre itself may lie outside. */
  readonly center: Vector3;
  /** How many voxels the part has. */
  readonly voxels: number;
}

/** Voxels that wait to be visited are kept in a list of this length at first. */
const firstRoom = 1024;

/**
 * The largest part of the voxels that have a number. Voxels of a part touch by their faces. Visits each of them twice.
 * @param numbers - of all voxels, i fastest
 * @param grid - `indexToWorld` from the indices of a voxel to the world
 * @returns null where no voxel has the number; of parts of the same size the first one
 */
export function findLargestPart(
  numbers: ArrayLike<number>,
  { dimensions: [nx, ny, nz], indexToWorld }: { readonly dimensions: Vector3; readonly indexToWorld: Matrix4 },
  wanted: number,
): LargestPart | null {
  const total = nx * ny * nz;
  const seen = new Uint8Array(total);
  const around = [1, -1, nx, -nx, nx * ny, -nx * ny];
  let stack = new Int32Array(firstRoom);
  /** Goes through the part of a voxel. */
  const visit = (first: number, mark: number, visitor: (i: number, j: number, k: number) => void): number => {
    let [waiting, voxels] = [1, 0];
    stack[0] = first;
    seen[first] = mark;
    while (waiting > 0) {
      const voxel = stack[--waiting];
      const [i, j, k] = [voxel % nx, Math.floor(voxel / nx) % ny, Math.floor(voxel / (nx * ny))];
      voxels++;
      visitor(i, j, k);
      const isInside = [i < nx - 1, i > 0, j < ny - 1, j > 0, k < nz - 1, k > 0];
      if (waiting + 6 > stack.length) {
        const longer = new Int32Array(2 * stack.length);
        longer.set(stack);
        stack = longer;
      }
      for (let side = 0; side < 6; side++) {
        const next = voxel + around[side];
        if (!isInside[side] || seen[next] >= mark || numbers[next] !== wanted) continue;
        seen[next] = mark;
        stack[waiting++] = next;
      }
    }
    return voxels;
  };
  let largest: { readonly first: number; readonly voxels: number; readonly sum: Vector3 } | null = null;
  for (let voxel = 0; voxel < total; voxel++) {
    if (numbers[voxel] !== wanted || seen[voxel]) continue;
    const sum: [number, number, number] = [0, 0, 0];
    const voxels = visit(voxel, 1, (i, j, k) => {
      sum[0] += i;
      sum[1] += j;
      sum[2] += k;
    });
    if (voxels > (largest?.voxels ?? 0)) largest = { first: voxel, voxels, sum };
  }
  if (!largest) return null;
  const middle = largest.sum.map((one) => one / largest.voxels);
  let [center, nearest]: [Vector3, number] = [[0, 0, 0], Infinity];
  visit(largest.first, 2, (i, j, k) => {
    const distance = Math.hypot(...transformDirection(indexToWorld, [i - middle[0], j - middle[1], k - middle[2]]));
    if (distance < nearest) [center, nearest] = [[i, j, k], distance];
  });
  return { center, voxels: largest.voxels };
}
