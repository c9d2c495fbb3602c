import { deflateSync } from 'node:zlib';
import { latin1, little } from '../bytes.ts';
import type { ByteWriter } from '../bytes.ts';
import type { Random } from '../random.ts';
import type { NumberName, TreeArray, TreeValue } from './radar-trees.ts';

// Parts of an HDF5 file, each with what may be wrong with it. Source: HDF5 File Format Specification 3.0

export interface Message {
  readonly type: number;
  readonly data: Uint8Array;
  readonly flags?: number;
}

const none = 2 ** 64;

/** A file that grows at its end: what is referred to is written before what refers to it. */
export class Hdf5Writer {
  readonly out = little();
  readonly random: Random;
  /** Addresses of what was written, for links that lead where they should not. */
  readonly places: number[] = [];
  /** Heaps by the text in them. */
  readonly #heaps = new Map<string, number>();

  constructor(random: Random) {
    this.random = random;
    this.out.zeros(48); // The superblock, which is known last.
  }

  /** @returns the address of what is written */
  put(bytes: Uint8Array): number {
    this.out.pad(8);
    const address = this.out.length;
    this.out.put(bytes);
    this.places.push(address);
    return address;
  }

  /** An address, or now and then another one: of another part, of what holds this one, or of nothing. */
  address(sound: number): number {
    const { random } = this;
    if (!random.isWild()) return sound;
    return random.chance(0.7) ? random.pick(this.places) : random.pick([0, none, this.out.length, random.size(sound)]);
  }

  /** Superblock of version 2, and the end. */
  finish(root: number): Uint8Array<ArrayBuffer> {
    const { random } = this;
    const block = little()
      .text('\x89HDF\r\n\x1a\n')
      .u8(random.or(2, 0, 1, 3, 4), random.or(8, 4, 2, 16), random.or(8, 4, 2), 0);
    block
      .u64(random.or(0, 8, none))
      .u64(none)
      .u64(random.size(this.out.length))
      .u64(this.address(root))
      .u32(0);
    this.out.patch(0, block.finish());
    return this.out.finish();
  }

  /** An object header of version 2, or of version 1; the last messages may lie in a block of their own. */
  header(messages: readonly Message[]): number {
    return this.random.chance(0.3)
      ? this.#oldHeader(this.random.shuffle(messages))
      : this.#newHeader(this.random.shuffle(messages));
  }

