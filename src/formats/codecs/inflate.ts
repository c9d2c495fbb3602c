// Our own deflate decoder, for files with data after the end of a stream. The browser's DecompressionStream treats such
// data as damage and throws away what it had unpacked, and fflate does not say where a stream ends.
// Source: RFC 1951

/** How far back a stream can refer, bytes. */
const windowBytes = 2 ** 15;
const bufferBytes = 2 ** 17;
/** The longest copy that one code of a stream can make. */
const longestCopy = 258;
const longestCode = 15;

/** Lengths of copies: the base of each code, and the number of extra bits. Source: RFC 1951, 3.2.5 */
const lengthBases = [
  3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258,
];
const lengthBits = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
const distanceBases = [
  1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145,
  8193, 12289, 16385, 24577,
];
const distanceBits = [0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13];

/** The order in which a block lists the lengths of the code for its codes. */
const orderOfLengths = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

/** What is wrong with a stream: it ends early, or it is not deflate data. */
export class DeflateError extends Error {
  constructor(readonly isCut: boolean) {
    super(isCut ? 'ends early' : 'is damaged');
  }
}

/** Indexed by the next `bits` bits: the symbol that they begin with, times 16, plus its length. */
interface Code {
  readonly bits: number;
  readonly table: Uint16Array;
}

/** Unpacks streams one after another in the same memory: a file may hold millions of short ones. */
export class Inflater {
  readonly #buffer = new Uint8Array(bufferBytes);
  /** Bytes in the buffer, and how many of them were yielded. */
  #length = 0;
  #given = 0;
  #bytes = new Uint8Array(0);
  #position = 0;
  #pending = 0;
  #pendingBits = 0;

  /**
   * Unpacks one stream.
   * @param start - index of its first byte
   * @yields pieces, which the caller may keep
   * @returns index of the first byte after the stream
   * @throws {DeflateError}
   */
  *unpack(bytes: Uint8Array<ArrayBuffer>, start: number): Generator<Uint8Array<ArrayBuffer>, number> {
    this.#bytes = bytes;
    this.#position = start;
    this.#pending = this.#pendingBits = this.#length = this.#given = 0;
    for (let isLast = false; !isLast;) {
      isLast = this.#read(1) === 1;
      const kind = this.#read(2);
      if (kind === 3) throw new DeflateError(false);
      if (kind === 0) yield* this.#copyStored();
      else yield* this.#unpackBlock(...(kind === 1 ? fixedCodes() : this.#readCodes()));
    }
    yield* this.#give();
    return this.#position - (this.#pendingBits >> 3);
  }

