import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { explainFetch } from './explain-fetch.ts';
import type { Download } from './download.ts';
import { readRetryAfter } from './retry-after.ts';

// Loaded when a file did not come at once.

/** Times that it is tried again. */
const rounds = 3;

/** Milliseconds before the first of them; each following one waits twice as long. */
const firstWaitMs = 500;

/** A server that asks for more patience than this is not waited for: the reader decides. */
const longestWaitMs = 20_000;

/** HTTP statuses that pass: too many requests, and servers that are not up, or not reached by those before them. */
const passing = [429, 502, 503, 504];

/**
 * Fetch the rest of a file, or all of it anew, where its failure may pass.
 * @param failure - what was thrown
 * @throws {VolumeViewError} `source/…`, `format/too-large`
 */
export async function fetchAgain(download: Download, failure: unknown): Promise<DecodeInput> {
  const { signal } = download.options;
  let cause = failure;
  for (let round = 0; round < rounds; round++) {
    const wait = chooseWait(download, round);
    if (wait === null) break;
    download.tell(); // A sign of life: the page waits only so long without one.
    await pause(wait, signal);
    download.tell();
    try {
      return await goOn(download);
    } catch (next) {
      signal?.throwIfAborted();
      if (next instanceof VolumeViewError) throw next;
      cause = next;
    }
  }
  throw explainFetch(download, cause);
}

/** Milliseconds to wait; null where it is in vain. */
function chooseWait({ url, response, options }: Download, round: number): number | null {
  if (!navigator.onLine) return null;
  // At random, so that those who failed together do not come back together.
  const wait = firstWaitMs * 2 ** round * (0.75 + Math.random() / 2);
  if (!response) return new URL(url).origin === options.pageOrigin && url.startsWith('http') ? wait : null; // Else CORS, most likely.
  if (response.ok) return wait;
  if (!passing.includes(response.status)) return null;
  const asked = readRetryAfter(response);
  return asked > longestWaitMs ? null : Math.max(wait, asked);
}

/** The part that is missing where the server can be trusted to send just that, else all. */
async function goOn(download: Download): Promise<DecodeInput> {
  const { loaded } = download;
  const tag = readTag(download);
  if (!loaded || !tag) return download.read(await download.open());
  const response = await download.open({ range: `bytes=${loaded}-`, 'if-range': tag });
  const isRest = response.status === 206 && response.headers.get('content-range')?.startsWith(`bytes ${loaded}-`);
  if (isRest || response.status === 200) return download.read(response, isRest);
  await response.body?.cancel();
  return download.read(await download.open());
}

/**
 * What names the very bytes of which some came; null where the server gave no such name, may not send parts, or packs what it
 * sends. Another origin would first have to allow the header If-Range, which few do.
 */
function readTag({ origin, url, options }: Download): string | null {
  const tag = origin?.headers.get('etag');
  if (!origin || !tag?.startsWith('"') || origin.headers.has('content-encoding')) return null;
  if (origin.headers.get('accept-ranges') !== 'bytes') return null;
  return new URL(origin.url || url).origin === options.pageOrigin ? tag : null;
}

/** @throws the signal's reason */
function pause(ms: number, signal?: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const stop = (): void => {
      clearTimeout(timer);
      reject(signal!.reason as Error);
    };
    const timer = setTimeout(() => {
      signal?.removeEventListener('abort', stop);
      resolve();
    }, ms);
    signal?.addEventListener('abort', stop, { once: true });
  });
}