  #newHeader(messages: readonly Message[]): number {
    const { random } = this;
    const pack = (list: readonly Message[]): Uint8Array =>
      list
        .reduce(
          (out, { type, data, flags = 0 }) =>
            out.u8(type).u16(random.size(data.length)).u8(random.or(flags, 2)).put(data),
          little(),
        )
        .finish();
    const split = messages.length > 1 && random.chance(0.2) ? random.int(1, messages.length - 1) : messages.length;
    let first = messages.slice(0, split);
    if (split < messages.length) {
      const rest = pack(messages.slice(split));
      const block = this.put(little().text('OCHK').put(rest).u32(0).finish());
      first = [
        ...first,
        {
          type: 0x10,
          data: little()
            .u64(this.address(block))
            .u64(random.size(rest.length + 8))
            .finish(),
        },
      ];
    }
    const body = pack(first);
    return this.put(little().text('OHDR').u8(2, 2).u32(random.size(body.length)).put(body).u32(0).finish());
  }

  #oldHeader(messages: readonly Message[]): number {
    const { random } = this;
    const body = little();
    for (const { type, data, flags = 0 } of messages) {
      const padded = Math.ceil(data.length / 8) * 8;
      body
        .u16(type)
        .u16(random.size(padded))
        .u8(flags, 0, 0, 0)
        .put(data)
        .zeros(padded - data.length);
    }
    return this.put(
      little()
        .u8(1, 0)
        .u16(random.size(messages.length))
        .u32(1)
        .u32(random.size(body.length))
        .u32(0)
        .put(body.finish())
        .finish(),
    );
  }

  /** An attribute in a message of version 3, its text in the message or in a heap elsewhere. */
  attribute(name: string, value: TreeValue): Message {
    const { random } = this;
    const isText = typeof value === 'string';
    const isElsewhere = isText && random.chance(0.3);
    const type = !isText
      ? numberType(value.type)
      : isElsewhere
        ? textElsewhereType()
        : textType(Math.max(1, value.length));
    const one = !isText && value.numbers.length === 1;
    const shape = isText || one ? shapeOf(random, []) : shapeOf(random, [value.numbers.length]);
    const data = !isText ? packNumbers(value.type, value.numbers) : isElsewhere ? this.textPlace(value) : latin1(value);
    const title = latin1(`${name}\0`);
    const head = little()
      .u8(random.or(3, 1, 2), 0)
      .u16(random.size(title.length))
      .u16(random.size(type.length))
      .u16(random.size(shape.length))
      .u8(0);
    return { type: 0x0c, data: head.put(title).put(type).put(shape).put(data).finish() };
  }

  /** What leads to a text: a heap that all texts of the file share, or one of its own. */
  textPlace(value: string): Uint8Array {
    const { random } = this;
    let heap = this.#heaps.get(value);
    if (heap === undefined) {
      const bytes = latin1(value);
      const size = 16 + 16 + Math.ceil(bytes.length / 8) * 8 + 16;
      const out = little()
        .text('GCOL')
        .u8(1, 0, 0, 0)
        .u64(random.size(size))
        .u16(1, 1)
        .u32(0)
        .u64(random.size(bytes.length))
        .put(bytes)
        .pad(8)
        .u16(0, 0)
        .u32(0)
        .u64(16);
      heap = this.put(out.finish());
      this.#heaps.set(value, heap);
    }
    return little()
      .u32(random.size(value.length))
      .u64(this.address(heap))
      .u32(random.or(1, 0, 2))
      .finish();
  }

  /** Messages that say what an array is and where its elements are. */
  array({ type, shape: sound, numbers, attributes }: TreeArray): Message[] {
    const { random } = this;
    const isSwollen = sound.length > 0 && random.isHostile();
    const shape = isSwollen ? sound.map((n) => n * random.pick([1, 1, 30, 1000, 50_000])) : sound;
    const data = type === 'text' ? Uint8Array.from(numbers) : packNumbers(type, numbers);
    const elementBytes = type === 'text' ? 1 : bytesOf(type);
    const filters = random.chance(0.6) ? listFilters(random, elementBytes) : [];
    const layout = isSwollen
      ? this.#swollen(shape, elementBytes, filters)
      : shape.length > 0 && (filters.length > 0 || random.chance(0.3))
        ? this.#chunked({ data, shape, elementBytes, filters })
        : this.#whole(data);
    return [
      { type: 0x01, data: shapeOf(random, shape) },
      { type: 0x03, data: type === 'text' ? textType(1) : numberType(type) },
      ...(random.chance(0.3)
        ? [
            {
              type: 0x05,
              data: little().u8(3, 0x20).u32(random.size(elementBytes)).put(random.bytes(elementBytes)).finish(),
            },
          ]
        : []),
      ...(filters.length > 0 ? [{ type: 0x0b, data: packFilters(random, filters) }] : []),
      { type: 0x08, data: layout },
      ...Object.entries(attributes).map(([name, value]) => this.attribute(name, value)),
    ];
  }

  #whole(data: Uint8Array): Uint8Array {
    const { random } = this;
    if (random.chance(0.3)) return little().u8(3, 0).u16(random.size(data.length)).put(data).finish();
    return little()
      .u8(3, 1)
      .u64(random.or(this.address(this.put(data)), none))
      .u64(random.size(data.length))
      .finish();
  }

  /** An array that is far larger than what is stored of it: never written, or a chunk of zeros. */
  #swollen(shape: readonly number[], elementBytes: number, filters: readonly Filter[]): Uint8Array {
    const { random } = this;
    if (filters.length === 0 || random.chance(0.5)) return little().u8(3, 1).u64(none, 0).finish();
    const chunk = shape.map((n) => Math.min(n, random.pick([1, 100, 3000])));
    const bytes = chunk.reduce((product, n) => product * n, elementBytes);
    return this.#chunked({ data: new Uint8Array(Math.min(bytes, 2 ** 21)), shape: chunk, elementBytes, filters });
  }

  /** Chunks in a B-tree of version 1, or one chunk with the newest layout. */
  #chunked({
    data,
    shape,
    elementBytes,
    filters,
  }: {
    data: Uint8Array;
    shape: readonly number[];
    elementBytes: number;
    filters: readonly Filter[];
  }): Uint8Array {
    const { random } = this;
    const stored = filters.reduce((bytes, { apply }) => apply(bytes), data);
    const place = this.put(stored);
    if (random.chance(0.4)) {
      const kind = random.or(1, 2, 3, 4, 5);
      const out = little()
        .u8(4, 2, filters.length > 0 ? 2 : 0, shape.length + 1, 8)
        .u64(...shape.map((n) => random.size(n)), elementBytes)
        .u8(kind);
      if (kind === 1 && filters.length > 0) out.u64(random.size(stored.length)).u32(random.or(0, 1, 0xff));
      if (kind === 3) out.u8(10);
      return out.u64(this.address(place)).finish();
    }
    const rows = shape[0];
    const keys = random.shuffle([0]).map((row) => ({ row: random.size(row), bytes: random.size(stored.length) }));
    const key = ({ row, bytes }: { row: number; bytes: number }): Uint8Array =>
      little()
        .u32(bytes, random.or(0, 1, 0xff))
        .u64(row, ...shape.slice(1).map(() => 0), 0)
        .finish();
    const tree = little()
      .text('TREE')
      .u8(random.or(1, 0), random.or(0, 1, 255))
      .u16(random.size(keys.length))
      .u64(none, none);
    for (const one of keys) tree.put(key(one)).u64(this.address(place));
    tree.put(key({ row: rows, bytes: 0 }));
    return little()
      .u8(3, 2, shape.length + 1)
      .u64(random.or(this.address(this.put(tree.finish())), none))
      .u32(...shape.map((n) => random.size(n)), elementBytes)
      .finish();
  }
}

