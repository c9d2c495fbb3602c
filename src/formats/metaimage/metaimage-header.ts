import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { expandPattern } from '../grid-files/find-data-files.ts';
import { checkValue, cutLine, readHeaderLines } from '../grid-files/read-header-lines.ts';
import { numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';

export const what = 'the MetaImage header';

export interface MetaImageHeader {
  /** By name. Names are case-sensitive, as in MetaIO. */
  readonly fields: ReadonlyMap<string, string>;
  /** Names of the files that hold the data; null if the data follow the header in its own file. */
  readonly dataFiles: readonly string[] | null;
  /** Where the header ends, bytes. */
  readonly end: number;
}

/**
 * Synonyms of a field; if a header has several, the first in this list counts. Source: metaObject.cxx and metaImage.cxx
 * of MetaIO, the reader of ITK.
 */
const synonyms = {
  TransformMatrix: ['TransformMatrix', 'Rotation', 'Orientation'],
  Offset: ['Offset', 'Position', 'Origin'],
  ElementSpacing: ['ElementSpacing', 'ElementSize'],
  BinaryDataByteOrderMSB: ['BinaryDataByteOrderMSB', 'ElementByteOrderMSB'],
};

/** The value of a field; undefined if it is absent. */
function findField({ fields }: Pick<MetaImageHeader, 'fields'>, name: string): string | undefined {
  const names: readonly string[] = Object.hasOwn(synonyms, name) ? synonyms[name as keyof typeof synonyms] : [name];
  const found = names.map((one) => fields.get(one)).find((value) => value !== undefined && value !== '');
  return found && checkValue(what, name, found);
}

/**
 * Reads a header: lines `name = value`, the last of which is ElementDataFile.
 * @throws {VolumeViewError} `format/corrupt`
 */
export function readMetaImageHeader(bytes: Uint8Array): MetaImageHeader {
  const fields = new Map<string, string>();
  const lines = readHeaderLines(what, bytes);
  for (const { text, next } of lines) {
    if (text.trim() === '') continue;
    const cut = cutLine(text, '=:');
    if (!cut?.name) throw corruptFile(what, `got the line "${text.slice(0, 60)}"; expected "name = value"`);
    const { name } = cut;
    fields.set(name, cut.value);
    if (name === 'ElementDataFile')
      return { fields, dataFiles: listNames(checkValue(what, name, cut.value), lines), end: next };
  }
  throw corruptFile(what, 'ends without ElementDataFile; the file is cut short');
}

/** @param rest - the lines after ElementDataFile */
function listNames(value: string, rest: Iterable<{ text: string }>): string[] | null {
  if (/^LOCAL$/i.test(value)) return null;
  if (!/^LIST(\s+\d+D?)?$/i.test(value)) return expandPattern(what, value) ?? [value];
  return Array.from(rest, ({ text }) => text.trim()).filter((name) => name !== '');
}

/** Source: MetaIO's metaTypes.h; its "long" has 32 bits. */
const types = new Map<string, NumberType>([
  ['MET_CHAR', numberTypes.int8],
  ['MET_UCHAR', numberTypes.uint8],
  ['MET_SHORT', numberTypes.int16],
  ['MET_USHORT', numberTypes.uint16],
  ['MET_INT', numberTypes.int32],
  ['MET_UINT', numberTypes.uint32],
  ['MET_LONG', numberTypes.int32],
  ['MET_ULONG', numberTypes.uint32],
  ['MET_LONG_LONG', numberTypes.int64],
  ['MET_ULONG_LONG', numberTypes.uint64],
  ['MET_FLOAT', numberTypes.float32],
  ['MET_DOUBLE', numberTypes.float64],
]);

export function readType(header: MetaImageHeader): NumberType {
  const name = needField(header, 'ElementType');
  const type = types.get(name.toUpperCase());
  if (type) return type;
  if (/_ARRAY$|^MET_(STRING|OTHER|NONE|ASCII_CHAR|FLOAT_MATRIX)$/i.test(name))
    throw unsupportedFile(
      what,
      `got the type ${name}; expected one number per voxel, such as MET_SHORT: convert the file first`,
    );
  throw corruptFile(what, `got the type "${name.slice(0, 40)}"; expected one of ${[...types.keys()].join(', ')}`);
}

/** The value of a required field. @throws {VolumeViewError} `format/corrupt` */
export function needField(header: MetaImageHeader, name: string): string {
  const value = findField(header, name);
  if (value === undefined) throw corruptFile(what, `lacks ${name}; the file is damaged`);
  return value;
}

/** True or False, by the first letter. */
export function readFlag(header: MetaImageHeader, name: string, fallback: boolean): boolean {
  const value = findField(header, name);
  if (value === undefined) return fallback;
  if (/^[ty1]/i.test(value)) return true;
  if (/^[fn0]/i.test(value)) return false;
  throw corruptFile(what, `got ${name} "${value.slice(0, 40)}"; expected True or False`);
}

/** Finite numbers. @returns null if the field is absent */
export function readNumbers(header: MetaImageHeader, name: string, count: number): number[] | null {
  const text = findField(header, name);
  if (text === undefined) return null;
  const numbers = text.split(/[\s,]+/).map(Number);
  if (numbers.length === count && numbers.every(Number.isFinite)) return numbers;
  throw corruptFile(what, `got ${name} "${text.slice(0, 60)}"; expected ${count} number${count > 1 ? 's' : ''}`);
}
