import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { usualAhead } from '../formats/base/read-ahead.ts';
import type { ByteRange, ByteStore } from './byte-store.ts';

/** At most so many files, and so many bytes, are read in one piece. */
const most = { files: 32, bytes: 2 ** 23 };

interface GroupOptions {
  /** The part of each file that is read; all of it if undefined. */
  readonly range?: ByteRange;
  readonly signal?: AbortSignal;
  /** Reads one file, where several can't be read at once. */
  readonly readOne: (url: string) => Promise<DecodeInput>;
}

interface Group {
  readonly urls: string[];
  bytes: number;
  coming?: Promise<ReadonlyMap<string, DecodeInput>>;
}

/**
 * Reads files that will be asked for in a known order: those that come next are read in one piece, where the store can do
 * that. For a browser, many small reads take twice as long as few large ones.
 */
export class GroupReader {
  /** Of each file that was not asked for yet. */
  readonly #groups = new Map<string, Group>();

  constructor(
    private readonly store: ByteStore,
    private readonly options: GroupOptions,
  ) {}

  /**
   * @param urls - in the order in which they will be asked for
   * @param sizeOf - bytes that will be read of a file
   * @returns how many are to be asked for before the first of them is there, so that one piece is read while another is used
   */
  plan(urls: readonly string[], sizeOf: (url: string) => number): number {
    if (!this.store.readTogether) return usualAhead;
    let group: Group = { urls: [], bytes: 0 };
    let largest = 1;
    for (const url of urls) {
      const size = sizeOf(url);
      if (group.urls.length === most.files || group.bytes + size > most.bytes) group = { urls: [], bytes: 0 };
      group.urls.push(url);
      group.bytes += size;
      largest = Math.max(largest, group.urls.length);
      this.#groups.set(url, group);
    }
    return Math.max(usualAhead, 2 * largest);
  }

  /** @throws as `readOne` does */
  async read(url: string): Promise<DecodeInput> {
    const group = this.#groups.get(url);
    // Nothing keeps what was asked for: the last file of a group frees its memory.
    this.#groups.delete(url);
    if (!group || group.urls.length === 1) return this.options.readOne(url);
    group.coming ??= this.#readTogether(group.urls);
    return (await group.coming).get(url) ?? this.options.readOne(url);
  }

  async #readTogether(urls: readonly string[]): Promise<ReadonlyMap<string, DecodeInput>> {
    const { range, signal } = this.options;
    const read = await this.store.readTogether!(urls, { range, signal });
    return new Map(read?.map((input) => [input.url, input]));
  }
}
