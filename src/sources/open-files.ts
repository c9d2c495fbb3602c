// Opens what holds files: a ZIP archive, or the files that a person chose. Loaded when it is needed.
import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import type { LocalFiles } from '../formats/base/load-request.ts';
import { nameOf } from '../formats/base/name-of.ts';
import type { FetchOptions } from './download.ts';
import { isZarr } from './is-zarr.ts';
import { isZip } from './is-zip.ts';
import { MemoryStore } from './memory-store.ts';
import { openLocal } from './open-local.ts';
import { openStore } from './open-store.ts';
import type { OpenOptions } from './open-store.ts';
import type { OpenedFiles } from './opened-files.ts';
import { ZipStore } from './zip-store.ts';

/** The URLs of files in an archive begin with this: no server can have this name (RFC 2606). */
const archiveBase = 'https://archive.invalid/';

/**
 * Finds the volumes in an archive or in chosen files, and opens one of them.
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
  if ('bytes' in given) {
    const name = nameOf(given.url);
    const store = await ZipStore.open(new MemoryStore(given), given.url, archiveBase, name);
    return openStore(
      { store, base: archiveBase, kind: 'archive', what: () => `the ZIP archive ${name}`, isPrivate: false },
      options,
    );
  }
  const chosen = await openLocal(given, options.signal);
  const [only, ...others] = await chosen.list();
  if (!only)
    throw new VolumeViewError(
      'attribute/invalid',
      'files got no files; expected a FileList, or an array of File objects.',
    );
  // Names of files, and those in archives, may be those of patients.
  const isPrivate = true;
  if (others.length === 0 && isZip((await chosen.read(only, { range: { start: 0, end: 4 } })).bytes)) {
    const store = await ZipStore.open(chosen, only, archiveBase, 'that was chosen');
    return openStore(
      { store, base: archiveBase, kind: 'archive', what: () => 'the ZIP archive that was chosen', isPrivate },
      options,
    );
  }
  const what = (count: number): string => (count > 1 ? `the choice of ${count} files` : 'the chosen file');
  return openStore({ store: chosen, base: given.base, kind: 'files', what, isPrivate }, options);
}
