import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput, ProgressListener } from '../formats/base/decoded-volume.ts';

/** Maximum number of bytes of a file: what engines allow for one buffer. */
export const maxFileBytes = 2 ** 31 - 1;

/** Bytes that are allocated on a server's word alone. */
const bytesOnTrust = 2 ** 24;

/** What came of an announced length by the time that more is allocated: one part of so many. */
const growth = 8;

export interface FetchOptions {
  readonly signal?: AbortSignal;
  /** Origin of the page: a worker made from a blob has one of its own. */
  readonly pageOrigin: string;
  /** Of `fetch`; where undefined, its own: cookies and logins for the page's own server alone. */
  readonly credentials?: RequestCredentials;
  /** That a file may have at most. */
  readonly maxBytes?: number;
  /** `total` is 0 where it is not known. */
  readonly onProgress: ProgressListener;
}

/** A file on its way, and what came of it. */
export class Download {
  /** The last answer; null where there is none. */
  response: Response | null = null;
  /** The answer that began what came. */
  origin: Response | null = null;
  /** Bytes that came. */
  loaded = 0;
  #announced = 0;
  /** What came, as far as it fits. */
  #room = new Uint8Array();
  /** What came beyond the announced length. */
  #pieces: Uint8Array<ArrayBuffer>[] = [];

  constructor(readonly url: string, readonly options: FetchOptions) {}

  async open(headers?: HeadersInit): Promise<Response> {
    const { signal, credentials } = this.options;
    this.response = null;
    return (this.response = await fetch(this.url, { signal, credentials, headers }));
  }

  /** @param isRest - whether it follows on what came already */
  async read(response: Response, isRest = false): Promise<DecodeInput> {
    const reader = response.body?.getReader();
    try {
      if (!response.ok) throw new Error(`status ${response.status}`);
      if (!isRest) this.#begin(response);
      this.tell();
      for (;;) {
        const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
        if (done || !value) break;
        this.#add(value);
        this.tell();
      }
    } finally {
      reader?.cancel().catch(() => undefined);
    }
    // A response to a blob: URL has lost its fragment, by which messages call the file.
    const url = this.url.startsWith('blob:') ? this.url : response.url || this.url;
    return { bytes: this.#join(), url, contentType: response.headers.get('content-type') ?? '' };
  }

  /** Say how far it is. */
  tell(): void {
    // A length that was passed was of something else, such as the packed form: no total is better than a wrong one.
    this.options.onProgress(this.loaded, this.loaded > this.#announced ? 0 : this.#announced);
  }

  #begin(response: Response): void {
    const announced = announcedLength(response);
    this.#check(announced);
    this.origin = response;
    this.#announced = announced;
    this.#pieces = [];
    this.loaded = 0;
    // What is said and does not come costs little. What comes ends up in a buffer of just its length, and was copied on
    // the way when there was an eighth of it: joining pieces at the end would take twice the memory.
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
    const [has, most] = [bytes, maxBytes].map((count) => count.toLocaleString('en'));
    throw new VolumeViewError('format/too-large', `${this.url.slice(0, 300)} has ${has} bytes or more; expected at most ${most}`);
  }
}

/** Content-Length, where it is the length of what arrives: with a content encoding it is that of the packed form. */
function announcedLength({ headers }: Response): number {
  const length = headers.has('content-encoding') ? 0 : Number(headers.get('content-length'));
  return Number.isSafeInteger(length) && length > 0 ? length : 0;
}
