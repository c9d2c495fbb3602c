import type { DecodeInput } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { yieldOnce } from '../base/piece-reader.ts';

/**
 * Yields the bytes of the files that hold samples, one after another.
 * @param urls - absolute; null if the samples are in the header's own file
 * @param count - number of files that are needed: the first ones
 */
export function listDataFiles(
  urls: readonly string[] | null,
  header: DecodeInput,
  context: ReadContext,
  count: number,
): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  return urls ? fetchBytesOf(urls.slice(0, count), context) : yieldOnce(header.bytes);
}

async function* fetchBytesOf(urls: readonly string[], context: ReadContext): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  for await (const { bytes } of context.fetchFiles(urls)) yield bytes;
}
