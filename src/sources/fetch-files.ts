import type { DecodeInput, ProgressListener } from '../formats/base/decoded-volume.ts';
import type { FolderAccess, ReadContext } from '../formats/base/format.ts';
import { loadReader } from '../formats/base/load-reader.ts';
import { readAhead } from '../formats/base/read-ahead.ts';
import type { FetchOptions } from './download.ts';
import type { FolderLoad } from './show-part.ts';

/** Fetches one file. */
export type FetchOne = (url: string, onProgress: ProgressListener) => Promise<DecodeInput>;

/**
 * Fetches files, and yields them in their order.
 * @param urls - absolute
 * @param onProgress - for several files it receives the bytes of all together, and no total, which is unknown
 */
export async function* fetchInOrder(
  urls: readonly string[],
  fetchOne: FetchOne,
  onProgress: ProgressListener,
): AsyncGenerator<DecodeInput> {
  const loaded = new Float64Array(urls.length);
  let sum = 0;
  const listen =
    (place: number): ProgressListener =>
    (bytes, total) => {
      sum += bytes - loaded[place];
      loaded[place] = bytes;
      if (urls.length > 1) onProgress(sum, 0);
      else onProgress(bytes, total);
    };
  for await (const file of readAhead(urls, (url, place) => fetchOne(url, listen(place)))) {
    if (file.status === 'rejected') throw file.reason;
    yield file.value;
  }
}

/**
 * Opens a list of files to read them in parts, as those of a folder are.
 * @param list - the first file, as a whole; and the absolute URLs of all
 * @param optionsOf - how a file is fetched: with or without the reader's logins
 */
export async function openList(
  list: Parameters<NonNullable<ReadContext['openList']>>,
  optionsOf: (url: string) => Omit<FetchOptions, 'onProgress'>,
  load: FolderLoad,
): Promise<FolderAccess> {
  const { openListFolder } = await loadReader(() => import('./list-folder.ts'));
  return openListFolder(list, optionsOf, load);
}
