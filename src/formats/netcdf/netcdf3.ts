import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { countElements, refuseTooMany } from '../base/data-tree.ts';
import type { AttributeValue, DataArray, DataGroup, ElementType, Numbers, NumberType } from '../base/data-tree.ts';
import { bytesOfNumber, decodeNumbers } from '../base/decode-numbers.ts';
import { decodeText } from '../base/decode-text.ts';
import { takeDuring } from '../base/take-during.ts';

// Our own reader, because the bytes come from strangers: it allocates and loops only as much as the file's length
// justifies. It is short, because NetCDF-3 has no compression and one group.

/** Types by their code; the last five exist only in CDF-5. */
const types: readonly (ElementType | undefined)[] = [
  undefined,
  'int8',
  'text',
  'int16',
  'int32',
  'float32',
  'float64',
  'uint8',
  'uint16',
  'uint32',
  'int64',
  'uint64',
];
const tags = { dimensions: 10, variables: 11, attributes: 12 };

/** Where a variable's values are. */
interface Variable {
  readonly name: string;
  readonly shape: readonly number[];
  readonly type: ElementType;
  readonly attributes: ReadonlyMap<string, AttributeValue>;
  readonly begin: number;
  /** Its values come in pieces, one in each record, along the first axis. */
  readonly isRecord: boolean;
}

/** Memory for a text in addition to its characters, bytes. */
const bytesPerText = 64;

interface Netcdf3 {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly budget: Budget;
  readonly attributes: ReadonlyMap<string, AttributeValue>;
  readonly variables: ReadonlyMap<string, Variable>;
  /** Bytes from one record to the next. */
  readonly recordBytes: number;
}

/** True where bytes begin as NetCDF-3 does: classic, 64-bit offset, or 64-bit data. */
export function isNetcdf3(bytes: Uint8Array): boolean {
  return bytes[0] === 0x43 && bytes[1] === 0x44 && bytes[2] === 0x46 && [1, 2, 5].includes(bytes[3]);
}

/**
 * Opens a NetCDF-3 file: classic, with 64-bit offsets, or with 64-bit data (CDF-5).
 * @param budget - of the load; if undefined, one for this file alone
 * @returns its only group
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/too-large`
 * Source: NetCDF Classic Format Specification, NetCDF user's guide, appendix B
 */
export function openNetcdf3(bytes: Uint8Array<ArrayBuffer>, budget = Budget.ofFile(bytes.length)): DataGroup {
  if (!isNetcdf3(bytes))
    throw new VolumeViewError(
      'format/unknown',
      'the file has no NetCDF-3 signature; expected a file that begins with CDF',
    );
  const file = readHeader(bytes, budget);
  const arrays = new Map([...file.variables].map(([name, variable]) => [name, new Netcdf3Array(file, variable)]));
  return {
    path: '/',
    attributes: file.attributes,
    names: [...file.variables.keys()],
    group: () => null,
    array: (name) => arrays.get(name) ?? null,
  };
}

class Netcdf3Array implements DataArray {
  readonly path: string;
  readonly shape: readonly number[];
  readonly type: ElementType;
  readonly attributes: ReadonlyMap<string, AttributeValue>;
  readonly #file: Netcdf3;
  readonly #variable: Variable;

  constructor(file: Netcdf3, variable: Variable) {
    this.#file = file;
    this.#variable = variable;
    this.path = `/${variable.name}`;
    this.shape = variable.shape;
    this.type = variable.type;
    this.attributes = variable.attributes;
  }

