import { checkLengths } from '../base/check-lengths.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { float16 } from '../base/half-floats.ts';
import { numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { isObject, listOf, numbersOf, objectOf, shownWord } from './read-json.ts';
import type { Json } from './read-json.ts';

/** One way of packing bytes: its name as in Zarr 3, and its settings. */
export interface ByteCodec {
  readonly name: string;
  readonly configuration: Json;
}

/** Several chunks in one file, with an index at its start or end. */
export interface Sharding {
  /** Voxels of a shard along each axis: multiples of those of a chunk. */
  readonly shape: readonly number[];
  readonly isIndexFirst: boolean;
  readonly hasChecksum: boolean;
}

/** What the metadata of an array say. */
export interface ZarrArray {
  /** Of its folder, '' or with a slash at its end. */
  readonly path: string;
  readonly shape: readonly number[];
  /** Voxels of what is packed together, along each axis. */
  readonly chunk: readonly number[];
  readonly shards: Sharding | null;
  readonly type: NumberType;
  readonly littleEndian: boolean;
  /** What voxels of missing chunks have. */
  readonly fill: number;
  /** Axes of the numbers of a chunk, the slowest first. */
  readonly order: readonly number[];
  /** In the order of packing. */
  readonly codecs: readonly ByteCodec[];
  /** Names of the axes; empty where the file gives none. */
  readonly names: readonly string[];
  /** The path of the file of a chunk, or of a shard, below that of the array. */
  fileOf(place: readonly number[]): string;
}

/** More axes than any microscope has. */
const maxAxes = 16;

/** Bytes of one chunk, unpacked. */
export const maxChunkBytes = 2 ** 28;

/** Chunks of a shard: an index of 16 MiB. */
const maxChunksOfShard = 2 ** 20;

const typeNames: ReadonlyMap<string, NumberType> = new Map(
  [...Object.values(numberTypes), float16].map((type) => [type.name, type] as const),
);

/** The types of Zarr 2, without byte order. Source: NumPy's array interface */
const letters: Readonly<Record<string, NumberType>> = {
  b1: numberTypes.uint8,
  u1: numberTypes.uint8,
  i1: numberTypes.int8,
  u2: numberTypes.uint16,
  i2: numberTypes.int16,
  u4: numberTypes.uint32,
  i4: numberTypes.int32,
  u8: numberTypes.uint64,
  i8: numberTypes.int64,
  f2: float16,
  f4: numberTypes.float32,
  f8: numberTypes.float64,
};

/**
 * Reads the metadata of an array of Zarr 2 (`.zarray`) or 3 (`zarr.json`).
 * @param what - for messages: 'level 2 of the Zarr'
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readArray(metadata: Json, path: string, what: string): ZarrArray {
  const array = metadata.zarr_format === 3 ? readVersion3(metadata, path, what) : readVersion2(metadata, path, what);
  const { shape, chunk, shards, type, order } = array;
  if (shape.length < 2 || shape.length > maxAxes)
    throw unsupportedFile(what, `has ${shape.length} axes; expected 2 or more, such as z, y and x`);
  checkLengths(what, 'shape', shape);
  if (chunk.length !== shape.length || (shards && shards.shape.length !== shape.length))
    throw corruptFile(what, `has chunks of ${chunk.length} axes and a shape of ${shape.length}; expected as many`);
  checkLengths(what, 'chunks', chunk);
  const bytes = chunk.reduce((product, n) => product * n, type.bytesPerSample);
  if (bytes > maxChunkBytes)
    throw unsupportedFile(
      what,
      `has chunks of ${chunk.join(' x ')} voxels; expected at most ${maxChunkBytes / 2 ** 20} MiB each: write it with smaller chunks`,
    );
  if (shards) {
    checkLengths(what, 'shards', shards.shape);
    const parts = shards.shape.map((n, axis) => n / chunk[axis]);
    if (!parts.every(Number.isInteger) || parts.reduce((product, n) => product * n, 1) > maxChunksOfShard)
      throw corruptFile(
        what,
        `has shards of ${shards.shape.join(' x ')} with chunks of ${chunk.join(' x ')}; expected whole numbers of chunks, at most ${maxChunksOfShard.toLocaleString('en')}`,
      );
  }
  const isOrder = order.length === shape.length && shape.every((_, axis) => order.includes(axis));
  if (!isOrder) throw corruptFile(what, 'says no order of its axes (transpose); expected each axis once');
  return array;
}

function readVersion2(metadata: Json, path: string, what: string): ZarrArray {
  const shape = lengthsOf(metadata.shape, 'shape', what);
  const [, endian, letter] = /^([<>|])(\w\d)$/.exec(String(metadata.dtype)) ?? [];
  const type = Object.hasOwn(letters, letter ?? '') ? letters[letter] : undefined;
  if (!type) throw refuseType(metadata.dtype, what);
  if (listOf(metadata.filters).length > 0)
    throw unsupportedFile(what, 'has filters; expected numbers that are only packed: write it without filters');
  const { compressor } = metadata;
  const separator = metadata.dimension_separator === '/' ? '/' : '.';
  return {
    path,
    shape,
    chunk: lengthsOf(metadata.chunks, 'chunks', what),
    shards: null,
    type,
    littleEndian: endian !== '>',
    fill: readFill(metadata.fill_value, what),
    order: readOrder(metadata.order, shape.length),
    codecs: isObject(compressor) ? [{ name: wordOf(compressor.id), configuration: compressor }] : [],
    names: [],
    fileOf: (place) => place.join(separator),
  };
}

function readVersion3(metadata: Json, path: string, what: string): ZarrArray {
  const shape = lengthsOf(metadata.shape, 'shape', what);
  const type = metadata.data_type === 'bool' ? numberTypes.uint8 : typeNames.get(wordOf(metadata.data_type));
  if (!type) throw refuseType(metadata.data_type, what);
  const grid = objectOf(metadata.chunk_grid);
  if (grid.name !== 'regular')
    throw unsupportedFile(what, `has a chunk grid of the kind ${shownWord(grid.name)}; expected "regular"`);
  const outer = lengthsOf(objectOf(grid.configuration).chunk_shape, 'chunks', what);
  const list = readCodecs(metadata.codecs, what);
  const [first] = list;
  if (first?.name === 'sharding_indexed' && list.length > 1)
    throw unsupportedFile(what, 'packs whole shards once more; expected only the chunks in them to be packed');
  const sharding = first?.name === 'sharding_indexed' ? first.configuration : null;
  const inner = sharding ? readCodecs(sharding.codecs, what) : list;
  const order = inner[0]?.name === 'transpose' ? readOrder(inner[0].configuration.order, shape.length) : null;
  const [bytes, ...codecs] = order ? inner.slice(1) : inner;
  if (bytes?.name !== 'bytes')
    throw unsupportedFile(
      what,
      `has the codec ${shownWord(bytes?.name)}; expected "bytes", with "transpose" before it, or in "sharding_indexed"`,
    );
  return {
    path,
    shape,
    chunk: sharding ? lengthsOf(sharding.chunk_shape, 'chunks', what) : outer,
    shards: sharding && { shape: outer, ...readIndex(sharding, what) },
    type,
    littleEndian: bytes.configuration.endian !== 'big',
    fill: readFill(metadata.fill_value, what),
    order: order ?? readOrder('C', shape.length),
    codecs,
    names: listOf(metadata.dimension_names).map((name) => (typeof name === 'string' ? name : '')),
    fileOf: chooseKeys(objectOf(metadata.chunk_key_encoding), what),
  };
}

/** How the index of a shard is written. Source: Zarr 3 specification, sharding codec 1.0 */
function readIndex(sharding: Json, what: string): Pick<Sharding, 'isIndexFirst' | 'hasChecksum'> {
  const codecs = readCodecs(sharding.index_codecs, what);
  const [bytes, check, more] = codecs;
  if (bytes?.name !== 'bytes' || bytes.configuration.endian === 'big' || more || (check && check.name !== 'crc32c'))
    throw unsupportedFile(what, 'packs the indices of its shards; expected "bytes" (little) and "crc32c"');
  return { isIndexFirst: sharding.index_location === 'start', hasChecksum: check !== undefined };
}

function readCodecs(list: unknown, what: string): readonly ByteCodec[] {
  return listOf(list).map((codec) => {
    if (typeof codec === 'string') return { name: codec, configuration: {} };
    if (!isObject(codec) || typeof codec.name !== 'string') throw corruptFile(what, 'has a codec without a name');
    return { name: codec.name.replace(/^numcodecs\./, ''), configuration: objectOf(codec.configuration) };
  });
}

/** Source: Zarr 3 specification, chunk key encoding */
function chooseKeys({ name = 'default', configuration }: Json, what: string): ZarrArray['fileOf'] {
  const isUsual = name === 'default';
  if (!isUsual && name !== 'v2')
    throw unsupportedFile(what, `names its chunks by ${shownWord(name)}; expected "default" or "v2"`);
  const { separator = isUsual ? '/' : '.' } = objectOf(configuration);
  const between = separator === '.' ? '.' : '/';
  return (place) => (isUsual ? ['c', ...place] : place).join(between);
}

/** `C`, `F`, or the axes from the slowest to the fastest. */
function readOrder(order: unknown, axes: number): readonly number[] {
  const usual = Array.from({ length: axes }, (_, axis) => axis);
  return order === 'F' ? usual.map((axis) => axes - 1 - axis) : (numbersOf(order) ?? usual);
}

function readFill(value: unknown, what: string): number {
  if (typeof value === 'number') return value;
  if (value === null || value === undefined || value === false) return 0;
  if (value === true) return 1;
  if (value === 'NaN' || value === 'Infinity' || value === '-Infinity') return Number(value);
  // The bytes of a number that is none: which of them makes no difference here.
  if (typeof value === 'string' && /^0x[0-9a-f]+$/i.test(value)) return NaN;
  throw unsupportedFile(what, `has a fill value that is no number: ${shownWord(value)}`);
}

function lengthsOf(value: unknown, name: string, what: string): readonly number[] {
  const lengths = numbersOf(value);
  if (lengths) return lengths;
  throw corruptFile(what, `has no ${name}; expected a list of whole numbers`);
}

function refuseType(type: unknown, what: string): Error {
  return unsupportedFile(
    what,
    `holds values of the type ${shownWord(type)}; expected whole numbers of 8 to 64 bits or floats of 16 to 64`,
  );
}

const wordOf = (value: unknown): string => (typeof value === 'string' ? value : '');
