import type { DecodedVolume, DecodeInput } from '../formats/base/decoded-volume.ts';
import type { FileTree } from '../formats/zarr/file-tree.ts';
import type { ReadOptions } from './byte-store.ts';
import type { FoundVolume } from './find-volume.ts';
import type { FolderReader } from './folder-reader.ts';

/** The volume in an archive, in chosen files, on a DICOMweb server or in a Zarr. */
export interface OpenedFiles extends FoundVolume {
  /** Their kind and number, without a name. */
  readonly source?: DecodedVolume['source'];
  /** Reads the files of series in parts. */
  readonly folder?: FolderReader;
  /** Set for a Zarr, whose reader reads its many files by itself: the first one is empty, and has more that is missing. */
  readonly tree?: FileTree;
  /** Reads any file that belongs to it, of a folder its start; it needs no `this`. @throws {VolumeViewError} as ByteStore says, and `source/not-found` for files of other places */
  read(url: string, options: ReadOptions): Promise<DecodeInput>;
}
