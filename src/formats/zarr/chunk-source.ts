import { Budget } from '../base/budget.ts';
import { SharedWork, untilAborted } from '../base/shared-work.ts';
import type { ByteCache } from './byte-cache.ts';
import { asNumbers } from './copy-chunk.ts';
import type { Numbers } from './copy-chunk.ts';
import type { FileTree } from './file-tree.ts';
import { joinChunks, readIndexOf, readRun, readSpan, shardOf } from './read-shards.ts';
import type { ChunkSpan, ShardedArray } from './read-shards.ts';
import { loadUnpacker } from './unpack-chunk.ts';
import { maxChunkBytes } from './zarr-array.ts';
import type { ZarrArray } from './zarr-array.ts';

/** What is kept of a Zarr: the numbers of chunks, and indices of shards. */
export type KeptOfZarr = ByteCache<Numbers | DataView>;

/** A chunk that is wanted. */
interface Wanted {
  readonly key: string;
  readonly place: readonly number[];
}

/** A chunk that is in a shard. */
interface Placed extends Wanted, ChunkSpan {
  readonly file: string;
}

/** What has come of some chunks, by their keys; null for one that is missing. */
type Unpacked = ReadonlyMap<string, Numbers | null>;

/**
 * Chunks of the arrays of a Zarr, which are asked for again and again: those that were used last are kept as they are unpacked, a chunk that is on its
 * way is waited for by all who want it, and given up when none of them does any longer. Indices of shards are kept as chunks are.
 */
export class ChunkSource {
  readonly #coming = new Map<string, SharedWork<Unpacked>>();
  readonly #indices = new Map<string, SharedWork<DataView | null>>();

  /**
   * @param tree - which limits how many files it reads at once
   * @param deviceBytes - that may be held on this device; undefined where it does not say it
   */
  constructor(
    private readonly tree: Pick<FileTree, 'read'>,
    private readonly kept: Pick<KeptOfZarr, 'get' | 'set'>,
    private readonly deviceBytes?: number,
  ) {}

