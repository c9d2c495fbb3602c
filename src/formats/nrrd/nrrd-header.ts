import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { checkValue, cutLine, readHeaderLines } from '../grid-files/read-header-lines.ts';
import { expandPattern } from '../grid-files/find-data-files.ts';
import { numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';

export const what = 'the NRRD header';

/** A header's fields by name, in lower case without blanks: 'space directions' is 'spacedirections'. */
export type NrrdFields = ReadonlyMap<string, string>;

export interface NrrdHeader {
  readonly fields: NrrdFields;
  /** What it says about segments, by key: 'Segment0_Name'. */
  readonly segments: ReadonlyMap<string, string>;
  /** Whether it says that voxels hold how much of them is of a segment. */
  readonly isFractional: boolean;
  /** Names of the files that hold the data; null if the data follow the header in its own file. */
  readonly dataFiles: readonly string[] | null;
  /** Where the header ends, bytes. */
  readonly end: number;
}

/** How 3D Slicer says it; older versions write Master. */
const fractional = /^Segmentation_(Source|Master)Representation:=\s*Fractional labelmap\s*$/;

/**
 * Reads a header: lines up to an empty one, or to the file's end if the data are in other files.
 * Source: "Definition of NRRD File Format", G. Kindlmann, teem.sourceforge.net/nrrd/format.html, versions 1 to 5.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readNrrdHeader(bytes: Uint8Array): NrrdHeader {
  const fields = new Map<string, string>();
  const segments = new Map<string, string>();
  const listed: string[] = [];
  let isFractional = false;
  let isList = false;
  let end = -1;
  for (const { text, next } of readHeaderLines(what, bytes)) {
    if (fields.size === 0 && text.startsWith('NRRD')) checkVersion(text);
    else if (text === '') end = next;
    else if (isList) listed.push(text.trim());
    else if (fractional.test(text)) isFractional = true;
    else readField(text, fields, segments);
    isList ||= /^LIST(\s+\d+)?$/.test(fields.get('datafile') ?? '');
    if (end >= 0) break;
  }
  const dataFile = fields.get('datafile');
  if (dataFile === undefined && end < 0)
    throw corruptFile(what, 'ends without an empty line after it; the file is cut short');
  const dataFiles = dataFile === undefined ? null : isList ? listed : (expandPattern(what, dataFile) ?? [dataFile]);
  return { fields, segments, isFractional, dataFiles, end: end < 0 ? bytes.length : end };
}

function checkVersion(line: string): void {
  const digits = /^NRRD(\d{4})\s*$/.exec(line)?.[1];
  if (digits === undefined)
    throw corruptFile(what, `got the first line "${line.slice(0, 20)}"; expected NRRD0001 to NRRD0005`);
  const version = Number(digits);
  if (version >= 1 && version <= 5) return;
  throw unsupportedFile(what, `got the mark "${line.slice(0, 20)}"; expected NRRD0001 to NRRD0005`);
}

/** Reads `field: value`, and the segments' lines `key:=value`. Everything else, and comments, are ignored. */
function readField(line: string, fields: Map<string, string>, segments: Map<string, string>): void {
  if (line.startsWith('#')) return;
  const cut = cutLine(line, ':');
  if (!cut?.name) throw corruptFile(what, `got the line "${line.slice(0, 60)}"; expected "field: value"`);
  if (line[line.indexOf(':') + 1] === '=') {
    if (/^Segment\d{1,5}_\w+$/.test(cut.name)) segments.set(cut.name, cut.value.slice(1, 4096));
    return;
  }
  const name = cut.name.slice(0, 100).toLowerCase().replace(/\s/g, '');
  // A description of the data for people may be long.
  if (name !== 'content') fields.set(name, checkValue(what, name, cut.value));
}

/** The value of a required field. @throws {VolumeViewError} `format/corrupt` */
export function needField(fields: NrrdFields, name: string): string {
  const value = fields.get(name);
  if (value === undefined || value === '') throw corruptFile(what, `lacks the field "${name}"; the file is damaged`);
  return value;
}

/** Names of each type. */
const typeNames: readonly (readonly [NumberType, string])[] = [
  [numberTypes.int8, 'signed char|int8|int8_t'],
  [numberTypes.uint8, 'uchar|unsigned char|uint8|uint8_t'],
  [numberTypes.int16, 'short|short int|signed short|signed short int|int16|int16_t'],
  [numberTypes.uint16, 'ushort|unsigned short|unsigned short int|uint16|uint16_t'],
  [numberTypes.int32, 'int|signed int|int32|int32_t'],
  [numberTypes.uint32, 'uint|unsigned int|uint32|uint32_t'],
  [numberTypes.int64, 'longlong|long long|long long int|signed long long|signed long long int|int64|int64_t'],
  [numberTypes.uint64, 'ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t'],
  [numberTypes.float32, 'float'],
  [numberTypes.float64, 'double'],
];

export function readType(fields: NrrdFields): NumberType {
  const name = needField(fields, 'type').replace(/\s+/g, ' ').toLowerCase();
  const found = typeNames.find(([, names]) => names.split('|').includes(name));
  if (found) return found[0];
  if (name === 'block')
    throw unsupportedFile(what, 'got the type "block", bytes of unknown meaning; convert the file to numbers first');
  throw corruptFile(
    what,
    `got the type "${name.slice(0, 40)}"; expected one such as ${typeNames.map(([type]) => type.name).join(', ')}`,
  );
}

const encodings = new Map<string, 'raw' | 'deflate' | 'bzip2' | 'text'>([
  ['raw', 'raw'],
  ['gz', 'deflate'],
  ['gzip', 'deflate'],
  ['bz2', 'bzip2'],
  ['bzip2', 'bzip2'],
  ['txt', 'text'],
  ['text', 'text'],
  ['ascii', 'text'],
]);

export function readEncoding(fields: NrrdFields): 'raw' | 'deflate' | 'bzip2' | 'text' {
  const name = needField(fields, 'encoding').toLowerCase();
  const encoding = encodings.get(name);
  if (encoding) return encoding;
  throw unsupportedFile(
    what,
    `got the encoding "${name.slice(0, 40)}"; expected raw, gzip, bzip2 or ascii: write the file again with one of them`,
  );
}

/** Little-endian if the header does not say it, as in Teem on today's machines. */
export function isLittleEndian(fields: NrrdFields): boolean {
  const name = (fields.get('endian') ?? 'little').toLowerCase();
  if (name !== 'little' && name !== 'big')
    throw corruptFile(what, `got the endian "${name.slice(0, 40)}"; expected little or big`);
  return name === 'little';
}

/** A whole number, from `min`. */
export function readCount(fields: NrrdFields, name: string, min: number): number {
  const text = fields.get(name) ?? '0';
  const value = Number(text);
  if (!/^[+-]?\d+$/.test(text) || !Number.isSafeInteger(value) || value < min) {
    throw corruptFile(what, `got "${text.slice(0, 40)}" as ${name}; expected a whole number from ${min}`);
  }
  return value;
}
