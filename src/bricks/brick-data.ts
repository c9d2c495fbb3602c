import type { FinerLevel } from '../volume/finer-voxels.ts';
import type { Samples } from '../volume/samples.ts';

/** Voxels along each axis of a brick that is read, without its halo. */
export const brickSide = 32;

/** A level of a pyramid that is read in bricks. */
export type BrickLevel = FinerLevel;

/** What was read of a brick. */
export interface BrickSamples {
  /**
   * (side + 2)³ stored values, i fastest, of the store's type: the brick with one voxel more at each side (its halo). Voxels outside of the level, and the whole halo of
   * a brick that is read alone, have the value of the nearest one inside. NaN (float only) means no data. The receiver owns them.
   */
  readonly samples: Samples;
  /** Smallest and largest stored value of all of them; low > high where none has data. */
  readonly low: number;
  readonly high: number;
  /** Whether any of them has no data. */
  readonly hasNoData: boolean;
}

/** Whether any voxel of a brick, its halo included, has no data. */
export function lacksData(samples: Samples): boolean {
  if (!(samples instanceof Float32Array)) return false;
  // Floats that are finite have a finite sum in doubles; that is quicker than to look at each.
  let sum = 0;
  for (let n = 0; n < samples.length; n++) sum += samples[n];
  return !Number.isFinite(sum);
}
