// Writes small stores of Zarr 2 and 3, without packing. Source: zarr-specs.readthedocs.io, v2 and v3
import { crc32c } from '../../src/formats/codecs/crc32c.ts';

/** Files of a store by their paths. */
export type ZarrFiles = ReadonlyMap<string, Uint8Array<ArrayBuffer>>;

/** An array, as a test describes it. */
export interface ArrayCase {
  readonly shape: readonly number[];
  readonly chunk: readonly number[];
  /** 'uint16' */
  readonly type?: 'uint8' | 'uint16' | 'float32';
  readonly version?: 2 | 3;
  /** Of Zarr 3: voxels of a shard. */
  readonly shard?: readonly number[];
  /** The value at a place. */
  valueAt(place: readonly number[]): number;
  /** Whether a chunk is left out. */
  isMissing?(place: readonly number[]): boolean;
  /** In place of what the metadata would say. */
  readonly metadata?: Readonly<Record<string, unknown>>;
}

const sizes = { uint8: 1, uint16: 2, float32: 4 } as const;
const letters = { uint8: '|u1', uint16: '<u2', float32: '<f4' } as const;

export const jsonBytes = (value: unknown): Uint8Array<ArrayBuffer> => new TextEncoder().encode(JSON.stringify(value));

/** All places in a block of these lengths, the last axis fastest. */
function placesIn(lengths: readonly number[]): number[][] {
  let places: number[][] = [[]];
  for (const length of lengths) places = places.flatMap((place) => Array.from({ length }, (_, i) => [...place, i]));
  return places;
}

/** The files of an array. @param path - its folder, without a slash at its end; '' for that of the store */
export function writeArray(files: Map<string, Uint8Array<ArrayBuffer>>, path: string, array: ArrayCase): void {
  const { shape, chunk, type = 'uint16', version = 2, shard, metadata } = array;
  const folder = path && `${path}/`;
  const isThree = version === 3;
  const own = isThree
    ? {
        zarr_format: 3,
        node_type: 'array',
        shape,
        data_type: type,
        chunk_grid: { name: 'regular', configuration: { chunk_shape: shard ?? chunk } },
        chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
        fill_value: 0,
        codecs: shard
          ? [
              {
                name: 'sharding_indexed',
                configuration: {
                  chunk_shape: chunk,
                  codecs: [{ name: 'bytes', configuration: { endian: 'little' } }],
                  index_codecs: [{ name: 'bytes', configuration: { endian: 'little' } }, { name: 'crc32c' }],
                },
              },
            ]
          : [{ name: 'bytes', configuration: { endian: 'little' } }],
        attributes: {},
      }
    : {
        zarr_format: 2,
        shape,
        chunks: chunk,
        dtype: letters[type],
        compressor: null,
        fill_value: 0,
        order: 'C',
        filters: null,
        dimension_separator: '/',
      };
  files.set(`${folder}${isThree ? 'zarr.json' : '.zarray'}`, jsonBytes({ ...own, ...metadata }));
  const keyOf = (place: readonly number[]): string => `${folder}${(isThree ? ['c', ...place] : place).join('/')}`;
  const chunks = placesIn(shape.map((n, axis) => Math.ceil(n / chunk[axis]))).filter(
    (place) => !array.isMissing?.(place),
  );
  if (!shard) for (const place of chunks) files.set(keyOf(place), chunkBytes(array, place));
  else {
    const counts = shard.map((n, axis) => n / chunk[axis]);
    for (const outer of placesIn(shape.map((n, axis) => Math.ceil(n / shard[axis])))) {
      const inside = chunks.filter((place) => place.every((n, axis) => Math.floor(n / counts[axis]) === outer[axis]));
      if (inside.length > 0) files.set(keyOf(outer), shardBytes(array, inside, counts));
    }
  }
}

function chunkBytes(
  { shape, chunk, type = 'uint16', valueAt }: ArrayCase,
  place: readonly number[],
): Uint8Array<ArrayBuffer> {
  const size = sizes[type];
  const voxels = placesIn(chunk);
  const view = new DataView(new ArrayBuffer(voxels.length * size));
  for (const [i, inside] of voxels.entries()) {
    const at = inside.map((n, axis) => n + place[axis] * chunk[axis]);
    const value = at.every((n, axis) => n < shape[axis]) ? valueAt(at) : 0;
    if (type === 'uint8') view.setUint8(i, value);
    else if (type === 'uint16') view.setUint16(2 * i, value, true);
    else view.setFloat32(4 * i, value, true);
  }
  return new Uint8Array(view.buffer);
}

