import { identity } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';

/** What cuts a volume in addition to its own bounds. */
export interface CutFaces {
  /** Row-major: the grid's unit cube to that of the visible region; the identity if all is visible. */
  readonly unitToRegion: Matrix4;
  /** The part that stays: places p of the unit cube with normal . p >= offset. */
  readonly halfSpaces: readonly { readonly normal: Vector3; readonly offset: number }[];
  /** The grid's unit cube to that of a box that is cut out; null if there is none. */
  readonly unitToCutout: Matrix4 | null;
}

export const uncut: CutFaces = { unitToRegion: identity, halfSpaces: [], unitToCutout: null };

/** Computes a place's coordinates in a box, in voxels from its low faces: (x, y, z, 1) times a row for each; and the box's size. */
export interface BoxInVoxels {
  readonly rows: readonly (readonly [number, number, number, number])[];
  readonly size: Vector3;
}

/** @param unitToBox - row-major: to a box's unit cube @param dimensions - number of voxels along the unit cube's edges */
export function measureBox(unitToBox: Matrix4, dimensions: Vector3): BoxInVoxels {
  const size = [0, 4, 8].map(
    (row) => 1 / changePerVoxel([unitToBox[row], unitToBox[row + 1], unitToBox[row + 2]], dimensions),
  ) as unknown as Vector3;
  const rows = size.map((scale, i) =>
    [0, 1, 2, 3].map((column) => scale * unitToBox[4 * i + column]),
  ) as unknown as BoxInVoxels['rows'];
  return { rows, size };
}

/** How much normal . p changes from one voxel to the next, along the normal. */
export function changePerVoxel(normal: Vector3, dimensions: Vector3): number {
  return Math.hypot(...normal.map((x, axis) => x / dimensions[axis]));
}

/**
 * How much light applies at a place: 0 at a cut and beyond, 1 from one voxel inside on. A cut face shows values; taps of gradients
 * beyond it would show data that was cut away. Source: Weiskopf, Engel and Ertl 2003. Twin: shaders/chunks/shade/lit.glsl, fadeAtCuts
 */
export function fadeAtCuts(
  { unitToRegion, halfSpaces, unitToCutout }: CutFaces,
  dimensions: Vector3,
): (place: Vector3) => number {
  const boxes = [identity, unitToRegion].map((one) => measureBox(one, dimensions));
  const cutout = unitToCutout && measureBox(unitToCutout, dimensions);
  const planes = halfSpaces.map(({ normal, offset }) => ({
    normal,
    offset,
    scale: 1 / changePerVoxel(normal, dimensions),
  }));
  return (place) => {
    let depth = cutout ? -depthInBox(cutout, place) : 1;
    for (const box of boxes) depth = Math.min(depth, depthInBox(box, place));
    for (const { normal, offset, scale } of planes)
      depth = Math.min(depth, scale * (normal[0] * place[0] + normal[1] * place[1] + normal[2] * place[2] - offset));
    return Math.min(1, Math.max(0, depth));
  };
}

/** Distance from a box's nearest face, in voxels; negative outside. */
function depthInBox({ rows, size }: BoxInVoxels, [x, y, z]: Vector3): number {
  let depth = Infinity;
  for (let axis = 0; axis < 3; axis++) {
    const row = rows[axis];
    const low = row[0] * x + row[1] * y + row[2] * z + row[3];
    depth = Math.min(depth, low, size[axis] - low);
  }
  return depth;
}
