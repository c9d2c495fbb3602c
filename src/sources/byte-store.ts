import type { DecodeInput, ProgressListener } from '../formats/base/decoded-volume.ts';

/** Bytes of a file from `start` up to `end`, which is not included. */
export interface ByteRange {
  readonly start: number;
  readonly end: number;
}

/** What is known of a file without reading it. */
export interface FileStat {
  /** Bytes; null where it is only known after reading the file. */
  readonly size: number | null;
}

export interface ReadOptions {
  /** The whole file if undefined. A range that reaches beyond the end of the file gives fewer bytes. */
  readonly range?: ByteRange;
  /** Maximum bytes to read; more are refused before memory is allocated. */
  readonly maxBytes?: number;
  readonly signal?: AbortSignal;
  readonly onProgress?: ProgressListener;
  /** Whether the start of a file is enough. Stores that read any part of a file quickly stop there. */
  readonly isEnough?: ((start: Uint8Array) => boolean) | null;
}

/**
 * Files, wherever they are: on servers, in an archive, on the reader's disk. A file is named by its absolute URL, so that
 * a file can name another one relative to itself. Files that are on no server have URLs of a host that does not exist.
 */
export interface ByteStore {
  /** URLs of all files, in their order; null where they can't be listed, as those of a server. */
  list(): Promise<readonly string[] | null>;
  /** @throws {VolumeViewError} `source/…` */
  stat(url: string): Promise<FileStat>;
  /** @throws {VolumeViewError} `source/…`, `format/…`; the signal's reason */
  read(url: string, options?: ReadOptions): Promise<DecodeInput>;
  /**
   * Where a file can be read again without this store: the file itself, one of an archive as a gzip file, or its URL; null
   * where it can not.
   */
  sourceOf?(url: string): Blob | string | null;
  /**
   * Reads the same part of several files at once, where that takes less time than one after another.
   * @returns in their order; null where one of them can't be read so: `read` says why
   * @throws the signal's reason
   */
  readTogether?(
    urls: readonly string[],
    options: Pick<ReadOptions, 'range' | 'signal'>,
  ): Promise<readonly DecodeInput[] | null>;
}

/** The URL of a file in a store. @param base - ends with a slash @param path - its parts are separated by slashes */
export function urlInStore(base: string, path: string): string {
  const parts = path.replaceAll('\\', '/').split('/').filter(Boolean);
  return new URL(parts.map(encodeURIComponent).join('/'), base).href;
}

/** The path of a file in its store, for messages. */
export function pathOf(url: string): string {
  return decodeURIComponent(new URL(url).pathname.slice(1)).slice(0, 200);
}
