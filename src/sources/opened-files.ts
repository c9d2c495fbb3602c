import type { DecodedVolume, DecodeInput } from '../formats/base/decoded-volume.ts';
import type { ReadOptions } from './byte-store.ts';
import type { FoundVolume } from './find-volume.ts';
import type { FolderReader } from './folder-reader.ts';

/** The volume in an archive, in chosen files or on a DICOMweb server. */
export interface OpenedFiles extends FoundVolume {
  /** Their kind and number, without a name. */
  readonly source: NonNullable<DecodedVolume['source']>;
  /** Reads the files of series in parts. */
  readonly folder?: FolderReader;
  /** Reads any file that belongs to it, of a folder its start; it needs no `this`. @throws {VolumeViewError} as ByteStore says, and `source/not-found` for files of other places */
  read(url: string, options: ReadOptions): Promise<DecodeInput>;
}
