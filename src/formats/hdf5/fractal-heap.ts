import { readTree2 } from './b-tree-2.ts';
import { bytesToHold, corruptHdf5, noAddress, unsupportedHdf5 } from './hdf5-bytes.ts';
import type { Cursor, Hdf5Bytes } from './hdf5-bytes.ts';

/** A heap of many small objects: newer files keep long lists of links and attributes in it. */
export interface FractalHeap {
  /** Bytes of the identifiers by which other structures refer to its objects. */
  readonly idBytes: number;
  /** Finds an object; null for the kind that nothing here needs. `id` is a cursor at its identifier. */
  find(id: Cursor): { position: number; size: number } | null;
}

/**
 * The doubling table: rows of `width` blocks each. The first two rows have blocks of the first size; in each further
 * row the blocks are twice as large as in the row before.
 */
interface Table {
  readonly file: Hdf5Bytes;
  readonly width: number;
  readonly firstBytes: number;
  readonly directRows: number;
  /** Bytes of an offset into the heap. */
  readonly offsetBytes: number;
}

/**
 * Source: HDF5 File Format Specification 3.0, III.G
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readFractalHeap(file: Hdf5Bytes, address: number): FractalHeap {
  const cursor = file.at(address);
  cursor.expect('FRHP');
  cursor.expectVersion('a heap', 0);
  const idBytes = cursor.u16();
  if (cursor.u16() > 0) throw unsupportedHdf5('a compressed heap of attributes or links');
  cursor.skip(1);
  const maxManaged = cursor.u32();
  cursor.length();
  const hugeTree = cursor.address();
  cursor.skip(9 * file.lengthBytes + file.addressBytes); // Free space and counts.
  const width = cursor.u16();
  const firstBytes = cursor.length();
  const maxDirect = cursor.length();
  const heapBits = cursor.u16();
  cursor.skip(2);
  const root = cursor.address();
  const rootRows = cursor.u16();
  if (!(width > 0 && firstBytes > 0 && maxDirect >= firstBytes && heapBits <= 64))
    throw corruptHdf5('has a heap without sane sizes');
  const directRows = Math.log2(maxDirect) - Math.log2(firstBytes) + 2;
  const table = { file, width, firstBytes, directRows, offsetBytes: Math.ceil(heapBits / 8) };
  const sizeBytes = Math.min(bytesToHold(maxDirect), bytesToHold(maxManaged));
  return {
    idBytes,
    find(id) {
      const kind = (id.u8() >> 4) & 3;
      if (kind === 1) return findHuge(file, hugeTree, id.unsigned(Math.min(idBytes - 1, file.lengthBytes)));
      if (kind === 2) return { position: id.position, size: idBytes - 1 };
      const offset = id.unsigned(table.offsetBytes);
      const size = id.unsigned(sizeBytes);
      const position =
        rootRows === 0
          ? file.at(root).position + offset
          : findManaged(table, { address: root, rows: rootRows }, offset);
      return { position, size };
    },
  };
}

/** Walks down to the block that holds an offset. */
function findManaged(table: Table, block: { address: number; rows: number }, offset: number): number {
  const { file, width } = table;
  const cursor = file.at(block.address);
  cursor.expect('FHIB');
  cursor.skip(1 + file.addressBytes + table.offsetBytes);
  let start = 0;
  for (let row = 0; row < block.rows; row++) {
    const size = table.firstBytes * 2 ** Math.max(0, row - 1);
    const column = Math.floor((offset - start) / size);
    if (column < width) {
      cursor.skip((row * width + column) * file.addressBytes);
      const child = cursor.address();
      const rest = offset - start - column * size;
      if (row < table.directRows) return file.at(child).position + rest;
      const rows = Math.log2(size) - Math.log2(table.firstBytes * width) + 1;
      return findManaged(table, { address: child, rows }, rest);
    }
    start += size * width;
  }
  throw corruptHdf5('refers to an object beyond the end of its heap');
}

/** Finds objects too large for the blocks, such as the angles of 720 radials. */
function findHuge(file: Hdf5Bytes, tree: number, wanted: number): { position: number; size: number } | null {
  if (tree === noAddress) return null;
  let found: { position: number; size: number } | null = null;
  readTree2(file, tree, (record) => {
    const address = record.address();
    const size = record.length();
    if (record.length() === wanted) found = { position: file.at(address).position, size };
  });
  return found;
}
