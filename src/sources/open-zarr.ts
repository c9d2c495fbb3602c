// Opens a Zarr on a server: a folder, or an archive of which parts are read. Loaded when it is needed.
import type { FetchOptions } from './download.ts';
import type { ByteStore } from './byte-store.ts';
import { HttpTree } from './http-tree.ts';
import { VolumeViewError } from '../core/errors.ts';
import { nameOf } from '../formats/base/name-of.ts';
import type { OpenedFiles } from './opened-files.ts';
import type { FolderLoad } from './show-part.ts';
import { findTrees, openedTree, openTree } from './store-tree.ts';
import { ZipStore } from './zip-store.ts';

/** The URLs of files in the archive begin with this: no server can have this name (RFC 2606). */
const archiveBase = 'https://archive.invalid/';

/**
 * @param address - absolute; what follows a question mark is added to all addresses
 * @throws {VolumeViewError} `source/…`, `format/…`
 */
export async function openZarr(
  address: string,
  reading: Omit<FetchOptions, 'onProgress'>,
  load: FolderLoad | undefined,
): Promise<OpenedFiles> {
  const { origin, pathname, search, protocol, hash } = new URL(address);
  const asked = new URLSearchParams(hash.slice(1));
  const choice = { channel: asked.get('channel'), channels: asked.get('channels') };
  const options: FetchOptions = { ...reading, onProgress: (...counts) => load?.onProgress(...counts) };
  const isFile = !/\.zarr(\/|$)/i.test(pathname);
  if (!protocol.startsWith('http'))
    throw new VolumeViewError(
      'source/not-found',
      'a Zarr is many files; expected its address on a server, or its folder as files',
    );
  const tree = new HttpTree(origin + (isFile ? pathname : pathname.replace(/\/*$/, '/')), search, options);
  if (!isFile) return openedTree(tree, load, choice);
  const archive: ByteStore = {
    list: async () => null,
    // A server that hides how long a file is may send it.
    stat: async () => ({ size: (await tree.size('')) ?? (await tree.wholeSize('')) }),
    async read(url, { range, signal } = {}) {
      const bytes = await tree.read('', { part: range, signal });
      if (bytes) return { bytes, url, contentType: '' };
      throw new VolumeViewError('source/not-found', `${nameOf(address)} is not there any more; load it again`);
    },
  };
  const zip = await ZipStore.open(archive, address, archiveBase, nameOf(address));
  const [folder] = findTrees(await zip.list(), archiveBase);
  if (folder !== undefined) return openTree(zip, { folder, base: archiveBase }, load, { kind: 'archive', ...choice });
  throw new VolumeViewError(
    'format/unknown',
    `the ZIP archive ${nameOf(address)} holds no Zarr; expected the files of one, with zarr.json or .zattrs`,
  );
}
