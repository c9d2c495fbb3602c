// Opens what holds files: a ZIP archive, or the files that a person chose. Loaded when it is needed.
import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { keptBytes } from '../formats/base/format.ts';
import type { LocalFiles } from '../formats/base/load-request.ts';
import { nameOf } from '../formats/base/name-of.ts';
import type { ByteStore, ReadOptions } from './byte-store.ts';
import type { FetchOptions } from './download.ts';
import { findVolume, isLitter } from './find-volume.ts';
import type { FindOptions, FoundVolume } from './find-volume.ts';
import { FolderReader } from './folder-reader.ts';
import { HttpStore } from './http-store.ts';
import { MemoryStore } from './memory-store.ts';
import { openLocal } from './open-local.ts';
import type { OpenedFiles } from './opened-files.ts';
import { PrivateStore, reasonOf } from './private-store.ts';
import { isZarr } from './is-zarr.ts';
import { isZip } from './is-zip.ts';
import type { FolderLoad } from './show-part.ts';
import { openTree } from './store-tree.ts';
import { ZipStore } from './zip-store.ts';

type OpenOptions = Pick<FindOptions, 'isStack' | 'signal'> & {
  /** Reads files of series in parts for this load; they are read as a whole if undefined. */
  readonly load?: FolderLoad;
};

/** The URLs of files in an archive begin with this: no server can have this name (RFC 2606). */
const archiveBase = 'https://archive.invalid/';

/**
 * Finds the one volume in an archive or in chosen files.
 * @param given - the archive, the files, or the address of a series on a DICOMweb server or of a Zarr
 * @throws {VolumeViewError} `format/…`, `source/…`, `attribute/invalid`
 */
export async function openFiles(
  given: DecodeInput | LocalFiles | string,
  options: OpenOptions,
  reading: Omit<FetchOptions, 'onProgress'> = { pageOrigin: '' },
): Promise<OpenedFiles> {
  if (typeof given === 'string') {
    if (isZarr(given)) return (await import('./open-zarr.ts')).openZarr(given, reading, options.load);
    return (await import('./open-dicomweb.ts')).openDicomWeb(given, reading, options.load);
  }
  if ('bytes' in given) return openZip(new MemoryStore(given), given.url, nameOf(given.url), options);
  const chosen = await openLocal(given, options.signal);
  const tree = await openTree(chosen, given.base, options.load, { kind: 'files' });
  if (tree) return tree;
  const store = await PrivateStore.of(chosen, given.base, isLitter);
  const [only, ...others] = await store.list();
  if (!only)
    throw new VolumeViewError(
      'attribute/invalid',
      'files got no files; expected a FileList, or an array of File objects.',
    );
  const { bytes } = await store.read(only, { range: { start: 0, end: 4 } });
  if (others.length > 0 || !isZip(bytes))
    return openStore(
      store,
      others.length > 0 ? `the choice of ${others.length + 1} files` : 'the chosen file',
      given.base,
      options,
    );
  // Its name, and those in it, may be those of patients.
  const zip = await ZipStore.open(store, only, archiveBase, 'that was chosen');
  const zipped = await openTree(zip, archiveBase, options.load, { kind: 'archive' });
  if (zipped) return zipped;
  return openStore(
    await PrivateStore.of(zip, archiveBase, isLitter),
    'the ZIP archive that was chosen',
    archiveBase,
    options,
  );
}

async function openZip(store: ByteStore, url: string, name: string, options: OpenOptions): Promise<OpenedFiles> {
  const zip = await ZipStore.open(store, url, archiveBase, name);
  const tree = await openTree(zip, archiveBase, options.load, { kind: 'archive' });
  if (tree) return tree;
  return openStore(zip, `the ZIP archive ${name}`, archiveBase, options);
}

async function openStore(store: ByteStore, what: string, base: string, options: OpenOptions): Promise<OpenedFiles> {
  // Looking at many files takes a while: whoever waits is to know that it goes on.
  const found = await findVolume(store, what, { ...options, onLook: () => options.load?.onProgress(0, 0) });
  const { files, isPrivate, starts } = found;
  const readOne: ByteStore['read'] = (url, reading) => readPrivate(store, url, found, reading);
  const { load, signal } = options;
  const folder =
    load && files && isPrivate ? await FolderReader.of(store, files, readOne, { load, starts, signal }) : null;
  return {
    ...found,
    ...(folder && { folder }),
    source: { kind: base === archiveBase ? 'archive' : 'files', count: (await store.list())?.length ?? 0 },
    async read(url, reading) {
      if (url.startsWith(base))
        // The start of the first file says its format. Its reader reads all of them by itself.
        return folder
          ? { ...(await folder.readStart(url, keptBytes)), missing: 0 }
          : (isPrivate ? readOne : store.read.bind(store))(url, reading);
      if (url.startsWith('data:')) return new HttpStore({ pageOrigin: '' }).read(url, reading);
      // A file from anywhere must not make the page request what its author has not named.
      throw new VolumeViewError(
        'source/not-found',
        `${what} names ${url.slice(0, 300)}, which it does not hold; expected all files of the volume in it`,
      );
    },
  };
}

/** Reads a file whose name is not to be seen: errors have its number instead. */
async function readPrivate(
  store: ByteStore,
  url: string,
  { files = [] }: FoundVolume,
  options: ReadOptions = {},
): Promise<DecodeInput> {
  try {
    return await store.read(url, options);
  } catch (cause) {
    options.signal?.throwIfAborted();
    if (!(cause instanceof VolumeViewError)) throw cause;
    throw new VolumeViewError(
      cause.code,
      `file ${files.indexOf(url) + 1} of ${files.length} (in the order of their names) can not be read: ${reasonOf(cause)}`,
    );
  }
}
