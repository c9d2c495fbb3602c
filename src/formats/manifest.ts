import { VolumeViewError } from '../errors.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import type { ChannelUse } from './channels.ts';
import { affine, ascendingPair, channelUse, count, Expected, filledText, filledTexts, finite, mosaicText, nonZero, nonZeroTriple, text } from './manifest-checks.ts';
import type { Check } from './manifest-checks.ts';
import { angles, azimuthPair, positive, rangePair, site, sweeps, utcTime } from './manifest-radar.ts';
import type { ManifestSite, ManifestSweep } from './manifest-radar.ts';

/** A JSON manifest, checked. Documented by schema/manifest.json, which a test holds against this file. */
export interface Manifest {
  /** URL of the data, relative to the manifest; of one with scans, the first scan's. Undefined where there are `files`. */
  readonly image?: string;
  /** URLs of a stack, the files of one volume in their order: images, a slice each, or a header and its data. */
  readonly files?: readonly string[];
  readonly mosaic?: { readonly columns: number; readonly rows: number };
  readonly slices?: number;
  /** How the image's channels make one number. */
  readonly channels?: ChannelUse;
  /** World units per pixel along i and j, per slice along k; per voxel of a NIfTI file. */
  readonly spacing?: Vector3;
  /** Row-major 4 x 4; wins over spacing. */
  readonly indexToWorld?: Matrix4;
  /** Data value = slope * value in the file + intercept. */
  readonly slope?: number;
  readonly intercept?: number;
  readonly unit?: string;
  readonly window?: readonly [number, number];
  readonly transferFunction?: string;
  readonly title?: string;
  readonly credit?: string;
  /** Degrees, one a tile: the mosaic is a radar's, a sweep a tile, rays downwards and gates to the right. */
  readonly elevations?: readonly number[];
  /** Metres to the middle of the first gate, and from gate to gate. */
  readonly range?: readonly [number, number];
  /** Middle of the first ray and step to the next one, degrees clockwise from north. */
  readonly azimuth?: readonly [number, number];
  /** Degrees. */
  readonly beamWidth?: number;
  /** What was measured, such as 'DBZH'. */
  readonly moment?: string;
  /** m/s: the values are velocities that fold over beyond. */
  readonly nyquist?: number;
  readonly site?: ManifestSite;
  /** ISO 8601 in UTC, when the scan began. */
  readonly time?: string;
  /** What is another for single tiles. */
  readonly sweeps?: readonly ManifestSweep[];
  /** One volume after another, in the order of time; each with what is the same for all. */
  readonly scans?: readonly Manifest[];
}

type Fields = Readonly<Record<string, unknown>>;

/**
 * Read a manifest. Unknown fields are left alone, for later versions and for others' notes.
 * @throws {VolumeViewError} `manifest/invalid`: the message names the field
 */
export function readManifest(bytes: Uint8Array): Manifest {
  const { scans, ...fields } = parseObject(bytes);
  if (scans === undefined) return readFields(fields);
  for (const name of ['image', 'files'] as const) {
    if (fields[name] !== undefined) fail(name, JSON.stringify(fields[name]), 'none beside "scans", each of which has its own');
  }
  const list = readScans(scans, fields);
  return { ...list[0], scans: list };
}

/** @param shared - what is the same for all scans */
function readScans(scans: unknown, shared: Fields): Manifest[] {
  if (!Array.isArray(scans) || scans.length === 0) return fail('scans', JSON.stringify(scans), 'a list of objects, one a scan');
  readFields({ image: '-', ...shared });
  const list = scans.map((scan: unknown, i) => {
    if (!isObject(scan) || scan.scans !== undefined) return fail('scans', JSON.stringify(scan), `{ "image": …, "time": … } at place ${i + 1}`);
    return readFields({ ...shared, ...scan }, `scans[${i}].`);
  });
  const times = list.flatMap(({ time }) => (time === undefined ? [] : [Date.parse(time)]));
  if (times.some((time, i) => time < times[i - 1])) fail('scans', 'times that go back', 'scans in the order of time');
  return list;
}

/** @param where - before a field's name in what is thrown */
function readFields(fields: Fields, where = ''): Manifest {
  if (fields.image === undefined && fields.files === undefined) {
    fail(`${where}image`, 'nothing', 'the URL of a mosaic image, a volume\'s file or a radar scan, or "files", a list of URLs');
  }
  if (fields.image !== undefined && fields.files !== undefined) fail(`${where}files`, JSON.stringify(fields.files), 'none beside "image"');
  const optional = <T>(name: string, check: Check<T>): T | undefined =>
    fields[name] === undefined ? undefined : checkField(where + name, fields[name], check);
  return {
    image: optional('image', filledText),
    files: optional('files', filledTexts),
    mosaic: optional('mosaic', mosaicText),
    slices: optional('slices', count),
    channels: optional('channels', channelUse),
    spacing: optional('spacing', nonZeroTriple),
    indexToWorld: optional('indexToWorld', affine),
    slope: optional('slope', nonZero),
    intercept: optional('intercept', finite),
    unit: optional('unit', text),
    window: optional('window', ascendingPair),
    transferFunction: optional('transferFunction', filledText),
    title: optional('title', text),
    credit: optional('credit', text),
    elevations: optional('elevations', angles),
    range: optional('range', rangePair),
    azimuth: optional('azimuth', azimuthPair),
    beamWidth: optional('beamWidth', positive),
    moment: optional('moment', filledText),
    nyquist: optional('nyquist', positive),
    site: optional('site', site),
    time: optional('time', utcTime),
    sweeps: optional('sweeps', sweeps),
    scans: undefined,
  };
}

function parseObject(bytes: Uint8Array): Fields {
  let value: unknown;
  try {
    value = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (cause) {
    const why = cause instanceof Error ? cause.message : String(cause);
    throw new VolumeViewError('manifest/invalid', `the manifest is not JSON: ${why}`, { cause });
  }
  if (!isObject(value)) throw new VolumeViewError('manifest/invalid', 'the manifest got another JSON value; expected an object { "image": … }');
  return value;
}

function isObject(value: unknown): value is Fields {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function checkField<T>(name: string, value: unknown, check: Check<T>): T {
  try {
    return check(value);
  } catch (expected) {
    return fail(name, JSON.stringify(value), expected instanceof Expected ? expected.message : String(expected));
  }
}

function fail(field: string, got: string, expected: string): never {
  const short = got.length > 80 ? `${got.slice(0, 80)}…` : got;
  throw new VolumeViewError('manifest/invalid', `the manifest's "${field}" got ${short}; expected ${expected}`);
}
