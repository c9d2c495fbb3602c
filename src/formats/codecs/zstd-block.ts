// A block of Zstandard: bytes as they are (literals), and copies of earlier ones between them. Source: RFC 8878, 3.1.1.3
import {
  BackwardBits,
  corruptZstd,
  makeStateCode,
  oneSymbol,
  readHuffman,
  readHuffmanCode,
  readStateCode,
} from './zstd-codes.ts';
import type { HuffmanCode, StateCode } from './zstd-codes.ts';

/** Maximum bytes of a block, unpacked. */
export const maxBlockBytes = 2 ** 17;

/** What a frame keeps from block to block. */
export interface FrameState {
  huffman: HuffmanCode | null;
  /** The codes of lengths of literals, of distances, and of lengths of copies. */
  codes: (StateCode | null)[];
  /** The last three distances. */
  recent: [number, number, number];
}

export const startFrame = (): FrameState => ({ huffman: null, codes: [null, null, null], recent: [1, 4, 8] });

/** Where a block is written to. */
export interface BlockOutput {
  /** With room for another block. */
  readonly bytes: Uint8Array;
  /** Where the frame begins, to which copies can reach. */
  readonly frame: number;
  /** Where the block begins. */
  readonly at: number;
}

const range = (from: number, to: number): number[] => Array.from({ length: to - from }, (_, i) => from + i);

/** Base and number of extra bits of each code. Source: RFC 8878, tables 16 and 18 */
const literalBases = [...range(0, 16), 16, 18, 20, 22, 24, 28, 32, 40, 48, ...range(6, 17).map((n) => 2 ** n)];
const literalBits = [...range(0, 16).fill(0), 1, 1, 1, 1, 2, 2, 3, 3, 4, ...range(6, 17)];
const copyBases = [
  ...range(3, 35),
  ...[35, 37, 39, 41, 43, 47, 51, 59, 67, 83, 99],
  ...range(7, 17).map((n) => 2 ** n + 3),
];
const copyBits = [...range(0, 32).fill(0), 1, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5, ...range(7, 17)];

/** Codes that a block need not describe. Source: RFC 8878, 3.1.1.3.2.2 */
const usual = [
  makeStateCode(
    6,
    [4, 3, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 2, 1, 1, 1, 1, 1, -1, -1, -1, -1],
  ),
  makeStateCode(5, [1, 1, 1, 1, 1, 1, 2, 2, 2, ...range(0, 15).fill(1), -1, -1, -1, -1, -1]),
  makeStateCode(6, [1, 4, 3, 2, 2, 2, 2, 2, 2, ...range(0, 37).fill(1), -1, -1, -1, -1, -1, -1, -1]),
];
const maxLogs = [9, 8, 9];
const maxSymbols = [35, 31, 52];

const literals = new Uint8Array(maxBlockBytes);

/**
 * Unpacks a block.
 * @returns where its output ends
 * @throws {VolumeViewError} `format/corrupt`
 */
export function unpackBlock(block: Uint8Array, frame: FrameState, output: BlockOutput): number {
  const { size, end } = readLiterals(block, frame);
  return copySequences(block, end, frame, { ...output, size });
}

/** Reads the literals of a block into `literals`. */
function readLiterals(block: Uint8Array, frame: FrameState): { size: number; end: number } {
  const kind = block[0] & 3;
  const form = (block[0] >> 2) & 3;
  const number = (count: number): number => range(0, count).reduce((sum, i) => sum + (block[i] ?? 0) * 2 ** (8 * i), 0);
  if (kind < 2) {
    const head = form === 1 ? 2 : form === 3 ? 3 : 1;
    const size = head === 1 ? block[0] >> 3 : Math.floor(number(head) / 16);
    const end = head + (kind === 1 ? 1 : size);
    if (size > maxBlockBytes || end > block.length) throw corruptZstd('ends early');
    if (kind === 1) literals.fill(block[head], 0, size);
    else literals.set(block.subarray(head, end));
    return { size, end };
  }
  const [head, width] = [3 + Math.max(0, form - 1), form < 2 ? 10 : form === 2 ? 14 : 18];
  const all = Math.floor(number(head) / 16);
  const [size, packed] = [all % 2 ** width, Math.floor(all / 2 ** width)];
  const end = head + packed;
  if (size > maxBlockBytes || end > block.length) throw corruptZstd('ends early');
  let start = head;
  if (kind === 2) {
    const { code, end: after } = readHuffmanCode(block, start, end);
    frame.huffman = code;
    start = after;
  }
  if (!frame.huffman) throw corruptZstd('uses a code that was not described');
  readStreams(block, { start, end, isOne: form === 0 }, frame.huffman, literals.subarray(0, size));
  return { size, end };
}

