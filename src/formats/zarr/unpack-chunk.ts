import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { loadReader } from '../base/load-reader.ts';
import { crc32c } from '../codecs/crc32c.ts';
import { unpack } from '../codecs/gunzip.ts';
import type { ByteCodec, ZarrArray } from './zarr-array.ts';

const what = 'a chunk of the Zarr';

/** Turns the bytes of a chunk into those of its numbers. */
export type UnpackChunk = (packed: Uint8Array<ArrayBuffer>) => Promise<Uint8Array<ArrayBuffer>>;

/** A chunk that is packed may be this much larger than its numbers: what can not be packed grows a little. */
const mostGrowth = (bytes: number): number => bytes + bytes / 8 + 2 ** 16;

/**
 * Loads what unpacks the chunks of an array. Each step has room for the bytes of a chunk and no more.
 * @throws {VolumeViewError} `format/unsupported`; the function `format/corrupt`, `format/too-large`
 */
export async function loadUnpacker({ chunk, type, codecs }: ZarrArray, budget: Budget): Promise<UnpackChunk> {
  const size = chunk.reduce((product, n) => product * n, type.bytesPerSample);
  const steps: UnpackChunk[] = [];
  for (const [i, codec] of codecs.entries())
    // Only the first one made the bytes that it got; those after it have what it made, of which the size is not known.
    steps.unshift(await loadStep(codec, i === 0 ? { exact: size } : { most: mostGrowth(size) }, budget));
  return async (packed) => {
    let bytes = packed;
    for (const step of steps) bytes = await step(bytes);
    if (bytes.length === size) return bytes;
    throw corruptFile(what, `has ${bytes.length} bytes where ${size} belong`);
  };
}

/** Bytes that a step gives: exactly so many, or at most. */
type Size =
  | { readonly exact: number; readonly most?: undefined }
  | { readonly most: number; readonly exact?: undefined };

async function loadStep({ name }: ByteCodec, { exact, most }: Size, budget: Budget): Promise<UnpackChunk> {
  const atMost = exact ?? most;
  const load = <T>(part: () => Promise<T>): Promise<T> => loadReader(part);
  switch (name) {
    case 'blosc': {
      const { unblosc } = await load(() => import('../codecs/unblosc.ts'));
      return async (packed) => {
        const size =
          exact ?? (packed.length < 16 ? 0 : new DataView(packed.buffer, packed.byteOffset).getUint32(4, true));
        return fill(size, atMost, (output) => unblosc(packed, output, budget));
      };
    }
    case 'lz4': {
      const { unlz4 } = await load(() => import('../codecs/unlz4.ts'));
      return async (packed) => {
        if (packed.length < 4) throw corruptFile(what, 'ends early');
        const size = new DataView(packed.buffer, packed.byteOffset).getUint32(0, true);
        return fill(size, atMost, (output) => unlz4(packed.subarray(4), output));
      };
    }
    case 'zstd': {
      const { unzstd } = await load(() => import('../codecs/unzstd.ts'));
      return async (packed) => unzstd(packed, atMost, budget);
    }
    case 'bz2': {
      const { bunzip2 } = await load(() => import('../codecs/bunzip2.ts'));
      const { Bunzip2Room } = await load(() => import('../codecs/bunzip2-room.ts'));
      return async (packed) => bunzip2(packed, atMost, new Bunzip2Room(budget));
    }
    case 'gzip':
    case 'zlib':
      return (packed) => inflate(packed, name, atMost);
    case 'crc32c':
      return async (packed) => {
        const end = packed.length - 4;
        if (end < 0) throw corruptFile(what, 'ends early');
        const sum = new DataView(packed.buffer, packed.byteOffset).getUint32(end, true);
        if (crc32c(packed.subarray(0, end)) !== sum) throw corruptFile(what, 'has a wrong checksum');
        return packed.subarray(0, end);
      };
    default:
      throw unsupportedFile(
        'the Zarr',
        `packs its chunks by ${/^[\w.-]{1,40}$/.test(name) ? `"${name}"` : 'something else'}; expected blosc, zstd, gzip, zlib, lz4, bz2 or nothing`,
      );
  }
}

function fill(size: number, atMost: number, write: (output: Uint8Array<ArrayBuffer>) => void): Uint8Array<ArrayBuffer> {
  if (size > atMost) throw corruptFile(what, `has ${size} bytes where ${atMost} belong`);
  const output = new Uint8Array(size);
  write(output);
  return output;
}

/** gzip or zlib data, in place. */
async function inflate(
  packed: Uint8Array<ArrayBuffer>,
  name: 'gzip' | 'zlib',
  atMost: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const output = new Uint8Array(atMost);
  let at = 0;
  for await (const piece of unpack(packed, name === 'gzip' ? 'gzip' : 'deflate', what)) {
    if (at + piece.length > atMost) throw corruptFile(what, `has more bytes than the ${atMost} that belong`);
    output.set(piece, at);
    at += piece.length;
  }
  return output.subarray(0, at);
}
