import type { DecodeInput, ProgressListener } from '../formats/base/decoded-volume.ts';

/** Number of files that are fetched at once: enough to hide the server's latency, and few enough to take little memory. */
const ahead = 6;

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
  const coming: Promise<DecodeInput>[] = [];
  for (let next = 0, given = 0; given < urls.length; given++) {
    for (; next < urls.length && next < given + ahead; next++) {
      const file = fetchOne(urls[next], listen(next));
      file.catch(() => undefined); // The error is thrown when the file's turn comes.
      coming.push(file);
    }
    yield await coming.shift()!;
  }
}
