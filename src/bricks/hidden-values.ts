import type { Vector3 } from '../volume/matrix.ts';
import { brickReach, brickSide } from './brick-data.ts';
import type { BrickSamples } from './brick-data.ts';
import type { BrickLayout } from './brick-layout.ts';
import type { Brick } from './pyramid.ts';
import { blockFinder } from './resident-field.ts';
import type { ResidualTable } from './residuals.ts';

/** What is known of the values that the levels of a pyramid hide, block by block, in stored values. */
export interface HiddenValues {
  /** The block at a place of the unit cube. */
  blockAt(x: number, y: number, z: number): number;
  /** Root of the mean square, and the largest, of the differences between a level and level 0. */
  rms(block: number, level: number): number;
  max(block: number, level: number): number;
  /** Over how many voxels of level 0 along a ray the differences of a level go together; undefined: as in noise of one octave. */
  correlation?(level: number): number;
  /** Smallest and largest value of a block; low > high where it has no data. */
  low(block: number): number;
  high(block: number): number;
}

/** Residuals of interpolated noise that are one voxel of their level apart: how far they go together. */
export const alongOfNoise = 0.25;

/** Over how many voxels values go together of which neighbours do so far. @param along - 0 to 1 */
export function voxelsTogether(along: number): number {
  return (1 + along) / (1 - along);
}

/** As a table says it that lies next to the pyramid. @param dimensions - of level 0 */
export function hiddenByTable({ side, low, high, levels }: ResidualTable, dimensions: Vector3): HiddenValues {
  return {
    blockAt: blockFinder(dimensions, side),
    rms: (block, level) => levels[level].rms[block],
    max: (block, level) => levels[level].max[block],
    low: (block) => low[block],
    high: (block) => high[block],
  };
}

/** The same for bricks over a volume. @param levels - the table's level of each level of bricks, and last that of the volume; the first is 0 */
export function hiddenUnderBricks(
  table: ResidualTable,
  { levels: [{ dimensions, scale, shift }] }: BrickLayout,
  levels: readonly number[],
): HiddenValues {
  const { blockAt, rms, max, low, high } = hiddenByTable(table, dimensions);
  const [inX, inY, inZ] = [0, 1, 2].map(
    (axis) => (place: number) => (place * scale[axis] + shift[axis]) / dimensions[axis],
  );
  return {
    blockAt: (x, y, z) => blockAt(inX(x), inY(y), inZ(z)),
    rms: (block, level) => rms(block, levels[level]),
    max: (block, level) => max(block, levels[level]),
    low,
    high,
  };
}

/** How far a value may lie outside of its block's, as a share of these: they are rounded. */
const rounding = 1e-5;

/** Whether the values of a brick are among those that a table has for its blocks: it is a table of other voxels where they are not. */
export function holdsBrick(
  { side, blocks, low, high }: ResidualTable,
  { levels }: BrickLayout,
  { level, at }: Brick,
  { low: least, high: most }: Pick<BrickSamples, 'low' | 'high'>,
): boolean {
  if (!(least <= most)) return true;
  const { factors } = levels[level];
  // A block's values have those of the next voxel: one of the voxels that it was read with.
  const beyond = factors.map((n) => n * brickReach - 1);
  const from = at.map((n, axis) => Math.floor((n * brickSide * factors[axis] - beyond[axis]) / side));
  const to = at.map((n, axis) => Math.floor(((n + 1) * brickSide * factors[axis] - 1 + beyond[axis]) / side));
  const [first, last] = [from, to].map((ends) => ends.map((n, axis) => Math.min(blocks[axis] - 1, Math.max(0, n))));
  let [min, max] = [Infinity, -Infinity];
  for (let k = first[2]; k <= last[2]; k++)
    for (let j = first[1]; j <= last[1]; j++)
      for (let i = first[0]; i <= last[0]; i++) {
        const block = i + blocks[0] * (j + blocks[1] * k);
        [min, max] = [Math.min(min, low[block]), Math.max(max, high[block])];
      }
  const tolerance = rounding * Math.max(Math.abs(min), Math.abs(max));
  return least >= min - tolerance && most <= max + tolerance;
}
