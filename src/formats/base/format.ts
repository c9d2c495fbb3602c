import type { GrayImage } from '../../volume/mosaic.ts';
import type { Budget } from './budget.ts';
import type { ChannelUse } from './channels.ts';
import type { DecodedVolume, DecodeInput, DecodeSettings, ProgressListener } from './decoded-volume.ts';
import type { ScansListener } from './load-request.ts';

// What a format tells of itself. registry.ts lists them all.

/** A file as formats look at it, to say whether it is theirs. */
export interface FileStart {
  /** The whole file. */
  readonly bytes: Uint8Array;
  /** Of a gzip file the first bytes that it holds, none where it is damaged; null for any other file. */
  readonly unpacked: Uint8Array | null;
  /** The first 512 bytes as text, without byte order mark and white space before it. */
  readonly text: string;
}

/** How a reader gets at other files. Both throw {VolumeViewError} as fetchBytes does. */
export interface FileAccess {
  /** @param url - absolute */
  fetchFile(url: string): Promise<DecodeInput>;
  /** Several files, in their order; a few are fetched ahead. */
  fetchFiles(urls: readonly string[]): AsyncIterable<DecodeInput>;
}

export interface ReadContext extends FileAccess {
  readonly onProgress: ProgressListener;
  /** To be drawn on before anything is allocated. */
  readonly budget: Budget;
  readonly onScans?: ScansListener;
  /** To be told as soon as it is known that the file is a radar's. */
  readonly onRadar?: () => void;
  /** Absolute URLs of the other files of a stack, after this one, in their order. */
  readonly further: readonly string[];
  /** Whether a manifest named this file. */
  readonly isPart: boolean;
  /** Decode what this file names. @param files - absolute URLs of a stack, `first` included; undefined where it is none */
  decode(first: DecodeInput, files: readonly string[] | undefined, settings: DecodeSettings): Promise<DecodedVolume>;
}

/** Makes a volume of a file; throws {VolumeViewError} `format/…`. */
export type FormatReader = (input: DecodeInput, settings: DecodeSettings, context: ReadContext) => Promise<DecodedVolume>;

/** What an image's reader is told. */
export interface ImageSettings {
  /** Gray where undefined. */
  readonly channels?: ChannelUse;
  readonly budget: Budget;
}

/** Makes one channel of an image file; throws {VolumeViewError} `format/…`. */
export type ImageReader = (bytes: Uint8Array<ArrayBuffer>, settings: ImageSettings) => GrayImage | Promise<GrayImage>;

interface FormatBase {
  /** Such as 'NRRD'. */
  readonly name: string;
  /** What an author would call it, with its file name endings: 'NRRD (.nrrd, .nhdr)'. The same words are said once. */
  readonly words: string;
  /** Endings of file names, without the dot, by which alone a file is called one of these. */
  readonly endings: readonly string[];
  /** What a file with such an ending begins with; null where its reader says what is wrong with one that does not. */
  readonly beginning: string | null;
  /** Whether a file is one of these, by its bytes. Must be quick, and must not match files of another format, unless `last`. */
  matches(start: FileStart): boolean;
  /** Set where a file that matches may be of another format, which is asked first. */
  readonly last?: true;
}

/** A file that holds, or names, a volume. */
export interface VolumeFormat extends FormatBase {
  /** Whether the reader takes the other files of a stack, as `further`. */
  readonly takesFiles?: true;
  load(): Promise<FormatReader>;
}

/** An image: a mosaic, a radar's mosaic, or one slice of a stack. */
export interface ImageFormat extends FormatBase {
  loadImage(): Promise<ImageReader>;
}

export type Format = VolumeFormat | ImageFormat;
