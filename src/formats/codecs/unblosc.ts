// Our own reader of Blosc's container. The usual one, numcodecs 0.3, is WebAssembly of 205 kB (packed), which a page may not allow; it
// allocates what a header of 16 bytes asks for, in a memory that never becomes smaller.
// Source: README_CHUNK_FORMAT.rst and blosc/blosc.c of github.com/Blosc/c-blosc 1.21
import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { DeflateError, Inflater } from './inflate.ts';
import { unblosclz } from './unblosclz.ts';
import { unlz4 } from './unlz4.ts';
import { isZlib } from './unzlib.ts';
import { unzstd } from './unzstd.ts';

const what = 'the Blosc data';
const headerBytes = 16;

/** Bits of the flags. */
const [shuffled, stored, bitShuffled, whole] = [1, 2, 4, 16];

/** Numbers of more bytes than this, and planes of fewer bytes than that, are not packed apart. */
const [maxSplits, minSplitBytes] = [16, 128];

/**
 * Unpacks a chunk of Blosc into exactly as many bytes as `output` has.
 * @param budget - of what Zstandard needs during the work
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export function unblosc(bytes: Uint8Array, output: Uint8Array<ArrayBuffer>, budget: Budget): void {
  if (bytes.length < headerBytes) throw corruptFile(what, 'end early');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const flags = bytes[2];
  const typeBytes = bytes[3];
  const [length, blockBytes, packed] = [4, 8, 12].map((at) => view.getUint32(at, true));
  if (bytes[0] > 2) throw unsupportedFile(what, `are of format ${bytes[0]}; expected 1 or 2 (c-blosc 1)`);
  if (length !== output.length) throw corruptFile(what, `have ${length} bytes where ${output.length} belong`);
  if (packed > bytes.length) throw corruptFile(what, 'end early');
  if (flags & stored) {
    if (headerBytes + length > bytes.length) throw corruptFile(what, 'end early');
    output.set(bytes.subarray(headerBytes, headerBytes + length));
    return;
  }
  if (length === 0) return;
  if (blockBytes === 0 || typeBytes === 0) throw corruptFile(what, 'have blocks of 0 bytes');
  const blocks = Math.ceil(length / blockBytes);
  if (headerBytes + 4 * blocks > packed) throw corruptFile(what, 'end early');
  const unpackStream = chooseUnpacker(flags >> 5, budget);
  const isShuffled = (flags & (shuffled | bitShuffled)) !== 0;
  const scratchBytes = isShuffled ? Math.min(blockBytes, length) : 0;
  budget.take(scratchBytes, what);
  const scratch = isShuffled ? new Uint8Array(scratchBytes) : null;
  for (let block = 0; block < blocks; block++) {
    const out = output.subarray(block * blockBytes, Math.min((block + 1) * blockBytes, length));
    const target = scratch?.subarray(0, out.length) ?? out;
    const isRest = out.length < blockBytes;
    const isSplit = !(flags & whole) && !isRest && typeBytes <= maxSplits && blockBytes / typeBytes >= minSplitBytes;
    const streams = isSplit ? typeBytes : 1;
    const streamBytes = Math.floor(out.length / streams);
    let at = view.getUint32(headerBytes + 4 * block, true);
    for (let stream = 0; stream < streams; stream++) {
      if (at + 4 > packed) throw corruptFile(what, 'end early');
      const size = view.getUint32(at, true);
      at += 4;
      if (at + size > packed) throw corruptFile(what, 'end early');
      const part = bytes.subarray(at, at + size);
      const into = target.subarray(stream * streamBytes, (stream + 1) * streamBytes);
      if (size === streamBytes) into.set(part);
      else unpackStream(part, into);
      at += size;
    }
    if (scratch) {
      if (flags & bitShuffled) gatherBits(target, out, typeBytes);
      else gatherBytes(target, out, typeBytes);
    }
  }
  budget.giveBack(scratchBytes);
}

type Unpacker = (bytes: Uint8Array, output: Uint8Array) => void;

/** @param format - the upper bits of the flags */
function chooseUnpacker(format: number, budget: Budget): Unpacker {
  switch (format) {
    case 0:
      return unblosclz;
    case 1:
      return unlz4;
    case 3:
      return inflateInto;
    case 4:
      return (bytes, output) => {
        const unpacked = unzstd(bytes, output.length, budget);
        if (unpacked.length !== output.length)
          throw corruptFile(what, `have ${unpacked.length} bytes where ${output.length} belong`);
        output.set(unpacked);
      };
    default:
      throw unsupportedFile(
        what,
        `are packed by ${format === 2 ? 'Snappy' : `method ${format}`}; expected lz4, zstd, zlib or blosclz`,
      );
  }
}

/** zlib data of one stream; its checksum is left to that of the whole, if there is one. */
function inflateInto(bytes: Uint8Array, output: Uint8Array): void {
  if (!isZlib(bytes)) throw corruptFile(what, 'have no zlib data where they belong');
  let out = 0;
  try {
    for (const piece of new Inflater().unpack(bytes as Uint8Array<ArrayBuffer>, 2)) {
      if (out + piece.length > output.length) break;
      output.set(piece, out);
      out += piece.length;
    }
  } catch (cause) {
    if (cause instanceof DeflateError) throw corruptFile(what, cause.message);
    throw cause;
  }
  if (out !== output.length) throw corruptFile(what, `have ${out} bytes where ${output.length} belong`);
}

/** The first bytes of all numbers lie first, then their second bytes, and so on. */
export function gatherBytes(from: Uint8Array, to: Uint8Array, typeBytes: number): void {
  const count = Math.floor(from.length / typeBytes);
  for (let byte = 0; byte < typeBytes; byte++)
    for (let i = 0, at = byte * count, out = byte; i < count; i++, out += typeBytes) to[out] = from[at++];
  to.set(from.subarray(count * typeBytes), count * typeBytes);
}

/** The lowest bits of all numbers lie first, and so on; of a number of numbers that is no multiple of 8, nothing is moved. */
function gatherBits(from: Uint8Array, to: Uint8Array, typeBytes: number): void {
  const count = Math.floor(from.length / typeBytes);
  if (count % 8 !== 0) return to.set(from);
  const row = count / 8;
  to.fill(0, 0, count * typeBytes);
  for (let bit = 0; bit < 8 * typeBytes; bit++) {
    const [byte, mask] = [bit >> 3, 1 << (bit & 7)];
    for (let at = 0; at < row; at++) {
      const bits = from[bit * row + at];
      if (bits === 0) continue;
      for (let i = 0, out = 8 * at * typeBytes + byte; i < 8; i++, out += typeBytes)
        if (bits & (1 << i)) to[out] |= mask;
    }
  }
  to.set(from.subarray(count * typeBytes), count * typeBytes);
}
