import { readTree } from './b-tree-1.ts';
import { corruptHdf5, noAddress } from './hdf5-bytes.ts';
import type { Cursor, Hdf5Bytes } from './hdf5-bytes.ts';
import type { ChunkedLayout } from './layout.ts';

/** A piece of an array, as it is stored. */
export interface Chunk {
  /** Index of its first element along each axis. */
  readonly start: readonly number[];
  readonly position: number;
  /** Bytes as stored, before the filters are undone. */
  readonly bytes: number;
  /** Bit i is set if filter i was not applied. */
  readonly skipped: number;
}

/** Memory for a chunk in a list, bytes. */
const bytesPerChunk = 200;

export interface ChunkedArray {
  readonly layout: ChunkedLayout;
  readonly shape: readonly number[];
  /** Lengths that the array may grow to: an index has a place for each chunk that may be written later. */
  readonly maxShape: readonly number[];
  readonly elementBytes: number;
  readonly isFiltered: boolean;
}

/**
 * Lists all chunks that were ever written.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function listChunks(file: Hdf5Bytes, array: ChunkedArray): Chunk[] {
  const { layout, shape } = array;
  if (layout.chunk.length !== shape.length || layout.chunk.some((length) => length < 1)) {
    throw corruptHdf5(`has chunks of ${layout.chunk.join(' x ')} in an array of ${shape.join(' x ')}`);
  }
  if (layout.address === noAddress) return [];
  const unfiltered = layout.chunk.reduce((product, length) => product * length, array.elementBytes);
  const position = file.base + layout.address;
  switch (layout.index.kind) {
    case 'b-tree':
      return keepSane(listInTree(file, layout), array);
    case 'single': {
      const { bytes, skipped } = layout.index;
      return [{ start: shape.map(() => 0), position, bytes: bytes ?? unfiltered, skipped }];
    }
    case 'implicit':
      file.check(position, unfiltered * countChunks(array));
      file.budget.take(bytesPerChunk * countChunks(array), 'a list of chunks');
      return keepInside(
        Array.from({ length: countChunks(array) }, (_, i) => ({
          start: startOf(array, i),
          position: position + i * unfiltered,
          bytes: unfiltered,
          skipped: 0,
        })),
        array,
      );
    case 'fixed-array':
      return keepInside(listInFixedArray(file.at(layout.address), array, unfiltered), array);
  }
}

function listInTree(file: Hdf5Bytes, layout: ChunkedLayout): Chunk[] {
  const readKey = (cursor: Cursor): Omit<Chunk, 'position'> => {
    const bytes = cursor.u32();
    const skipped = cursor.u32();
    const start = layout.chunk.map(() => cursor.unsigned(8));
    cursor.skip(8);
    return { start, bytes, skipped };
  };
  return readTree(file, layout.address, 1, readKey).map(({ key, address }) => ({
    ...key,
    position: file.base + address,
  }));
}

/** Source: HDF5 File Format Specification 3.0, VII.C */
function listInFixedArray(cursor: Cursor, array: ChunkedArray, unfiltered: number): Chunk[] {
  const { file } = cursor;
  cursor.expect('FAHD');
  cursor.expectVersion('an index of chunks', 0);
  cursor.skip(1);
  const entryBytes = cursor.u8();
  const pageBits = cursor.u8();
  const entries = cursor.length();
  const data = cursor.address();
  if (data === noAddress) return [];
  if (entries !== countChunks(array) || pageBits > 30)
    throw corruptHdf5(`has an index of ${entries} chunks for ${countChunks(array)}`);
  const sizeBytes = entryBytes - file.addressBytes - 4;
  if (array.isFiltered ? !(sizeBytes >= 1 && sizeBytes <= 8) : entryBytes !== file.addressBytes) {
    throw corruptHdf5(`has an index of chunks with ${entryBytes} bytes for each`);
  }
  const block = file.at(data);
  file.check(block.position, entries * entryBytes);
  file.budget.take(bytesPerChunk * entries, 'a list of chunks');
  block.expect('FADB');
  block.skip(2 + file.addressBytes);
  const pageEntries = 2 ** pageBits;
  const isPaged = entries > pageEntries;
  const written = isPaged ? block.slice(Math.ceil(Math.ceil(entries / pageEntries) / 8)) : null;
  if (isPaged) block.skip(4);
  const chunks: Chunk[] = [];
  for (let i = 0; i < entries; i++) {
    const page = Math.floor(i / pageEntries);
    if (isPaged && i > 0 && i % pageEntries === 0) block.skip(4); // The checksum of the previous page.
    const next = block.position + entryBytes;
    const address = block.address();
    const stored = array.isFiltered
      ? { bytes: block.unsigned(sizeBytes), skipped: block.u32() }
      : { bytes: unfiltered, skipped: 0 };
    block.position = next;
    const isWritten = !written || (written[page >> 3] & (0x80 >> (page & 7))) !== 0;
    if (isWritten && address !== noAddress)
      chunks.push({ start: startOf(array, i), position: file.base + address, ...stored });
  }
  return chunks;
}

/**
 * Keeps the chunks that lie in the array. Two chunks at one position, or a chunk that is not on the lattice, are
 * damage, and a damaged list could make the reader unpack far too much.
 */
function keepSane(chunks: Chunk[], { layout, shape }: ChunkedArray): Chunk[] {
  const places = new Set<string>();
  return chunks.filter(({ start }) => {
    const place = start.join(' ');
    if (places.has(place) || start.some((at, axis) => at % layout.chunk[axis] !== 0)) {
      throw corruptHdf5(`has a chunk at ${place}, where another one is or none belongs`);
    }
    places.add(place);
    return start.every((at, axis) => at < shape[axis]);
  });
}

/** Removes chunks beyond the array's present shape: they belong to what it may grow to, and hold nothing yet. */
function keepInside(chunks: Chunk[], { shape, maxShape }: ChunkedArray): Chunk[] {
  return shape.every((length, axis) => length === maxShape[axis])
    ? chunks
    : chunks.filter(({ start }) => start.every((at, axis) => at < shape[axis]));
}

/** The number of chunks that the array may grow to. */
function countChunks({ layout, maxShape }: ChunkedArray): number {
  return maxShape.reduce((product, length, axis) => product * Math.ceil(length / layout.chunk[axis]), 1);
}

/** The start of chunk number i, counted along the last axis first. */
function startOf({ layout, maxShape }: ChunkedArray, i: number): number[] {
  const start = maxShape.map(() => 0);
  let rest = i;
  for (let axis = maxShape.length - 1; axis >= 0; axis--) {
    const along = Math.ceil(maxShape[axis] / layout.chunk[axis]);
    start[axis] = (rest % along) * layout.chunk[axis];
    rest = Math.floor(rest / along);
  }
  return start;
}
