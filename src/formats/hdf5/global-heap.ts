import { decodeText } from '../base/decode-text.ts';
import { corruptHdf5, Cursor, Hdf5Bytes, noAddress } from './hdf5-bytes.ts';

/** Memory for a text in addition to its characters, and for an object in addition to its bytes in the file. */
const bytesPerText = 64;
const bytesPerObject = 160;

/** Bytes of a reference to a text: its length, the address of a heap, its index there. */
export function bytesOfTextPlace(file: Hdf5Bytes): number {
  return 8 + file.addressBytes;
}

/**
 * Reads texts of variable length, which lie in heaps that objects share.
 * @param places - their references, one after another
 * Source: HDF5 File Format Specification 3.0, III.E
 * @throws {VolumeViewError} `format/corrupt`
 */
export function readTextsElsewhere(file: Hdf5Bytes, places: Uint8Array<ArrayBuffer>): string[] {
  const table = new Hdf5Bytes(places, file.budget);
  table.addressBytes = file.addressBytes;
  const cursor = new Cursor(table, 0);
  const count = Math.floor(places.length / bytesOfTextPlace(file));
  file.budget.take(bytesPerText * count, 'a list of texts');
  return Array.from({ length: count }, () => {
    const length = cursor.u32();
    const address = cursor.address();
    const index = cursor.u32();
    if (length === 0 || address === noAddress) return '';
    const heap = file.heaps.get(address) ?? readHeap(file, address);
    file.heaps.set(address, heap);
    const bytes = heap.get(index);
    if (!bytes || bytes.length < length) throw corruptHdf5('refers to a text that it does not hold');
    // Many references may lead to the same long text.
    file.budget.take(2 * length, 'a list of texts');
    return decodeText(bytes.subarray(0, length));
  });
}

/** Objects of a heap by their indices. */
function readHeap(file: Hdf5Bytes, address: number): Map<number, Uint8Array> {
  const cursor = file.at(address);
  const start = cursor.position;
  cursor.expect('GCOL');
  cursor.expectVersion('a heap', 1);
  cursor.skip(3);
  const end = start + cursor.length();
  const objects = new Map<number, Uint8Array>();
  while (cursor.position + 8 + file.lengthBytes <= end) {
    const index = cursor.u16();
    cursor.skip(6);
    const size = cursor.length();
    if (index === 0) break; // Free space, up to the end.
    file.budget.take(bytesPerObject, 'a heap of texts');
    objects.set(index, cursor.slice(size));
    cursor.position += (8 - (size % 8)) % 8;
  }
  return objects;
}
