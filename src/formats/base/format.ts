import type { CartesianGrid } from '../../volume/grid.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import type { Budget } from './budget.ts';
import type { ChannelUse } from './channels.ts';
import type {
  DecodedCartesianVolume,
  DecodedVolume,
  DecodeInput,
  DecodeSettings,
  ProgressListener,
} from './decoded-volume.ts';
import type { ScansListener } from './load-request.ts';
import type { FileRange, WebPixels } from './scan-data.ts';

// How a format describes itself. registry.ts lists all formats.

/** The part of a file by which a format recognizes its own files. */
export interface FileStart {
  /** The whole file. */
  readonly bytes: Uint8Array;
  /** The first bytes that a gzip file holds, none if it is damaged; null for any other file. */
  readonly unpacked: Uint8Array | null;
  /** The first 512 bytes as text, without the byte order mark and white space at its start. */
  readonly text: string;
}

/** How a reader fetches other files. Both methods throw {VolumeViewError} as fetchBytes does. */
export interface FileAccess {
  /** @param url - absolute @param range - the bytes from `start` up to `end`; the whole file if undefined */
  fetchFile(url: string, range?: { readonly start: number; readonly end: number }): Promise<DecodeInput>;
  /** Fetches several files and yields them in their order; a few are fetched ahead. */
  fetchFiles(urls: readonly string[]): AsyncIterable<DecodeInput>;
}

/** Of each file of a folder so many bytes are kept from the first look at it: the start of most, up to their data. */
export const keptBytes = 2 ** 14;

/** Frames that are had without the others of their file, as from a DICOMweb server. */
export interface FrameAccess {
  /** Where they can be had again later, by a page. @param frames - from 0 */
  addressOf(url: string, frames: readonly number[]): WebPixels;
  /** Their pixels, as a file without any other element. */
  read(url: string, frames: readonly number[]): Promise<DecodeInput>;
}

/** Parts of files on servers, which a page can have again later by its `fetchFile`. */
export interface PartAccess {
  /** The size of a file of which the start was read; null where its server sends no parts of it, or hides the size. */
  sizeOf(url: string): number | null;
  read(url: string, range: FileRange): Promise<DecodeInput>;
}

/** Many files of which the starts are read first: they need not be in memory together. */
export interface FolderAccess {
  /** The first bytes of a file; the input says how many are `missing`. */
  readStart(url: string, bytes: number): Promise<DecodeInput>;
  /** A whole file. */
  readWhole(url: string): Promise<DecodeInput>;
  /** Where a file can be read again later, by a page: the file itself, one of an archive as a gzip file, or its URL; null where it can not. */
  sourceOf(url: string): Blob | string | null;
  /** Set where frames are had alone: then the start of a file has all that is before its pixels. */
  readonly frames?: FrameAccess;
  /** Set where servers send parts of files. */
  readonly parts?: PartAccess;
  /** Whole files will be read in this order, so that several can be read in one piece. @returns how many to ask for ahead */
  plan(urls: readonly string[]): number;
  /** No other files will be read, so that the progress counts only these. @param bytes - of files of which only parts are read */
  expect(urls: readonly string[], bytes?: ReadonlyMap<string, number>): void;
  /** Shows a small volume of a part of the data, while the rest is read. @param grid - of the whole volume */
  showPart(part: DecodedCartesianVolume, grid: CartesianGrid): Promise<void>;
}

export interface ReadContext extends FileAccess {
  /** Of the volumes in an archive or in chosen files, so many are numbered before those of this reader; 0 where undefined. */
  readonly before?: number;
  /** Set for files each of which is a part of a volume: those of a disk or of an archive, of which the first one's start is given, and those of a series on a server. */
  readonly folder?: FolderAccess;
  /** Reads the files of a list on servers in the same way. @param first - the first file, as a whole @param urls - all files, absolute */
  readonly openList?: (first: DecodeInput, urls: readonly string[]) => Promise<FolderAccess>;
  readonly onProgress: ProgressListener;
  /** Readers take their bytes from it before they allocate anything. */
  readonly budget: Budget;
  readonly onScans?: ScansListener;
  /** Readers call it as soon as they know that the file is a radar's. */
  readonly onRadar?: () => void;
  /** Absolute URLs of the other files of a stack, after this one, in their order. */
  readonly further: readonly string[];
  /** Whether a manifest named this file. */
  readonly isPart: boolean;
  /**
   * Decodes a file that this one names. @param files - absolute URLs of a stack, `first` included; undefined if it is
   * not a stack
   * @param openList - in place of that of the context
   */
  decode(
    first: DecodeInput,
    files: readonly string[] | undefined,
    settings: DecodeSettings,
    openList?: ReadContext['openList'],
  ): Promise<DecodedVolume>;
}

/** Makes a volume from a file; throws {VolumeViewError} `format/…`. */
export type FormatReader = (
  input: DecodeInput,
  settings: DecodeSettings,
  context: ReadContext,
) => Promise<DecodedVolume>;

/** The settings that an image's reader receives. */
export interface ImageSettings {
  /** Gray if undefined. */
  readonly channels?: ChannelUse;
  readonly budget: Budget;
}

/** Makes one channel from an image file; throws {VolumeViewError} `format/…`. */
export type ImageReader = (bytes: Uint8Array<ArrayBuffer>, settings: ImageSettings) => GrayImage | Promise<GrayImage>;

interface FormatBase {
  /** Such as 'NRRD'. */
  readonly name: string;
  /**
   * What an author would call it, with its file name endings: 'NRRD (.nrrd, .nhdr)'. A list names formats of the same
   * words only once.
   */
  readonly words: string;
  /** Endings of file names, without the dot, that are enough to call a file one of these. */
  readonly endings: readonly string[];
  /**
   * The bytes that a file with such an ending must begin with; null if the reader itself explains what is wrong with
   * other files.
   */
  readonly beginning: string | null;
  /** Recognizes a file by its bytes. It must be quick, and must not match files of another format, unless `last` is set. */
  matches(start: FileStart): boolean;
  /** Set if a file that matches may be of another format: the other formats are tried first. */
  readonly last?: true;
}

/** A file that holds, or names, a volume. */
export interface VolumeFormat extends FormatBase {
  /** Whether the reader accepts the other files of a stack, as `further`. */
  readonly takesFiles?: true;
  /** Whether each file is a part of a volume, mostly one slice: all such files of a folder belong together. */
  readonly isSlice?: true;
  /** Whether each of several files may be a slice, as images are: then the attribute stack says it. */
  readonly mayBeSlice?: true;
  load(): Promise<FormatReader>;
}

/** An image: a mosaic, a radar's mosaic, or one slice of a stack. */
export interface ImageFormat extends FormatBase {
  loadImage(): Promise<ImageReader>;
}

export type Format = VolumeFormat | ImageFormat;
