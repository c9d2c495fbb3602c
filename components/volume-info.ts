import type { Volume } from '../src/volume/volume.ts';
import type { Matrix4, Vector3 } from '../src/volume/matrix.ts';

/** What a page may know of a loaded volume: everything but its samples. */
export interface VolumeInfo {
  /** Voxels along i, j and k. */
  readonly dimensions: Vector3;
  /** World units per voxel along i, j and k. */
  readonly spacing: Vector3;
  /** Unit of the data values, or ''. */
  readonly unit: string;
  /** Smallest and largest data value. */
  readonly range: readonly [number, number];
  /** What the data came from, 'NIfTI-1' for instance. */
  readonly format: string;
  /** Row-major 4 x 4: voxel index, whole numbers at voxel centres, to world. */
  readonly indexToWorld: Matrix4;
  /** What the volume is, if its manifest says so. */
  readonly title?: string;
  /** Whose data these are, if its manifest says so. */
  readonly credit?: string;
  /** Set where the volume was made smaller to fit the device. */
  readonly reduced?: { readonly from: Vector3; readonly to: Vector3 };
}

export function describeVolume(volume: Volume): VolumeInfo {
  const { dimensions, spacing, unit, range, format, indexToWorld, title, credit, reduced } = volume;
  return { dimensions, spacing, unit, range, format, indexToWorld, title, credit, reduced };
}
