import { VolumeViewError } from '../core/errors.ts';
import type { Download } from './download.ts';
import { readRetryAfter } from './retry-after.ts';

/** Explains to the author of a page why a file could not be fetched. */
export function explainFetch({ url, response, loaded, options }: Download, cause: unknown): VolumeViewError {
  const file = shorten(url);
  if (!response) return explainNoAnswer(url, options.pageOrigin, cause);
  if (response.ok) {
    return new VolumeViewError(
      'source/unavailable',
      `${file} broke off after ${loaded} bytes, several times; check the network and load it again`,
      { cause },
    );
  }
  const { status } = response;
  const got = `${file} got HTTP status ${`${status} ${response.statusText}`.trimEnd()}`;
  if (status >= 500 || status === 429 || status === 408) {
    const wait = Math.ceil(readRetryAfter(response) / 1000);
    const asked = wait ? ` The server asks to be left alone for ${wait} seconds.` : '';
    return new VolumeViewError(
      'source/unavailable',
      `${got}: the server can not send it now; expected the file.${asked} Load it again later, or look into the server's log`,
      { cause },
    );
  }
  const what =
    status === 401 || status === 403
      ? 'the server gives it only to those who may have it; expected the file. Sign in at that server first, or put the file where all may read it'
      : 'expected the file; check the URL for typing errors and that the server has it';
  return new VolumeViewError('source/not-found', `${got}; ${what}`, { cause });
}

/** `fetch` says only "failed", by design, so that pages can't explore networks; the origins suggest the likely reason. */
function explainNoAnswer(url: string, pageOrigin: string, cause: unknown): VolumeViewError {
  const file = shorten(url);
  const target = new URL(url);
  if (target.protocol === 'file:') {
    return new VolumeViewError(
      'source/cross-origin',
      `${file} can not be read: browsers let a page opened from disk read no files; serve the page over http, or let from-disk.html of this package write the file into a page`,
      { cause },
    );
  }
  if (/^https?:$/.test(target.protocol) && target.origin !== pageOrigin) {
    return new VolumeViewError(
      'source/cross-origin',
      `${file} can not be read from ${pageOrigin === 'null' ? adviceWithoutOrigin : adviceTo(pageOrigin)}`,
      { cause },
    );
  }
  return new VolumeViewError(
    'source/not-found',
    `${file} can not be fetched; check the URL, the network and the page's Content-Security-Policy (connect-src)`,
    { cause },
  );
}

/**
 * What the author of a sandboxed page, or of a page opened from disk, can do. Only this header lets such a page read
 * anything.
 */
const adviceWithoutOrigin =
  'this page, which has no origin: its frame is sandboxed, or it is not served. Expected the server to answer with the header "Access-Control-Allow-Origin: *" (CORS); ' +
  'set it there, give the data as a data: URL, or, if you trust the page in the frame, write allow-same-origin into its sandbox';

const adviceTo = (pageOrigin: string): string =>
  `${pageOrigin}; expected the server to answer with the header Access-Control-Allow-Origin (CORS); set it there, copy the file to the page's own server, or check that the address is right`;

/** A data: URL may be megabytes long. */
function shorten(url: string): string {
  return url.length > 300 ? `${url.slice(0, 100)}…` : url;
}
