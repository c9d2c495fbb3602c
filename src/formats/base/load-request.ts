import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ScanTimes, ScanTarget } from './choose-scan.ts';
import type { PlaceData, ScanData } from './scan-data.ts';
import type { SourceSettings } from './source-settings.ts';

export type { DeviceLimits };

/** Files of the reader's disk. */
export interface LocalFiles {
  /** Begins the URLs that the files have for each other; each choice of files has its own. */
  readonly base: string;
  /** They are checked when they are opened: scripts of a page may give anything. */
  readonly files: readonly unknown[];
  /** Sends further files, to a worker, which has to have them all. */
  readonly rest?: MessagePort;
}

/** What to load: a `src`, and what the element's other attributes say about it. */
export interface LoadRequest {
  /** http(s), data: or blob:; a relative URL is resolved against the page's base URL. */
  readonly url: string;
  /**
   * A stack: all files of **one** volume in their order, with `url` as the first. Each image is one slice (a single
   * image is a volume of one slice); a header comes before the files of its data. Undefined if `url` is the only file.
   */
  readonly files?: readonly string[];
  /** Files of the reader's disk, of one volume; then `url` is their base. */
  readonly local?: LocalFiles;
  /** How to read it. */
  readonly settings?: SourceSettings;
  /** Of a manifest with scans, or a file of several volumes: which one. Where undefined it is the first, and a file is not opened as scans. */
  readonly scan?: ScanTarget;
  /** Whether its page can show a coarse level of a pyramid with bricks of finer ones over it. */
  readonly finer?: boolean;
  /** Set once the file is open: where that scan lies, or the numbers of one place in all scans. */
  readonly data?: ScanData | PlaceData;
  /**
   * The device's limits, which the volume must fit. Asking the device takes a while: the file is fetched and decoded
   * meanwhile.
   */
  readonly limits: DeviceLimits | Promise<DeviceLimits>;
  /**
   * Maximum bytes of samples, set after the GPU ran out of memory. `limits` has it too; here it makes this request
   * differ from earlier ones.
   */
  readonly maxBytes?: number;
}

export interface LoadProgress {
  /** Bytes. */
  readonly loaded: number;
  /** Bytes; 0 if unknown. */
  readonly total: number;
  readonly phase: 'fetch' | 'decode';
  /** No bytes came for a while, so other loads may start. Pages don't receive this. */
  readonly isStill?: boolean;
}

export type LoadProgressListener = (progress: LoadProgress) => void;

/**
 * Receives the scans that a manifest or a file of several volumes holds, before one of them is loaded.
 * @param data - where they lie; undefined for a manifest
 */
export type ScansListener = (times: ScanTimes, data?: readonly ScanData[]) => void;

/**
 * A small volume that stands in for a large one until that is ready. For a radar it has everything except the
 * macrocells, which are empty: it is not shown, but it allows the renderer to prepare its programs.
 */
export interface CoarseVolume {
  readonly volume: Volume;
  /** The large volume, without its large arrays. */
  readonly of: Omit<Volume, 'samples' | 'macrocells'>;
}

/** @param coarse - null as soon as the load knows that the volume is a radar's, before any of its data are known */
export type CoarseListener = (coarse: CoarseVolume | null) => void;
