import type { BrickLevel, BrickSamples } from '../../bricks/brick-data.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import type { ResidualTable } from '../../bricks/residuals.ts';

/** Reads a pyramid brick by brick. */
export interface BrickStore {
  /** Voxels of a brick along each axis, without its halo. */
  readonly side: number;
  /** The type of all samples. */
  readonly type: 'uint8' | 'uint16' | 'float32';
  /**
   * Data value = slope * sample + intercept, the same for all bricks. The ordinary volume of the same file may have others, and another type: it is
   * stored as its own range of values allows.
   */
  readonly slope: number;
  readonly intercept: number;
  /** The finest first. Levels of the file whose voxels have no whole factors are left out. */
  readonly levels: readonly BrickLevel[];
  /**
   * Reads a brick. Failed requests are repeated before this fails.
   * @param isAlone - without the voxels of its neighbours: these may be in other chunks; false if undefined
   * @param signal - gives it up: requests that no other brick waits for end in the network
   * @throws {VolumeViewError} `source/…`, `format/…`; the signal's reason; an `AbortError` once the store is closed; {RangeError} for a brick that
   * does not exist
   */
  read(brick: Brick, signal: AbortSignal, isAlone?: boolean): Promise<BrickSamples>;
  /**
   * What the pyramid's writer has said of its levels, in stored values of this store, with the levels of this store. Null where it has said nothing. Nothing is
   * kept: call it once.
   * @throws {VolumeViewError} `format/corrupt` where it can not be true, `format/too-large`, `format/unsupported`, `source/…`: then the bricks can be read all the
   * same; the signal's reason; an `AbortError` once the store is closed
   */
  residuals(signal: AbortSignal): Promise<ResidualTable | null>;
  /** Ends all that is on its way. No request is alive afterwards. */
  close(): void;
}
