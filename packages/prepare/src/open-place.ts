import { urlInStore } from '../../../src/sources/byte-store.ts';
import type { ByteStore, ReadOptions } from '../../../src/sources/byte-store.ts';
import { isLitter } from '../../../src/sources/find-volume.ts';
import { PrivateStore } from '../../../src/sources/private-store.ts';
import { ZipStore } from '../../../src/sources/zip-store.ts';
import { folderBase, FolderStore } from './folder-store.ts';
import type { Place } from './job.ts';

/** URLs of files in an archive begin with this. */
export const archiveBase = 'https://archive.invalid/';

/** The files of a place, under their own names. @throws {VolumeViewError} of an archive that can't be read */
export async function openPlace({ folder, only, archive }: Place): Promise<ByteStore> {
  if (archive === undefined) return new FolderStore(folder, { only });
  const store = new FolderStore(folder, { only: [archive] });
  return ZipStore.open(store, urlInStore(folderBase, archive), archiveBase, 'of the folder');
}

/** A store that remembers which files were read as a whole or in part. */
export class WatchedStore implements ByteStore {
  readonly wasRead = new Set<string>();

  constructor(readonly inner: ByteStore) {}

  list(): Promise<readonly string[] | null> {
    return this.inner.list();
  }

  stat(url: string) {
    return this.inner.stat(url);
  }

  async read(url: string, options?: ReadOptions) {
    const input = await this.inner.read(url, options);
    this.wasRead.add(url);
    return input;
  }
}

/** The files of a place under names that say nothing, because messages and volumes may have names of files. */
export async function hideNames(store: ByteStore, { archive }: Place): Promise<PrivateStore> {
  return PrivateStore.of(store, archive === undefined ? folderBase : archiveBase, isLitter);
}
