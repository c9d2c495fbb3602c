import { VolumeViewError } from '../errors.ts';
import type { DecodeInput, ProgressListener } from './decoded-volume.ts';

/** Maximum number of bytes of a file: what engines allow for one buffer. */
const maxFileBytes = 2 ** 31 - 1;

export interface FetchOptions {
  readonly signal?: AbortSignal;
  /** Origin of the page: a worker made from a blob has one of its own. */
  readonly pageOrigin: string;
  /** `total` is 0 where it is not known. */
  readonly onProgress: ProgressListener;
}

/**
 * Fetch a file whole.
 * @param url - absolute; http(s), data: or blob:
 * @throws {VolumeViewError} `source/not-found`, `source/cross-origin`, `format/too-large`
 */
export async function fetchBytes(url: string, options: FetchOptions): Promise<DecodeInput> {
  const response = await openResponse(url, options);
  if (!response.ok) {
    await response.body?.cancel();
    throw new VolumeViewError(
      'source/not-found',
      `${shorten(url)} got HTTP status ${response.status} ${response.statusText}`.trimEnd() +
        '; expected the file; check the URL for typing errors and that the server has it',
    );
  }
  const bytes = await readBody(response, url, options);
  // A response to a blob: URL has lost its fragment, by which messages call the file.
  const from = url.startsWith('blob:') ? url : response.url || url;
  return { bytes, url: from, contentType: response.headers.get('content-type') ?? '' };
}

async function openResponse(url: string, options: FetchOptions): Promise<Response> {
  try {
    return await fetch(url, { signal: options.signal });
  } catch (cause) {
    if (options.signal?.aborted) throw options.signal.reason;
    throw explainFailure(url, options.pageOrigin, cause);
  }
}

/** `fetch` says only "failed", by design, so that pages can not explore networks; the origins tell the likely reason. */
function explainFailure(url: string, pageOrigin: string, cause: unknown): VolumeViewError {
  const target = new URL(url);
  if (target.protocol === 'file:') {
    return new VolumeViewError(
      'source/cross-origin',
      `${shorten(url)} can not be read: browsers let a page opened from disk read no files; serve the page over http, or give the data as a data: URL`,
      { cause },
    );
  }
  if (/^https?:$/.test(target.protocol) && target.origin !== pageOrigin) {
    return new VolumeViewError(
      'source/cross-origin',
      `${shorten(url)} can not be read from ${pageOrigin}; expected the server to answer with the header ` +
        "Access-Control-Allow-Origin (CORS); set it there, copy the file to the page's own server, or check that the address is right",
      { cause },
    );
  }
  return new VolumeViewError(
    'source/not-found',
    `${shorten(url)} can not be fetched; check the URL, the network and the page's Content-Security-Policy (connect-src)`,
    { cause },
  );
}

async function readBody(response: Response, url: string, options: FetchOptions): Promise<Uint8Array<ArrayBuffer>> {
  const announced = announcedLength(response);
  if (announced > maxFileBytes) {
    await response.body?.cancel();
    throw tooLarge(url, announced);
  }
  // For an announced length, one buffer is allocated at once; joining pieces later takes twice the memory.
  const room = new Uint8Array(announced);
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let loaded = 0;
  options.onProgress(0, announced);
  const reader = response.body?.getReader();
  try {
    for (;;) {
      const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
      if (done || !value) break;
      if (pieces.length === 0 && loaded + value.length <= room.length) room.set(value, loaded);
      else pieces.push(value);
      loaded += value.length;
      if (loaded > maxFileBytes) throw tooLarge(url, loaded);
      // A length that was passed was of something else, such as the packed form: no total is better than a wrong one.
      options.onProgress(loaded, loaded > announced ? 0 : announced);
    }
  } catch (cause) {
    if (options.signal?.aborted) throw options.signal.reason;
    if (cause instanceof VolumeViewError) throw cause;
    throw new VolumeViewError('source/not-found', `${shorten(url)} broke off after ${loaded} bytes; check the network and load it again`, { cause });
  } finally {
    reader?.cancel().catch(() => undefined);
  }
  if (pieces.length === 0) return loaded === room.length ? room : room.slice(0, loaded);
  const inPieces = pieces.reduce((sum, piece) => sum + piece.length, 0);
  return joinPieces([room.subarray(0, loaded - inPieces), ...pieces], loaded);
}

/** Content-Length, where it is the length of what arrives: with a content encoding it is that of the packed form. */
function announcedLength(response: Response): number {
  if (response.headers.has('content-encoding')) return 0;
  const length = Number(response.headers.get('content-length'));
  return Number.isSafeInteger(length) && length > 0 ? length : 0;
}

function joinPieces(pieces: readonly Uint8Array<ArrayBuffer>[], length: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    bytes.set(piece, at);
    at += piece.length;
  }
  return bytes;
}

function tooLarge(url: string, bytes: number): VolumeViewError {
  return new VolumeViewError('format/too-large', `${shorten(url)} has ${bytes.toLocaleString('en')} bytes or more; expected at most ${maxFileBytes.toLocaleString('en')}`);
}

/** A data: URL may be megabytes long. */
function shorten(url: string): string {
  return url.length > 300 ? `${url.slice(0, 100)}…` : url;
}
