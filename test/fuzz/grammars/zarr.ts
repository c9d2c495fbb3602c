import { deflateRawSync, deflateSync, gzipSync } from 'node:zlib';
import { crc32 } from '../../../src/formats/codecs/crc32.ts';
import { jsonBytes, pyramidFiles, writeArray } from '../../helpers/zarr-bytes.ts';
import { zipBytes } from '../../helpers/zip-bytes.ts';
import type { ZipPart } from '../../helpers/zip-bytes.ts';
import { little } from '../bytes.ts';
import { damage } from '../fuzz-case.ts';
import type { FilesCase, Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** What may stand in metadata in place of anything. */
const odd = [
  null,
  0,
  -1,
  1e9,
  2 ** 31,
  2 ** 53,
  0.5,
  1e-300,
  1e300,
  '',
  'x',
  '../..',
  [],
  {},
  [1e9, 1e9, 1e9],
  [0],
  true,
] as const;

/** Pyramids of Zarr 2 and 3 with metadata and chunks that lie: shapes, chunks, shards, transforms, packings. Source: zarr-specs, OME-Zarr 0.5 */
export const zarr: Grammar = (random): FilesCase => {
  const version = random.pick([2, 3] as const);
  const axes = random.pick(['zyx', 'czyx', 'tzyx', 'xyz', 'yx', 'tczyx']);
  const shape = Array.from(axes, (name) => ('xyz'.includes(name) ? random.int(1, 9) : random.int(1, 3)));
  const chunk = shape.map((n) => random.int(1, n));
  const files = pyramidFiles({
    version,
    axes,
    shape,
    chunk,
    shard: version === 3 && random.chance(0.5) ? chunk.map((n) => n * random.int(1, 3)) : undefined,
    type: random.pick(['uint8', 'uint16', 'float32'] as const),
    levels: random.int(1, 3),
    attributes: {
      ...(random.chance(0.2) && { 'image-label': { colors: [{ 'label-value': 1, rgba: [255, 0, 0, 255] }] } }),
      ...(random.chance(0.4) && {
        omero: { channels: Array.from({ length: random.int(0, 4) }, () => channelOf(random)) },
      }),
    },
  });
  const isPacked = version === 2 && random.chance(0.5);
  const compressor = random.isSound ? 'gzip' : random.pick(['gzip', 'zlib', 'blosc', 'zstd', 'lz4', 'bz2']);
  for (const [path, bytes] of files) {
    if (/json$|\/?\.z/.test(path)) {
      const metadata = JSON.parse(new TextDecoder().decode(bytes)) as Record<string, unknown>;
      if (isPacked && path.endsWith('.zarray')) metadata.compressor = { id: compressor };
      if (random.isWild()) change(random, metadata);
      files.set(path, damageText(random, jsonBytes(metadata)));
    } else if (random.isWild()) files.delete(path);
    else files.set(path, damage(random, isPacked ? pack(random, compressor, bytes) : bytes));
  }
  const isArchive = random.chance(0.3);
  return {
    files: isArchive
      ? [{ name: 'x.ozx', bytes: damage(random, archiveOf(random, files)) }]
      : [...files].map(([name, bytes]) => ({ name, bytes })),
    isTree: true,
    isPacked: isArchive,
    choice: {
      ...(random.chance(0.3) && { channels: random.or('1,2', ...oddChannels) }),
      ...(random.chance(0.1) && { channel: random.or('1', ...oddChannels) }),
    },
    settings: {
      ...(random.chance(0.2) && { labelDetail: random.number(0.002) }),
      ...(random.chance(0.2) && { region: [random.number(0), -0.005, 0, random.number(-0.005), 0, 0.004] }),
      ...(random.chance(0.2) && { scan: { index: random.int(0, 2) } }),
    },
  };
};

/** The same read brick by brick, with a table of what its levels hide, which lies too. */
export const bricks: Grammar = (random): FilesCase => {
  const one = zarr(random) as FilesCase;
  const levels = new Set(one.files.map(({ name }) => /^(\d)\//.exec(name)?.[1])).size - 1;
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  const group = { version: random.or(1, 0, 2, 1e300), block: random.or<unknown>([32, 32, 32], ...odd), levels };
  files.set('zarr.json', jsonBytes({ attributes: { 'volume-view': group } }));
  const names = Array.from({ length: levels }, (_, n) =>
    n === 0 ? ['min', 'max'] : [`residual-max-${n}`, `residual-rms-${n}`],
  ).flat();
  for (const name of names)
    writeArray(files, name, {
      version: 3,
      type: 'float32',
      shape: random.or([1, 1, 1], [1, 1, 2], [1, 1]),
      chunk: [1, 1, 1],
      valueAt: () => random.or(1, NaN, -1, 1e38, Infinity),
    });
  for (const [path, bytes] of files) {
    if (!path.endsWith('.json')) continue;
    const metadata = JSON.parse(new TextDecoder().decode(bytes)) as Record<string, unknown>;
    if (random.isWild()) change(random, metadata);
    files.set(path, jsonBytes(metadata));
  }
  return {
    ...one,
    isBricks: true,
    files: [...one.files, ...[...files].map(([name, bytes]) => ({ name: `volume-view/${name}`, bytes }))],
    choice: { channel: '1', ...one.choice },
  };
};

/** What an address may ask for in place of channels. */
const oddChannels = [
  '2,1',
  '3',
  '',
  ' ',
  ',',
  '0',
  '-1',
  '1,1,1',
  '1e9',
  '1.5',
  'x',
  'NaN',
  '1,2,3,4,5,6,7,8,9',
  '1,'.repeat(2000),
];

/** The files in a ZIP archive, stored or packed, some with sizes, places and checksums that lie, in folders or twice. */
function archiveOf(random: Random, files: ReadonlyMap<string, Uint8Array<ArrayBuffer>>): Uint8Array<ArrayBuffer> {
  const folder = random.or('', 'cells.zarr/', '../', '/', 'a/b/');
  const parts = [...files].map(([path, bytes]): ZipPart => {
    const isDeflated = random.chance(0.3);
    return {
      path: random.or(folder + path, path, folder + path.toUpperCase(), `${folder}zarr.json`),
      packed: isDeflated ? deflateRawSync(bytes) : bytes,
      method: random.or(isDeflated ? 8 : 0, 0, 8, 9, 93),
      crc: random.or(crc32(bytes), 0),
      size: random.size(bytes.length) % 2 ** 32,
      ...(random.isWild() && { offset: random.size(30) % 2 ** 32 }),
      ...(random.isWild() && { flags: random.pick([1, 8, 0x800, 0xffff]) }),
    };
  });
  return zipBytes(random.chance(0.1) ? [...parts, ...parts] : parts, {
    ...(random.isWild() && { count: random.size(parts.length) % 2 ** 16 }),
    ...(random.isWild() && { listOffset: random.size(0) % 2 ** 32 }),
  });
}

/** How a channel is to look. */
const channelOf = (random: Random): unknown => ({
  label: random.or<unknown>('DAPI', 5, null, '<b>', 'x'.repeat(1000)),
  color: random.or<unknown>('00FF00', 'javascript:alert(1)', '#12', 7, '000000', 'red;x:url(//y)'),
  active: random.or<unknown>(true, false, null, 'no', 0),
  window: random.or<unknown>(
    { start: 0, end: 200 },
    null,
    { start: 5, end: 5 },
    { start: -1e308, end: 1e308 },
    { start: 'a' },
    [],
  ),
});

/** One value somewhere inside becomes another one. */
function change(random: Random, value: unknown): void {
  if (typeof value !== 'object' || value === null) return;
  const keys = Object.keys(value);
  if (keys.length === 0) return;
  const key = random.pick(keys);
  const inner: unknown = Reflect.get(value, key);
  if (typeof inner === 'object' && inner !== null && random.chance(0.8)) change(random, inner);
  else Reflect.set(value, key, random.pick(odd));
}

/** A metadata file is seldom cut. */
const damageText = (random: Random, bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> =>
  random.isWild() ? damage(random, bytes) : bytes;

/** Packed as the metadata say, if this can pack it; else noise, with a header that may lie. */
function pack(random: Random, compressor: string, bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const size = random.size(bytes.length) % 2 ** 32;
  switch (compressor) {
    case 'gzip':
      return new Uint8Array(gzipSync(bytes));
    case 'blosc': {
      const isStored = random.chance(0.5);
      const out = little()
        .u8(2, 1, random.or(isStored ? 0x22 : 0x21, 0x01, 0x24, 0x44, 0x61, 0x81, 0xff), random.or(2, 0, 1, 8, 255))
        .u32(size, random.size(bytes.length || 1) % 2 ** 32);
      const body = isStored ? bytes : little().u32(20).put(random.bytes(bytes.length)).finish();
      return out
        .u32(random.size(16 + body.length) % 2 ** 32)
        .put(body)
        .finish();
    }
    case 'lz4':
      return little().u32(size).put(random.bytes(bytes.length)).finish();
    case 'zlib':
      return new Uint8Array(deflateSync(bytes));
    default:
      return random.chance(0.5) ? new Uint8Array(gzipSync(bytes)) : random.bytes(bytes.length);
  }
}
