import type { GridFrame } from '../volume/grid.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/samples.ts';

/** Voxels along each axis of a brick that is read, without its halo. */
export const brickSide = 32;

/**
 * A level of a pyramid that is read in bricks. `indexToWorld` is what the file says. So the place of a voxel in another level follows from both
 * matrices, and not from the factors alone: many files have their coarse voxels half a voxel away from where the factors put them.
 */
export interface BrickLevel extends GridFrame {
  /** Bricks along i, j and k: those at the upper ends may reach over the end. */
  readonly bricks: Vector3;
  /**
   * Voxels of level 0 that one voxel has along i, j and k: whole numbers from 1, not always powers of two, nor the same along all axes. Brick
   * `at` of level 0 lies in brick `floor(at / factors)` of this level (no further than its last one): the place of any of its points is at
   * most half a voxel outside that brick, and so between voxels that the brick has.
   */
  readonly factors: Vector3;
}

/** What was read of a brick. */
export interface BrickSamples {
  /**
   * (side + 2)³ stored values, i fastest, of the store's type: the brick with one voxel more at each side. Voxels outside of the level have the value of
   * the nearest one inside. NaN (float only) means no data. The receiver owns them.
   */
  readonly samples: Samples;
  /** Smallest and largest stored value of all of them; low > high where none has data. */
  readonly low: number;
  readonly high: number;
  /** Whether any of them has no data. */
  readonly hasNoData: boolean;
}
