import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { readAhead } from '../base/read-ahead.ts';
import { crc32c } from '../codecs/crc32c.ts';
import type { FilePart, FileTree } from './file-tree.ts';
import { maxChunkBytes } from './zarr-array.ts';
import type { Sharding, ZarrArray } from './zarr-array.ts';

const what = 'a shard of the Zarr';

/** What an index has in both numbers of a chunk that is missing. */
const nothing = 2n ** 64n - 1n;

/** Chunks of one shard are read together up to so many bytes; bytes between two of them that are read too, as a request costs more. */
const [maxRunBytes, maxGapBytes] = [2 ** 22, 2 ** 14];

/** Chunks that are read together. */
export interface ChunkRun {
  /** Their places in the array. */
  readonly places: readonly (readonly number[])[];
  /** Reads their packed bytes, in their order. */
  read(): Promise<readonly Uint8Array<ArrayBuffer>[]>;
}

/** Where a chunk lies in its shard, in bytes. */
export interface ChunkSpan {
  readonly start: number;
  readonly end: number;
}

interface PlacedChunk extends ChunkSpan {
  readonly place: readonly number[];
  /** Its rank among those that are wanted. */
  readonly rank: number;
}

/** An array in shards. */
export type ShardedArray = ZarrArray & { readonly shards: Sharding };

/** The file of a chunk's shard, and the number of the chunk in its index. */
export function shardOf(
  { path, shards, chunk, fileOf }: ShardedArray,
  place: readonly number[],
): { readonly file: string; readonly inside: number } {
  const counts = shards.shape.map((n, axis) => n / chunk[axis]);
  return {
    file: path + fileOf(place.map((n, axis) => Math.floor(n / counts[axis]))),
    inside: place.reduce((sum, n, axis) => sum * counts[axis] + (n % counts[axis]), 0),
  };
}

interface ShardReading {
  readonly budget: Budget;
  readonly signal?: AbortSignal;
  /** Shards whose indices are read at once. */
  readonly atOnce: number;
}

/**
 * Divides the chunks of shards into parts of files that are read by one request each: neighbours together. Those that are wanted first come first;
 * chunks that are missing are left out. Reads the index of each shard.
 * @param places - of the chunks in the array, by how much they are wanted
 * @throws {VolumeViewError} `format/corrupt`, `source/…`
 */
export async function listRuns(
  tree: Pick<FileTree, 'read'>,
  array: ShardedArray,
  places: readonly (readonly number[])[],
  { budget, signal, atOnce }: ShardReading,
): Promise<ChunkRun[]> {
  const wanted = new Map<string, (Pick<PlacedChunk, 'place' | 'rank'> & { readonly inside: number })[]>();
  for (const [rank, place] of places.entries()) {
    const { file, inside } = shardOf(array, place);
    const known = wanted.get(file);
    if (known) known.push({ place, rank, inside });
    else wanted.set(file, [{ place, rank, inside }]);
  }
  const ranked: { readonly run: ChunkRun; readonly rank: number }[] = [];
  const readIndex = (path: string): Promise<DataView | null> => readIndexOf(tree, path, array, { budget, signal });
  const paths = [...wanted.keys()];
  let next = 0;
  for await (const index of readAhead(paths, readIndex, atOnce)) {
    const path = paths[next++];
    if (index.status === 'rejected') throw index.reason;
    const { value: view } = index;
    if (!view) continue;
    const found = wanted.get(path)!.flatMap(({ place, rank, inside }): PlacedChunk[] => {
      const span = readSpan(view, inside);
      return span ? [{ place, rank, ...span }] : [];
    });
    budget.giveBack(view.byteLength);
    for (const chunks of joinChunks(found))
      ranked.push({
        rank: Math.min(...chunks.map(({ rank }) => rank)),
        run: { places: chunks.map(({ place }) => place), read: () => readRun(tree, path, chunks, signal) },
      });
  }
  ranked.sort((a, b) => a.rank - b.rank);
  return ranked.map(({ run }) => run);
}

/** Reads the index of a shard, whose bytes are taken from the budget; null where the shard is missing. @throws {VolumeViewError} `format/corrupt`, `source/…` */
export async function readIndexOf(
  tree: Pick<FileTree, 'read'>,
  path: string,
  { shards, chunk }: ShardedArray,
  { budget, signal }: { readonly budget: Budget; readonly signal?: AbortSignal },
): Promise<DataView | null> {
  const chunks = shards.shape.reduce((product, n, axis) => product * (n / chunk[axis]), 1);
  const indexBytes = 16 * chunks + (shards.hasChecksum ? 4 : 0);
  const part: FilePart = shards.isIndexFirst ? { start: 0, end: indexBytes } : { last: indexBytes };
  const bytes = await tree.read(path, { part, signal });
  if (!bytes) return null;
  budget.addFile(bytes.length);
  budget.take(bytes.length, what);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  if (bytes.length !== indexBytes)
    throw corruptFile(what, `has ${bytes.length} bytes where its index of ${indexBytes} belongs`);
  if (shards.hasChecksum && crc32c(bytes.subarray(0, -4)) !== view.getUint32(indexBytes - 4, true))
    throw corruptFile(what, 'has an index with a wrong checksum');
  return view;
}

/** Where a chunk lies; null where it is missing. @param inside - its number in the index */
export function readSpan(index: DataView, inside: number): ChunkSpan | null {
  const [start, length] = [index.getBigUint64(16 * inside, true), index.getBigUint64(16 * inside + 8, true)];
  if (start === nothing && length === nothing) return null;
  const end = Number(start + length);
  if (!Number.isSafeInteger(end) || length > 2 * maxChunkBytes)
    throw corruptFile(what, 'says that a chunk lies where no file has it');
  return { start: Number(start), end };
}

/** Chunks that lie side by side in a shard, or nearly. Those that overlap, as no program writes them, are read one by one. */
export function joinChunks<T extends ChunkSpan>(chunks: readonly T[]): T[][] {
  const runs: T[][] = [];
  const ordered = [...chunks];
  ordered.sort((a, b) => a.start - b.start);
  for (const chunk of ordered) {
    const run = runs.at(-1);
    const gap = run ? chunk.start - run.at(-1)!.end : Infinity;
    if (run && gap >= 0 && gap <= maxGapBytes && chunk.end - run[0].start <= maxRunBytes) run.push(chunk);
    else runs.push([chunk]);
  }
  return runs;
}

/** Reads the packed bytes of chunks that lie side by side. @throws {VolumeViewError} `format/corrupt`, `source/…` */
export async function readRun(
  tree: Pick<FileTree, 'read'>,
  path: string,
  chunks: readonly ChunkSpan[],
  signal: AbortSignal | undefined,
): Promise<readonly Uint8Array<ArrayBuffer>[]> {
  const { start } = chunks[0];
  const { end } = chunks.at(-1)!;
  const bytes = end > start ? await tree.read(path, { part: { start, end }, signal }) : new Uint8Array();
  return chunks.map((chunk) => {
    const own = bytes?.subarray(chunk.start - start, chunk.end - start);
    if (own?.length === chunk.end - chunk.start) return own;
    throw corruptFile(what, `has ${own?.length ?? 0} bytes of a chunk of ${chunk.end - chunk.start}: it is cut short`);
  });
}
