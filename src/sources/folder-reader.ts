import type { DecodedCartesianVolume, DecodeInput } from '../formats/base/decoded-volume.ts';
import type { FolderAccess } from '../formats/base/format.ts';
import type { ByteStore } from './byte-store.ts';
import { GroupReader } from './group-reader.ts';
import { showPart } from './show-part.ts';
import type { FolderLoad } from './show-part.ts';

interface FolderOptions {
  readonly load: FolderLoad;
  /** Starts that were read already. */
  readonly starts?: ReadonlyMap<string, DecodeInput>;
  readonly signal?: AbortSignal;
}

/** Reads the files of a series that lie at hand, in parts, and reports how much of all is read. */
export class FolderReader implements FolderAccess {
  /** Bytes that were read of each file. */
  readonly #read = new Map<string, number>();
  /** The files that are read; null for all. */
  #expected: ReadonlySet<string> | null = null;
  #loaded = 0;
  #total = 0;

  readonly #whole: GroupReader;

  private constructor(
    store: ByteStore,
    private readonly read: ByteStore['read'],
    private readonly sizes: ReadonlyMap<string, number>,
    private readonly options: FolderOptions,
  ) {
    const { signal } = options;
    this.#whole = new GroupReader(store, { signal, readOne: (url) => read(url, { signal }) });
  }

  /** @param files - of the store @param read - reads a file of them */
  static async of(
    store: ByteStore,
    files: readonly string[],
    read: ByteStore['read'],
    options: FolderOptions,
  ): Promise<FolderReader> {
    const sizes = new Map<string, number>();
    for (const url of files) sizes.set(url, (await store.stat(url)).size ?? 0);
    const reader = new FolderReader(store, read, sizes, options);
    for (const size of sizes.values()) reader.#total += size;
    return reader;
  }

  async readStart(url: string, bytes: number): Promise<DecodeInput> {
    const { signal, starts } = this.options;
    const kept = starts?.get(url);
    const isEnough = kept && (kept.bytes.length >= bytes || kept.missing === 0);
    const input = isEnough ? kept : await this.read(url, { range: { start: 0, end: bytes }, signal });
    this.#count(url, input.bytes.length);
    return input;
  }

  async readWhole(url: string): Promise<DecodeInput> {
    const input = await this.#whole.read(url);
    this.#count(url, Infinity);
    return input;
  }

  plan(urls: readonly string[]): number {
    return this.#whole.plan(urls, (url) => this.sizes.get(url) ?? 0);
  }

  expect(urls: readonly string[]): void {
    this.#expected = new Set(urls);
    const rest = urls.map((url) => (this.sizes.get(url) ?? 0) - (this.#read.get(url) ?? 0));
    this.#total = rest.reduce((sum, bytes) => sum + bytes, this.#loaded);
  }

  showPart(part: DecodedCartesianVolume, grid: DecodedCartesianVolume['grid']): Promise<void> {
    return showPart(this.options.load, part, grid);
  }

  /** @param bytes - from its start */
  #count(url: string, bytes: number): void {
    const before = this.#read.get(url) ?? 0;
    const now = Math.max(before, Math.min(bytes, this.sizes.get(url) ?? 0));
    this.#read.set(url, now);
    this.#loaded += now - before;
    if (this.#expected && !this.#expected.has(url)) this.#total += now - before;
    this.options.load.onProgress(this.#loaded, this.#total);
  }
}