  readRows(from: number, count: number): Numbers {
    if (this.type === 'text' || this.type === 'other') throw corrupt(`holds text in ${this.path}; expected numbers`);
    const { type } = this;
    // 64-bit integers become doubles.
    const made = count * countElements(this.shape.slice(1)) * bytesOf(type) * (type.endsWith('int64') ? 2 : 1);
    return takeDuring(this.#file.budget, { bytes: made, what: this.path }, () =>
      decodeNumbers(this.#readBytes(from, count), type, false),
    );
  }

  readTexts(): readonly string[] {
    if (this.type !== 'text') throw corrupt(`holds numbers in ${this.path}; expected text`);
    const length = this.shape.at(-1) ?? 1;
    const all = countElements(this.shape);
    const texts = length === 0 ? 0 : Math.floor(all / length);
    this.#file.budget.take(2 * all + bytesPerText * texts, this.path);
    const bytes = this.#readBytes(0, this.shape[0] ?? 1);
    return Array.from({ length: texts }, (_, i) => decodeText(bytes.subarray(i * length, (i + 1) * length)));
  }

  #readBytes(from: number, count: number): Uint8Array<ArrayBuffer> {
    const { bytes, recordBytes } = this.#file;
    const { begin, isRecord } = this.#variable;
    const rows = this.shape[0] ?? 1;
    if (!(from >= 0 && count >= 0 && from + count <= rows))
      throw corrupt(`asks for rows ${from} to ${from + count} of ${this.path}, which has ${rows}`);
    const rowElements = countElements(this.shape.slice(1));
    const rowBytes = rowElements * bytesOf(this.type);
    refuseTooMany(this.path, count * rowElements);
    if (rowBytes === 0) return new Uint8Array(0); // Empty rows: the file may have any number of them.
    const step = isRecord ? recordBytes : rowBytes;
    const end = begin + (from + count - 1) * step + rowBytes;
    if (count > 0 && !(end <= bytes.length))
      throw corrupt(`ends early: got ${bytes.length} bytes; ${this.path} ends at ${end}`);
    if (!isRecord) return bytes.slice(begin + from * rowBytes, begin + (from + count) * rowBytes);
    this.#file.budget.step(count, this.path);
    const rowsBytes = new Uint8Array(count * rowBytes);
    for (let i = 0; i < count; i++) {
      const at = begin + (from + i) * recordBytes;
      rowsBytes.set(bytes.subarray(at, at + rowBytes), i * rowBytes);
    }
    return rowsBytes;
  }
}

function readHeader(bytes: Uint8Array<ArrayBuffer>, budget: Budget): Netcdf3 {
  const cursor = new HeaderCursor(bytes, 4);
  const stated = cursor.count();
  const dimensions = cursor.list(tags.dimensions, () => {
    cursor.name();
    return cursor.count();
  });
  const attributes = readAttributes(cursor);
  const variables = cursor.list(tags.variables, () => readVariable(cursor, dimensions));
  const records = variables.filter(({ isRecord }) => isRecord);
  const own = records.map(({ shape, type }) => countElements(shape.slice(1)) * bytesOf(type));
  // A single record variable is not padded; all others are padded to 4 bytes.
  const recordBytes = own.length === 1 ? own[0] : own.reduce((sum, n) => sum + pad(n), 0);
  const first = records.reduce((min, { begin }) => Math.min(min, begin), Infinity);
  const isOpen = stated === cursor.maxCount; // An unfinished file: the reader counts the records that are there.
  const count = isOpen && recordBytes > 0 ? Math.max(0, Math.floor((bytes.length - first) / recordBytes)) : stated;
  const complete = variables.map((variable) =>
    variable.isRecord ? { ...variable, shape: [count, ...variable.shape.slice(1)] } : variable,
  );
  checkEnd(bytes, complete, recordBytes);
  return {
    bytes,
    budget,
    attributes,
    variables: new Map(complete.map((variable) => [variable.name, variable])),
    recordBytes,
  };
}

function readVariable(cursor: HeaderCursor, dimensions: readonly number[]): Variable {
  const name = cursor.name();
  const axes = cursor.count();
  if (axes > 1024) throw corrupt(`has ${name} of ${axes} axes`);
  const shape = Array.from({ length: axes }, () => {
    const length = dimensions[cursor.count()];
    if (length === undefined) throw corrupt(`has ${name} along an axis that it does not list`);
    return length;
  });
  const attributes = readAttributes(cursor);
  const type = types[cursor.u32()];
  if (!type) throw corrupt(`has ${name} of an unknown type`);
  cursor.count(); // Its size in bytes, which overflows if it is large: it is computed again when it is needed.
  return { name, shape, type, attributes, begin: cursor.begin(), isRecord: shape[0] === 0 };
}

