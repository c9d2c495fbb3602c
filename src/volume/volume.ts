import type { Histogram } from './histogram.ts';
import type { Macrocells } from './macrocells.ts';
import type { Matrix4, Vector3 } from './matrix.ts';

/**
 * Stored samples. Signed 8- and 16-bit files are shifted to unsigned and wider types become float, the shift being
 * undone by `slope` and `intercept`, so three types are all that textures and shaders have to know.
 */
export type Samples = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Float32Array<ArrayBuffer>;

/** A scalar volume on a cartesian grid. */
export interface Volume {
  /** Voxels along i (fastest), j and k. */
  readonly dimensions: Vector3;
  /** `dimensions[0] * dimensions[1] * dimensions[2]` stored values, i fastest. NaN (float only) means no data. */
  readonly samples: Samples;
  /** Data value = slope * sample + intercept, in `unit`. */
  readonly slope: number;
  readonly intercept: number;
  /** Unit of the data values ('HU', 'dBZ', ...); '' where unknown. */
  readonly unit: string;
  /**
   * Row-major 4 x 4: voxel index (i, j, k), integers at voxel *centres*, to world coordinates. The world is x right,
   * y anterior, z superior in mm for medical files (RAS); flips and shears are kept.
   */
  readonly indexToWorld: Matrix4;
  /** World length of one voxel step along i, j and k. */
  readonly spacing: Vector3;
  /** Smallest and largest valid data value, in `unit`. */
  readonly range: readonly [number, number];
  /** Counts of valid data values over `range`. */
  readonly histogram: Histogram;
  /** Ranges of stored values in blocks of voxels. */
  readonly macrocells: Macrocells;
  /** Whether any sample is NaN (no data). */
  readonly hasNoData: boolean;
  /** What the data came from: 'NIfTI-1', 'PNG mosaic', ... */
  readonly format: string;
  /** What the file or manifest itself says of how it wants to be shown. Attributes win over these. */
  readonly title?: string;
  readonly credit?: string;
  readonly window?: readonly [number, number];
  readonly transferFunction?: string;
  /** Set when the volume was made smaller to fit the device. */
  readonly reduced?: { readonly from: Vector3; readonly to: Vector3 };
}
