import type { FinerLevel } from '../volume/finer-voxels.ts';
import type { Samples } from '../volume/samples.ts';

/** Voxels along each axis of a brick that is read, without its halo. */
export const brickSide = 32;

/** Voxels of the neighbours at each side of a brick on the GPU: so many does interpolation up to its faces read, and a voxel away from there, as light does. */
export const brickHalo = 2;

/** Of them, those that interpolation up to its faces reads. */
export const brickReach = 1;

/** Voxels along each axis of a brick with its halo. */
export const slotSide = brickSide + 2 * brickHalo;

/** A level of a pyramid that is read in bricks. */
export type BrickLevel = FinerLevel;

/** What was read of a brick. */
export interface BrickSamples {
  /**
   * (side + 4)³ stored values, i fastest, of the store's type: the brick with two voxels more at each side (its halo). A store reads the inner half of the halo. The outer
   * half, voxels outside of the level, and the whole halo of a brick that is read alone have the value of the nearest one that was read. NaN (float only) means no data.
   * The receiver owns them.
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
