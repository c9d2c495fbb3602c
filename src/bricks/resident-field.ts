import { interpolate } from '../optics/rays/interpolate.ts';
import { storedField } from '../optics/rays/ray-field.ts';
import type { FieldStage } from '../optics/rays/ray-stages.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { DetailField } from './detail-field.ts';
import { toLevel } from './pyramid.ts';
import type { Pyramid } from './pyramid.ts';

/** The number of the cell (brick of level 0) at a place of the unit cube. */
export function cellFinder({ levels, side }: Pyramid): (x: number, y: number, z: number) => number {
  return blockFinder(levels[0].dimensions, side);
}

/** The number of the block of `side` voxels at a place of the unit cube, i fastest. */
export function blockFinder(dimensions: Vector3, side: number): (x: number, y: number, z: number) => number {
  const [cx, cy, cz] = dimensions.map((n) => Math.ceil(n / side));
  const [sx, sy, sz] = dimensions.map((n) => n / side);
  const index = (share: number, scale: number, count: number): number =>
    Math.min(count - 1, Math.max(0, Math.floor(share * scale)));
  return (x, y, z) => index(x, sx, cx) + cx * (index(y, sy, cy) + cy * index(z, sz, cz));
}

/**
 * The stored value at a place of the unit cube at the level that its cell has. As if bricks had a halo with the voxels of their
 * neighbours, and so those of the same level.
 * @param levelOf - of each cell; may change later
 */
export function residentSampler(pyramid: Pyramid, levelOf: Uint8Array): (x: number, y: number, z: number) => number {
  const cellAt = cellFinder(pyramid);
  const scales = pyramid.levels.map((_, level) => toLevel(pyramid, level));
  return (x, y, z) => {
    const level = levelOf[cellAt(x, y, z)];
    const [sx, sy, sz] = scales[level];
    const { samples, dimensions } = pyramid.levels[level];
    return interpolate(samples, dimensions, [x * sx, y * sy, z * sz]);
  };
}

/** What an estimate of the detail reads of a pyramid. */
export function detailField(pyramid: Pyramid, levelOf: Uint8Array): DetailField {
  const cellAt = cellFinder(pyramid);
  const voxels = pyramid.levels.map(
    (_, level) => pyramid.levels[0].dimensions.map((n) => 2 ** level / n) as unknown as Vector3,
  );
  return {
    levels: pyramid.levels.length,
    valueAt: residentSampler(pyramid, levelOf),
    voxelAt: (x, y, z) => voxels[levelOf[cellAt(x, y, z)]],
    cellAt,
    levelOf: (cell) => levelOf[cell],
  };
}

/** The same as the field of a ray. */
export function residentField(
  pyramid: Pyramid,
  levelOf: Uint8Array,
  scaling: { readonly slope: number; readonly intercept: number },
): FieldStage {
  const storedAt = residentSampler(pyramid, levelOf);
  return storedField(([x, y, z]: Vector3) => storedAt(x, y, z), scaling);
}
