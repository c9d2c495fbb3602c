import type { GridFrame } from './grid.ts';
import type { Vector3 } from './matrix.ts';

/** Voxels that are smaller than those of a volume, at some of its places: bricks of the finer levels of its pyramid. */
export interface FinerVoxels {
  /** What the renderer's `FieldProvider` has: who makes such voxels has loaded the code that uploads them. */
  readonly upload: (...given: never[]) => unknown;
  /** The grid of the pyramid's finest level over the volume's own unit cube: light counts changes from one of its voxels to the next. */
  readonly finest: GridFrame;
  /** The same for the finest level of which something is there now: it says how finely rays have to be sampled. */
  readonly grid: GridFrame;
  /** The stored value at a place of the unit cube; NaN for no data, and undefined where the volume itself says more. */
  storedAt(place: Vector3): number | undefined;
  /** Edges of the voxel at a place, in the unit cube. */
  voxelAt(place: Vector3): Vector3;
}
