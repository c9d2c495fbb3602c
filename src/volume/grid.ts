import { length, multiply, scaleAndTranslate, transformPoint } from './matrix.ts';
import type { Matrix4, Vector3 } from './matrix.ts';

/**
 * A block of cells and its place in the world, for cameras, step lengths and macrocells. Samples lie at the cells'
 * centres only on a cartesian grid.
 */
export interface GridFrame {
  /** Cells along i (fastest), j and k; for a region they need not be whole numbers. */
  readonly dimensions: Vector3;
  /**
   * Row-major 4 x 4: cell index (i, j, k), integers at cell *centres*, to world coordinates. The world is x right,
   * y anterior, z superior in mm for medical files (RAS); flips and shears are kept.
   */
  readonly indexToWorld: Matrix4;
  /** World length of one cell step along i, j and k: the lengths of the affine's columns. */
  readonly spacing: Vector3;
}

/** A grid with one sample at each cell's centre. */
export interface CartesianGrid extends GridFrame {
  readonly kind: 'cartesian';
}

export function cartesianGrid(dimensions: Vector3, indexToWorld: Matrix4): CartesianGrid {
  return { kind: 'cartesian', dimensions, indexToWorld, spacing: spacingOf(indexToWorld) };
}

/** Row-major: the unit cube [0, 1]^3 that holds all voxels entirely (texture coordinates) to world coordinates. */
export function unitToWorld(grid: GridFrame): Matrix4 {
  return multiply(grid.indexToWorld, scaleAndTranslate(grid.dimensions, [-0.5, -0.5, -0.5]));
}

/** World length of one voxel step along i, j and k: the lengths of the affine's columns. */
export function spacingOf(indexToWorld: Matrix4): Vector3 {
  return [0, 1, 2].map((c) =>
    length([indexToWorld[c], indexToWorld[4 + c], indexToWorld[8 + c]]),
  ) as unknown as Vector3;
}

/**
 * The world of a volume whose file gives no position: centred at the origin. Image columns run to -x, image rows to -y
 * and slices to +z, which is the axial DICOM order (left, posterior, superior) in RAS coordinates. Seen from the front
 * (+y), columns run to the right.
 */
export function axialIndexToWorld(dimensions: Vector3, spacing: Vector3): Matrix4 {
  const signed: Vector3 = [-spacing[0], -spacing[1], spacing[2]];
  return scaleAndTranslate(signed, signed.map((s, axis) => (-s * (dimensions[axis] - 1)) / 2) as unknown as Vector3);
}

/** The eight corners of the grid in world coordinates. */
export function corners(grid: GridFrame): Vector3[] {
  const toWorld = unitToWorld(grid);
  return [0, 1, 2, 3, 4, 5, 6, 7].map((c) => transformPoint(toWorld, [c & 1, (c >> 1) & 1, c >> 2]));
}

/** World lengths of the grid's three edges. */
export function edgeLengths(grid: GridFrame): Vector3 {
  const { dimensions, spacing } = grid;
  return [spacing[0] * dimensions[0], spacing[1] * dimensions[1], spacing[2] * dimensions[2]];
}

/** World length of the grid's shortest voxel edge. */
export function finestSpacing(grid: GridFrame): number {
  return Math.min(...grid.spacing);
}

/** World length of the longest of the grid's four space diagonals: the maximum length of a ray. */
export function longestDiagonal(grid: GridFrame): number {
  const c = corners(grid);
  return Math.max(
    ...[0, 1, 2, 3].map((i) => length([c[i][0] - c[7 - i][0], c[i][1] - c[7 - i][1], c[i][2] - c[7 - i][2]])),
  );
}

/** Centre of the grid, and the radius of the sphere around the grid. */
export function boundingSphere(grid: GridFrame): { center: Vector3; radius: number } {
  return { center: transformPoint(unitToWorld(grid), [0.5, 0.5, 0.5]), radius: longestDiagonal(grid) / 2 };
}

/**
 * Between two samples that are one voxel apart, tri-linear values differ from the straight line by at most this share
 * of the roughness around them. Causes: kinks at up to three faces of voxels, each crossed half way, and the twist
 * inside a voxel.
 */
export const offLine = 0.7;
