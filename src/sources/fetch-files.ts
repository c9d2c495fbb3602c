import type { DecodeInput, ProgressListener } from '../formats/base/decoded-volume.ts';

/** Files that are fetched at once: so many that the way to the server costs little, so few that little memory is taken. */
const ahead = 6;

/** Fetches one file. */
export type FetchOne = (url: string, onProgress: ProgressListener) => Promise<DecodeInput>;

/**
 * Fetch files, and hand them on in their order.
 * @param urls - absolute
 * @param onProgress - of several files it is told the bytes of all that have come, and no total, which nobody knows
 */
export async function* fetchInOrder(urls: readonly string[], fetchOne: FetchOne, onProgress: ProgressListener): AsyncGenerator<DecodeInput> {
  const loaded = new Float64Array(urls.length);
  let sum = 0;
  const listen = (place: number): ProgressListener => (bytes, total) => {
    sum += bytes - loaded[place];
    loaded[place] = bytes;
    if (urls.length > 1) onProgress(sum, 0);
    else onProgress(bytes, total);
  };
  const coming: Promise<DecodeInput>[] = [];
  for (let next = 0, given = 0; given < urls.length; given++) {
    for (; next < urls.length && next < given + ahead; next++) {
      const file = fetchOne(urls[next], listen(next));
      file.catch(() => undefined); // It is told when its turn comes.
      coming.push(file);
    }
    yield await coming.shift()!;
  }
}
