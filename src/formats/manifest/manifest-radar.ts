import { count, Expected, finite, isFinite, maxList, shortText } from './manifest-checks.ts';
import type { Check } from './manifest-checks.ts';
import type { ManifestSite, ManifestSweep } from '../base/radar-settings.ts';

// The fields of a manifest that describe a radar's mosaic.

export const positive: Check<number> = (value) => {
  if (!isFinite(value) || value <= 0) throw new Expected('a number above 0');
  return value;
};

/** The maximum number of sweeps, the same as for a radar file. */
const maxTiles = 4096;

/** Characters of a time. */
const maxTime = 50;

/** Metres and degrees beyond this do not occur in radar data. */
const farthest = 1e9;

/**
 * Two numbers.
 * @param expected - in words
 * @param fits - whether the second one is valid
 */
const pair =
  (expected: string, fits: (second: number) => boolean): Check<readonly [number, number]> =>
  (value) => {
    if (
      !Array.isArray(value) ||
      value.length !== 2 ||
      !value.every((n) => isFinite(n) && Math.abs(n) <= farthest) ||
      !fits(value[1])
    )
      throw new Expected(expected);
    return value as unknown as readonly [number, number];
  };

export const rangePair = pair(
  '[first, gate length] in metres up to 1e9, the gate length above 0',
  (length) => length > 0,
);

export const azimuthPair = pair('[first, step] in degrees up to 1e9, the step not 0', (step) => step !== 0);

export const angles: Check<readonly number[]> = (value) => {
  if (
    !Array.isArray(value) ||
    value.length === 0 ||
    value.length > maxTiles ||
    !value.every((angle) => isFinite(angle) && Math.abs(angle) <= 90)
  ) {
    throw new Expected(`a list of up to ${maxTiles.toLocaleString('en')} degrees from -90 to 90, one a tile`);
  }
  return value as number[];
};

const isUtc = (text: string): boolean =>
  /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z$/.test(text) && !Number.isNaN(Date.parse(text));

/** A number with its unit, from some start. */
const counted = /^-?\d{1,15}(\.\d{1,20})?(e[-+]?\d{1,2})? ?[A-Za-z][A-Za-z/]{0,9}$/;

const utcTime: Check<string> = (value) => {
  if (typeof value !== 'string' || value.length >= maxTime || !isUtc(value))
    throw new Expected('a time in UTC, such as "2018-12-20T06:06:28Z"');
  return value;
};

/** A time in UTC, or one that is counted from the first scan. */
export const scanTime: Check<string> = (value) => {
  const isTime = typeof value === 'string' && value.length < maxTime && (isUtc(value) || counted.test(value));
  if (!isTime)
    throw new Expected('a time in UTC, such as "2018-12-20T06:06:28Z", or a number with its unit, such as "12.5 s"');
  return value;
};

export const site: Check<ManifestSite> = (value) =>
  readFields(value, { name: shortText, latitude: finite, longitude: finite, height: finite });

const numbers: Check<readonly number[]> = (value) => {
  if (!Array.isArray(value) || value.length === 0 || value.length > maxList || !value.every(isFinite))
    throw new Expected(`a list of up to ${maxList.toLocaleString('en')} numbers`);
  return value;
};

const radialElevations: Check<readonly number[]> = (value) => {
  if (!numbers(value).every((angle) => Math.abs(angle) <= 90))
    throw new Expected('a list of degrees from -90 to 90, one a ray');
  return value as number[];
};

const sweep: Check<ManifestSweep> = (value) =>
  readFields(value, {
    rays: count,
    gates: count,
    range: rangePair,
    azimuth: azimuthPair,
    azimuths: numbers,
    elevations: radialElevations,
    nyquist: positive,
    time: utcTime,
  });

export const sweeps: Check<readonly ManifestSweep[]> = (value) => {
  if (!Array.isArray(value) || value.length > maxTiles)
    throw new Expected(`a list of up to ${maxTiles.toLocaleString('en')} objects, one a tile`);
  return value.map((one: unknown, i) => {
    try {
      return sweep(one);
    } catch (expected) {
      throw expected instanceof Expected ? new Expected(`at place ${i + 1} ${expected.message}`) : expected;
    }
  });
};

/** The known fields of an object; others are ignored. */
export function readFields<T extends object>(
  value: unknown,
  checks: { readonly [K in keyof T]-?: Check<NonNullable<T[K]>> },
): T {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new Expected('an object');
  const given = value as Record<string, unknown>;
  const fields: Partial<T> = {};
  for (const name of Object.keys(checks) as (keyof T & string)[]) {
    if (given[name] === undefined) continue;
    try {
      fields[name] = checks[name](given[name]);
    } catch (expected) {
      throw expected instanceof Expected ? new Expected(`as "${name}" ${expected.message}`) : expected;
    }
  }
  return fields as T;
}
