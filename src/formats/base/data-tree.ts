import { VolumeViewError } from '../../core/errors.ts';

// One interface to files that describe themselves, HDF5 and NetCDF: groups, attributes and arrays.

/** A group: attributes, groups and arrays by name. A NetCDF-3 file is one group. */
export interface DataGroup {
  /** From the file's root, such as '/dataset1/what'. */
  readonly path: string;
  /** Attributes of types that are not used here (references, compounds) are left out. */
  readonly attributes: ReadonlyMap<string, AttributeValue>;
  /** Names of everything in the group, in the file's order. */
  readonly names: readonly string[];
  /** The group of this name; null if there is none. */
  group(name: string): DataGroup | null;
  /** The array of this name; null if there is none. */
  array(name: string): DataArray | null;
}

/** A text, several texts, or one or more numbers in double precision. */
export type AttributeValue = string | readonly string[] | Float64Array;

/** An array of numbers or of texts. */
export interface DataArray {
  /** From the file's root, such as '/dataset1/data1/data'. */
  readonly path: string;
  /** Lengths of the axes, slowest first; empty for a single value. */
  readonly shape: readonly number[];
  readonly type: ElementType;
  readonly attributes: ReadonlyMap<string, AttributeValue>;
  /**
   * Numbers of a range of the first axis, [from, from + count), and all of the others, last axis fastest. An array
   * without axes is one row. 64-bit integers come as doubles. The load's budget counts the numbers only while they are
   * read: callers that keep them take the bytes themselves.
   * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
   */
  readRows(from: number, count: number): Numbers;
  /**
   * All texts. Where each character is an element of its own (as in NetCDF), the last axis makes a text.
   * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
   */
  readTexts(): readonly string[];
}

export type NumberType =
  | 'int8'
  | 'uint8'
  | 'int16'
  | 'uint16'
  | 'int32'
  | 'uint32'
  | 'int64'
  | 'uint64'
  | 'float16'
  | 'float32'
  | 'float64';

export type ElementType = NumberType | 'text' | 'other';

export type Numbers =
  | Int8Array<ArrayBuffer>
  | Uint8Array<ArrayBuffer>
  | Int16Array<ArrayBuffer>
  | Uint16Array<ArrayBuffer>
  | Int32Array<ArrayBuffer>
  | Uint32Array<ArrayBuffer>
  | Float32Array<ArrayBuffer>
  | Float64Array<ArrayBuffer>;

/** Maximum number of elements that are read at once: the largest sweep of the largest radars has a tenth of it. */
export const maxElements = 2 ** 26;

/** Elements in an array of a shape, the last axis included. */
export function countElements(shape: readonly number[]): number {
  return shape.reduce((product, length) => product * length, 1);
}

/**
 * All numbers of an array.
 * @throws {VolumeViewError} as `readRows`
 */
export function readAll(array: DataArray): Numbers {
  return array.readRows(0, array.shape[0] ?? 1);
}

/** The first number of an attribute; undefined if the attribute is absent, or a text that is not a number. */
export function numberOf(value: AttributeValue | undefined): number | undefined {
  if (value === undefined) return undefined;
  // Some writers store numbers as text ('0.5', '1.000000').
  const number = typeof value[0] === 'number' ? value[0] : Number.parseFloat(textOf(value) ?? '');
  return Number.isNaN(number) && typeof value[0] !== 'number' ? undefined : number;
}

/** The text of an attribute; undefined if it is absent or a number. */
export function textOf(value: AttributeValue | undefined): string | undefined {
  if (typeof value === 'string') return value;
  const first = value?.[0];
  return typeof first === 'string' ? first : undefined;
}

/** @throws {VolumeViewError} `format/too-large`, if an array has too many elements to read */
export function refuseTooMany(path: string, elements: number): void {
  if (elements <= maxElements) return;
  throw new VolumeViewError(
    'format/too-large',
    `${path} asks for ${elements.toLocaleString('en')} values at once; expected at most ${maxElements.toLocaleString('en')}; use a smaller file`,
  );
}
