import { Budget } from '../base/budget.ts';
import { Bunzip2Output, Bunzip2Room, corruptBzip2 as corrupt } from './bunzip2-room.ts';

// Our own bzip2 decoder. Of those on npm, seek-bzip needs Node's Buffer and reads its package.json at run time, bz2
// sorts every block with a comparator (seconds per megabyte) and reads NaN beyond the end, and the WebAssembly builds
// need a page that allows WASM. None of them limits the size of the output.
// Source: bzip2's own manual (Julian Seward, 1.0.8) and Joe Tsai's "BZIP2: Format Specification" (2016).

const blockMagic = 0x314159265359;
const endMagic = 0x177245385090;
const longestCode = 20;
const symbolsPerSelector = 50;

/** True where bytes begin with bzip2's signature. */
export function isBzip2(bytes: Uint8Array): boolean {
  return (
    bytes.length > 3 &&
    bytes[0] === 0x42 &&
    bytes[1] === 0x5a &&
    bytes[2] === 0x68 &&
    bytes[3] >= 0x31 &&
    bytes[3] <= 0x39
  );
}

/** Sorting so many bytes of a block counts as one step. */
const blockPerStep = 4;

/** The steps of a stream without any blocks, 14 bytes. */
const stepsPerStream = 64;

/** A file length that gives the largest useful budget, for callers without a budget: `atMost` is their limit. */
const anyFileBytes = 2 ** 22;

/**
 * Unpacks bzip2 data and checks the checksums: all streams that follow each other, as pbzip2 and cat write them. Other
 * data after them are ignored.
 * @param atMost - maximum bytes of output
 * @param room - shared with earlier streams. During the work, the output and the copy that extends it are taken from
 * its budget
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function bunzip2(
  bytes: Uint8Array,
  atMost: number,
  room = new Bunzip2Room(Budget.ofFile(anyFileBytes)),
): Uint8Array<ArrayBuffer> {
  if (!isBzip2(bytes)) throw corrupt('has no bzip2 header');
  const output = new Bunzip2Output(atMost, room.budget);
  try {
    for (let at = 0; isBzip2(bytes.subarray(at, at + 4));) {
      const largest = 100_000 * (bytes[at + 3] - 0x30);
      at = unpackBlocks(new BitReader(bytes, at + 4), output, () => room.links(largest));
      output.budget.step(stepsPerStream, 'a bzip2 stream');
    }
    return output.finish();
  } finally {
    output.release();
  }
}

/** @returns where the stream ends */
function unpackBlocks(bits: BitReader, output: Bunzip2Output, makeRoom: () => Uint32Array): number {
  let streamChecksum = 0;
  for (;;) {
    const magic = bits.read(24) * 2 ** 24 + bits.read(24);
    if (magic !== blockMagic && magic !== endMagic) throw corrupt('has neither a block nor an end where one must be');
    const checksum = ((bits.read(16) << 16) | bits.read(16)) >>> 0;
    if (magic === endMagic) {
      if (checksum !== streamChecksum) throw corrupt('has a wrong checksum');
      return bits.end;
    }
    output.startBlock();
    const block = readBlock(bits, makeRoom());
    output.budget.step(block.links.length / blockPerStep, 'a bzip2 block');
    writeRuns(block, output);
    if (output.checksum() !== checksum) throw corrupt('has a block with a wrong checksum');
    streamChecksum = (((streamChecksum << 1) | (streamChecksum >>> 31)) ^ checksum) >>> 0;
  }
}

/** Reads numbers of some bits each, the highest bit first. */
class BitReader {
  private pending = 0;
  private count = 0;

  constructor(
    private readonly bytes: Uint8Array,
    private position: number,
  ) {}

  /** Index of the first byte of which no bit was read. */
  get end(): number {
    return this.position - (this.count >> 3);
  }

  /** The next 1 to 24 bits, without consuming them; beyond the end they are 0. */
  peek(width: number): number {
    while (this.count <= 24) {
      this.pending = (this.pending << 8) | (this.position < this.bytes.length ? this.bytes[this.position] : 0);
      this.position++;
      this.count += 8;
    }
    return (this.pending << (32 - this.count)) >>> (32 - width);
  }

  skip(width: number): void {
    this.count -= width;
    if (this.end > this.bytes.length) throw corrupt('ends early');
  }

  read(width: number): number {
    const value = this.peek(width);
    this.skip(width);
    return value;
  }
}

/**
 * Reads one block after its checksum, and undoes the Burrows-Wheeler transform.
 * @param links - as long as the largest block
 * @returns links: the low byte is a byte of the block, the bits above it are the index of the next one; and the index
 * of the first one
 */
function readBlock(bits: BitReader, links: Uint32Array): { links: Uint32Array; first: number } {
  if (bits.read(1)) throw corrupt('has a randomised block, which bzip2 has not written since 1999');
  const origin = bits.read(24);
  const alphabet = readAlphabet(bits);
  const codeCount = bits.read(3);
  const selectorCount = bits.read(15);
  if (codeCount < 2 || codeCount > 6 || selectorCount === 0) throw corrupt(`has a block of ${codeCount} codes`);
  const selectors = readSelectors(bits, selectorCount, codeCount);
  const codes = Array.from({ length: codeCount }, () => readCode(bits, alphabet.length + 2));
  const counts = new Uint32Array(256);
  const length = readSymbols(bits, { alphabet, selectors, codes }, { links, counts });
  if (origin >= length) throw corrupt('has a block that starts outside of itself');
  let sum = 0;
  const places = counts.map((count) => (sum += count) - count);
  for (let i = 0; i < length; i++) links[places[links[i] & 0xff]++] |= i << 8;
  return { links: links.subarray(0, length), first: links[origin] >>> 8 };
}

