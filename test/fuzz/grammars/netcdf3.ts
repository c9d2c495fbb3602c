import { big } from '../bytes.ts';
import type { ByteWriter } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';
import { packNumbers } from './hdf5-writer.ts';
import { makeCfradial1 } from './radar-trees.ts';
import type { NumberName, TreeArray, TreeValue } from './radar-trees.ts';

const codes: Readonly<Record<NumberName | 'text', number>> = {
  i1: 1,
  text: 2,
  i2: 3,
  i4: 4,
  f4: 5,
  f8: 6,
  u1: 7,
  u2: 8,
  u4: 9,
};

/** CfRadial 1 in NetCDF-3, all three versions: counts, dimensions and places that lie, records. Source: NetCDF user's guide, appendix B */
export const netcdf3: Grammar = (random) => {
  const tree = makeCfradial1(random);
  const version = random.pick([1, 2, 5] as const);
  const arrays = Object.entries(tree.arrays).filter(
    ([, { type }]) => version === 5 || !['u1', 'u2', 'u4'].includes(type),
  );
  const writer = new Header(random, version);
  const records = random.chance(0.3) ? (tree.arrays.azimuth.shape[0] ?? 0) : NaN;
  const lengths = [...new Set(arrays.flatMap(([, { shape }]) => shape))];
  const write = (begins: readonly number[]): Uint8Array<ArrayBuffer> =>
    writer.write({ attributes: tree.attributes, arrays, begins, lengths, records });
  return oneFile(random.or('scan.nc', 'scan'), damage(random, fill(arrays, records, write)));
};

/** The header with the places of the data after it, and the data. */
function fill(
  arrays: readonly (readonly [string, TreeArray])[],
  records: number,
  write: (begins: readonly number[]) => Uint8Array,
): Uint8Array<ArrayBuffer> {
  const headLength = write(arrays.map(() => 0)).length;
  const body = big();
  const begins: number[] = [];
  const packed = arrays.map(([, { type, numbers }]) =>
    type === 'text' ? Uint8Array.from(numbers) : packNumbers(type, numbers, big()),
  );
  const isRecord = ([, { shape }]: readonly [string, TreeArray]): boolean => shape[0] === records;
  arrays.forEach((array, i) => {
    if (isRecord(array)) return;
    begins[i] = headLength + body.length;
    body.put(packed[i]).pad(4);
  });
  for (let record = 0; record < records; record++) {
    arrays.forEach((array, i) => {
      if (!isRecord(array)) return;
      const length = packed[i].length / records;
      begins[i] ??= headLength + body.length;
      body.put(packed[i].subarray(record * length, (record + 1) * length)).pad(4);
    });
  }
  return big().put(write(begins)).put(body.finish()).finish();
}

interface Contents {
  readonly attributes: Readonly<Record<string, TreeValue>>;
  readonly arrays: readonly (readonly [string, TreeArray])[];
  readonly begins: readonly number[];
  readonly lengths: readonly number[];
  readonly records: number;
}

/** Draws nothing twice: a header is written once to know its length, and once with the places of the data. */
class Header {
  readonly #random: Random;
  readonly #version: 1 | 2 | 5;
  readonly #drawn: unknown[] = [];
  #at = 0;

  constructor(random: Random, version: 1 | 2 | 5) {
    this.#random = random;
    this.#version = version;
  }

  write({ attributes, arrays, begins, lengths, records }: Contents): Uint8Array<ArrayBuffer> {
    this.#at = 0;
    const out = big()
      .text('CDF')
      .u8(this.#once((random) => random.or<number>(this.#version, 1, 2, 5)));
    this.#count(out, Number.isNaN(records) ? 0 : this.#once((random) => random.or(records, 2 ** 32 - 1, 2 ** 64)));
    this.#list(out, 10, lengths, (length, i) => {
      this.#name(out, `d${i}`);
      this.#count(out, length === records ? 0 : length);
    });
    this.#attributes(out, attributes);
    this.#list(out, 11, arrays, ([name, { shape, type, attributes }], i) => {
      this.#name(out, name);
      this.#count(out, shape.length);
      for (const length of shape) this.#count(out, lengths.indexOf(length));
      this.#attributes(out, attributes);
      out.u32(this.#once((random) => random.or(codes[type], 0, 2, 11, 12)));
      this.#count(out, 0);
      const begin = this.#once((random) => (random.isWild() ? random.size(200) : -1));
      const place = begin < 0 ? (begins[i] ?? 0) : begin;
      if (this.#version === 1) out.u32(place);
      else out.u64(place);
    });
    return out.finish();
  }

  #once<T>(draw: (random: Random) => T): T {
    if (this.#at >= this.#drawn.length) this.#drawn.push(draw(this.#random));
    return this.#drawn[this.#at++] as T;
  }

  #count(out: ByteWriter, sound: number): void {
    const count = this.#once((random) => (random.isWild() ? random.size(sound) : -1));
    if (this.#version === 5) out.u64(count < 0 ? sound : count);
    else out.u32(count < 0 ? sound : count);
  }

  #name(out: ByteWriter, name: string): void {
    this.#count(out, name.length);
    out.text(name).pad(4);
  }

  #list<T>(out: ByteWriter, tag: number, items: readonly T[], write: (item: T, i: number) => void): void {
    out.u32(items.length > 0 ? tag : 0);
    this.#count(out, items.length);
    items.forEach(write);
  }

  #attributes(out: ByteWriter, attributes: Readonly<Record<string, TreeValue>>): void {
    this.#list(out, 12, Object.entries(attributes), ([name, value]) => {
      this.#name(out, name);
      out.u32(typeof value === 'string' ? codes.text : codes[value.type]);
      this.#count(out, typeof value === 'string' ? value.length : value.numbers.length);
      if (typeof value === 'string') out.text(value).pad(4);
      else out.put(packNumbers(value.type, value.numbers, big())).pad(4);
    });
  }
}
