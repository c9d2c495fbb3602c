import type { DecodedVolume, DecodeInput } from '../formats/base/decoded-volume.ts';
import type { FileTree } from '../formats/zarr/file-tree.ts';
import type { ReadOptions } from './byte-store.ts';
import type { FolderReader } from './folder-reader.ts';

/** The volume in an archive, in chosen files, on a DICOMweb server or in a Zarr. */
export interface OpenedFiles {
  /** The file with which it begins, and all files of a stack. */
  readonly first: string;
  readonly files?: readonly string[];
  /** Whether names of the files may be those of patients: then messages do not have them. */
  readonly isPrivate?: true;
  /** Of the volumes of all files, so many are counted before those of the reader; 0 where undefined. */
  readonly before?: number;
  /** Reads the files of series in parts. */
  readonly folder?: FolderReader;
  /** Set for a Zarr, whose reader reads its many files by itself: the first one is empty, and has more that is missing. */
  readonly tree?: FileTree;
  /** Where a file can be read again without this, as ByteStore says; undefined where none can. */
  sourceOf?(url: string): Blob | string | null;
  /** Adds to what was read where it comes from, without a name, which other volumes there are, and what is in none of them. */
  describe<T extends DecodedVolume>(volume: T): T;
  /** Reads any file that belongs to it, of a folder its start; it needs no `this`. @throws {VolumeViewError} as ByteStore says, and `source/not-found` for files of other places */
  read(url: string, options: ReadOptions): Promise<DecodeInput>;
}
