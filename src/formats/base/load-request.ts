import type { Cleaning } from './clean-volume.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ScanTimes, ScanTarget } from './choose-scan.ts';
import type { RadarSettings } from './radar-settings.ts';

export type { DeviceLimits };

/** What to load: a `src`, and what the element's other attributes say of it. They win over the file and a manifest. */
export interface LoadRequest extends RadarSettings {
  /** http(s), data: or blob:; a relative one is taken from the page's base URL. */
  readonly url: string;
  /**
   * A stack: all files of **one** volume in their order, `url` the first of them. Images are a slice each (and one alone is
   * a volume of one slice); a header comes before the files of its data. Undefined where `url` is all that is loaded.
   */
  readonly files?: readonly string[];
  readonly mosaic?: { readonly columns: number; readonly rows: number };
  /** Tiles of a mosaic that are in use; all where undefined. */
  readonly slices?: number;
  /** World units per voxel of the file, per pixel (i, j) and slice (k) of a mosaic. */
  readonly spacing?: Vector3;
  /** Hide parts that touch nothing, see clean-volume.ts; all is shown where undefined. */
  readonly clean?: Cleaning;
  /** Of a manifest with scans: which one; the first where undefined. */
  readonly scan?: ScanTarget;
  /** What the volume must fit. To ask the device takes a while: the file is fetched and decoded meanwhile. */
  readonly limits: DeviceLimits | Promise<DeviceLimits>;
  /** Most bytes of samples, where the GPU had no memory for more: it is in `limits` too, and tells requests apart. */
  readonly maxBytes?: number;
}

export interface LoadProgress {
  /** Bytes. */
  readonly loaded: number;
  /** Bytes; 0 where it is not known. */
  readonly total: number;
  readonly phase: 'fetch' | 'decode';
  /** Nothing came for a while: others may load meanwhile. Pages are not told. */
  readonly isStill?: boolean;
}

export type LoadProgressListener = (progress: LoadProgress) => void;

/** Is told what scans a manifest lists, before one of them is loaded. */
export type ScansListener = (times: ScanTimes) => void;

/**
 * A small volume that stands in for a large one until that is there. Of a radar all of it but for its macrocells, which hold nothing: it is not
 * shown, but what draws it can be made ready meanwhile.
 */
export interface CoarseVolume {
  readonly volume: Volume;
  /** The large one, but for what takes memory. */
  readonly of: Omit<Volume, 'samples' | 'macrocells'>;
}

/** @param coarse - null as soon as it is known that the volume is a radar's, before anything of it is */
export type CoarseListener = (coarse: CoarseVolume | null) => void;
