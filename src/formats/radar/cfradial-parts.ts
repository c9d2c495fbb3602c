import { VolumeViewError } from '../../core/errors.ts';
import { countElements, numberOf, readAll, textOf } from '../base/data-tree.ts';
import type { DataArray, DataGroup, Numbers } from '../base/data-tree.ts';
import { isNumeric, kindsOf, readValues } from './cf-packing.ts';
import { isoTime, parseTimeUnits } from './cf-time.ts';
import { corrupt } from './cfradial-problem.ts';
import { momentKindOf, normaliseUnit } from './moment-kind.ts';
import type { RadarFile, RadarMoment, RadarSweep, SweepData } from './radar-file.ts';

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
  const [number] = readValues(array, at, 1);
  return number !== undefined && Number.isFinite(number) ? number : undefined;
}

/** The first text of a variable, or of an attribute of the same name. */
export function firstText(group: DataGroup, name: string): string | undefined {
  const array = group.array(name);
  if (array?.type === 'text') return array.readTexts()[0];
  return textOf(group.attributes.get(name));
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
  const kinds = kindsOf(array);
  if (kinds.length > 1) return { name, unit, kind: 'kinds', numbers: [Math.min(...kinds), Math.max(...kinds)] };
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

/** Elevations of radials, NaN for those without one; undefined if the file has none for them. */
export function readElevations(
  array: DataArray | null,
  radials: { readonly from: number; readonly count: number },
): Float64Array<ArrayBuffer> | undefined {
  if (!array || !isNumeric(array)) return undefined;
  const numbers = readValues(array, radials.from, radials.count);
  return numbers.length === radials.count ? numbers : undefined;
}

/** If a sweep's nominal elevation differs from its radials' by more than this, degrees, it is not that of the sweep. */
const farthestNominal = 1;

/**
 * The elevation of a sweep: its nominal one, or that in the middle of its radials', where the file does not say it or its antenna was
 * somewhere else. Radials without exception at 0 were never filled in, if the sweep is said to be elsewhere.
 * @throws {VolumeViewError} `format/corrupt` if the file says neither
 */
export function settleElevations(
  nominal: number | undefined,
  elevations: Float64Array<ArrayBuffer> | undefined,
  path: string,
): Pick<RadarSweep, 'elevation' | 'elevations' | 'left'> {
  const stated = nominal !== undefined && Math.abs(nominal) <= 180 ? nominal : undefined;
  const own = elevations && { elevations };
  // Most sweeps need no sorting.
  if (stated !== undefined && elevations?.every((one) => Math.abs(one - stated) <= farthestNominal))
    return { elevation: stated, ...own };
  const middle = elevations && middleOf(elevations);
  if (stated === undefined) {
    if (middle === undefined) throw corrupt(`has no elevation of the sweep in ${path}, nor of its radials`);
    return { elevation: middle, ...own };
  }
  if (middle === undefined || Math.abs(middle - stated) <= farthestNominal) return { elevation: stated, ...own };
  if (elevations!.every((one) => one === 0)) return { elevation: stated };
  const [got, shown] = [stated, middle].map((angle) => Number(angle.toFixed(2)));
  return {
    elevation: middle,
    ...own,
    left: [`the fixed angle ${got}° of a sweep is not used: its radials are at ${shown}°`],
  };
}

/** The median of elevations; undefined if none is one. */
function middleOf(elevations: Float64Array): number | undefined {
  const sorted = elevations.filter((one) => Math.abs(one) <= 180);
  sorted.sort();
  return sorted.length > 0 ? sorted[Math.floor(sorted.length / 2)] : undefined;
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

/** Middle of the first gate, and gate length, metres. */
export type GatePlace = Pick<SweepData, 'firstGate' | 'gateLength'>;

/**
 * First gate's middle and gate length from the variable `range`, which has the middles of all gates.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported` if the gates have different lengths
 */
export function readRange(array: DataArray): GatePlace {
  const known = ranges.get(array);
  if (known) return known;
  const range = measureRange(array, readValues(array, 0, array.shape[0] ?? 1));
  ranges.set(array, range);
  return range;
}

/** All sweeps of a file may share one variable. */
const ranges = new WeakMap<DataArray, GatePlace>();

/** Metres in the unit of a variable. */
export function metresOf({ attributes }: DataArray): number {
  return /^k(ilo)?m/i.test(textOf(attributes.get('units'))?.trim() ?? '') ? 1000 : 1;
}

/** @param numbers - middles of gates, in the unit of the variable */
export function measureRange(array: DataArray, numbers: Numbers): GatePlace {
  const scale = metresOf(array);
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
