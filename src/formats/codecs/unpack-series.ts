import { VolumeViewError } from '../../core/errors.ts';
import { Adler32 } from './adler32.ts';
import { addToCrc } from './crc32.ts';
import { DeflateError, Inflater } from './inflate.ts';
import { startsWith } from '../base/starts-with.ts';

// What the browser's own decompressor does not accept: several members in one gzip file (RFC 1952, 2.2; bgzip, mgzip
// and cat write them), and bytes after the data, such as the zeros that fill a tape's block.

/** Maximum number of empty members in a row: more than any file has. */
const maxEmptyMembers = 2 ** 16;

/**
 * Unpacks all members of a gzip file, or zlib data, and checks their checksums. Zeros after a member are skipped, as
 * gzip and Python do. Anything else that is not a member ends the data, as with gzip.
 * @param what - for messages: 'the gzip file of 992 bytes'
 * @throws {VolumeViewError} `format/corrupt`, after the valid part was yielded
 */
export function* unpackSeries(
  bytes: Uint8Array<ArrayBuffer>,
  form: 'gzip' | 'deflate',
  what: string,
): Generator<Uint8Array<ArrayBuffer>> {
  try {
    if (form === 'gzip') yield* unpackMembers(bytes);
    else yield* unpackZlib(bytes);
  } catch (cause) {
    if (!(cause instanceof DeflateError)) throw cause;
    throw new VolumeViewError(
      'format/corrupt',
      `${what} ${cause.message}; fetch it again, or compress the data again`,
      { cause },
    );
  }
}

function* unpackMembers(bytes: Uint8Array<ArrayBuffer>): Generator<Uint8Array<ArrayBuffer>> {
  const inflater = new Inflater();
  let at = 0;
  for (let empty = 0; empty < maxEmptyMembers; empty++) {
    const stream = inflater.unpack(bytes, findData(bytes, at));
    let [crc, length] = [-1, 0];
    let next = stream.next();
    for (; !next.done; next = stream.next()) {
      crc = addToCrc(crc, next.value);
      length += next.value.length;
      empty = 0;
      yield next.value;
    }
    at = next.value + 8;
    if (at > bytes.length) throw new DeflateError(true);
    const view = new DataView(bytes.buffer, bytes.byteOffset + next.value, 8);
    if (view.getUint32(0, true) !== ~crc >>> 0 || view.getUint32(4, true) !== length % 2 ** 32)
      throw new DeflateError(false);
    while (bytes[at] === 0) at++;
    if (!startsWith(bytes.subarray(at, at + 4), '\x1f\x8b\x08')) return;
  }
  throw new DeflateError(false);
}

/** Index of the first byte of a member's data. Source: RFC 1952, 2.3 */
function findData(bytes: Uint8Array, start: number): number {
  const flags = bytes[start + 3];
  // Reserved bits: no meaning is defined yet.
  if (flags & 0xe0) throw new DeflateError(false);
  let at = start + 10;
  if (flags & 4) at += 2 + bytes[at] + 256 * bytes[at + 1];
  for (const bit of [8, 16]) {
    if (!(flags & bit)) continue;
    const end = bytes.indexOf(0, at);
    if (end < 0) throw new DeflateError(true);
    at = end + 1;
  }
  if (flags & 2) at += 2;
  // This is also true if a length beyond the end made it NaN.
  if (!(at < bytes.length)) throw new DeflateError(true);
  return at;
}

function* unpackZlib(bytes: Uint8Array<ArrayBuffer>): Generator<Uint8Array<ArrayBuffer>> {
  const stream = new Inflater().unpack(bytes, 2);
  const sum = new Adler32();
  let next = stream.next();
  for (; !next.done; next = stream.next()) {
    sum.add(next.value);
    yield next.value;
  }
  if (next.value + 4 > bytes.length) throw new DeflateError(true);
  if (new DataView(bytes.buffer, bytes.byteOffset + next.value).getUint32(0) !== sum.value)
    throw new DeflateError(false);
}