  /**
   * @param places - of chunks, in chunks along each axis of the array
   * @returns the numbers of each, in the byte order of the array; null for one that is missing
   * @throws {VolumeViewError} `format/…`, `source/…`; the signal's reason
   */
  async read(
    array: ZarrArray,
    places: readonly (readonly number[])[],
    signal: AbortSignal,
  ): Promise<(Numbers | null)[]> {
    signal.throwIfAborted();
    const wanted = places.map((place) => ({ place, key: `${array.path}#${place.join('/')}` }));
    const found = new Map<string, Numbers | null>();
    const isLacking = ({ key }: Wanted): boolean => {
      const known = this.kept.get(key) as Numbers | null | undefined;
      if (known !== undefined) found.set(key, known);
      return known === undefined;
    };
    let lacking = wanted.filter(isLacking);
    const { shards } = array;
    if (shards && lacking.length > 0) {
      const placed = await this.#findInShards({ ...array, shards }, lacking, signal);
      // Others may have come while the indices came.
      lacking = lacking.filter(isLacking);
      this.#startRuns(array, placed);
    } else for (const one of lacking) this.#startAlone(array, one);
    // What is in no index is missing.
    const works = lacking.map(({ key }) => this.#coming.get(key) ?? null);
    const all = await waitForAll(works, signal);
    for (const [i, { key }] of lacking.entries()) found.set(key, all[i]?.get(key) ?? null);
    return wanted.map(({ key }) => found.get(key)!);
  }

  #startAlone(array: ZarrArray, one: Wanted): void {
    this.#start(array, [one], async (signal) => [
      await this.tree.read(array.path + array.fileOf(one.place), { maxBytes: 2 * maxChunkBytes, signal }),
    ]);
  }

  #startRuns(array: ZarrArray, placed: readonly Placed[]): void {
    const byFile = new Map<string, Placed[]>();
    for (const one of placed) {
      if (this.#coming.has(one.key) || this.kept.get(one.key) !== undefined) continue;
      const known = byFile.get(one.file);
      if (known) known.push(one);
      else byFile.set(one.file, [one]);
    }
    for (const [file, all] of byFile)
      for (const run of joinChunks(all)) this.#start(array, run, (signal) => readRun(this.tree, file, run, signal));
  }

  /** Begins to read chunks that come by one request, unless they are on their way. */
  #start(
    array: ZarrArray,
    chunks: readonly Wanted[],
    read: (signal: AbortSignal) => Promise<readonly (Uint8Array<ArrayBuffer> | null)[]>,
  ): void {
    if (this.#coming.has(chunks[0].key)) return;
    const work = new SharedWork<Unpacked>(
      async (signal) => {
        const found = new Map<string, Numbers | null>();
        for (const [i, packed] of (await read(signal)).entries()) {
          signal.throwIfAborted();
          const { key } = chunks[i];
          const numbers = packed && (await this.#unpack(array, packed));
          this.kept.set(key, numbers);
          found.set(key, numbers);
        }
        return found;
      },
      () => chunks.forEach(({ key }) => this.#coming.delete(key)),
    );
    for (const { key } of chunks) this.#coming.set(key, work);
  }

  /** Each chunk has a budget of its own: what is kept of all of them has its own limit. */
  async #unpack(array: ZarrArray, packed: Uint8Array<ArrayBuffer>): Promise<Numbers> {
    const size = array.type.bytesPerSample;
    const budget = new Budget(this.deviceBytes);
    budget.addFile(packed.length);
    budget.take(
      array.chunk.reduce((product, n) => product * n, size),
      'a chunk of the Zarr',
    );
    const unpack = await loadUnpacker(array, budget);
    return asNumbers(await unpack(packed), size);
  }

  /** Where chunks lie in their shards; those that are missing are left out. */
  async #findInShards(array: ShardedArray, wanted: readonly Wanted[], signal: AbortSignal): Promise<Placed[]> {
    const places = wanted.map((one) => ({ ...one, ...shardOf(array, one.place) }));
    const files = [...new Set(places.map(({ file }) => file))];
    const indices = new Map<string, DataView | null>();
    const lacking = files.filter((file) => {
      const known = this.kept.get(keyOfIndex(file)) as DataView | null | undefined;
      if (known !== undefined) indices.set(file, known);
      return known === undefined;
    });
    const read = await waitForAll(
      lacking.map((file) => this.#startIndex(array, file)),
      signal,
    );
    for (const [i, file] of lacking.entries()) indices.set(file, read[i]);
    return places.flatMap(({ inside, ...one }) => {
      const index = indices.get(one.file);
      const span = index && readSpan(index, inside);
      return span ? [{ ...one, ...span }] : [];
    });
  }

  /** Begins to read an index, unless it is on its way. */
  #startIndex(array: ShardedArray, file: string): SharedWork<DataView | null> {
    const key = keyOfIndex(file);
    const coming = this.#indices.get(key);
    if (coming) return coming;
    const work = new SharedWork(
      async (signal) => {
        const index = await readIndexOf(this.tree, file, array, { budget: new Budget(this.deviceBytes), signal });
        this.kept.set(key, index);
        return index;
      },
      () => this.#indices.delete(key),
    );
    this.#indices.set(key, work);
    return work;
  }
}

const keyOfIndex = (file: string): string => `${file}#index`;

/** Waits for works, of which some may be none. @throws what one of them throws; the signal's reason */
async function waitForAll<T>(works: readonly (SharedWork<T> | null)[], signal: AbortSignal): Promise<(T | null)[]> {
  const joined = works.map((work) => work?.join() ?? Promise.resolve(null));
  try {
    return await untilAborted(Promise.all(joined), signal);
  } finally {
    for (const work of works) work?.leave(signal.reason);
  }
}