/** The byte values that occur in a block. */
function readAlphabet(bits: BitReader): Uint8Array {
  const rows = bits.read(16);
  const alphabet: number[] = [];
  for (let row = 0; row < 16; row++) {
    const used = rows & (0x8000 >> row) ? bits.read(16) : 0;
    for (let i = 0; i < 16; i++) if (used & (0x8000 >> i)) alphabet.push(16 * row + i);
  }
  if (alphabet.length === 0) throw corrupt('has a block without any byte values');
  return Uint8Array.from(alphabet);
}

/** Which code each 50 symbols use. The file writes the codes as moves to the front. */
function readSelectors(bits: BitReader, count: number, codeCount: number): Uint8Array {
  const recent = Uint8Array.from({ length: codeCount }, (_, i) => i);
  const selectors = new Uint8Array(count);
  for (let i = 0; i < count; i++) {
    let place = 0;
    while (bits.read(1)) if (++place >= codeCount) throw corrupt('names a code that is not there');
    selectors[i] = moveToFront(recent, place);
  }
  return selectors;
}

function moveToFront(list: Uint8Array, place: number): number {
  const value = list[place];
  // Most moves are short: a loop is faster than copyWithin.
  for (let i = place; i > 0; i--) list[i] = list[i - 1];
  list[0] = value;
  return value;
}

/** A canonical Huffman code. */
interface Code {
  readonly shortest: number;
  /** For each length: the first value of the next `longestCode` bits that belongs to a longer code. */
  readonly ends: Uint32Array;
  /** For each length: code - offset is an index into `symbols`. */
  readonly offsets: Int32Array;
  readonly symbols: Uint16Array;
}

function readCode(bits: BitReader, symbolCount: number): Code {
  const lengths = new Uint8Array(symbolCount);
  let length = bits.read(5);
  for (let i = 0; i < symbolCount; i++) {
    while (bits.read(1)) length += bits.read(1) ? -1 : 1;
    if (length < 1 || length > longestCode) throw corrupt(`has a code of ${length} bits`);
    lengths[i] = length;
  }
  return makeCode(lengths);
}

function makeCode(lengths: Uint8Array): Code {
  const ends = new Uint32Array(longestCode + 1);
  const offsets = new Int32Array(longestCode + 1);
  const symbols = new Uint16Array(lengths.length);
  let [code, place] = [0, 0];
  for (let length = 1; length <= longestCode; length++) {
    offsets[length] = code - place;
    for (let symbol = 0; symbol < lengths.length; symbol++) {
      if (lengths[symbol] !== length) continue;
      symbols[place++] = symbol;
      code++;
    }
    if (code > 2 ** length) throw corrupt('has a code with more words than there are');
    ends[length] = code * 2 ** (longestCode - length);
    code *= 2;
  }
  return { shortest: Math.min(...lengths), ends, offsets, symbols };
}

function readSymbol(bits: BitReader, { shortest, ends, offsets, symbols }: Code): number {
  const ahead = bits.peek(longestCode);
  let length = shortest;
  while (ahead >= ends[length]) if (++length > longestCode) throw corrupt('has a word that no code knows');
  bits.skip(length);
  return symbols[(ahead >>> (longestCode - length)) - offsets[length]];
}

/**
 * Reads the bytes of a block in their sorted order into the low bytes of `links`, and counts how often each occurs.
 * Symbols 0 and 1 are the digits, lowest first, of a run's length; the last symbol is the end; others are moves to the
 * front.
 * @returns bytes in the block
 */
function readSymbols(
  bits: BitReader,
  { alphabet, selectors, codes }: { alphabet: Uint8Array; selectors: Uint8Array; codes: readonly Code[] },
  { links, counts }: { links: Uint32Array; counts: Uint32Array },
): number {
  const recent = alphabet.slice();
  const end = alphabet.length + 1;
  let [length, run, digit] = [0, 0, 1];
  for (const selector of selectors) {
    const code = codes[selector];
    for (let i = 0; i < symbolsPerSelector; i++) {
      const symbol = readSymbol(bits, code);
      if (symbol < 2) {
        run += digit << symbol;
        digit *= 2;
        if (run > links.length) throw corrupt('has a run that is longer than a block');
        continue;
      }
      if (length + run > links.length) throw corrupt('has a block that is too long');
      if (run > 0) {
        links.fill(recent[0], length, length + run);
        counts[recent[0]] += run;
        length += run;
        [run, digit] = [0, 1];
      }
      if (symbol === end) return length;
      if (length >= links.length) throw corrupt('has a block that is too long');
      const byte = moveToFront(recent, symbol - 1);
      links[length++] = byte;
      counts[byte]++;
    }
  }
  throw corrupt('has a block without an end');
}

/** Writes a block's bytes in their own order. After four equal bytes, the next byte says how many more of them follow. */
function writeRuns({ links, first }: { links: Uint32Array; first: number }, output: Bunzip2Output): void {
  let place = first;
  let [previous, same] = [-1, 0];
  for (let i = 0; i < links.length; i++) {
    const link = links[place];
    const byte = link & 0xff;
    place = link >>> 8;
    if (same === 4) {
      output.write(previous, byte);
      same = 0;
      continue;
    }
    same = byte === previous ? same + 1 : 1;
    previous = byte;
    output.write(byte, 1);
  }
}
