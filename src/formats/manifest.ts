import { VolumeViewError } from '../errors.ts';
import { invertAffine } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import type { ChannelUse } from './channels.ts';
import { parseMosaicSize } from '../volume/mosaic.ts';

/** A JSON manifest, checked. Documented by schema/manifest.json, which a test holds against this file. */
export interface Manifest {
  /** URL of the data, relative to the manifest. */
  readonly image: string;
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
}

/** Checks one field's value and brings it to the form that is used; throws what was expected. */
type Check<T> = (value: unknown) => T;

/**
 * Read a manifest. Unknown fields are left alone, for later versions and for others' notes.
 * @throws {VolumeViewError} `manifest/invalid`: the message names the field
 */
export function readManifest(bytes: Uint8Array): Manifest {
  const fields = parseObject(bytes);
  if (fields.image === undefined) fail('image', 'nothing', 'the URL of a mosaic image or a NIfTI file');
  const optional = <T>(name: string, check: Check<T>): T | undefined =>
    fields[name] === undefined ? undefined : checkField(name, fields[name], check);
  return {
    image: checkField('image', fields.image, filledText),
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
  };
}

function parseObject(bytes: Uint8Array): Record<string, unknown> {
  let value: unknown;
  try {
    value = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (cause) {
    const why = cause instanceof Error ? cause.message : String(cause);
    throw new VolumeViewError('manifest/invalid', `the manifest is not JSON: ${why}`, { cause });
  }
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw new VolumeViewError('manifest/invalid', 'the manifest got another JSON value; expected an object { "image": … }');
  }
  return value as Record<string, unknown>;
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

/** Says what a field should have been. */
class Expected extends Error {}

const isFinite = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);

const text: Check<string> = (value) => {
  if (typeof value !== 'string') throw new Expected('a text');
  return value;
};

const filledText: Check<string> = (value) => {
  if (typeof value !== 'string' || value === '') throw new Expected('a text that is not empty');
  return value;
};

const mosaicText: Check<{ columns: number; rows: number }> = (value) => {
  const size = typeof value === 'string' ? parseMosaicSize(value) : null;
  if (!size) throw new Expected('"COLUMNSxROWS", such as "10x10"');
  return size;
};

const count: Check<number> = (value) => {
  if (!Number.isSafeInteger(value) || (value as number) < 1) throw new Expected('a whole number from 1');
  return value as number;
};

const finite: Check<number> = (value) => {
  if (!isFinite(value)) throw new Expected('a number');
  return value;
};

const nonZero: Check<number> = (value) => {
  if (!isFinite(value) || value === 0) throw new Expected('a number other than 0');
  return value;
};

const channelUse: Check<ChannelUse> = (value) => {
  if (value !== 'gray' && value !== 'high-low') throw new Expected('"gray" or "high-low"');
  return value;
};

const nonZeroTriple: Check<Vector3> = (value) => {
  if (!Array.isArray(value) || value.length !== 3 || !value.every((n) => isFinite(n) && n !== 0)) {
    throw new Expected('three numbers other than 0');
  }
  return value as unknown as Vector3;
};

const ascendingPair: Check<[number, number]> = (value) => {
  if (!Array.isArray(value) || value.length !== 2 || !value.every(isFinite) || value[0] >= value[1]) {
    throw new Expected('two ascending numbers, [low, high]');
  }
  return value as [number, number];
};

const affine: Check<Matrix4> = (value) => {
  const isList = Array.isArray(value) && (value.length === 12 || value.length === 16) && value.every(isFinite);
  if (!isList) throw new Expected('12 or 16 numbers, row by row');
  const [a, b, c, d] = value.length === 16 ? value.slice(12) : [0, 0, 0, 1];
  if (a !== 0 || b !== 0 || c !== 0 || d !== 1) throw new Expected('0, 0, 0, 1 as the last row');
  const matrix = [...value.slice(0, 12), 0, 0, 0, 1];
  if (!invertAffine(matrix)) throw new Expected('three axes that do not lie in one plane');
  return matrix;
};