function readAttributes(cursor: HeaderCursor): Map<string, AttributeValue> {
  return new Map(
    cursor.list(tags.attributes, () => {
      const name = cursor.name();
      const type = types[cursor.u32()];
      if (!type) throw corrupt(`has an attribute ${name} of an unknown type`);
      const bytes = cursor.padded(cursor.count() * bytesOf(type));
      const value =
        type === 'text'
          ? decodeText(bytes)
          : Float64Array.from(decodeNumbers(bytes.slice(), type as NumberType, false));
      return [name, value] as const;
    }),
  );
}

/** @throws {VolumeViewError} `format/corrupt`, if a variable ends after the file */
function checkEnd(bytes: Uint8Array, variables: readonly Variable[], recordBytes: number): void {
  for (const { name, shape, type, begin, isRecord } of variables) {
    const rowBytes = countElements(shape.slice(1)) * bytesOf(type);
    const rows = shape[0] ?? 1;
    const end = begin + (isRecord ? Math.max(0, rows - 1) * recordBytes + (rows > 0 ? rowBytes : 0) : rows * rowBytes);
    if (!(end <= bytes.length)) throw corrupt(`ends early: got ${bytes.length} bytes; ${name} ends at ${end}`);
  }
}

/** Reads the header, big-endian. */
class HeaderCursor {
  readonly #bytes: Uint8Array<ArrayBuffer>;
  readonly #view: DataView;
  readonly #version: number;
  #at: number;

  constructor(bytes: Uint8Array<ArrayBuffer>, at: number) {
    this.#bytes = bytes;
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#version = bytes[3];
    this.#at = at;
  }

  /** The value that means that a count is unknown. */
  get maxCount(): number {
    return this.#version === 5 ? Number(2n ** 64n - 1n) : 2 ** 32 - 1;
  }

  u32(): number {
    return this.#view.getUint32(this.#take(4));
  }

  #u64(): number {
    return Number(this.#view.getBigUint64(this.#take(8)));
  }

  /** A count or a length. */
  count(): number {
    return this.#version === 5 ? this.#u64() : this.u32();
  }

  /** Where a variable begins. */
  begin(): number {
    return this.#version === 1 ? this.u32() : this.#u64();
  }

  name(): string {
    return decodeText(this.padded(this.count()));
  }

  /** Bytes that are followed by others up to a multiple of 4. */
  padded(length: number): Uint8Array<ArrayBuffer> {
    const at = this.#take(length);
    this.#at = Math.min(this.#at + pad(length) - length, this.#bytes.length);
    return this.#bytes.subarray(at, at + length);
  }

  /** A list: a tag, a count, and the items; two zeros if it is empty. */
  list<Item>(tag: number, readItem: () => Item): Item[] {
    const got = this.u32();
    const count = this.count();
    if (got === 0 && count === 0) return [];
    // Each item takes at least 8 bytes, so a count that does not fit into the file is refused.
    if (got !== tag || !(count * 8 <= this.#bytes.length))
      throw corrupt(`has a list of ${count} with the tag ${got}; expected the tag ${tag}`);
    return Array.from({ length: count }, readItem);
  }

  #take(length: number): number {
    const at = this.#at;
    if (!(at + length <= this.#bytes.length)) throw corrupt(`ends within its header: got ${this.#bytes.length} bytes`);
    this.#at += length;
    return at;
  }
}

function bytesOf(type: ElementType): number {
  return type === 'text' || type === 'other' ? 1 : bytesOfNumber[type];
}

function pad(length: number): number {
  return Math.ceil(length / 4) * 4;
}

function corrupt(what: string): VolumeViewError {
  return new VolumeViewError(
    'format/corrupt',
    `the NetCDF file ${what}; it is damaged or was cut short: fetch it again`,
  );
}
