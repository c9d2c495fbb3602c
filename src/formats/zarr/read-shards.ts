import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { crc32c } from '../codecs/crc32c.ts';
import type { FilePart, FileTree } from './file-tree.ts';
import { maxChunkBytes } from './zarr-array.ts';
import type { Sharding, ZarrArray } from './zarr-array.ts';

const what = 'a shard of the Zarr';

/** What an index has in both numbers of a chunk that is missing. */
const nothing = 2n ** 64n - 1n;

/** Reads the packed bytes of a chunk; null where it is missing. */
export type ReadPacked = (place: readonly number[]) => Promise<Uint8Array<ArrayBuffer> | null>;

/** Where the chunks of shards lie: each index is read once. */
export function readFromShards(
  tree: Pick<FileTree, 'read'>,
  array: ZarrArray & { readonly shards: Sharding },
  { budget, signal }: { readonly budget: Budget; readonly signal?: AbortSignal },
): ReadPacked {
  const { shards, chunk } = array;
  const counts = shards.shape.map((n, axis) => n / chunk[axis]);
  const chunks = counts.reduce((product, n) => product * n, 1);
  const indexBytes = 16 * chunks + (shards.hasChecksum ? 4 : 0);
  const part: FilePart = shards.isIndexFirst ? { start: 0, end: indexBytes } : { last: indexBytes };
  const indices = new Map<string, Promise<DataView | null>>();
  const readIndex = async (path: string): Promise<DataView | null> => {
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
  };
  return async (place) => {
    const path = array.path + array.fileOf(place.map((n, axis) => Math.floor(n / counts[axis])));
    let coming = indices.get(path);
    if (!coming) indices.set(path, (coming = readIndex(path)));
    const index = await coming;
    if (!index) return null;
    const inside = place.reduce((sum, n, axis) => sum * counts[axis] + (n % counts[axis]), 0);
    const [start, length] = [index.getBigUint64(16 * inside, true), index.getBigUint64(16 * inside + 8, true)];
    if (start === nothing && length === nothing) return null;
    const end = Number(start + length);
    if (!Number.isSafeInteger(end) || length > 2 * maxChunkBytes)
      throw corruptFile(what, 'says that a chunk lies where no file has it');
    const bytes = await tree.read(path, { part: { start: Number(start), end }, signal });
    if (bytes?.length === Number(length)) return bytes;
    throw corruptFile(what, `has ${bytes?.length ?? 0} bytes of a chunk of ${String(length)}: it is cut short`);
  };
}
