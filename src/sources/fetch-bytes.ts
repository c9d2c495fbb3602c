import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { loadIfReachable } from '../formats/base/load-reader.ts';
import { Download } from './download.ts';
import type { FetchOptions } from './download.ts';

/**
 * Fetches a whole file. If the failure may pass, it tries again, and continues where the first attempt broke off.
 * @param url - absolute; http(s), data: or blob:
 * @throws {VolumeViewError} `source/not-found`, `source/unavailable`, `source/cross-origin`, `format/too-large`
 * @throws {NeedsMainThread} in a worker that lacks the second attempt
 */
export async function fetchBytes(url: string, options: FetchOptions): Promise<DecodeInput> {
  const download = new Download(url, options);
  try {
    return await download.read(await download.open());
  } catch (cause) {
    options.signal?.throwIfAborted();
    if (cause instanceof VolumeViewError) throw cause;
    const rare = await loadIfReachable(() => import('#rare/sources/fetch-again.ts'));
    if (rare) return rare.fetchAgain(download, cause);
    throw new VolumeViewError('source/not-found', `${url.slice(0, 300)} can not be fetched; check the network`, {
      cause,
    });
  }
}
