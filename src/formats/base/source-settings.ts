import type { Vector3 } from '../../volume/matrix.ts';
import type { Cleaning } from './clean-volume.ts';
import type { RadarSettings } from './radar-settings.ts';

/** How an image is cut into slices, or into a radar's sweeps. */
export interface MosaicSettings {
  readonly mosaic?: { readonly columns: number; readonly rows: number };
  /** Number of tiles of a mosaic that are in use; all if undefined. */
  readonly slices?: number;
}

/** What attributes say about how to read a file. They override the file and a manifest; what is undefined follows from these. */
export interface SourceSettings extends MosaicSettings, RadarSettings {
  /** World units per voxel of the file, per pixel (i, j) and slice (k) of a mosaic. */
  readonly spacing?: Vector3;
  /** Which of several series, from 1; the one with the most voxels where undefined. */
  readonly series?: number;
  /** What of a pyramid of levels is read: x, y and z of two opposite corners, world; all where undefined. */
  readonly region?: readonly number[];
  /** Bytes that the level of a pyramid may have; what the device holds where undefined. */
  readonly maxBytes?: number;
  /** Bytes that the bricks of a page may take on its GPU; what the device can afford where undefined. */
  readonly maxGpuBytes?: number;
  /** Of labels: the length, world units, than which the voxels of a level need not be shorter. Then no level is read that may have means. */
  readonly labelDetail?: number;
  /** Hide parts that touch nothing, see clean-volume.ts; all is shown where undefined. */
  readonly clean?: Cleaning;
  /** Whether cookies and logins are sent to other servers than the page's own; not where undefined. */
  readonly credentials?: 'include';
}
