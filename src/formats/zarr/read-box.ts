import type { Budget } from '../base/budget.ts';
import type { ProgressListener } from '../base/decoded-volume.ts';
import { halfFloatBits } from '../base/half-floats.ts';
import { hostIsLittleEndian, swapBytes } from '../base/number-types.ts';
import { asNumbers, copyChunk } from './copy-chunk.ts';
import type { FileTree } from './file-tree.ts';
import { listChunks } from './list-chunks.ts';
import type { ArrayBox } from './list-chunks.ts';
import { listRuns } from './read-shards.ts';
import { loadUnpacker } from './unpack-chunk.ts';
import { maxChunkBytes } from './zarr-array.ts';
import type { ZarrArray } from './zarr-array.ts';

/** Chunks that are on their way at once, and the bytes of their numbers. */
const [atOnce, bytesAtOnce] = [8, 2 ** 28];

/** Chunks that come by one request: null for one that is missing. */
interface Pieces {
  readonly places: readonly (readonly number[])[];
  read(): Promise<readonly (Uint8Array<ArrayBuffer> | null)[]>;
}

interface BoxReading {
  readonly budget: Budget;
  readonly signal?: AbortSignal;
  /** Gets bytes of the box, and all of them. */
  readonly onProgress: ProgressListener;
}

/**
 * Reads boxes of an array that differ only in the index along an axis that is none of space, such as those of several channels: what they have in
 * one chunk is read once. The middle comes first. What is in no chunk has the fill value. The bytes of the boxes are taken from the budget.
 * @returns the numbers of each box in the byte order of the array, i fastest
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`, `source/…`; the signal's reason
 */
export async function readBoxes(
  tree: Pick<FileTree, 'read'>,
  array: ZarrArray,
  boxes: readonly ArrayBox[],
  { budget, signal, onProgress }: BoxReading,
): Promise<readonly Uint8Array<ArrayBuffer>[]> {
  const size = array.type.bytesPerSample;
  const each = boxes[0].dimensions.reduce((product, n) => product * n, size);
  const total = boxes.length * each;
  // Chunks may be missing, so that few bytes of a file may stand for many: the device has room for them, which was looked at before.
  budget.addFile(total);
  budget.take(total, 'the volume');
  const unpack = await loadUnpacker(array, budget);
  const read = boxes.map((box) => {
    const bytes = new Uint8Array(each);
    const output = asNumbers(bytes, size);
    if (array.fill !== 0) output.fill(bitsOf(array) as never);
    return { box, bytes, output };
  });
  const { places, users } = shareChunks(array, read);
  const chunkBytes = array.chunk.reduce((product, n) => product * n, size);
  // One failure ends the others.
  const failed = new AbortController();
  const all = signal ? anyOf(signal, failed) : failed.signal;
  const readAlone = async (place: readonly number[]): Promise<readonly (Uint8Array<ArrayBuffer> | null)[]> => [
    await tree.read(array.path + array.fileOf(place), { maxBytes: 2 * maxChunkBytes, signal: all }),
  ];
  const most = Math.max(1, Math.min(atOnce, bytesAtOnce / chunkBytes));
  let [next, done] = [0, 0];
  let runs: readonly Pieces[] = [];
  const work = async (): Promise<void> => {
    while (next < runs.length) {
      const { places: own, read: fetch } = runs[next++];
      const several = await fetch();
      all.throwIfAborted();
      const bytesOfAll = several.reduce((sum, one) => sum + (one?.length ?? 0), 0);
      budget.addFile(bytesOfAll);
      budget.take(bytesOfAll + chunkBytes, 'a chunk of the Zarr');
      for (const [i, packed] of several.entries()) {
        if (packed) {
          const numbers = asNumbers(await unpack(packed), size);
          for (const user of users.get(String(own[i]))!) copyChunk(numbers, own[i], { array, ...user });
        }
        done++;
        onProgress(Math.round((done / places.length) * total), total);
      }
      budget.giveBack(bytesOfAll + chunkBytes);
    }
  };
  onProgress(0, total);
  try {
    runs = array.shards
      ? await listRuns(tree, { ...array, shards: array.shards }, places, { budget, signal: all, atOnce })
      : places.map((place) => ({ places: [place], read: () => readAlone(place) }));
    done = places.length - runs.reduce((sum, run) => sum + run.places.length, 0); // The others are missing.
    await Promise.all(Array.from({ length: most }, work));
    onProgress(total, total);
  } catch (cause) {
    failed.abort(cause);
    throw cause;
  }
  return read.map(({ bytes }) => bytes);
}

/** The chunks that boxes need, and which boxes need each of them. */
function shareChunks<User extends { readonly box: ArrayBox }>(
  array: ZarrArray,
  all: readonly User[],
): { readonly places: readonly (readonly number[])[]; readonly users: ReadonlyMap<string, readonly User[]> } {
  const places: (readonly number[])[] = [];
  const users = new Map<string, User[]>();
  for (const user of all)
    for (const place of listChunks(array, user.box)) {
      const known = users.get(String(place));
      if (known) known.push(user);
      else {
        places.push(place);
        users.set(String(place), [user]);
      }
    }
  return { places, users };
}

/** A signal that either of them gives. */
function anyOf(signal: AbortSignal, other: AbortController): AbortSignal {
  if (signal.aborted) other.abort(signal.reason);
  signal.addEventListener('abort', () => other.abort(signal.reason), { once: true, signal: other.signal });
  return other.signal;
}

/** The bits of the fill value as the file has them. */
export function bitsOf({ type, fill, littleEndian }: ZarrArray): number | bigint {
  const size = type.bytesPerSample;
  const bytes = new Uint8Array(8);
  const view = new DataView(bytes.buffer);
  if (size === 2 && type.read.kind === 'floats') view.setUint16(0, halfFloatBits(fill), hostIsLittleEndian);
  else if (type.read.kind === 'floats') view[size === 4 ? 'setFloat32' : 'setFloat64'](0, fill, hostIsLittleEndian);
  else view.setBigInt64(0, BigInt(Number.isFinite(fill) ? Math.trunc(fill) : 0), hostIsLittleEndian);
  const own = bytes.slice(0, size);
  if (littleEndian !== hostIsLittleEndian) swapBytes(own, type.bytesPerNumber);
  return asNumbers(own, size)[0];
}
