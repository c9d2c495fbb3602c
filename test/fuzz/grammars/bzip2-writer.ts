// A small packer of bzip2: no package of npm packs, and what is packed here need not be small. Sources: as src/formats/codecs/bunzip2.ts.

const crcTable = Int32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte << 24;
  for (let bit = 0; bit < 8; bit++) crc = (crc << 1) ^ (crc < 0 ? 0x04c11db7 : 0);
  return crc;
});

/** One block: its symbols after all steps but the codes, and the checksum of what comes out. */
interface Block {
  readonly symbols: readonly number[];
  /** Bytes that occur, ascending. */
  readonly used: readonly number[];
  readonly origin: number;
  readonly crc: number;
}

export interface Bzip2Options {
  /** Hundreds of thousands of bytes of a block, 1 to 9. */
  readonly level?: number;
  /** Added to checksums. */
  readonly wrong?: number;
}

/** Pack some bytes, a few thousand at most. */
export function bzip2(bytes: Uint8Array, options: Bzip2Options = {}): Uint8Array<ArrayBuffer> {
  return writeStream(bytes.length > 0 ? [packBlock(bytes)] : [], options);
}

/** Blocks that are full of runs of one byte, 5 bytes of which stand for 255: 45 MB from 50 bytes, at level 9. */
export function bzip2OfRuns(blocks: number, runs: number, options: Bzip2Options = {}): Uint8Array<ArrayBuffer> {
  const byte = 251;
  let crc = -1;
  for (let i = 0; i < 255 * runs; i++) crc = (crc << 8) ^ crcTable[(crc >>> 24) ^ byte];
  const block: Block = { symbols: [...packZeros(5 * runs), 2], used: [byte], origin: 0, crc: ~crc >>> 0 };
  return writeStream(
    Array.from({ length: blocks }, () => block),
    options,
  );
}

function packBlock(bytes: Uint8Array): Block {
  let crc = -1;
  for (const byte of bytes) crc = (crc << 8) ^ crcTable[(crc >>> 24) ^ byte];
  const runs = packRuns(bytes);
  const turns = Uint32Array.from(runs, (_, i) => i);
  turns.sort((a, b) => {
    for (let i = 0; i < runs.length; i++) {
      const difference = runs[(a + i) % runs.length] - runs[(b + i) % runs.length];
      if (difference) return difference;
    }
    return a - b;
  });
  const last = Array.from(turns, (turn) => runs[(turn + runs.length - 1) % runs.length]);
  const used = [...new Set(runs)];
  used.sort((a, b) => a - b);
  return { symbols: moveToFront(last, used), used, origin: turns.indexOf(0), crc: ~crc >>> 0 };
}

/** Four of a byte, and how many more there are. */
function packRuns(bytes: Uint8Array): number[] {
  const runs: number[] = [];
  for (let at = 0; at < bytes.length;) {
    let length = 1;
    while (length < 255 && bytes[at + length] === bytes[at]) length++;
    for (let i = 0; i < Math.min(4, length); i++) runs.push(bytes[at]);
    if (length >= 4) runs.push(length - 4);
    at += length;
  }
  return runs;
}

function moveToFront(bytes: readonly number[], used: readonly number[]): number[] {
  const order = [...used];
  const symbols: number[] = [];
  let zeros = 0;
  for (const byte of bytes) {
    const place = order.indexOf(byte);
    if (place === 0) {
      zeros++;
      continue;
    }
    symbols.push(...packZeros(zeros), place + 1);
    zeros = 0;
    order.unshift(...order.splice(place, 1));
  }
  return [...symbols, ...packZeros(zeros), used.length + 1];
}

/** A count in digits of 1 and 2. */
function packZeros(count: number): number[] {
  const digits: number[] = [];
  for (let rest = count; rest > 0; rest = Math.floor((rest - 1) / 2)) digits.push((rest - 1) % 2);
  return digits;
}

function writeStream(blocks: readonly Block[], { level = 9, wrong = 0 }: Bzip2Options): Uint8Array<ArrayBuffer> {
  const bits = new BitWriter();
  for (const byte of [0x42, 0x5a, 0x68, 0x30 + level]) bits.write(byte, 8);
  let all = 0;
  for (const block of blocks) {
    writeBlock(bits, block, wrong);
    all = (((all << 1) | (all >>> 31)) ^ block.crc) >>> 0;
  }
  bits
    .write(0x177245, 24)
    .write(0x385090, 24)
    .write(all >>> 16, 16)
    .write((all + wrong) & 0xffff, 16);
  return bits.finish();
}

function writeBlock(bits: BitWriter, { symbols, used, origin, crc }: Block, wrong: number): void {
  bits
    .write(0x314159, 24)
    .write(0x265359, 24)
    .write(crc >>> 16, 16)
    .write((crc + wrong) & 0xffff, 16);
  bits.write(0, 1).write(origin, 24);
  const isUsed = (byte: number): number => Number(used.includes(byte));
  for (let high = 0; high < 16; high++) bits.write(Number(used.some((byte) => byte >> 4 === high)), 1);
  for (let high = 0; high < 16; high++) {
    if (used.some((byte) => byte >> 4 === high))
      for (let low = 0; low < 16; low++) bits.write(isUsed(16 * high + low), 1);
  }
  const count = used.length + 2;
  const width = Math.ceil(Math.log2(count));
  const selectors = Math.ceil(symbols.length / 50);
  bits.write(2, 3).write(selectors, 15);
  for (let i = 0; i < selectors; i++) bits.write(0, 1);
  for (let table = 0; table < 2; table++) {
    bits.write(width, 5);
    for (let i = 0; i < count; i++) bits.write(0, 1);
  }
  for (const symbol of symbols) bits.write(symbol, width);
}

class BitWriter {
  readonly #bytes: number[] = [];
  #used = 0;

  write(value: number, width: number): this {
    for (let bit = width - 1; bit >= 0; bit--, this.#used++) {
      if (this.#used % 8 === 0) this.#bytes.push(0);
      if ((value >>> bit) & 1) this.#bytes[this.#bytes.length - 1] |= 0x80 >> (this.#used % 8);
    }
    return this;
  }

  finish(): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(this.#bytes);
  }
}
