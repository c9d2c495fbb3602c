// Bits of a JPEG stream, and the codes that are made of them. Source: ITU-T T.81, annexes C and F
import { corruptFile } from '../base/file-problem.ts';

/** For each 16 bits: 256 times the length of the code that they begin with, plus its symbol; 0 for no code. */
export type HuffmanTable = Uint16Array;

/** @param counts - of codes of 1 to 16 bits @returns null where they are too many */
export function makeHuffmanTable(counts: Uint8Array, symbols: Uint8Array): HuffmanTable | null {
  const table = new Uint16Array(2 ** 16);
  let [next, code] = [0, 0];
  for (let length = 1; length <= 16; length++) {
    for (let i = 0; i < counts[length - 1]; i++, code += 2 ** (16 - length)) {
      if (code >= 2 ** 16) return null;
      table.fill(256 * length + symbols[next++], code, code + 2 ** (16 - length));
    }
  }
  return table;
}

/** Reads bits. After the bytes 255 and 0 stands a 255; any other byte after 255 ends the bits. Behind their end are zeros. */
export class JpegBits {
  #bits = 0;
  #count = 0;
  /** Zeros that are not in the stream. */
  #added = 0;

  constructor(
    readonly bytes: Uint8Array,
    private at: number,
    private readonly what: string,
  ) {}

  /** 1 to 16 bits. */
  read(count: number): number {
    if (this.#count < count) this.#fill();
    this.#count -= count;
    return (this.#bits >>> this.#count) & (2 ** count - 1);
  }

  /** @throws {VolumeViewError} `format/corrupt` */
  readSymbol(table: HuffmanTable): number {
    if (this.#count < 16) this.#fill();
    const found = table[(this.#bits >>> (this.#count - 16)) & 0xffff];
    if (found === 0)
      throw corruptFile(this.what, 'has packed pixels (JPEG) with a code that stands for nothing; copy the file again');
    this.#count -= found >> 8;
    return found & 0xff;
  }

  /** A number of so many bits, half of which are negative. */
  readSigned(count: number): number {
    if (count === 0) return 0;
    const bits = this.read(count);
    return bits < 2 ** (count - 1) ? bits - 2 ** count + 1 : bits;
  }

  /** Goes on behind the next mark that the coder starts again. @throws {VolumeViewError} `format/corrupt` */
  restart(): void {
    this.#bits = this.#count = this.#added = 0;
    while (this.at < this.bytes.length && !(this.bytes[this.at] === 0xff && (this.bytes[this.at + 1] & 0xf8) === 0xd0))
      this.at++;
    if (this.at >= this.bytes.length) throw this.#endsEarly();
    this.at += 2;
  }

  /** @throws {VolumeViewError} `format/corrupt` if bits were read that are not in the stream */
  check(): void {
    if (this.#added > this.#count) throw this.#endsEarly();
  }

  #endsEarly(): Error {
    return corruptFile(this.what, 'has packed pixels (JPEG) that end early; copy the file again');
  }

  #fill(): void {
    while (this.#count <= 16) {
      const byte = this.bytes[this.at];
      const isEnd = byte === undefined || (byte === 0xff && this.bytes[this.at + 1] !== 0);
      if (isEnd) this.#added += 8;
      else this.at += byte === 0xff ? 2 : 1;
      this.#bits = (this.#bits << 8) | (isEnd ? 0 : byte);
      this.#count += 8;
    }
  }
}
