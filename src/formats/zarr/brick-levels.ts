import { brickReach, brickSide } from '../../bricks/brick-data.ts';
import type { BrickLevel } from '../../bricks/brick-data.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { OmeAxes } from './ome-axes.ts';
import { worldOf } from './ome-levels.ts';
import type { OmeLevel } from './ome-levels.ts';
import type { OmeImage } from './open-image.ts';

/** A level that is read in bricks. */
export interface ZarrBrickLevel {
  readonly brick: BrickLevel;
  readonly level: OmeLevel;
  /** Which level of the file it is: the finest is 0. */
  readonly number: number;
}

/** Voxels: how far a level may lie from where whole factors put it. Half of one is what files have whose levels begin at the same middle of a voxel. */
const mostAway = 0.5 + 1e-3;

/**
 * The levels of an image that can be read in bricks: their voxels are whole numbers of voxels of the finest one, and a brick needs no more than so many bytes of chunks.
 * @returns the finest first; none where the finest one can't be
 */
export function chooseBrickLevels({ levels, axes }: OmeImage, maxBytes: number): ZarrBrickLevel[] {
  const found = levels.flatMap((level, number): ZarrBrickLevel[] => {
    const factors = findFactors(level, levels[0], axes);
    if (!factors || bytesForBrick(level, axes) > maxBytes) return [];
    const { dimensions } = level;
    const bricks = dimensions.map((n) => Math.ceil(n / brickSide)) as unknown as Vector3;
    return [{ level, number, brick: { ...cartesianGrid(dimensions, worldOf(level, axes)), bricks, factors } }];
  });
  return found[0]?.number === 0 ? found : [];
}

/** Voxels of the finest level in one of this, along i, j and k; null where they are no whole numbers. */
function findFactors(level: OmeLevel, finest: OmeLevel, { space }: OmeAxes): Vector3 | null {
  const factors = space.map((axis, i) => {
    if (axis === null) return 1;
    const ratio = level.scale[axis] / finest.scale[axis];
    const factor = Math.max(1, Math.round(ratio));
    // Both ends of the finest level, as places in this one, and where the factor puts them.
    const isNear = [-0.5, finest.dimensions[i] - 0.5].every((end) => {
      const own = (end * finest.scale[axis] + finest.translation[axis] - level.translation[axis]) / level.scale[axis];
      return Math.abs(own - ((end + 0.5) / factor - 0.5)) <= mostAway;
    });
    return isNear ? factor : 0;
  });
  return factors.includes(0) ? null : (factors as unknown as Vector3);
}

/** Bytes of the chunks that a brick needs at most with the voxels next to it. */
function bytesForBrick({ array, dimensions }: OmeLevel, { space }: OmeAxes): number {
  const chunks = space.reduce<number>((product, axis, i) => {
    if (axis === null) return product;
    const span = Math.min(dimensions[i], brickSide + 2 * brickReach);
    return (
      product * Math.min(Math.ceil(dimensions[i] / array.chunk[axis]), Math.ceil((span - 1) / array.chunk[axis]) + 1)
    );
  }, 1);
  return chunks * array.chunk.reduce((product, n) => product * n, array.type.bytesPerSample);
}
