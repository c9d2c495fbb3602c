import { inflateSync } from 'fflate';
import { Adler32 } from '../codecs/adler32.ts';
import { maxDeflateRatio } from '../codecs/gunzip.ts';
import { Inflater } from '../codecs/inflate.ts';
import type { Budget } from '../base/budget.ts';
import type { Remedy } from './advice.ts';
import { corruptHdf5, Cursor, unsupportedHdf5 } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import type { Message } from './object-header.ts';
import { scaleOffsetHead, unpackScaleOffset } from './scale-offset.ts';

/** A step that was applied to each chunk when it was written. */
export interface Filter {
  readonly id: number;
  readonly name: string;
  readonly parameters: readonly number[];
}

const deflate = 1;
const shuffle = 2;
const fletcher32 = 3;
export const scaleOffset = 6;
const names = new Map([
  [4, 'SZIP'],
  [5, 'N-bit'],
  [307, 'bzip2'],
  [32000, 'LZF'],
  [32001, 'Blosc'],
  [32004, 'LZ4'],
  [32015, 'Zstandard'],
]);

/** Filters that h5repack can undo, and one that only h5py knows; all others are plugins. */
const remedies = new Map<number, Remedy>([
  [4, 'repack'],
  [5, 'repack'],
  [32000, 'h5py'],
]);

/** Bytes that filters before the last deflate may add: a checksum, and what scale-offset begins with. */
const added = 4 + scaleOffsetHead;

/** Unpacking so many bytes counts as one step. */
const bytesPerStep = 16;

/** The maximum that HDF5 itself allows: a chunk has a bit for each filter. */
const maxFilters = 32;

/**
 * Source: HDF5 File Format Specification 3.0, IV.A.2.l
 * @throws {VolumeViewError} `format/corrupt`
 */
export function readFilters(file: Hdf5Bytes, message: Message): Filter[] {
  const cursor = new Cursor(file, message.position);
  const version = cursor.expectVersion('a list of filters', 1, 2);
  const count = cursor.u8();
  if (count > maxFilters) throw corruptHdf5(`lists ${count} filters for one array; expected at most ${maxFilters}`);
  if (version === 1) cursor.skip(6);
  return Array.from({ length: count }, () => {
    const id = cursor.u16();
    const nameBytes = version === 1 || id >= 256 ? cursor.u16() : 0;
    cursor.skip(2);
    const parameterCount = cursor.u16();
    cursor.skip(version === 1 ? Math.ceil(nameBytes / 8) * 8 : nameBytes);
    const parameters = Array.from({ length: parameterCount }, () => cursor.u32());
    if (version === 1 && parameterCount % 2) cursor.skip(4);
    return { id, name: names.get(id) ?? `number ${id}`, parameters };
  });
}

/**
 * Undoes the filters of a chunk.
 * @param skipped - bit i is set if filter i was not applied
 * @param expected - bytes that the chunk must have in the end
 * @param budget - the output of each step is taken from it and given back
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function undoFilters(
  stored: Uint8Array<ArrayBuffer>,
  filters: readonly Filter[],
  { skipped, expected, budget }: { skipped: number; expected: number; budget: Budget },
): Uint8Array<ArrayBuffer> {
  let bytes = stored;
  for (let i = filters.length - 1; i >= 0; i--) {
    if (skipped & (1 << i)) continue;
    const { id, name, parameters } = filters[i];
    const made =
      id === deflate
        ? Math.min(expected + added, maxDeflateRatio * bytes.length)
        : id === scaleOffset
          ? expected
          : bytes.length;
    budget.take(made, 'a compressed chunk');
    // Output beyond the expected size is thrown away, but it still takes time.
    if (id === scaleOffset) budget.step(expected / 8, 'a compressed chunk');
    if (id === deflate) budget.step((maxDeflateRatio * bytes.length) / bytesPerStep, 'a compressed chunk');
    if (id === deflate) bytes = inflate(bytes, expected + added);
    else if (id === shuffle) bytes = unshuffle(bytes, parameters[0] ?? 1);
    else if (id === fletcher32) bytes = checkFletcher32(bytes);
    else if (id === scaleOffset) bytes = unpackScaleOffset(bytes, parameters, expected);
    else throw unsupportedHdf5(`data compressed with ${name}`, remedies.get(id) ?? 'repack-with-plugin');
    budget.giveBack(made);
  }
  if (bytes.length !== expected) throw corruptHdf5(`has a chunk of ${bytes.length} bytes where ${expected} belong`);
  return bytes;
}

/**
 * Unpacks a zlib stream into a buffer of fixed size, so that a stream that expands beyond `maxBytes` takes no more memory:
 * the rest is dropped, and the checksum is wrong. Source: RFC 1950
 */
