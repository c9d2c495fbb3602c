import type { FilePart, FileTree } from '../formats/zarr/file-tree.ts';
import { Download } from './download.ts';
import type { FetchOptions } from './download.ts';
import { explainFetch } from './explain-fetch.ts';
import { pause } from './pause.ts';
import { readRetryAfter } from './retry-after.ts';
import { VolumeViewError } from '../core/errors.ts';

/** How often a file is asked for again, milliseconds before the first time, which double, and the longest wait that a server may ask for. */
const [rounds, firstWaitMs, longestWaitMs] = [4, 300, 20_000];

/** HTTP statuses that may pass. */
const mayPass = (status: number): boolean => status >= 500 || status === 429 || status === 408;

/** Bytes of files of a server that sends no parts: so many are kept, since the next part is mostly of the same file. */
const keptBytes = 2 ** 28;

/** The files of a folder on a server: each is asked for alone, and again where a failure may pass. */
export class HttpTree implements Pick<FileTree, 'read'> {
  /** Whether the server has answered: then a failure is none of those that do not pass, such as a lack of CORS. */
  #hasAnswered = false;
  /** Whole files, of a server that does not send parts. */
  readonly #whole = new Map<string, Uint8Array<ArrayBuffer>>();
  #wholeBytes = 0;

  /**
   * @param base - ends with a slash, or is the address of a single file
   * @param search - what is added to all addresses, with its question mark
   */
  constructor(
    readonly base: string,
    readonly search: string,
    readonly options: FetchOptions,
  ) {}

  async read(
    ...[path, { part, maxBytes, signal } = {}]: Parameters<FileTree['read']>
  ): Promise<Uint8Array<ArrayBuffer> | null> {
    const url = this.#urlOf(path);
    const kept = part && this.#whole.get(url);
    if (kept) return cut(kept, part);
    const options: FetchOptions = {
      ...this.options,
      maxBytes: part ? undefined : maxBytes,
      signal: signal ?? this.options.signal,
      onProgress: () => this.options.onProgress(0, 0),
    };
    const range = part && (await this.#rangeOf(url, part, options));
    return this.#again(url, options, async (download) => {
      let response = await download.open(range ? { range } : undefined);
      this.#hasAnswered = true;
      const missed = part && 'last' in part ? missedEnd(response, part.last) : null;
      if (missed) {
        await response.body?.cancel();
        response = await download.open({ range: missed });
      }
      const { status } = response;
      if (status === 404 || status === 416) {
        await response.body?.cancel();
        return status === 404 ? null : new Uint8Array();
      }
      if (!part || status === 206) return (await download.read(response)).bytes;
      // The server sends no parts.
      const { bytes } = await download.read(response);
      this.#keep(url, bytes);
      return cut(bytes, part);
    });
  }

  /** Bytes of a file, as the server says it without sending it. @throws {VolumeViewError} `source/…` */
  async size(path: string): Promise<number | null> {
    const url = this.#urlOf(path);
    return this.#again(url, this.options, async (download) => {
      const { credentials, signal, fetch: ask } = this.options;
      const response = (download.response = await (ask ?? fetch)(url, { method: 'HEAD', credentials, signal }));
      this.#hasAnswered = true;
      if (!response.ok) throw new Error(`status ${response.status}`);
      const size = Number((!response.headers.has('content-encoding') && response.headers.get('content-length')) || NaN);
      return Number.isSafeInteger(size) ? size : null;
    });
  }

  /** Bytes of a file that is fetched for this, and kept. Null where it is not there. @throws {VolumeViewError} `source/…` */
  async wholeSize(path: string): Promise<number | null> {
    const bytes = await this.read(path);
    if (bytes) this.#keep(this.#urlOf(path), bytes);
    return bytes?.length ?? null;
  }

  #urlOf(path: string): string {
    return this.base + path.split('/').map(encodeURIComponent).join('/') + this.search;
  }

  /** Of another origin, a browser asks first whether it may ask for the end of a file, which few servers allow. */
  async #rangeOf(url: string, part: FilePart, { pageOrigin }: FetchOptions): Promise<string> {
    if ('end' in part) return `bytes=${part.start}-${part.end - 1}`;
    if (new URL(url).origin === pageOrigin) return `bytes=-${part.last}`;
    const path = decodeURIComponent(url.slice(this.base.length, url.length - this.search.length));
    const size = await this.size(path).catch(() => null);
    return size === null ? `bytes=-${part.last}` : `bytes=${Math.max(0, size - part.last)}-${size - 1}`;
  }

  #keep(url: string, bytes: Uint8Array<ArrayBuffer>): void {
    this.#wholeBytes += bytes.length - (this.#whole.get(url)?.length ?? 0);
    this.#whole.set(url, bytes);
    for (const [first, { length }] of this.#whole) {
      if (this.#wholeBytes <= keptBytes || first === url) break;
      this.#whole.delete(first);
      this.#wholeBytes -= length;
    }
  }

  async #again<T>(url: string, options: FetchOptions, act: (download: Download) => Promise<T>): Promise<T> {
    for (let round = 0; ; round++) {
      const download = new Download(url, options);
      try {
        return await act(download);
      } catch (cause) {
        options.signal?.throwIfAborted();
        if (cause instanceof VolumeViewError) throw cause;
        const { response } = download;
        const isOwn = new URL(url).origin === options.pageOrigin;
        const passes = response ? response.ok || mayPass(response.status) : isOwn || this.#hasAnswered;
        const asked = response ? readRetryAfter(response) : 0;
        if (!passes || round === rounds || asked > longestWaitMs || !navigator.onLine)
          throw explainFetch(download, cause);
        // Random, so that requests that failed together are not repeated together.
        const wait = Math.max(asked, firstWaitMs * 2 ** round * (0.5 + Math.random()));
        this.options.onProgress(0, 0); // A sign of life: the page ends a load that reports nothing for too long.
        await pause(wait, options.signal);
      }
    }
  }
}

/** The range of the last bytes, where a server has sent others: the one in Vite's development server takes `bytes=-20` as `bytes=0-20`. */
function missedEnd({ status, headers }: Response, last: number): string | null {
  const [, start, total] = /^bytes (\d+)-\d+\/(\d+)$/.exec(headers.get('content-range') ?? '') ?? [];
  if (status !== 206 || total === undefined) return null;
  const first = Math.max(0, Number(total) - last);
  return Number(start) === first ? null : `bytes=${first}-${Number(total) - 1}`;
}

function cut(bytes: Uint8Array<ArrayBuffer>, part: FilePart): Uint8Array<ArrayBuffer> {
  return 'end' in part ? bytes.slice(part.start, part.end) : bytes.slice(Math.max(0, bytes.length - part.last));
}