/** One stream of literals, or four, whose lengths come first. */
function readStreams(
  block: Uint8Array,
  { start, end, isOne }: { readonly start: number; readonly end: number; readonly isOne: boolean },
  code: HuffmanCode,
  out: Uint8Array,
): void {
  if (isOne) return readHuffman(new BackwardBits(block, start, end), code, out);
  const part = (out.length + 3) >> 2;
  let at = start + 6;
  if (at > end || 3 * part > out.length) throw corruptZstd('ends early');
  for (let i = 0; i < 4; i++) {
    const length = i < 3 ? block[start + 2 * i] + 256 * block[start + 2 * i + 1] : end - at;
    if (at + length > end) throw corruptZstd('ends early');
    readHuffman(
      new BackwardBits(block, at, at + length),
      code,
      out.subarray(i * part, i < 3 ? (i + 1) * part : undefined),
    );
    at += length;
  }
}

/** Reads the codes of the sequences, and carries them out. */
function copySequences(
  block: Uint8Array,
  start: number,
  frame: FrameState,
  output: BlockOutput & { readonly size: number },
): number {
  const { bytes, size } = output;
  let at = start;
  let count = block[at++] ?? 0;
  if (count === 255) {
    count = block[at] + 256 * block[at + 1] + 0x7f00;
    at += 2;
  } else if (count > 127) count = (count - 128) * 256 + block[at++];
  if (count === 0) {
    bytes.set(literals.subarray(0, size), output.at);
    return output.at + size;
  }
  const modes = block[at++];
  for (let i = 0; i < 3; i++) {
    const mode = (modes >> (6 - 2 * i)) & 3;
    if (mode === 0) frame.codes[i] = usual[i];
    else if (mode === 1) {
      if (!(block[at] <= maxSymbols[i])) throw corruptZstd('has a symbol that is none');
      frame.codes[i] = oneSymbol(block[at++]);
    } else if (mode === 2) {
      const { code, end } = readStateCode(block, { start: at, end: block.length }, maxLogs[i], maxSymbols[i]);
      frame.codes[i] = code;
      at = end;
    }
  }
  const [literalCode, distanceCode, copyCode] = frame.codes;
  if (!literalCode || !distanceCode || !copyCode || at >= block.length)
    throw corruptZstd('uses a code that was not described');
  const bits = new BackwardBits(block, at, block.length);
  const limit = output.at + maxBlockBytes;
  let [to, from] = [output.at, 0];
  let literalState = bits.read(literalCode.log);
  let distanceState = bits.read(distanceCode.log);
  let copyState = bits.read(copyCode.log);
  for (let i = 0; i < count; i++) {
    const wide = distanceCode.symbols[distanceState];
    const distance = 2 ** wide + bits.read(wide);
    const copySymbol = copyCode.symbols[copyState];
    const length = copyBases[copySymbol] + bits.read(copyBits[copySymbol]);
    const literalSymbol = literalCode.symbols[literalState];
    const plain = literalBases[literalSymbol] + bits.read(literalBits[literalSymbol]);
    if (i + 1 < count) {
      literalState = literalCode.bases[literalState] + bits.read(literalCode.widths[literalState]);
      copyState = copyCode.bases[copyState] + bits.read(copyCode.widths[copyState]);
      distanceState = distanceCode.bases[distanceState] + bits.read(distanceCode.widths[distanceState]);
    }
    if (bits.left < 0 || from + plain > size || to + plain + length > limit)
      throw corruptZstd('has a block that is longer than one may be');
    bytes.set(literals.subarray(from, from + plain), to);
    from += plain;
    to += plain;
    const back = chooseDistance(frame.recent, distance, plain === 0);
    if (back < 1 || back > to - output.frame) throw corruptZstd('copies bytes from before its start');
    // A copy may reach into itself.
    const end = to + length;
    for (; to < end; to++) bytes[to] = bytes[to - back];
  }
  if (bits.left !== 0 || to + size - from > limit) throw corruptZstd('has a block that ends elsewhere than it says');
  bytes.set(literals.subarray(from, size), to);
  return to + size - from;
}

/** Distances 1 to 3 stand for the last ones; without literals, for those after the first, or the first less one. */
function chooseDistance(recent: FrameState['recent'], distance: number, isBare: boolean): number {
  const place = distance > 3 ? 3 : distance - 1 + (isBare ? 1 : 0);
  if (place === 0) return recent[0];
  const [first, second, third] = recent;
  const back = distance > 3 ? distance - 3 : place === 1 ? second : place === 2 ? third : first - 1;
  recent[2] = place === 1 ? third : second;
  recent[1] = first;
  recent[0] = back;
  return back;
}
