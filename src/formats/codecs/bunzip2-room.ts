import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';

// The memory that bunzip2.ts works in.

/**
 * The memory that unpacking needs besides its output. Streams that are unpacked one after another share it: a stream
 * without any block takes only 14 bytes of a file.
 */
export class Bunzip2Room {
  readonly budget: Budget;
  #links = new Uint32Array(0);

  constructor(budget: Budget) {
    this.budget = budget;
  }

  /** Memory for the largest block of a stream, allocated with the first block. */
  links(length: number): Uint32Array<ArrayBuffer> {
    if (this.#links.length < length) {
      this.budget.take(4 * (length - this.#links.length), 'a bzip2 block');
      this.#links = new Uint32Array(length);
    }
    return this.#links.subarray(0, length);
  }

  /** Gives all of it back to the budget. */
  release(): void {
    this.budget.giveBack(this.#links.byteLength);
    this.#links = new Uint32Array(0);
  }
}

/** The first size of the output buffer, bytes. It is allocated with the first byte. */
const firstOutput = 2 ** 16;

/** The output, its checksum, and its limit. */
export class Bunzip2Output {
  private bytes = new Uint8Array(0);
  private length = 0;
  private crc = 0;

  constructor(
    private readonly atMost: number,
    readonly budget: Budget,
  ) {}

  startBlock(): void {
    this.crc = -1;
  }

  write(byte: number, count: number): void {
    const end = this.length + count;
    if (end > this.atMost) {
      throw new VolumeViewError(
        'format/too-large',
        `the bzip2 data unpack to more than ${this.atMost.toLocaleString('en')} bytes; check the file`,
      );
    }
    if (end > this.bytes.length) this.grow(end);
    while (this.length < end) {
      this.bytes[this.length++] = byte;
      this.crc = (this.crc << 8) ^ crcTable[(this.crc >>> 24) ^ byte];
    }
  }

  checksum(): number {
    return ~this.crc >>> 0;
  }

  finish(): Uint8Array<ArrayBuffer> {
    this.budget.take(this.length, 'the bzip2 data');
    this.budget.giveBack(this.length);
    return this.bytes.slice(0, this.length);
  }

  /** Gives the output's memory back to the budget. */
  release(): void {
    this.budget.giveBack(this.bytes.length);
  }

  private grow(end: number): void {
    const length = Math.min(this.atMost, Math.max(end, 2 * this.bytes.length, firstOutput));
    this.budget.take(length, 'the bzip2 data');
    const larger = new Uint8Array(length);
    larger.set(this.bytes);
    this.budget.giveBack(this.bytes.length);
    this.bytes = larger;
  }
}

/** CRC-32 with the polynomial 0x04c11db7, the highest bit first. */
const crcTable = Int32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte << 24;
  for (let bit = 0; bit < 8; bit++) crc = (crc << 1) ^ (crc < 0 ? 0x04c11db7 : 0);
  return crc;
});

export function corruptBzip2(what: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `the bzip2 data ${what}; the file is damaged, fetch it again`);
}
