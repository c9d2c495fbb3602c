// Bits of a JPEG stream, and the codes that are made of them. Source: ITU-T T.81, annexes C and F
import { corruptFile } from '../base/file-problem.ts';
import { PackedBits } from './packed-bits.ts';

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

/** Reads the codes of a JPEG stream. */
export class JpegBits extends PackedBits {
  constructor(bytes: Uint8Array, at: number, what: string) {
    super(bytes, at, 8, what);
  }

  /** @throws {VolumeViewError} `format/corrupt` */
  readSymbol(table: HuffmanTable): number {
    if (this.count < 16) this.fill();
    const found = table[(this.bits >>> (this.count - 16)) & 0xffff];
    if (found === 0)
      throw corruptFile(this.what, 'has packed pixels (JPEG) with a code that stands for nothing; copy the file again');
    this.count -= found >> 8;
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
    let { at } = this;
    while (at < this.bytes.length && !(this.bytes[at] === 0xff && (this.bytes[at + 1] & 0xf8) === 0xd0)) at++;
    if (at >= this.bytes.length) throw this.endsEarly();
    this.goTo(at + 2);
  }
}
