// The two codes of Zstandard. Source: RFC 8878, 4.1 (finite state entropy) and 4.2 (Huffman)
import { VolumeViewError } from '../../core/errors.ts';

export function corruptZstd(problem: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `the Zstandard data ${problem}; the file is damaged, fetch it again`);
}

/** Reads bits from the last one to the first one. Before the first one, all are 0. */
export class BackwardBits {
  /** The number of bits that are left; below 0 where more were read than there are. */
  left: number;

  /** @param end - the last byte has a 1 where the bits end */
  constructor(
    private readonly bytes: Uint8Array,
    private readonly start: number,
    end: number,
  ) {
    const last = end > start ? bytes[end - 1] : 0;
    if (last === 0) throw corruptZstd('has bits without an end');
    this.left = 8 * (end - 1 - start) + 31 - Math.clz32(last);
  }

  /** The next 0 to 16 bits, without consuming them. */
  peek(width: number): number {
    const at = this.left - width;
    if (at >= 0) return this.at(at) & ((1 << width) - 1);
    const here = width + at;
    return here > 0 ? (this.at(0) & ((1 << here) - 1)) << -at : 0;
  }

  /** The next 0 to 31 bits. */
  read(width: number): number {
    if (width > 16) {
      const high = this.read(width - 16);
      return high * 65536 + this.read(16);
    }
    const value = this.peek(width);
    this.left -= width;
    return value;
  }

  /** At least 17 bits from a place on. */
  private at(bit: number): number {
    const byte = this.start + (bit >> 3);
    const { bytes } = this;
    return (bytes[byte] | (bytes[byte + 1] << 8) | (bytes[byte + 2] << 16)) >> (bit & 7);
  }
}

/** A code of states: each has a symbol, and the bits of the next state are added to a base. */
export interface StateCode {
  readonly log: number;
  readonly symbols: Uint8Array;
  readonly widths: Uint8Array;
  readonly bases: Uint16Array;
}

/** A code that always gives the same symbol. */
export const oneSymbol = (symbol: number): StateCode => ({
  log: 0,
  symbols: Uint8Array.of(symbol),
  widths: Uint8Array.of(0),
  bases: Uint16Array.of(0),
});

/** @param shares - of the states, for each symbol; -1 for a share below one */
export function makeStateCode(log: number, shares: readonly number[]): StateCode {
  const size = 1 << log;
  const symbols = new Uint8Array(size);
  const next = new Uint16Array(shares.length);
  let high = size;
  shares.forEach((share, symbol) => {
    if (share === -1) symbols[--high] = symbol;
    next[symbol] = Math.abs(share);
  });
  const step = (size >> 1) + (size >> 3) + 3;
  let place = 0;
  shares.forEach((share, symbol) => {
    for (let i = 0; i < share; i++) {
      symbols[place] = symbol;
      do place = (place + step) & (size - 1);
      while (place >= high);
    }
  });
  const [widths, bases] = [new Uint8Array(size), new Uint16Array(size)];
  for (let state = 0; state < size; state++) {
    const number = next[symbols[state]]++;
    widths[state] = log - (31 - Math.clz32(number));
    bases[state] = (number << widths[state]) - size;
  }
  return { log, symbols, widths, bases };
}

/**
 * Reads the shares of a code.
 * @param end - of the bytes that it may have
 * @returns the code, and where its description ends
 */
