// The files of a list on servers, of which the starts are read first. Loaded when a reader wants that.
import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import type { FolderAccess } from '../formats/base/format.ts';
import type { ByteRange, ByteStore, FileStat, ReadOptions } from './byte-store.ts';
import { Download } from './download.ts';
import type { FetchOptions } from './download.ts';
import { fetchBytes } from './fetch-bytes.ts';
import { FolderReader } from './folder-reader.ts';
import { HttpStore } from './http-store.ts';
import type { FolderLoad } from './show-part.ts';

type OptionsOf = (url: string) => Omit<FetchOptions, 'onProgress'>;

/** @param list - the first file, as a whole; and the URLs of all */
export async function openListFolder(
  [first, files]: readonly [DecodeInput, readonly string[]],
  optionsOf: OptionsOf,
  load: FolderLoad,
): Promise<FolderAccess> {
  const store = new ListStore(files, optionsOf);
  const { signal } = optionsOf(first.url);
  return FolderReader.of(store, files, store.read.bind(store), {
    load,
    whole: [first],
    parts: { sizeOf: (url) => store.sizeOfParts(url) },
    signal,
  });
}

/** Bytes of a file behind its start, where its server hides how long it is: as many as a file may have. */
const hidden = 2 ** 31;

/**
 * Files on servers. Where a server sends no parts, the whole file comes in place of its start, and is kept until it is asked
 * for: nothing is fetched twice.
 */
class ListStore implements ByteStore {
  readonly #sizes = new Map<string, number>();
  readonly #whole = new Map<string, DecodeInput>();
  #sendsParts = true;

  constructor(
    private readonly files: readonly string[],
    private readonly optionsOf: OptionsOf,
  ) {}

  async list(): Promise<readonly string[]> {
    return this.files;
  }

  /** Null until some of the file has come, and where its server hides it. */
  async stat(url: string): Promise<FileStat> {
    return { size: this.#sizes.get(url) ?? null };
  }

  /** Bytes of a file of which parts can be read; null for others. */
  sizeOfParts(url: string): number | null {
    return this.#whole.has(url) ? null : (this.#sizes.get(url) ?? null);
  }

  sourceOf(url: string): string {
    return url;
  }

  async read(url: string, { range, onProgress = () => undefined }: ReadOptions = {}): Promise<DecodeInput> {
    const options = { ...this.optionsOf(url), onProgress };
    const kept = this.#whole.get(url);
    if (!range) {
      this.#whole.delete(url);
      return kept ?? fetchBytes(url, options);
    }
    if (range.start > 0 && !kept) return new HttpStore(options).read(url, { ...options, range });
    const part =
      kept || !this.#sendsParts || !url.startsWith('http') ? null : await this.#readPart(url, range, options);
    if (part) return part;
    const whole = this.#whole.get(url) ?? this.#keep(url, await fetchBytes(url, options));
    const start = whole.bytes.subarray(range.start, range.end);
    return { ...whole, bytes: start, missing: whole.bytes.length - start.length };
  }

  #keep(url: string, whole: DecodeInput): DecodeInput {
    this.#whole.set(url, whole);
    this.#sizes.set(url, whole.bytes.length);
    return whole;
  }

  /** @returns null where the whole file has to be tried, or has come: that tries again, and explains what is wrong */
  async #readPart(url: string, { end }: ByteRange, options: FetchOptions): Promise<DecodeInput | null> {
    const download = new Download(url, options);
    try {
      const response = await download.open({ range: `bytes=0-${end - 1}` });
      const { headers, status } = response;
      // Servers of another origin hide this header, unless they say otherwise.
      const range = headers.get('content-range');
      if (status === 206 && !headers.has('content-encoding') && (range?.startsWith('bytes 0-') ?? true)) {
        const input = await download.read(response);
        const size = Number(/\/(\d+)$/.exec(range ?? '')?.[1] ?? NaN);
        if (!Number.isSafeInteger(size)) return { ...input, missing: input.bytes.length < end ? 0 : hidden };
        this.#sizes.set(url, size);
        return { ...input, missing: Math.max(0, size - input.bytes.length) };
      }
      if (response.ok) this.#sendsParts = false;
      if (status === 200) this.#keep(url, await download.read(response));
      else await response.body?.cancel();
    } catch (cause) {
      options.signal?.throwIfAborted();
      if (cause instanceof VolumeViewError) throw cause;
      // Of another origin, a browser may have asked first whether it may ask for parts.
      if (!download.response) this.#sendsParts = false;
    }
    return null;
  }
}
