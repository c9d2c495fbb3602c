// HDF5 files that no library would write: objects are placed one after another, and addresses and lengths are written as given, even if
// they are wrong. Checksums stay 0; the reader does not check them.

type Bytes = readonly number[] | Uint8Array;

const little = (value: number, bytes: number): number[] =>
  Array.from({ length: bytes }, (_, i) => Number((BigInt(value) >> BigInt(8 * i)) & 0xffn));
export const u16 = (value: number): number[] => little(value, 2);
export const u32 = (value: number): number[] => little(value, 4);
export const u64 = (value: number): number[] => (value < 0 ? Array.from({ length: 8 }, () => 0xff) : little(value, 8));
const text = (value: string): number[] => [...new TextEncoder().encode(value)];

/** The undefined address: nothing is stored. */
export const nowhere = -1;

/** A message of an object header. */
export interface Message {
  readonly type: number;
  readonly data: Bytes;
}

export const types = {
  uint8: [0x10, 0, 0, 0, ...u32(1), ...u16(0), ...u16(8)],
  float64: [0x11, 0x20, 63, 0, ...u32(8), ...u16(0), ...u16(64), 52, 11, 0, 52, ...u32(1023)],
  text: (bytes: number): number[] => [0x13, 0, 0, 0, ...u32(bytes)],
  /** Text of variable length, which is stored elsewhere. */
  anyText: [0x19, 1, 0, 0, ...u32(16), 0x13, 0, 0, 0, ...u32(1)],
};

export const shape = (...lengths: number[]): number[] =>
  lengths.length > 0 ? [2, lengths.length, 0, 1, ...lengths.flatMap(u64)] : [2, 0, 0, 0];

export const message = (type: number, data: Bytes): Message => ({ type, data });

/** @param value - a text, a number, or the type, shape and data of any other value */
export function attribute(
  name: string,
  value: string | number | { type: readonly number[]; shape: readonly number[]; data: Bytes },
): Message {
  const plain =
    typeof value === 'string'
      ? { type: types.text(value.length), shape: shape(), data: text(value) }
      : typeof value === 'number'
        ? { type: types.float64, shape: shape(), data: [...new Uint8Array(Float64Array.of(value).buffer)] }
        : value;
  const sizes = [name.length + 1, plain.type.length, plain.shape.length].flatMap(u16);
  return message(0x0c, [3, 0, ...sizes, 0, ...text(name), 0, ...plain.type, ...plain.shape, ...plain.data]);
}

export const link = (name: string, address: number): Message =>
  message(0x06, [1, 1, ...u16(name.length), ...text(name), ...u64(address)]);

export const contiguous = (address: number, bytes: number): Message =>
  message(0x08, [3, 1, ...u64(address), ...u64(bytes)]);

/** Indexed by a B-tree. */
export const chunked = (address: number, chunk: readonly number[], elementBytes: number): Message =>
  message(0x08, [3, 2, chunk.length + 1, ...u64(address), ...[...chunk, elementBytes].flatMap(u32)]);

/** Superblock of version 2; objects with headers of version 2. */
export class Hdf5Builder {
  #bytes: number[] = Array.from({ length: 48 }, () => 0);

  /** Add bytes to the file. @returns their address */
  place(bytes: Bytes): number {
    const address = this.#bytes.length;
    for (const byte of bytes) this.#bytes.push(byte);
    return address;
  }

  /** Add an object header. @returns its address */
  object(messages: readonly Message[]): number {
    const body = messages.flatMap(({ type, data }) => [type, ...u16(data.length), 0, ...data]);
    return this.place([...text('OHDR'), 2, 2, ...u32(body.length), ...body, 0, 0, 0, 0]);
  }

  /** @param more - more messages, for example the layout of its values; by default nothing is stored */
  array(
    type: readonly number[],
    lengths: readonly number[],
    more: readonly Message[] = [contiguous(nowhere, 0)],
  ): number {
    return this.object([message(0x01, shape(...lengths)), message(0x03, type), ...more]);
  }

  group(links: Readonly<Record<string, number>>, attributes: Readonly<Record<string, string | number>> = {}): number {
    return this.object([
      ...Object.entries(links).map(([name, address]) => link(name, address)),
      ...Object.entries(attributes).map(([name, value]) => attribute(name, value)),
    ]);
  }

  /** @param root - address of its header */
  build(root: number): Uint8Array<ArrayBuffer> {
    const head = [
      0x89,
      ...text('HDF'),
      13,
      10,
      26,
      10,
      2,
      8,
      8,
      0,
      ...u64(0),
      ...u64(nowhere),
      ...u64(this.#bytes.length),
      ...u64(root),
    ];
    return Uint8Array.from([...head, ...this.#bytes.slice(head.length)]);
  }

  /** A scan of ODIM_H5. @param datasets - addresses of groups 'dataset…' */
  buildOdim(datasets: readonly number[]): Uint8Array<ArrayBuffer> {
    const what = this.group({}, { object: 'PVOL' });
    const links = Object.fromEntries(datasets.map((address, i) => [`dataset${i + 1}`, address]));
    return this.build(this.group({ what, ...links }, { Conventions: 'ODIM_H5/V2_2' }));
  }

  /** A group 'dataset…' of ODIM_H5 with one moment. @param data - address of its array */
  odimSweep(data: number, where: Readonly<Record<string, number>>): number {
    const what = this.group({}, { quantity: 'DBZH', gain: 0.5, offset: -32 });
    return this.group({ where: this.group({}, where), data1: this.group({ what, data }) });
  }
}
