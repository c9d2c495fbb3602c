import { corruptHdf5, noAddress } from './hdf5-bytes.ts';
import type { Cursor, Hdf5Bytes } from './hdf5-bytes.ts';

/** What an entry takes in memory, its key included. */
const bytesPerEntry = 200;

/**
 * Walk a version 1 B-tree, in order.
 * @param nodeType - 0 for groups, 1 for chunks
 * @param readKey - reads the key before a child; what it returns goes with the child
 * @returns of each entry of the leaves its key and the address that it leads to
 * Source: HDF5 File Format Specification 3.0, III.A.1
 */
export function readTree<Key>(file: Hdf5Bytes, root: number, nodeType: number, readKey: (cursor: Cursor) => Key): { key: Key; address: number }[] {
  const found: { key: Key; address: number }[] = [];
  const visited = new Set<number>();
  const visit = (address: number, parentLevel: number): void => {
    // Each node has one parent; one that is met twice belongs to a damaged tree.
    if (visited.has(address)) throw corruptHdf5('has a B-tree that leads back into itself');
    visited.add(address);
    const cursor = file.at(address);
    cursor.expect('TREE');
    const type = cursor.u8();
    const level = cursor.u8();
    if (type !== nodeType || level >= parentLevel) throw corruptHdf5('has a B-tree whose levels do not descend');
    const entries = cursor.u16();
    cursor.address();
    cursor.address();
    file.budget.take(entries * bytesPerEntry, 'a B-tree');
    for (let i = 0; i < entries; i++) {
      const key = readKey(cursor);
      const child = cursor.address();
      if (child === noAddress) continue;
      if (level > 0) visit(child, level);
      else found.push({ key, address: child });
    }
  };
  visit(root, 256);
  return found;
}
