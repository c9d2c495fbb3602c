import { VolumeViewError } from '../../core/errors.ts';
import { countElements, numberOf, readAll, textOf } from '../base/data-tree.ts';
import type { AttributeValue, DataArray, DataGroup, Numbers, NumberType } from '../base/data-tree.ts';
import { packGates } from './gate-samples.ts';
import type { PackedGates } from './gate-samples.ts';
import { isoTime, parseTimeUnits } from './cf-time.ts';
import { momentKindOf, normaliseUnit } from './moment-kind.ts';
import type { RadarFile, RadarMoment, SweepData } from './radar-file.ts';

// Code that CfRadial 1 and 2 share.

/** The maximum length of a row of which only the first number is needed. */
const maxRowNumbers = 64;

/**
 * Reads all numbers of a variable.
 * @throws {VolumeViewError} `format/corrupt`, if it is absent or its length differs
 */
export function requireNumbers(group: DataGroup, name: string, length: number): Float64Array {
  const array = group.array(name);
  if (!array) throw corrupt(`has no variable ${name} in ${group.path}`);
  if (countElements(array.shape) !== length) {
    throw corrupt(`got ${array.shape.join(' x ')} values in ${array.path}; expected ${length}`);
  }
  return Float64Array.from(readAll(array));
}

/** The first number of a variable; undefined if it is absent, its fill value, or not finite. */
export function firstNumber(group: DataGroup, name: string, at = 0): number | undefined {
  const array = group.array(name);
  if (!array || !isNumeric(array) || !(at < (array.shape[0] ?? 1))) return undefined;
  // The first number of a long row means nothing here, and the row would be read for each sweep.
  if (countElements(array.shape.slice(1)) > maxRowNumbers) return undefined;
  const [number] = array.readRows(at, 1);
  const isMissing = number === undefined || !Number.isFinite(number) || noDataOf(array).includes(number);
  return isMissing ? undefined : number;
}

/** The first text of a variable, or of an attribute of the same name. */
export function firstText(group: DataGroup, name: string): string | undefined {
  const array = group.array(name);
  if (array?.type === 'text') return array.readTexts()[0];
  return textOf(group.attributes.get(name));
}

export function isNumeric(array: DataArray): array is DataArray & { readonly type: NumberType } {
  return array.type !== 'text' && array.type !== 'other';
}

/** NetCDF-4 stores a dimension that has no variable as an array of this name. Source: NetCDF-4 format specification */
const dimensionAlone = 'This is a netCDF dimension but not a netCDF variable';

/** Whether an array is a variable of numbers. */
export function isNumericVariable(array: DataArray): boolean {
  return isNumeric(array) && !textOf(array.attributes.get('NAME'))?.startsWith(dimensionAlone);
}

/** Position of the antenna. For a moving one, its first position. */
export function readSite(root: DataGroup): RadarFile['site'] {
  const name = ['site_name', 'instrument_name']
    .map((key) => firstText(root, key))
    .find((text) => text && text !== 'None');
  const latitude = firstNumber(root, 'latitude');
  const longitude = firstNumber(root, 'longitude');
  const height = firstNumber(root, 'altitude');
  return {
    ...(name ? { name } : {}),
    ...(latitude === undefined ? {} : { latitude }),
    ...(longitude === undefined ? {} : { longitude }),
    ...(height === undefined ? {} : { height }),
  };
}

/** ISO 8601 of an element of the variable `time`; undefined if there is none. */
export function readTime(group: DataGroup, at: number): string | undefined {
  const seconds = firstNumber(group, 'time', at);
  const units = parseTimeUnits(textOf(group.array('time')?.attributes.get('units')) ?? '');
  return seconds === undefined || !units ? undefined : isoTime(units.from + seconds * units.unit);
}

/** When the scan began, from the file's own attribute. */
export function readStart(root: DataGroup): string | undefined {
  const parsed = parseTimeUnits(`seconds since ${firstText(root, 'time_coverage_start') ?? ''}`);
  return parsed ? isoTime(parsed.from) : undefined;
}

/** What the file says about a moment. */
export function describeMoment(name: string, array: DataArray): RadarMoment {
  const unit = normaliseUnit(textOf(array.attributes.get('units')) ?? '');
  const kinds = flagsOf(array).filter(({ meaning }) => !emptyMeaning.test(meaning));
  if (kinds.length > 1) {
    const numbers = kinds.map(({ value }) => value);
    return { name, unit, kind: 'kinds', numbers: [Math.min(...numbers), Math.max(...numbers)] };
  }
  return {
    name,
    unit,
    kind: momentKindOf({ name, unit, standardName: textOf(array.attributes.get('standard_name')) ?? '' }),
  };
}

/** Middles of radials, 0 <= azimuth < 360. */
export function wrapAzimuths(numbers: Numbers, path: string): Float64Array<ArrayBuffer> {
  return Float64Array.from(numbers, (azimuth) => {
    if (!(Math.abs(azimuth) <= 720))
      throw corrupt(`got the azimuth ${azimuth} in ${path}; expected degrees from 0 to 360`);
    // A tiny negative angle becomes 360 itself in floating point.
    return (((azimuth % 360) + 360) % 360) % 360;
  });
}

