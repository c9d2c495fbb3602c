import { meetVoxelPlanes } from '../optics/rays/voxel-planes.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { brickSide } from './brick-data.ts';
import type { BrickLayout } from './brick-layout.ts';

/** A piece that begins or ends so near to a face between bricks, in shares of a line, is on one side of it. */
const faceSlack = 1e-8;

/** The bricks, and the volume over which they lie. */
interface ShownBricks {
  readonly layout: BrickLayout;
  /** Of the finest level of which something is there. */
  readonly grid: GridFrame;
  slotAt(place: Vector3): number;
}

/**
 * Where values of bricks kink along a line between two places of the unit cube, see `FieldStage.kinksAlong`: at the planes of the finest voxels that are there, and right
 * before and behind faces between bricks, over which they may jump. Twin: shaders/chunks/field/bricks-3d.glsl, meetPlaneOrFace
 */
export function findKinks({ layout, grid, slotAt }: ShownBricks, from: Vector3, to: Vector3): number[] {
  const voxels = grid.dimensions;
  const meet = (count: (x: number, axis: number) => number, dimensions: Vector3): readonly number[] => {
    const [begin, end] = [from.map(count), to.map(count)];
    const way = end.map((x, axis) => x - begin[axis]);
    return meetVoxelPlanes(begin as unknown as Vector3, way as unknown as Vector3, dimensions);
  };
  const planes = meet((x, axis) => x * voxels[axis] - 0.5, voxels);
  const [{ scale, shift }] = layout.levels;
  const ends = layout.cells.map((n) => n + 1) as unknown as Vector3; // There are faces at both ends.
  const faces = meet((x, axis) => (x * scale[axis] + shift[axis]) / brickSide, ends);
  const slotOf = (share: number): number =>
    slotAt(from.map((x, axis) => x + share * (to[axis] - x)) as unknown as Vector3);
  const sides = faces
    .map((share) => [share - faceSlack, share + faceSlack])
    .filter(([before, behind]) => slotOf(before) !== slotOf(behind));
  const kinks = [...planes, ...sides.flat().filter((share) => share > 0 && share < 1)];
  kinks.sort((a, b) => a - b);
  return kinks;
}
