import type { CartesianGrid } from '../../volume/grid.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';

/** A part of a file: bytes from `start` up to `end`, or the `last` ones. */
export type FilePart = { readonly start: number; readonly end: number } | { readonly last: number };

export interface TreeReading {
  /** The whole file if undefined. */
  readonly part?: FilePart;
  /** More are refused before memory is allocated. */
  readonly maxBytes?: number;
  readonly signal?: AbortSignal;
}

/** A folder of many files, any part of which can be read, wherever it is. */
export interface FileTree {
  /** Which channel its address asks for, as a number from 1: what is after `channel=`; null where it asks for none. */
  readonly channel?: string | null;
  /** Which channels it asks for as colours: numbers from 1 with commas. */
  readonly channels?: string | null;
  /**
   * Reads a file, or a part of it, which may have fewer bytes than were asked for.
   * @param path - below the folder, without a slash at its start
   * @returns null where there is no such file
   * @throws {VolumeViewError} `source/…`, `format/too-large`; the signal's reason
   */
  read(path: string, options?: TreeReading): Promise<Uint8Array<ArrayBuffer> | null>;
  /** Shows a small volume while the rest is read. @param grid - of the whole volume */
  showPart(part: DecodedCartesianVolume, grid: CartesianGrid): Promise<void>;
}