interface Filter {
  readonly id: number;
  readonly parameters: readonly number[];
  readonly apply: (bytes: Uint8Array) => Uint8Array;
}

function listFilters(random: Random, elementBytes: number): Filter[] {
  const deflate: Filter = {
    id: random.or(1, 32000, 4),
    parameters: [random.size(6)],
    apply: (bytes) => deflateSync(bytes),
  };
  const shuffle: Filter = {
    id: 2,
    parameters: [random.size(elementBytes)],
    apply: (bytes) => shuffleBytes(bytes, elementBytes),
  };
  return random.shuffle(random.chance(0.5) ? [shuffle, deflate] : [deflate]);
}

/** As they are, or one of them again and again. */
function packFilters(random: Random, filters: readonly Filter[]): Uint8Array {
  const all = random.isWild() ? Array.from({ length: random.pick([2, 33, 255]) }, () => random.pick(filters)) : filters;
  return all
    .reduce(
      (out, { id, parameters }) =>
        (id >= 256 ? out.u16(id, 0) : out.u16(id)).u16(0, parameters.length).u32(...parameters),
      little().u8(2, random.or(all.length, 0, 255)),
    )
    .finish();
}

function shuffleBytes(bytes: Uint8Array, size: number): Uint8Array {
  const count = Math.floor(bytes.length / size);
  return Uint8Array.from(bytes, (byte, i) =>
    i < count * size ? bytes[(i % count) * size + Math.floor(i / count)] : byte,
  );
}

export function shapeOf(random: Random, shape: readonly number[]): Uint8Array {
  const sizes = shape.map((n) => random.size(n));
  return little()
    .u8(random.or(2, 1, 3), random.or(sizes.length, 0, 32, 33), 0, random.or(sizes.length > 0 ? 1 : 0, 2))
    .u64(...sizes)
    .finish();
}

const bytesOf = (type: NumberName): number => Number(type[1]);

export function numberType(type: NumberName): Uint8Array {
  const bytes = bytesOf(type);
  if (type[0] !== 'f')
    return little()
      .u8(0x10, type[0] === 'i' ? 8 : 0, 0, 0)
      .u32(bytes)
      .u16(0, 8 * bytes)
      .finish();
  return little()
    .u8(0x11, 0x20, 8 * bytes - 1, 0)
    .u32(bytes)
    .u16(0, 8 * bytes)
    .u8(bytes === 4 ? 23 : 52, bytes === 4 ? 8 : 11, 0, bytes === 4 ? 23 : 52)
    .u32(bytes === 4 ? 127 : 1023)
    .finish();
}

export const textType = (bytes: number): Uint8Array => little().u8(0x13, 0, 0, 0).u32(bytes).finish();
export const textElsewhereType = (): Uint8Array => little().u8(0x19, 1, 0, 0).u32(16).put(textType(1)).finish();

export function packNumbers(type: NumberName, numbers: readonly number[], out: ByteWriter = little()): Uint8Array {
  for (const number of numbers) {
    if (type === 'f4') out.f32(number);
    else if (type === 'f8') out.f64(number);
    else if (type[1] === '1') out.u8(number);
    else if (type[1] === '2') out.u16(number);
    else out.u32(number);
  }
  return out.finish();
}