function shardBytes(
  array: ArrayCase,
  inside: readonly (readonly number[])[],
  counts: readonly number[],
): Uint8Array<ArrayBuffer> {
  const total = counts.reduce((product, n) => product * n, 1);
  const index = new DataView(new ArrayBuffer(16 * total + 4));
  for (let i = 0; i < 2 * total; i++) index.setBigUint64(8 * i, 2n ** 64n - 1n, true);
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let at = 0;
  for (const place of inside) {
    const bytes = chunkBytes(array, place);
    const i = place.reduce((sum, n, axis) => sum * counts[axis] + (n % counts[axis]), 0);
    index.setBigUint64(16 * i, BigInt(at), true);
    index.setBigUint64(16 * i + 8, BigInt(bytes.length), true);
    parts.push(bytes);
    at += bytes.length;
  }
  const bytes = new Uint8Array(at + index.byteLength);
  let start = 0;
  for (const part of parts) {
    bytes.set(part, start);
    start += part.length;
  }
  const list = new Uint8Array(index.buffer);
  index.setUint32(16 * total, crc32c(list.subarray(0, -4)), true);
  bytes.set(list, at);
  return bytes;
}

/** A pyramid, as a test describes it. */
export interface PyramidCase {
  readonly version?: 2 | 3;
  /** Of the finest level, in the order of the axes. */
  readonly shape: readonly number[];
  readonly chunk?: readonly number[];
  readonly shard?: readonly number[];
  readonly type?: ArrayCase['type'];
  /** Names of the axes: 'zyx' if undefined. */
  readonly axes?: string;
  /** Unit of the axes of space, and of time. */
  readonly unit?: string | null;
  readonly timeUnit?: string;
  /** The finest level's voxel along z, y and x, and where its first voxel lies. */
  readonly scale?: readonly number[];
  readonly translation?: readonly number[];
  readonly levels?: number;
  /** Value at a place in units of the file along x, y and z; with time and channel. */
  valueAt?(place: { x: number; y: number; z: number; t: number; c: number }): number;
  readonly isMissing?: ArrayCase['isMissing'];
  /** Added to the attributes of OME. */
  readonly attributes?: Readonly<Record<string, unknown>>;
  /** Added to the multiscale. */
  readonly multiscale?: Readonly<Record<string, unknown>>;
}

/** A number that differs from voxel to voxel: a plane through space, so that its mean over a block is its value in the middle. */
const plane: NonNullable<PyramidCase['valueAt']> = ({ x, y, z, t, c }) =>
  1000 + 8 * x + 64 * y + 512 * z + 10_000 * c + 100 * t;

/** The files of an image with levels, each with voxels twice as long as those before it, and right places. */
export function pyramidFiles(pyramid: PyramidCase): Map<string, Uint8Array<ArrayBuffer>> {
  const { version = 2, shape, axes = 'zyx', unit = 'micrometer', timeUnit, levels = 1, valueAt = plane } = pyramid;
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  const names = Array.from(axes);
  const { scale = names.map(() => 1), translation = names.map(() => 0) } = pyramid;
  const isSpace = names.map((name) => 'xyz'.includes(name));
  const datasets = Array.from({ length: levels }, (_, level) => {
    const factor = isSpace.map((one) => (one ? 2 ** level : 1));
    const own = shape.map((n, axis) => Math.max(1, Math.ceil(n / factor[axis])));
    const step = scale.map((one, axis) => one * factor[axis]);
    const start = translation.map((one, axis) => one + ((factor[axis] - 1) / 2) * scale[axis]);
    writeArray(files, String(level), {
      version,
      shape: own,
      chunk: pyramid.chunk ?? own.map((n, axis) => (isSpace[axis] ? Math.min(n, 4) : 1)),
      shard: pyramid.shard,
      type: pyramid.type,
      isMissing: pyramid.isMissing,
      valueAt: (place) => {
        const at = { x: 0, y: 0, z: 0, t: 0, c: 0 };
        for (const [axis, name] of names.entries())
          at[name as 'x'] = isSpace[axis] ? step[axis] * place[axis] + start[axis] : place[axis];
        return valueAt(at);
      },
    });
    return {
      path: String(level),
      coordinateTransformations: [
        { type: 'scale', scale: step },
        { type: 'translation', translation: start },
      ],
    };
  });
  const typed = names.map((name, axis) => ({
    name,
    type: isSpace[axis] ? 'space' : name === 't' ? 'time' : 'channel',
    ...(isSpace[axis] && unit && { unit }),
    ...(name === 't' && timeUnit && { unit: timeUnit }),
  }));
  const image = { version: '0.4', name: 'image', axes: typed, datasets, ...pyramid.multiscale };
  const ome = { multiscales: [image], ...pyramid.attributes };
  if (version === 3)
    files.set(
      'zarr.json',
      jsonBytes({ zarr_format: 3, node_type: 'group', attributes: { ome: { version: '0.5', ...ome } } }),
    );
  else {
    files.set('.zgroup', jsonBytes({ zarr_format: 2 }));
    files.set('.zattrs', jsonBytes(ome));
  }
  return files;
}
