/** Writes numbers one after another, and back into what is written. */
export class ByteWriter {
  #bytes = new Uint8Array(1024);
  #view = new DataView(this.#bytes.buffer);
  #length = 0;
  readonly little: boolean;

  constructor(little: boolean) {
    this.little = little;
  }

  get length(): number {
    return this.#length;
  }

  u8(...values: number[]): this {
    return this.#numbers(values, 1, 'setUint8');
  }

  u16(...values: number[]): this {
    return this.#numbers(values, 2, 'setUint16');
  }

  u32(...values: number[]): this {
    return this.#numbers(values, 4, 'setUint32');
  }

  u64(...values: number[]): this {
    for (const value of values) this.#room(8).setBigUint64(this.#length - 8, toBigInt(value), this.little);
    return this;
  }

  f32(...values: number[]): this {
    return this.#numbers(values, 4, 'setFloat32');
  }

  f64(...values: number[]): this {
    return this.#numbers(values, 8, 'setFloat64');
  }

  #numbers(
    values: readonly number[],
    size: number,
    set: 'setUint8' | 'setUint16' | 'setUint32' | 'setFloat32' | 'setFloat64',
  ): this {
    for (const value of values) this.#room(size)[set](this.#length - size, value, this.little);
    return this;
  }

  text(value: string): this {
    return this.put(latin1(value));
  }

  put(bytes: Uint8Array): this {
    this.#room(bytes.length);
    this.#bytes.set(bytes, this.#length - bytes.length);
    return this;
  }

  zeros(count: number): this {
    this.#room(count);
    return this;
  }

  /** Zeros up to a multiple of `step`. */
  pad(step: number): this {
    return this.zeros((step - (this.#length % step)) % step);
  }

  /** Write into what is there. */
  patch(at: number, bytes: Uint8Array): void {
    this.#bytes.set(bytes.subarray(0, Math.max(0, this.#length - at)), at);
  }

  finish(): Uint8Array<ArrayBuffer> {
    return this.#bytes.slice(0, this.#length);
  }

  /** So many more bytes. @returns where to write, as `setUint8` does it */
  #room(count: number): DataView {
    this.#length += count;
    if (this.#length > this.#bytes.length) {
      const larger = new Uint8Array(2 * this.#length);
      larger.set(this.#bytes);
      this.#bytes = larger;
      this.#view = new DataView(larger.buffer);
    }
    return this.#view;
  }
}

export const little = (): ByteWriter => new ByteWriter(true);
export const big = (): ByteWriter => new ByteWriter(false);

export function latin1(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(text, (character) => character.charCodeAt(0));
}

export function concat(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** All bits set for what is no number of 64 bits. */
function toBigInt(value: number): bigint {
  return Number.isFinite(value) && value < 2 ** 64 ? BigInt.asUintN(64, BigInt(Math.trunc(value))) : 2n ** 64n - 1n;
}

const crcTable = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

/** The checksum of PNG's chunks and of gzip. Source: W3C, PNG 3, annex D */
export function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = (crc >>> 8) ^ crcTable[(crc ^ byte) & 0xff];
  return ~crc >>> 0;
}
