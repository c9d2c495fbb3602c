import type { ZipEntry } from './zip-directory.ts';

/** Bytes that Deflate can hold as they are in one block. Source: RFC 1951, 3.2.4 */
const maxStored = 65_535;

/**
 * A file of a ZIP archive as a gzip file of one member (RFC 1952), from parts of the archive, none of which is read: what is
 * unpacked of it is checked.
 * @param take - gives a part of the archive
 * @param dataStart - where its data begin in the archive
 */
export function asGzip<T>(
  { method, crc, size, packed }: ZipEntry,
  dataStart: number,
  take: (start: number, end: number) => T,
): (T | Uint8Array<ArrayBuffer>)[] {
  const head = Uint8Array.of(0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 0xff);
  const end = new DataView(new ArrayBuffer(8));
  end.setUint32(0, crc, true);
  end.setUint32(4, size % 2 ** 32, true);
  const data = method === 0 ? storeBlocks(size, dataStart, take) : [take(dataStart, dataStart + packed)];
  return [head, ...data, new Uint8Array(end.buffer)];
}

/** Data that are not packed, as blocks of Deflate. */
function storeBlocks<T>(
  size: number,
  dataStart: number,
  take: (start: number, end: number) => T,
): (T | Uint8Array<ArrayBuffer>)[] {
  const parts: (T | Uint8Array<ArrayBuffer>)[] = [];
  for (let at = 0; at === 0 || at < size; at += maxStored) {
    const length = Math.min(maxStored, size - at);
    const block = new DataView(new ArrayBuffer(5));
    block.setUint8(0, at + length === size ? 1 : 0);
    block.setUint16(1, length, true);
    block.setUint16(3, ~length, true);
    parts.push(new Uint8Array(block.buffer), take(dataStart + at, dataStart + at + length));
  }
  return parts;
}