/** The mean of elevations, for a sweep that has no nominal one. */
export function meanElevation(numbers: Numbers, path: string): number {
  let sum = 0;
  for (const elevation of numbers) sum += elevation;
  const mean = sum / numbers.length;
  if (!(Math.abs(mean) <= 180)) throw corrupt(`got the mean elevation ${mean} in ${path}; expected degrees`);
  return mean;
}

/** Elevations of radials; undefined if the file has none for them. */
export function readElevations(
  array: DataArray | null,
  radials: { readonly from: number; readonly count: number },
): Float64Array<ArrayBuffer> | undefined {
  if (!array || !isNumeric(array)) return undefined;
  const numbers = Float64Array.from(array.readRows(radials.from, radials.count));
  return numbers.length === radials.count ? numbers : undefined;
}

/** For each radial 1 if the antenna was between sweeps; undefined if the file does not say it. Source: CfRadial 1.4, 5.4 */
export function readTransitions(
  array: DataArray | null,
  radials: { readonly from: number; readonly count: number },
): Uint8Array | undefined {
  if (!array || !isNumeric(array) || array.shape.length !== 1) return undefined;
  const flags = Uint8Array.from(array.readRows(radials.from, radials.count), (flag) => Number(flag === 1));
  return flags.length === radials.count && flags.includes(1) ? flags : undefined;
}

/** What has to be known of a radar that moves: all its radials are drawn from one place. Source: CfRadial 1.4, 4.5 */
export function describePlatform(root: DataGroup): string[] {
  const moves = /^(true|1)$/i.test(firstText(root, 'platform_is_mobile')?.trim() ?? '');
  return moves
    ? ['the radar moved while it scanned (platform_is_mobile): all is shown as if it had stayed where it began']
    : [];
}

/**
 * First gate's middle and gate length from the variable `range`, which has the middles of all gates.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported` if the gates have different lengths
 */
export function readRange(array: DataArray): Pick<SweepData, 'firstGate' | 'gateLength'> {
  const known = ranges.get(array);
  if (known) return known;
  const range = measureRange(array, readAll(array));
  ranges.set(array, range);
  return range;
}

/** All sweeps of a file may share one variable. */
const ranges = new WeakMap<DataArray, Pick<SweepData, 'firstGate' | 'gateLength'>>();

function measureRange(array: DataArray, numbers: Numbers): Pick<SweepData, 'firstGate' | 'gateLength'> {
  const scale = /^k(ilo)?m/i.test(textOf(array.attributes.get('units')) ?? '') ? 1000 : 1;
  const firstGate = scale * numbers[0];
  const last = scale * numbers[numbers.length - 1];
  const stated = numberOf(array.attributes.get('meters_between_gates'));
  const gateLength = numbers.length > 1 ? (last - firstGate) / (numbers.length - 1) : (stated ?? NaN);
  if (!(gateLength > 0 && Number.isFinite(firstGate) && Math.abs(firstGate) < 1e6 && gateLength < 1e5)) {
    throw corrupt(`got gates from ${firstGate} m on of ${gateLength} m in ${array.path}; expected ascending ranges`);
  }
  let farthest = 0;
  for (let i = 0; i < numbers.length; i++)
    farthest = Math.max(farthest, Math.abs(scale * numbers[i] - firstGate - i * gateLength));
  if (farthest <= 0.1 * gateLength) return { firstGate, gateLength };
  throw new VolumeViewError(
    'format/unsupported',
    `${array.path} got gates of uneven lengths, up to ${farthest.toFixed(1)} m off; expected steps of ${gateLength.toFixed(1)} m; resample the file to even gates`,
  );
}

/** Numbers of a moment as samples. */
export function packArray(array: DataArray, numbers: Numbers): PackedGates {
  if (!isNumeric(array))
    throw new VolumeViewError('format/unsupported', `${array.path} holds no numbers; expected integers or floats`);
  const slope = numberOf(array.attributes.get('scale_factor')) ?? 1;
  const intercept = numberOf(array.attributes.get('add_offset')) ?? 0;
  if (!(Number.isFinite(slope) && slope !== 0 && Number.isFinite(intercept))) {
    throw corrupt(
      `got scale_factor ${slope} and add_offset ${intercept} at ${array.path}; expected finite numbers, the first not 0`,
    );
  }
  const unsigned = textOf(array.attributes.get('_Unsigned'))?.toLowerCase() === 'true';
  const [noData, valid] = [noDataOf(array), validRangeOf(array)];
  const mask = (mask: number) => ({
    slope,
    intercept,
    noData: noData.map((n) => n & mask),
    valid: validOf(valid.map((n) => (Number.isFinite(n) ? n & mask : n))),
  });
  if (unsigned && numbers instanceof Int8Array) {
    return packGates(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.length), {
      type: 'uint8',
      ...mask(0xff),
    });
  }
  if (unsigned && numbers instanceof Int16Array) {
    return packGates(new Uint16Array(numbers.buffer, numbers.byteOffset, numbers.length), {
      type: 'uint16',
      ...mask(0xffff),
    });
  }
  return packGates(numbers, { type: array.type, slope, intercept, noData, valid: validOf(valid) });
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
  return value instanceof Float64Array ? [...value.subarray(0, maxRowNumbers)] : [];
}

export function corrupt(what: string): VolumeViewError {
  return new VolumeViewError(
    'format/corrupt',
    `the CfRadial file ${what}; check the program that wrote it, or fetch it again`,
  );
}
