import type { NumberType } from '../base/data-tree.ts';
import { corruptHdf5, Cursor, unsupportedHdf5 } from './hdf5-bytes.ts';

/** The type of an element. `bytes` is the size of one element. */
export type DataType =
  | { readonly kind: 'number'; readonly bytes: number; readonly type: NumberType; readonly littleEndian: boolean }
  /** Text of a fixed length. */
  | { readonly kind: 'text'; readonly bytes: number }
  /** Text elsewhere in the file: `bytes` is the size of the reference to it. */
  | { readonly kind: 'text-elsewhere'; readonly bytes: number }
  /** References, compounds and other types that no radar value has. */
  | { readonly kind: 'other'; readonly bytes: number; readonly name: string };

const others = [
  '',
  '',
  'a time',
  '',
  'a bit field',
  'an opaque value',
  'a compound',
  'a reference',
  '',
  'a sequence',
  'an array',
];

/**
 * Source: HDF5 File Format Specification 3.0, IV.A.2.d
 * @throws {VolumeViewError} `format/corrupt`
 */
export function readDataType(cursor: Cursor): DataType {
  const kind = cursor.u8() & 0x0f;
  const flags = cursor.u8();
  cursor.skip(2);
  const bytes = cursor.u32();
  if (bytes === 0) throw corruptHdf5('has elements of 0 bytes');
  switch (kind) {
    case 0:
      return readInteger(cursor, flags, bytes);
    case 1:
      return readFloat(cursor, flags, bytes);
    case 3:
      return { kind: 'text', bytes };
    case 8:
      return readEnumeration(cursor, bytes);
    case 9:
      return (flags & 0x0f) === 1 ? { kind: 'text-elsewhere', bytes } : { kind: 'other', bytes, name: others[9] };
    default:
      return { kind: 'other', bytes, name: others[kind] ?? 'an unknown type' };
  }
}

/** An enumeration is stored as an integer, whose type follows. */
function readEnumeration(cursor: Cursor, bytes: number): DataType {
  const base = new Cursor(cursor.file, cursor.position).u8() & 0x0f;
  return base === 0 ? readDataType(cursor) : { kind: 'other', bytes, name: 'an enumeration of what is no integer' };
}

function readInteger(cursor: Cursor, flags: number, bytes: number): DataType {
  const offset = cursor.u16();
  const precision = cursor.u16();
  const isWhole = offset === 0 && precision === 8 * bytes;
  if (!isWhole || ![1, 2, 4, 8].includes(bytes))
    return { kind: 'other', bytes, name: `an integer of ${precision} bits in ${bytes} bytes` };
  const type = `${flags & 0x08 ? '' : 'u'}int${8 * bytes}` as NumberType;
  return { kind: 'number', bytes, type, littleEndian: (flags & 1) === 0 };
}

function readFloat(cursor: Cursor, flags: number, bytes: number): DataType {
  cursor.skip(12);
  if (flags & 0x40 || ![2, 4, 8].includes(bytes)) return { kind: 'other', bytes, name: `a float of ${8 * bytes} bits` };
  return { kind: 'number', bytes, type: `float${8 * bytes}` as NumberType, littleEndian: (flags & 1) === 0 };
}

/**
 * Lengths of the axes, slowest first; empty for a single value; null for an array without values.
 * Source: HDF5 File Format Specification 3.0, IV.A.2.b
 */
export function readShape(cursor: Cursor): number[] | null {
  return readExtent(cursor)?.shape ?? null;
}

/** As `readShape`, with the lengths that the array may grow to: an index of chunks has places for these. */
export function readExtent(cursor: Cursor): { shape: number[]; maxShape: number[] } | null {
  const version = cursor.expectVersion('a dataspace', 1, 2);
  const axes = cursor.u8();
  const flags = cursor.u8();
  const kind = cursor.u8();
  if (version === 1) cursor.skip(4);
  else if (kind === 2) return null;
  if (axes > 32) throw unsupportedHdf5(`an array of ${axes} axes`);
  const shape = Array.from({ length: axes }, () => cursor.length());
  return { shape, maxShape: flags & 1 ? shape.map(() => cursor.length()) : shape };
}
