import { VolumeViewError } from '../../core/errors.ts';
import { readScanTime } from '../../core/scan-time.ts';
import type { ScanTime } from '../../core/scan-time.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { ChannelUse } from '../base/channels.ts';
import {
  affine,
  ascendingPair,
  channelUse,
  count,
  Expected,
  filledShortText,
  filledText,
  filledTexts,
  finite,
  mosaicText,
  nonZero,
  nonZeroTriple,
  shortText,
  text,
} from './manifest-checks.ts';
import type { Check } from './manifest-checks.ts';
import { angles, azimuthPair, positive, rangePair, scanTime, site, sweeps } from './manifest-radar.ts';
import type { ManifestSite, ManifestSweep } from '../base/radar-settings.ts';
import type { RawLayout } from '../raw/raw-layout.ts';
import { labels, pixel, prepared, yes } from './manifest-prepared.ts';
import type { PreparedFields } from './manifest-prepared.ts';
import { lossy } from './manifest-lossy.ts';
import type { Lossy } from '../../volume/volume.ts';
import { raw } from './manifest-raw.ts';

/** A JSON manifest, checked. Documented by schema/manifest.json; a test compares that with this file. */
export interface Manifest extends PreparedFields {
  /** URL of the data, relative to the manifest; if there are scans, the first scan's. Undefined if there are `files`. */
  readonly image?: string;
  /** URLs of a stack, the files of one volume in their order: images, one slice each, or a header and its data. */
  readonly files?: readonly string[];
  /** Instead of them, URL of a video: each frame is a mosaic. The scans, where there are some, are its frames. */
  readonly video?: string;
  /** Set if the files have no header: how their numbers lie. */
  readonly raw?: RawLayout;
  readonly mosaic?: { readonly columns: number; readonly rows: number };
  readonly slices?: number;
  /** How the image's channels make one number. */
  readonly channels?: ChannelUse;
  /** World units per pixel along i and j, per slice along k; per voxel of a NIfTI file. */
  readonly spacing?: Vector3;
  /** Row-major 4 x 4; overrides spacing. */
  readonly indexToWorld?: Matrix4;
  /** Data value = slope * value in the file + intercept. */
  readonly slope?: number;
  readonly intercept?: number;
  readonly unit?: string;
  readonly window?: readonly [number, number];
  readonly transferFunction?: string;
  readonly title?: string;
  readonly credit?: string;
  /** Degrees, one per tile. The mosaic is a radar's, one sweep per tile, with rays downwards and gates to the right. */
  readonly elevations?: readonly number[];
  /** Metres to the middle of the first gate, and from gate to gate. */
  readonly range?: readonly [number, number];
  /** Middle of the first ray, and the step to the next one, degrees clockwise from north. */
  readonly azimuth?: readonly [number, number];
  /** Degrees. */
  readonly beamWidth?: number;
  /** What was measured, such as 'DBZH'. */
  readonly moment?: string;
  /** m/s. If set, the values are velocities that fold at this speed. */
  readonly nyquist?: number;
  readonly site?: ManifestSite;
  /** ISO 8601 in UTC, when the scan began. */
  readonly time?: string;
  /** Values of single tiles that differ. */
  readonly sweeps?: readonly ManifestSweep[];
  /** How far the values are from those before a lossy form, such as a video, was made. */
  readonly lossy?: Lossy;
  /** Several volumes in the order of time; each includes what is the same for all. */
  readonly scans?: readonly Manifest[];
}

type Fields = Readonly<Record<string, unknown>>;

/** Maximum bytes of a manifest: thousands of scans whose sweeps list all their azimuths take a tenth of it. */
const maxBytes = 2 ** 26;

/** Maximum number of scans: a day of them, one every ten seconds, is fewer. */
export const maxScans = 10_000;

/**
 * Reads a manifest. Unknown fields are ignored: they may come from later versions, or be the author's notes.
 * @throws {VolumeViewError} `manifest/invalid`: the message names the field
 */
export function readManifest(bytes: Uint8Array): Manifest {
  const { scans, ...fields } = parseObject(bytes);
  const shared = readFields(fields);
  if (scans === undefined || shared.video !== undefined) checkSource(shared);
  if (scans === undefined) {
    checkTime(shared);
    return { ...empty, ...shared };
  }
  for (const name of ['image', 'files'] as const) {
    if (fields[name] !== undefined) fail(name, fields[name], 'none together with "scans": each scan has its own');
  }
  const list = readScans(scans, shared);
  return { ...list[0], scans: list };
}

/**
 * @param shared - fields that are the same for all scans: they have been checked, and are not checked again for each
 * scan
 */
function readScans(scans: unknown, shared: Partial<Manifest>): Manifest[] {
  if (!Array.isArray(scans) || scans.length === 0 || scans.length > maxScans) {
    return fail('scans', scans, `a list of 1 to ${maxScans.toLocaleString('en')} objects, one a scan`);
  }
  const list = scans.map((scan: unknown, i): Manifest => {
    if (!isObject(scan) || scan.scans !== undefined)
      return fail('scans', scan, `{ "image": …, "time": … } at place ${i + 1}`);
    const own = readFields(scan, `scans[${i}].`);
    checkScan(own, shared, `scans[${i}].`);
    const scanned = { ...empty, ...shared, ...own };
    checkTime(scanned, `scans[${i}].`);
    return scanned;
  });
  let last: ScanTime | null = null;
  for (const { time } of list) {
    const now: ScanTime | null = time === undefined ? last : readScanTime(time);
    if (last && now!.unit !== last.unit)
      fail('scans', time, 'scans that all have a time in UTC, or all one in the same unit');
    if (last && now!.value < last.value) fail('scans', time, 'scans in the order of time');
    last = now;
  }
  return list;
}

