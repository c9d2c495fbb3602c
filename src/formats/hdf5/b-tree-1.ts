import { corruptHdf5, noAddress } from './hdf5-bytes.ts';
import type { Cursor, Hdf5Bytes } from './hdf5-bytes.ts';

/** Memory for an entry and its key, bytes. */
const bytesPerEntry = 200;

/**
 * Walks a version 1 B-tree, in order.
 * @param nodeType - 0 for groups, 1 for chunks
 * @param readKey - reads the key before a child; its result is returned with the child
 * @returns the key and the target address of each entry of the leaves
 * Source: HDF5 File Format Specification 3.0, III.A.1
 */
export function readTree<Key>(
  file: Hdf5Bytes,
  root: number,
  nodeType: number,
  readKey: (cursor: Cursor) => Key,
): { key: Key; address: number }[] {
  const found: { key: Key; address: number }[] = [];
  const visited = new Set<number>();
  const visit = (address: number, parentLevel: number): void => {
    // Each node has one parent: if a node occurs twice, the tree is damaged.
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
