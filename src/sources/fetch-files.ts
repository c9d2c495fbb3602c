import type { DecodeInput, ProgressListener } from '../formats/base/decoded-volume.ts';
import { readAhead } from '../formats/base/read-ahead.ts';

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
