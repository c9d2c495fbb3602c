// Writes arrays of Zarr 3. Source: Zarr 3 specification; its codec "sharding_indexed" 1.0
import { crc32c } from '../formats/codecs/crc32c.ts';
import type { Vector3 } from '../volume/matrix.ts';

/** Numbers of an array of three axes. */
export interface ArrayData {
  /** 'int16': as Zarr calls it. */
  readonly type: string;
  /** Lengths along i, j and k. In the file the axes are z, y and x. */
  readonly dimensions: Vector3;
  /** What numbers of chunks that are left out have. */
  readonly fill: number;
  /**
   * The numbers of a chunk of `side` along each axis, i fastest, little-endian; what reaches over the end has the fill value. Null where all of them have it.
   */
  chunkAt(at: Vector3): Uint8Array | null;
}

/** How an array lies in its files. */
export interface ArrayLayout {
  /** Numbers of a chunk, and chunks of a shard, along each axis. */
  readonly side: number;
  readonly chunksPerShard: number;
  /** gzip. */
  pack(bytes: Uint8Array): Uint8Array;
}

/** A file by its path in the store. */
export type StoreFile = readonly [path: string, content: Uint8Array | string];

/** In place of the offset and the length of a chunk that is not there. */
const absent = 0xffff_ffff_ffff_ffffn;

/** The files of an array, one after the other: its metadata, then its shards. */
export function* writeArray(path: string, array: ArrayData, layout: ArrayLayout): Generator<StoreFile> {
  const { side, chunksPerShard } = layout;
  const { dimensions, type, fill } = array;
  const backwards = (lengths: readonly number[]): number[] => [lengths[2], lengths[1], lengths[0]];
  // A shard that is larger than its array would only have a larger index.
  const perShard = dimensions.map((n) => Math.min(chunksPerShard, Math.ceil(n / side))) as unknown as Vector3;
  const little = { name: 'bytes', configuration: { endian: 'little' } };
  yield [
    `${path}/zarr.json`,
    jsonOf({
      zarr_format: 3,
      node_type: 'array',
      shape: backwards(dimensions),
      data_type: type,
      chunk_grid: { name: 'regular', configuration: { chunk_shape: backwards(perShard.map((n) => n * side)) } },
      chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
      fill_value: Number.isNaN(fill) ? 'NaN' : fill,
      codecs: [
        {
          name: 'sharding_indexed',
          configuration: {
            chunk_shape: [side, side, side],
            codecs: [type.endsWith('8') ? { name: 'bytes' } : little, { name: 'gzip', configuration: { level: 6 } }],
            index_codecs: [little, { name: 'crc32c' }],
            index_location: 'end',
          },
        },
      ],
      dimension_names: ['z', 'y', 'x'],
      attributes: {},
    }),
  ];
  const shards = dimensions.map((n, axis) => Math.ceil(n / (side * perShard[axis])));
  for (let k = 0; k < shards[2]; k++)
    for (let j = 0; j < shards[1]; j++)
      for (let i = 0; i < shards[0]; i++) {
        const bytes = packShard([i, j, k], perShard, array, layout);
        if (bytes) yield [`${path}/c/${k}/${j}/${i}`, bytes];
      }
}

/** The chunks of a shard, and its index; null where it has none. */
function packShard(at: Vector3, perShard: Vector3, array: ArrayData, { side, pack }: ArrayLayout): Uint8Array | null {
  const count = perShard[0] * perShard[1] * perShard[2];
  const index = new BigUint64Array(2 * count).fill(absent);
  const chunks: Uint8Array[] = [];
  let length = 0;
  for (let n = 0; n < count; n++) {
    // i is the fastest axis, in the index too.
    const inside = [
      n % perShard[0],
      Math.floor(n / perShard[0]) % perShard[1],
      Math.floor(n / (perShard[0] * perShard[1])),
    ];
    const chunk = inside.map((one, axis) => at[axis] * perShard[axis] + one) as unknown as Vector3;
    if (chunk.some((one, axis) => one * side >= array.dimensions[axis])) continue;
    const bytes = array.chunkAt(chunk);
    if (!bytes) continue;
    const packed = pack(bytes);
    index.set([BigInt(length), BigInt(packed.length)], 2 * n);
    chunks.push(packed);
    length += packed.length;
  }
  if (chunks.length === 0) return null;
  const shard = new Uint8Array(length + index.byteLength + 4);
  let end = 0;
  for (const chunk of chunks) {
    shard.set(chunk, end);
    end += chunk.length;
  }
  const view = new DataView(shard.buffer);
  for (const [n, value] of index.entries()) view.setBigUint64(end + 8 * n, value, true);
  view.setUint32(end + index.byteLength, crc32c(shard.subarray(end, end + index.byteLength)), true);
  return shard;
}

/** JSON as these files have it: for people, too. */
export const jsonOf = (value: unknown): string => `${JSON.stringify(value, null, 2)}\n`;