  /** Copies a block that is stored without compression. */
  *#copyStored(): Generator<Uint8Array<ArrayBuffer>> {
    this.#read(this.#pendingBits & 7);
    const length = this.#read(16);
    if ((length ^ this.#read(16)) !== 0xffff) throw new DeflateError(false);
    this.#position -= this.#pendingBits >> 3;
    this.#pending = this.#pendingBits = 0;
    const end = this.#position + length;
    if (end > this.#bytes.length) throw new DeflateError(true);
    while (this.#position < end) {
      if (this.#length === bufferBytes) yield* this.#make();
      const part = this.#bytes.subarray(this.#position, Math.min(end, this.#position + bufferBytes - this.#length));
      this.#buffer.set(part, this.#length);
      this.#length += part.length;
      this.#position += part.length;
    }
  }

  *#unpackBlock(literals: Code, distances: Code): Generator<Uint8Array<ArrayBuffer>> {
    const buffer = this.#buffer;
    for (;;) {
      if (this.#length > bufferBytes - longestCopy) yield* this.#make();
      const symbol = this.#readSymbol(literals);
      if (symbol < 256) {
        buffer[this.#length++] = symbol;
        continue;
      }
      if (symbol === 256) return;
      const row = symbol - 257;
      if (row >= lengthBases.length) throw new DeflateError(false);
      const length = lengthBases[row] + this.#read(lengthBits[row]);
      const far = this.#readSymbol(distances);
      if (far >= distanceBases.length) throw new DeflateError(false);
      const distance = distanceBases[far] + this.#read(distanceBits[far]);
      if (distance > this.#length) throw new DeflateError(false);
      const end = this.#length + length;
      for (; this.#length < end; this.#length++) buffer[this.#length] = buffer[this.#length - distance];
    }
  }

  /** Yields the bytes in the buffer, and keeps those that later copies may refer to. */
  *#make(): Generator<Uint8Array<ArrayBuffer>> {
    yield* this.#give();
    this.#buffer.copyWithin(0, this.#length - windowBytes, this.#length);
    this.#length = this.#given = windowBytes;
  }

  *#give(): Generator<Uint8Array<ArrayBuffer>> {
    if (this.#length > this.#given) yield this.#buffer.slice(this.#given, this.#length);
    this.#given = this.#length;
  }

  /** Reads the codes of a block that has its own. */
  #readCodes(): [literals: Code, distances: Code] {
    const literals = 257 + this.#read(5);
    const distances = 1 + this.#read(5);
    const own = new Uint8Array(orderOfLengths.length);
    for (let i = 0, count = 4 + this.#read(4); i < count; i++) own[orderOfLengths[i]] = this.#read(3);
    const code = makeCode(own);
    const lengths = new Uint8Array(literals + distances);
    for (let at = 0; at < lengths.length;) {
      const symbol = this.#readSymbol(code);
      if (symbol < 16) {
        lengths[at++] = symbol;
        continue;
      }
      if (symbol === 16 && at === 0) throw new DeflateError(false);
      const value = symbol === 16 ? lengths[at - 1] : 0;
      const count = symbol === 16 ? 3 + this.#read(2) : symbol === 17 ? 3 + this.#read(3) : 11 + this.#read(7);
      if (at + count > lengths.length) throw new DeflateError(false);
      lengths.fill(value, at, (at += count));
    }
    return [makeCode(lengths.subarray(0, literals)), makeCode(lengths.subarray(literals))];
  }

  /** Reads ahead until at least `count` bits are there, zeros beyond the end. */
  #fill(count: number): void {
    while (this.#pendingBits < count) {
      this.#pending |= (this.#position < this.#bytes.length ? this.#bytes[this.#position] : 0) << this.#pendingBits;
      this.#position++;
      this.#pendingBits += 8;
    }
  }

  #drop(count: number): void {
    this.#pending >>>= count;
    this.#pendingBits -= count;
    if (this.#position - (this.#pendingBits >> 3) > this.#bytes.length) throw new DeflateError(true);
  }

  /** The next 0 to 16 bits, the lowest first. */
  #read(count: number): number {
    this.#fill(count);
    const value = this.#pending & ((1 << count) - 1);
    this.#drop(count);
    return value;
  }

  #readSymbol({ bits, table }: Code): number {
    this.#fill(bits);
    const entry = table[this.#pending & ((1 << bits) - 1)];
    if (entry === 0) throw new DeflateError(this.#position - (this.#pendingBits >> 3) >= this.#bytes.length);
    this.#drop(entry & 15);
    return entry >> 4;
  }
}

let fixed: [literals: Code, distances: Code] | undefined;

/** Source: RFC 1951, 3.2.6 */
function fixedCodes(): [literals: Code, distances: Code] {
  const lengthOf = (symbol: number): number => (symbol < 144 ? 8 : symbol < 256 ? 9 : symbol < 280 ? 7 : 8);
  return (fixed ??= [
    makeCode(Uint8Array.from({ length: 288 }, (_, symbol) => lengthOf(symbol))),
    makeCode(new Uint8Array(32).fill(5)),
  ]);
}

/**
 * @param lengths - of each symbol's code word, 0 if it has none
 * @throws {DeflateError} if there are more words than fit
 */
function makeCode(lengths: Uint8Array): Code {
  const bits = Math.max(1, ...lengths);
  const counts = new Uint16Array(longestCode + 2);
  for (const length of lengths) counts[length + 1] += length > 0 ? 1 : 0;
  const table = new Uint16Array(1 << bits);
  // The first word of each length.
  const words = new Uint32Array(longestCode + 2);
  for (let length = 1; length <= longestCode; length++) words[length] = (words[length - 1] + counts[length]) << 1;
  for (let symbol = 0; symbol < lengths.length; symbol++) {
    const length = lengths[symbol];
    if (length === 0) continue;
    const word = words[length]++;
    if (word >= 1 << length) throw new DeflateError(false);
    for (let at = reverse(word, length); at < table.length; at += 1 << length) table[at] = (symbol << 4) | length;
  }
  return { bits, table };
}

/** Code words are written from their highest bit on, all other numbers from their lowest. */
function reverse(word: number, length: number): number {
  let turned = 0;
  for (let bit = 0; bit < length; bit++) turned |= ((word >> bit) & 1) << (length - 1 - bit);
  return turned;
}
