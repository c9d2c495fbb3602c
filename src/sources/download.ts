import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput, ProgressListener } from '../formats/base/decoded-volume.ts';

/** Maximum number of bytes of a file: what browsers allow for one buffer. */
export const maxFileBytes = 2 ** 31 - 1;

/** Maximum bytes that are allocated because a server announces them. */
const bytesOnTrust = 2 ** 24;

/** A buffer grows by this factor, when 1 / growth of the announced length has been received. */
const growth = 8;

export interface FetchOptions {
  readonly signal?: AbortSignal;
  /** Origin of the page. A worker made from a blob has a different origin of its own. */
  readonly pageOrigin: string;
  /** `credentials` of `fetch`. If undefined, the default of `fetch`: cookies and logins only for the page's own server. */
  readonly credentials?: RequestCredentials;
  /** Instead of the browser's own `fetch`. */
  readonly fetch?: typeof globalThis.fetch | null;
  /** Maximum bytes of a file. */
  readonly maxBytes?: number;
  /** Whether the start of a file is enough, of which its server can send parts. It may get zeros in place of bytes that have not arrived. */
  readonly isEnough?: ((start: Uint8Array) => boolean) | null;
  /** `total` is 0 if it is unknown. */
  readonly onProgress: ProgressListener;
}

/** A file that is being downloaded, and the bytes received so far. */
export class Download {
  /** The last response; null if there is none. */
  response: Response | null = null;
  /** The response with which the received bytes began. */
  origin: Response | null = null;
  /** Bytes received. */
  loaded = 0;
  #announced = 0;
  /** The received bytes, as far as they fit. */
  #room = new Uint8Array();
  /** Received bytes beyond the announced length. */
  #pieces: Uint8Array<ArrayBuffer>[] = [];

  constructor(
    readonly url: string,
    readonly options: FetchOptions,
  ) {}

  async open(headers?: Readonly<Record<string, string>>): Promise<Response> {
    const { signal, credentials, fetch: ask } = this.options;
    this.response = null;
    return (this.response = await (ask ?? fetch)(this.url, { signal, credentials, headers }));
  }

  /** @param isRest - whether the response continues the bytes that were received before */
  async read(response: Response, isRest = false): Promise<DecodeInput> {
    const reader = response.body?.getReader();
    const { headers } = response;
    try {
      if (!response.ok) throw new Error(`status ${response.status}`);
      if (!isRest) this.#begin(response);
      this.report();
      for (;;) {
        const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
        if (done || !value) break;
        this.#add(value);
        this.report();
        if (this.options.isEnough?.(this.#room) && headers.has('accept-ranges')) break;
      }
    } finally {
      reader?.cancel().catch(() => undefined);
    }
    // A response to a blob: URL has lost its fragment, which messages use as the file's name.
    const url = this.url.startsWith('blob:') ? this.url : response.url || this.url;
    return {
      bytes: this.#join(),
      url,
      contentType: headers.get('content-type') ?? '',
      missing: this.#announced - this.loaded,
    };
  }

  /** Reports the progress. */
  report(): void {
    // If more bytes came than announced, the announced length was for something else, such as the packed form: no total
    // is better than a wrong one.
    this.options.onProgress(this.loaded, this.loaded > this.#announced ? 0 : this.#announced);
  }

  #begin(response: Response): void {
    const announced = announcedLength(response);
    this.#check(announced);
    this.origin = response;
    this.#announced = announced;
    this.#pieces = [];
    this.loaded = 0;
    // An announced length that never arrives costs little. The received bytes end up in a buffer of exactly their
    // length: they were copied to it when an eighth had arrived, because joining pieces at the end would take twice the
    // memory.
    let length = announced;
    while (length > bytesOnTrust) length = Math.ceil(length / growth);
    this.#room = new Uint8Array(length);
  }

  #add(piece: Uint8Array<ArrayBuffer>): void {
    const end = this.loaded + piece.length;
    this.#check(end);
    if (end > this.#room.length && end <= this.#announced) {
      const room = new Uint8Array(Math.min(this.#announced, Math.max(end, this.#room.length * growth)));
      room.set(this.#room);
      this.#room = room;
    }
    if (!this.#pieces.length && end <= this.#room.length) this.#room.set(piece, this.loaded);
    else this.#pieces.push(piece);
    this.loaded = end;
  }

  #join(): Uint8Array<ArrayBuffer> {
    if (this.loaded === this.#room.length) return this.#room;
    const bytes = new Uint8Array(this.loaded);
    let at = this.loaded - this.#pieces.reduce((sum, piece) => sum + piece.length, 0);
    bytes.set(this.#room.subarray(0, at));
    for (const piece of this.#pieces) {
      bytes.set(piece, at);
      at += piece.length;
    }
    return bytes;
  }

  #check(bytes: number): void {
    const { maxBytes = maxFileBytes } = this.options;
    if (bytes <= maxBytes) return;
    const [has, max] = [bytes, maxBytes].map((count) => count.toLocaleString('en'));
    throw new VolumeViewError(
      'format/too-large',
      `${this.url.slice(0, 300)} has ${has} bytes or more; expected at most ${max}`,
    );
  }
}

/**
 * Content-Length, if it is the length of the received data: with a content encoding it is the length of the packed
 * form.
 */
function announcedLength({ headers }: Response): number {
  const length = headers.has('content-encoding') ? 0 : Number(headers.get('content-length'));
  return Number.isSafeInteger(length) && length > 0 ? length : 0;
}
