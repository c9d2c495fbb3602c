import { unpack } from './gunzip.ts';

/** True if bytes begin with a zlib header: deflate, no preset dictionary, and a number that 31 divides (RFC 1950). */
export function isZlib(bytes: Uint8Array): boolean {
  return (
    bytes.length > 2 && (bytes[0] & 0x0f) === 8 && (bytes[1] & 0x20) === 0 && (bytes[0] * 256 + bytes[1]) % 31 === 0
  );
}

/** The same as gunzip, for zlib data: one stream. */
export function unzlib(bytes: Uint8Array<ArrayBuffer>): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  return unpack(bytes, 'deflate', `the zlib data of ${bytes.length} bytes`);
}
