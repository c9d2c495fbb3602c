import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { explainFetch } from './explain-fetch.ts';
import type { Download } from './download.ts';
import { pause } from './pause.ts';
import { readRetryAfter } from './retry-after.ts';

// Loaded when the first attempt to fetch a file failed.

/** Number of retries. */
const rounds = 3;

/** Milliseconds before the first retry; the wait doubles with each one. */
const firstWaitMs = 500;

/** If a server asks for a longer wait than this, the retries end, and the reader decides. */
const longestWaitMs = 20_000;

/** HTTP statuses that may pass: too many requests, and servers that are down, or that a proxy can't reach. */
const passing = [429, 502, 503, 504];

/**
 * Fetches the rest of a file, or all of it again, if the failure may pass.
 * @param failure - what was thrown
 * @throws {VolumeViewError} `source/…`, `format/too-large`
 */
export async function fetchAgain(download: Download, failure: unknown): Promise<DecodeInput> {
  const { signal } = download.options;
  let cause = failure;
  for (let round = 0; round < rounds; round++) {
    const wait = chooseWait(download, round);
    if (wait === null) break;
    download.report(); // A sign of life: the page ends a load that reports nothing for too long.
    await pause(wait, signal);
    download.report();
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

/** Milliseconds to wait; null if a retry is useless. */
function chooseWait({ url, response, options }: Download, round: number): number | null {
  if (!navigator.onLine) return null;
  // Random, so that clients that failed together do not retry together.
  const wait = firstWaitMs * 2 ** round * (0.75 + Math.random() / 2);
  if (!response) return new URL(url).origin === options.pageOrigin && url.startsWith('http') ? wait : null; // Else the reason is probably CORS.
  if (response.ok) return wait;
  if (!passing.includes(response.status)) return null;
  const asked = readRetryAfter(response);
  return asked > longestWaitMs ? null : Math.max(wait, asked);
}

/** Fetches the missing part if the server can be trusted to send exactly that, else the whole file. */
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
 * The tag that identifies the bytes received so far. Null if the server gave none, may not send parts, or packs what it
 * sends. A server of another origin would have to allow the header If-Range first, which few do.
 */
function readTag({ origin, url, options }: Download): string | null {
  const tag = origin?.headers.get('etag');
  if (!origin || !tag?.startsWith('"') || origin.headers.has('content-encoding')) return null;
  if (origin.headers.get('accept-ranges') !== 'bytes') return null;
  return new URL(origin.url || url).origin === options.pageOrigin ? tag : null;
}