function inflate(bytes: Uint8Array<ArrayBuffer>, maxBytes: number): Uint8Array<ArrayBuffer> {
  const [method, flags] = bytes;
  const isZlib =
    bytes.length >= 6 && (method & 0x0f) === 8 && (method * 256 + flags) % 31 === 0 && (flags & 0x20) === 0;
  if (!isZlib) throw corruptHdf5('has a chunk that is not compressed as it says');
  const whole = unpackInto(
    bytes.subarray(2, bytes.length - 4),
    new Uint8Array(Math.min(maxBytes, maxDeflateRatio * bytes.length)),
  );
  const sum = new Adler32();
  sum.add(whole);
  const checksumAt = (end: number): number => new DataView(bytes.buffer, bytes.byteOffset + end, 4).getUint32(0);
  // zlib ignores what follows a stream, and so does HDF5's own library.
  if (
    checksumAt(bytes.length - 4) !== sum.value &&
    checksumAt(Math.min(findEnd(bytes), bytes.length - 4)) !== sum.value
  )
    throw corruptHdf5('has a chunk with a wrong checksum');
  return whole;
}

function findEnd(bytes: Uint8Array<ArrayBuffer>): number {
  const stream = new Inflater().unpack(bytes, 2);
  try {
    for (;;) {
      const { done, value } = stream.next();
      if (done) return value;
    }
  } catch {
    throw corruptHdf5('has a chunk that can not be unpacked');
  }
}

function unpackInto(bytes: Uint8Array, out: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  try {
    return out.subarray(0, inflateSync(bytes, { out }).length);
  } catch {
    throw corruptHdf5('has a chunk that can not be unpacked');
  }
}

/** Puts elements together again: the data have the first bytes of all elements, then the second ones, and so on. */
function unshuffle(bytes: Uint8Array<ArrayBuffer>, elementBytes: number): Uint8Array<ArrayBuffer> {
  const elements = Math.floor(bytes.length / elementBytes);
  // The filter moves nothing if there is one element, or if no element is complete.
  if (elementBytes < 2 || elements < 2) return bytes;
  const whole = new Uint8Array(bytes.length);
  for (let part = 0; part < elementBytes; part++) {
    for (let i = 0, from = part * elements, to = part; i < elements; i++, from++, to += elementBytes)
      whole[to] = bytes[from];
  }
  whole.set(bytes.subarray(elements * elementBytes), elements * elementBytes);
  return whole;
}

/** Sums of 16-bit words, big-endian, with an odd last byte as the high one; stored little-endian after the data. */
function checkFletcher32(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const end = bytes.length - 4;
  if (end < 0) throw corruptHdf5('has a chunk without its checksum');
  let low = 0;
  let high = 0;
  for (let i = 0; i < end; i += 2) {
    low = (low + bytes[i] * 256 + (i + 1 < end ? bytes[i + 1] : 0)) % 65535;
    high = (high + low) % 65535;
  }
  const sums = [bytes[end] + bytes[end + 1] * 256, bytes[end + 2] + bytes[end + 3] * 256];
  if (sums[0] % 65535 !== low || sums[1] % 65535 !== high) throw corruptHdf5('has a chunk with a wrong checksum');
  return bytes.subarray(0, end);
}
