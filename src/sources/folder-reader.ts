import type { DecodedCartesianVolume, DecodeInput } from '../formats/base/decoded-volume.ts';
import type { FolderAccess, FrameAccess, PartAccess } from '../formats/base/format.ts';
import type { ByteStore } from './byte-store.ts';
import { GroupReader } from './group-reader.ts';
import { showPart } from './show-part.ts';
import type { FolderLoad } from './show-part.ts';

interface FolderOptions {
  readonly load: FolderLoad;
  /** Starts that were read already. */
  readonly starts?: ReadonlyMap<string, DecodeInput>;
  /** Files that were read as a whole already. */
  readonly whole?: readonly DecodeInput[];
  /** Reads frames without the others of their file; `onBytes` gets the number of bytes that came since the last call. */
  readonly frames?: Pick<FrameAccess, 'addressOf'> & {
    read(url: string, frames: readonly number[], onBytes: (bytes: number) => void): Promise<DecodeInput>;
  };
  /** Whether servers send parts of files. */
  readonly parts?: Pick<PartAccess, 'sizeOf'>;
  readonly signal?: AbortSignal;
}

/** Reads the files of a series in parts, and reports how much of all is read. */
export class FolderReader implements FolderAccess {
  readonly frames?: FrameAccess;
  readonly parts?: PartAccess;
  /** Bytes that were read of each file. */
  readonly #read = new Map<string, number>();
  /** The files that are read; null for all. */
  #expected: ReadonlySet<string> | null = null;
  #loaded = 0;
  #total = 0;
  /** Of the files that are read, those whose size is not known yet. */
  #unknown: Set<string>;
  /** Files on a server: their sizes are learned with them, and none counts for the budget before it has come. */
  readonly #isRemote: boolean;
  /** Until they are asked for. */
  readonly #kept: Map<string, DecodeInput>;
  readonly #whole: GroupReader;

  private constructor(
    private readonly store: ByteStore,
    private readonly read: ByteStore['read'],
    private readonly sizes: Map<string, number | null>,
    private readonly options: FolderOptions,
  ) {
    const { signal, whole = [], frames, parts } = options;
    if (parts)
      this.parts = {
        // A file that came as a whole is not read again.
        sizeOf: (url) => (this.#kept.has(url) ? null : parts.sizeOf(url)),
        read: async (url, range) => {
          const input = await read(url, { range, signal });
          this.#count(url, (this.#read.get(url) ?? 0) + input.bytes.length);
          this.options.load.budget?.addFile(input.bytes.length);
          return input;
        },
      };
    if (frames)
      this.frames = {
        addressOf: (url, some) => frames.addressOf(url, some),
        read: async (url, some) => {
          const input = await frames.read(url, some, (bytes) => this.#count(url, (this.#read.get(url) ?? 0) + bytes));
          if (this.#isRemote) this.options.load.budget?.addFile(input.bytes.length);
          return input;
        },
      };
    this.#unknown = new Set([...sizes.keys()].filter((url) => sizes.get(url) === null));
    this.#isRemote = this.#unknown.size > 0;
    for (const size of sizes.values()) this.#total += size ?? 0;
    this.#kept = new Map(whole.map((input) => [input.url, input]));
    this.#whole = new GroupReader(store, {
      signal,
      readOne: (url) => read(url, { signal, onProgress: (loaded) => this.#count(url, loaded) }),
    });
    for (const { url, bytes } of whole) {
      this.#learn(url, bytes.length);
      this.#count(url, bytes.length);
    }
  }

  /** @param files - of the store @param read - reads a file of them */
  static async of(
    store: ByteStore,
    files: readonly string[],
    read: ByteStore['read'],
    options: FolderOptions,
  ): Promise<FolderReader> {
    const sizes = new Map<string, number | null>();
    for (const url of files) sizes.set(url, (await store.stat(url)).size);
    return new FolderReader(store, read, sizes, options);
  }

  async readStart(url: string, bytes: number): Promise<DecodeInput> {
    const { signal, starts } = this.options;
    const whole = this.#kept.get(url);
    if (whole) return cutStart(whole, bytes);
    const kept = starts?.get(url);
    const isEnough = kept && (kept.bytes.length >= bytes || kept.missing === 0);
    const input = isEnough ? kept : await this.read(url, { range: { start: 0, end: bytes }, signal });
    if (this.#unknown.has(url)) this.#learn(url, (await this.store.stat(url)).size);
    this.#count(url, input.bytes.length);
    return this.#isRemote ? { ...input, packedBytes: input.bytes.length } : input;
  }

  async readWhole(url: string): Promise<DecodeInput> {
    const kept = this.#kept.get(url);
    this.#kept.delete(url);
    const input = kept ?? (await this.#whole.read(url));
    if (this.#isRemote && !kept) this.options.load.budget?.addFile(input.bytes.length);
    this.#learn(url, input.bytes.length);
    this.#count(url, Infinity);
    return input;
  }

  sourceOf(url: string): Blob | string | null {
    return this.store.sourceOf?.(url) ?? null;
  }

  plan(urls: readonly string[]): number {
    return this.#whole.plan(urls, (url) => this.sizes.get(url) ?? 0);
  }

  expect(urls: readonly string[], bytes: ReadonlyMap<string, number> = new Map()): void {
    const expected = (this.#expected = new Set(urls));
    for (const [url, some] of bytes) this.sizes.set(url, some);
    this.#unknown = new Set(urls.filter((url) => this.#sizeOf(url) === null));
    this.#total = 0;
    for (const url of expected) this.#total += this.#sizeOf(url) ?? 0;
    for (const [url, bytes] of this.#read) if (!expected.has(url)) this.#total += bytes;
  }

  showPart(part: DecodedCartesianVolume, grid: DecodedCartesianVolume['grid']): Promise<void> {
    return showPart(this.options.load, part, grid);
  }

  #sizeOf(url: string): number | null {
    return this.sizes.get(url) ?? null;
  }

  #learn(url: string, size: number | null): void {
    if (size === null || this.#sizeOf(url) !== null) return;
    this.sizes.set(url, size);
    if (this.#unknown.delete(url)) this.#total += size;
  }

  /** @param bytes - from its start */
  #count(url: string, bytes: number): void {
    const before = this.#read.get(url) ?? 0;
    const now = Math.max(before, Math.min(bytes, this.#sizeOf(url) ?? bytes));
    this.#read.set(url, now);
    this.#loaded += now - before;
    if (this.#expected && !this.#expected.has(url)) this.#total += now - before;
    this.options.load.onProgress(this.#loaded, this.#unknown.size > 0 ? 0 : this.#total);
  }
}

function cutStart(whole: DecodeInput, bytes: number): DecodeInput {
  const start = whole.bytes.subarray(0, bytes);
  return { ...whole, bytes: start, packedBytes: start.length, missing: whole.bytes.length - start.length };
}
