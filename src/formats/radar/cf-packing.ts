import { VolumeViewError } from '../../core/errors.ts';
import { numberOf, textOf } from '../base/data-tree.ts';
import type { AttributeValue, DataArray, Numbers, NumberType } from '../base/data-tree.ts';
import { corrupt } from './cfradial-problem.ts';
import { packGates } from './gate-samples.ts';
import type { PackedGates } from './gate-samples.ts';

// How a variable of CF says what its stored numbers mean: scale_factor, add_offset, _Unsigned, _FillValue and others.

/** The maximum number of values that an attribute may list. */
const maxListed = 64;

export function isNumeric(array: DataArray): array is DataArray & { readonly type: NumberType } {
  return array.type !== 'text' && array.type !== 'other';
}

/**
 * Values of rows, unpacked: of coordinates and other variables that are not shown as they are.
 * @returns NaN for no data
 * @throws {VolumeViewError} as `readRows`; `format/corrupt` if the variable holds no numbers
 */
export function readValues(array: DataArray, from: number, count: number): Float64Array<ArrayBuffer> {
  if (!isNumeric(array)) throw corrupt(`holds no numbers in ${array.path}`);
  const { slope, intercept } = scaleOf(array);
  const { numbers, mask } = asStored(array, array.readRows(from, count));
  const round = numbers instanceof Float32Array ? Math.fround : mask;
  const isNoData = new Set(noDataOf(array).map(round));
  return Float64Array.from(numbers, (number) => (isNoData.has(number) ? NaN : slope * number + intercept));
}

/** @throws {VolumeViewError} `format/corrupt` for a scale that no number has */
function scaleOf({ attributes, path }: DataArray): { slope: number; intercept: number } {
  const slope = numberOf(attributes.get('scale_factor')) ?? 1;
  const intercept = numberOf(attributes.get('add_offset')) ?? 0;
  if (Number.isFinite(slope) && slope !== 0 && Number.isFinite(intercept)) return { slope, intercept };
  throw corrupt(
    `got scale_factor ${slope} and add_offset ${intercept} at ${path}; expected finite numbers, the first not 0`,
  );
}

/** Numbers of a variable as they are meant, see `asStored`. */
interface Stored {
  readonly numbers: Numbers;
  readonly type: NumberType;
  /** The same for a number of an attribute, which is stored as the variable's are. */
  mask(number: number): number;
}

/** NetCDF-3 has no unsigned numbers; a variable says with `_Unsigned` that its signed ones are meant so. */
function asStored({ attributes, type }: DataArray & { readonly type: NumberType }, numbers: Numbers): Stored {
  const isUnsigned = textOf(attributes.get('_Unsigned'))?.toLowerCase() === 'true';
  const { buffer, byteOffset, length } = numbers;
  if (isUnsigned && numbers instanceof Int8Array)
    return { numbers: new Uint8Array(buffer, byteOffset, length), type: 'uint8', mask: (number) => number & 0xff };
  if (isUnsigned && numbers instanceof Int16Array)
    return { numbers: new Uint16Array(buffer, byteOffset, length), type: 'uint16', mask: (number) => number & 0xffff };
  return { numbers, type, mask: (number) => number };
}

/** Numbers of a moment as samples. */
export function packArray(array: DataArray, numbers: Numbers): PackedGates {
  if (!isNumeric(array))
    throw new VolumeViewError('format/unsupported', `${array.path} holds no numbers; expected integers or floats`);
  const { numbers: stored, type, mask } = asStored(array, numbers);
  const valid = validRangeOf(array).map((number) => (Number.isFinite(number) ? mask(number) : number));
  return packGates(stored, { type, ...scaleOf(array), noData: noDataOf(array).map(mask), valid: validOf(valid) });
}

/**
 * Lowest and highest number, as stored, that a variable calls valid; infinite where it does not say. One that the variable's type can not hold says nothing.
 * Source: netCDF4 1.7.5 for Python, which Py-ART 2.3 reads with; xradar 0.12 does not look at it
 */
function validRangeOf({ attributes, type }: DataArray): readonly [number, number] {
  const range = attributes.get('valid_range');
  const pair =
    range instanceof Float64Array && range.length === 2
      ? range
      : ['valid_min', 'valid_max'].map((name) => numbersOf(attributes.get(name))[0]);
  const [low, high] = Array.from(pair, (number) => (number !== undefined && canHold(type, number) ? number : NaN));
  return [Number.isNaN(low) ? -Infinity : low, Number.isNaN(high) ? Infinity : high];
}

/** A range that holds no number at all says nothing. */
function validOf([low, high]: readonly number[]): readonly [number, number] | undefined {
  return low <= high && (low > -Infinity || high < Infinity) ? [low, high] : undefined;
}

/** Whether a type has this number as it is. */
function canHold(type: DataArray['type'], number: number): boolean {
  if (type === 'float32') return Math.fround(number) === number;
  if (type === 'float64' || type === 'float16') return Number.isFinite(number);
  const bits = Number(/\d+$/.exec(type)?.[0] ?? 0);
  const [low, high] = type.startsWith('u') ? [0, 2 ** bits - 1] : [-(2 ** (bits - 1)), 2 ** (bits - 1) - 1];
  return Number.isInteger(number) && number >= low && number <= high;
}

/** What a variable of flags calls one that says that there are no data. */
const emptyMeaning =
  /^(no_?data|no_?value|missing(_?(data|value))?|fill(_?value)?|bad_?data|not_?(measured|scanned|available)|undefined?|unavailable|invalid(_?data)?)$/i;

/** A number that stands for something. */
interface Flag {
  readonly value: number;
  readonly meaning: string;
}

/** Source: CF conventions 1.11, 3.5: flag_values and flag_meanings, of which there are as many */
function flagsOf({ attributes }: DataArray): Flag[] {
  const values = attributes.get('flag_values');
  const meanings = textOf(attributes.get('flag_meanings'))?.trim().split(/\s+/) ?? [];
  return values instanceof Float64Array && values.length === meanings.length
    ? Array.from(values, (value, i) => ({ value, meaning: meanings[i] }))
    : [];
}

/** Numbers that stand for kinds of something, and not for no data. */
export const kindsOf = (array: DataArray): number[] =>
  flagsOf(array)
    .filter(({ meaning }) => !emptyMeaning.test(meaning))
    .map(({ value }) => value);

/** Flags that stand for no data. */
const emptyFlagsOf = (array: DataArray): number[] =>
  flagsOf(array)
    .filter(({ meaning }) => emptyMeaning.test(meaning))
    .map(({ value }) => value);

/** NetCDF's fill values for parts that were never written. Source: netcdf.h, NC_FILL_…; single bytes have none. */
const defaultFills: Readonly<Partial<Record<NumberType, number>>> = {
  int16: -32767,
  uint16: 65535,
  int32: -2147483647,
  uint32: 4294967295,
  float32: 9.969209968386869e36,
  float64: 9.969209968386869e36,
};

function noDataOf(array: DataArray): number[] {
  const stated = ['_FillValue', 'missing_value', '_Undetect'].flatMap((name) => numbersOf(array.attributes.get(name)));
  stated.push(...emptyFlagsOf(array));
  const fill = isNumeric(array) ? defaultFills[array.type] : undefined;
  return array.attributes.has('_FillValue') || fill === undefined ? stated : [...stated, fill];
}

/** Of a variable there may be several. */
function numbersOf(value: AttributeValue | undefined): number[] {
  return value instanceof Float64Array ? [...value.subarray(0, maxListed)] : [];
}