export function readStateCode(
  bytes: Uint8Array,
  { start, end }: { readonly start: number; readonly end: number },
  maxLog: number,
  maxSymbol: number,
): { code: StateCode; end: number } {
  let bit = 8 * start;
  const peek = (width: number): number =>
    ((bytes[bit >> 3] | (bytes[(bit >> 3) + 1] << 8) | (bytes[(bit >> 3) + 2] << 16)) >> (bit & 7)) &
    ((1 << width) - 1);
  const log = peek(4) + 5;
  bit += 4;
  if (log > maxLog) throw corruptZstd(`has a code of 2^${log} states; expected at most 2^${maxLog}`);
  const shares: number[] = [];
  let left = 1 << log;
  while (left > 0 && shares.length <= maxSymbol && bit < 8 * end) {
    const width = 32 - Math.clz32(left + 1);
    const few = (1 << width) - 2 - left;
    const low = peek(width - 1);
    const isShort = low < few;
    const whole = peek(width);
    const value = isShort ? low : whole >= 1 << (width - 1) ? whole - few : whole;
    bit += isShort ? width - 1 : width;
    const share = value - 1;
    shares.push(share);
    left -= Math.abs(share);
    if (share !== 0) continue;
    for (let zeros = 3; zeros === 3 && shares.length <= maxSymbol + 1;) {
      zeros = peek(2);
      bit += 2;
      for (let i = 0; i < zeros; i++) shares.push(0);
    }
  }
  const after = (bit + 7) >> 3;
  if (left !== 0 || shares.length > maxSymbol + 1 || after > end) throw corruptZstd('has a code that is not whole');
  return { code: makeStateCode(log, shares), end: after };
}

/** Indexed by the next `bits` bits: the symbol that they begin with, times 16, plus its length. */
export interface HuffmanCode {
  readonly bits: number;
  readonly table: Uint16Array;
}

const maxHuffmanBits = 11;

/** @returns the code, and where its description ends */
export function readHuffmanCode(bytes: Uint8Array, start: number, end: number): { code: HuffmanCode; end: number } {
  if (start >= end) throw corruptZstd('ends early');
  const head = bytes[start];
  const after = start + 1 + (head < 128 ? head : (head - 126) >> 1);
  if (after > end) throw corruptZstd('ends early');
  const weights =
    head < 128
      ? readWeights(bytes, start + 1, after)
      : Array.from({ length: head - 127 }, (_, i) => (bytes[start + 1 + (i >> 1)] >> (i & 1 ? 0 : 4)) & 15);
  return { code: makeHuffmanCode(weights), end: after };
}

function readWeights(bytes: Uint8Array, start: number, end: number): number[] {
  const { code, end: from } = readStateCode(bytes, { start, end }, 6, 255);
  const bits = new BackwardBits(bytes, from, end);
  const states = [bits.read(code.log), bits.read(code.log)];
  const weights: number[] = [];
  for (let turn = 0; weights.length < 255; turn ^= 1) {
    const state = states[turn];
    weights.push(code.symbols[state]);
    states[turn] = code.bases[state] + bits.read(code.widths[state]);
    if (bits.left >= 0) continue;
    weights.push(code.symbols[states[turn ^ 1]]);
    return weights;
  }
  throw corruptZstd('has a code that is not whole');
}

/** @param weights - of all symbols but the last one: 0 for none, else the longer the code, the smaller */
function makeHuffmanCode(weights: readonly number[]): HuffmanCode {
  const sum = weights.reduce((all, weight) => all + (weight > 0 ? 2 ** (weight - 1) : 0), 0);
  const bits = 32 - Math.clz32(sum);
  const last = 2 ** bits - sum;
  if (sum === 0 || bits > maxHuffmanBits || (last & (last - 1)) !== 0)
    throw corruptZstd('has a code with more words than there are');
  const all = [...weights, 32 - Math.clz32(last)];
  const table = new Uint16Array(1 << bits);
  let place = 0;
  for (let weight = 1; weight <= bits; weight++) {
    all.forEach((one, symbol) => {
      if (one !== weight) return;
      table.fill(symbol * 16 + bits + 1 - weight, place, place + 2 ** (weight - 1));
      place += 2 ** (weight - 1);
    });
  }
  return { bits, table };
}

/** Fills `out` with symbols. */
export function readHuffman(bits: BackwardBits, { bits: width, table }: HuffmanCode, out: Uint8Array): void {
  for (let i = 0; i < out.length; i++) {
    const found = table[bits.peek(width)];
    out[i] = found >> 4;
    bits.left -= found & 15;
  }
  if (bits.left !== 0) throw corruptZstd('has bytes that end elsewhere than they say');
}