/** The sweeps of a radar are shown with the time of the day. */
function checkTime({ elevations, time }: Partial<Manifest>, where = ''): void {
  if (elevations !== undefined && time !== undefined && readScanTime(time)?.unit !== 'UTC')
    failWith(`${where}time`, `"${time}"`, 'a time in UTC, because it is a scan of a radar');
}

/** The fields that say where the data are. */
const sourceNames = ['image', 'files', 'video'] as const;

/** @param where - goes before a field's name in an error message */
function checkSource(manifest: Partial<Manifest>, where = ''): void {
  const [first, second] = sourceNames.filter((name) => manifest[name] !== undefined);
  if (first === undefined) {
    failWith(
      `${where}image`,
      'nothing',
      'the URL of a mosaic image, a volume\'s file or a radar scan, or "files", a list of URLs, or "video"',
    );
  }
  if (second !== undefined) fail(where + second, manifest[second], `none together with "${first}"`);
  if (first === 'video') checkFrame(manifest, where);
}

/** A scan has its own source, or is a frame of the video of all. @param where - goes before a field's name in an error message */
function checkScan(own: Partial<Manifest>, { video }: Partial<Manifest>, where: string): void {
  if (own.video !== undefined)
    fail(
      `${where}video`,
      own.video,
      'none in a scan: "video" and "scans" stand together, and each scan is one of its frames',
    );
  if (video === undefined) return checkSource(own, where);
  for (const name of ['image', 'files'] as const)
    if (own[name] !== undefined)
      fail(where + name, own[name], 'none together with "video": each scan is one of its frames');
  checkFrame(own, where);
}

function checkFrame({ raw, channels }: Partial<Manifest>, where: string): void {
  if (raw !== undefined) fail(`${where}raw`, raw, 'none together with "video"');
  if (channels === 'high-low') fail(`${where}channels`, channels, '"gray": a video has one number for each pixel');
}

const checks: { readonly [Name in Exclude<keyof Manifest, 'scans'>]: Check<NonNullable<Manifest[Name]>> } = {
  image: filledText,
  files: filledTexts,
  video: filledText,
  raw,
  mosaic: mosaicText,
  slices: count,
  channels: channelUse,
  spacing: nonZeroTriple,
  indexToWorld: affine,
  slope: nonZero,
  intercept: finite,
  unit: shortText,
  window: ascendingPair,
  transferFunction: filledText,
  title: text,
  credit: text,
  elevations: angles,
  range: rangePair,
  azimuth: azimuthPair,
  beamWidth: positive,
  moment: filledShortText,
  nyquist: positive,
  site,
  time: scanTime,
  sweeps,
  labels,
  noData: pixel,
  noDataBelow: pixel,
  anatomical: yes,
  prepared,
  lossy,
};

/** All fields, each undefined. */
const empty: Manifest = Object.fromEntries([...Object.keys(checks), 'scans'].map((name) => [name, undefined]));

/** Reads the known fields; others are ignored. @param where - goes before a field's name in an error message */
function readFields(fields: Fields, where = ''): Partial<Manifest> {
  const read: [string, unknown][] = [];
  for (const [name, check] of Object.entries(checks)) {
    const value = Object.hasOwn(fields, name) ? fields[name] : undefined;
    if (value !== undefined) read.push([name, checkField(where + name, value, check as Check<unknown>)]);
  }
  return Object.fromEntries(read);
}

function parseObject(bytes: Uint8Array): Fields {
  if (bytes.length > maxBytes) {
    throw new VolumeViewError(
      'format/too-large',
      `the manifest got ${bytes.length.toLocaleString('en')} bytes; expected at most ${maxBytes.toLocaleString('en')}: list fewer scans, or their sweeps in manifests of their own`,
    );
  }
  let value: unknown;
  try {
    value = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (cause) {
    const why = cause instanceof Error ? cause.message : String(cause);
    throw new VolumeViewError('manifest/invalid', `the manifest is not JSON: ${why}`, { cause });
  }
  if (!isObject(value))
    throw new VolumeViewError(
      'manifest/invalid',
      'the manifest got another JSON value; expected an object { "image": … }',
    );
  return value;
}

function isObject(value: unknown): value is Fields {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function checkField<T>(name: string, value: unknown, check: Check<T>): T {
  try {
    return check(value);
  } catch (expected) {
    return fail(name, value, expected instanceof Expected ? expected.message : String(expected));
  }
}

function fail(field: string, got: unknown, expected: string): never {
  return failWith(field, describe(got), expected);
}

function failWith(field: string, got: string, expected: string): never {
  const short = got.length > 80 ? `${got.slice(0, 80)}…` : got;
  throw new VolumeViewError('manifest/invalid', `the manifest's "${field}" got ${short}; expected ${expected}`);
}

/** The beginning of a value as JSON: the whole may be megabytes long, or thousands of nested lists. */
function describe(value: unknown, depth = 0): string {
  if (typeof value === 'string') return JSON.stringify(value.slice(0, 80));
  if (typeof value !== 'object' || value === null) return String(value);
  if (depth > 2) return '…';
  if (Array.isArray(value))
    return `[${value
      .slice(0, 20)
      .map((one) => describe(one, depth + 1))
      .join(',')}${value.length > 20 ? ',…' : ''}]`;
  return `{${Object.keys(value)
    .slice(0, 10)
    .map((key) => `${JSON.stringify(key.slice(0, 40))}:${describe((value as Fields)[key], depth + 1)}`)
    .join(',')}}`;
}
