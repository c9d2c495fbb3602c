import { bytesToHold, corruptHdf5, noAddress } from './hdf5-bytes.ts';
import type { Cursor, Hdf5Bytes } from './hdf5-bytes.ts';

/** Memory for what is made of a record, bytes. */
const bytesPerRecord = 64;

/** What a version 2 B-tree says about its nodes. */
interface Tree {
  readonly file: Hdf5Bytes;
  readonly recordBytes: number;
  readonly readRecord: (cursor: Cursor) => void;
  /** Bytes of the count of a child's records, and for each level bytes of the count of all records below it. */
  readonly countBytes: number;
  readonly totalBytes: readonly number[];
}

/**
 * Walks a version 2 B-tree and calls `readRecord` with a cursor at each record.
 * Source: HDF5 File Format Specification 3.0, III.A.2
 */
export function readTree2(file: Hdf5Bytes, address: number, readRecord: (cursor: Cursor) => void): void {
  const cursor = file.at(address);
  cursor.expect('BTHD');
  cursor.expectVersion('a B-tree', 0);
  cursor.skip(1);
  const nodeBytes = cursor.u32();
  const recordBytes = cursor.u16();
  const depth = cursor.u16();
  cursor.skip(2);
  const root = cursor.address();
  const records = cursor.u16();
  if (root === noAddress || records === 0) return;
  if (recordBytes === 0 || depth > 32) throw corruptHdf5('has a B-tree without sane sizes');
  const tree = {
    file,
    recordBytes,
    readRecord,
    ...sizeCounts({ nodeBytes, recordBytes, depth, addressBytes: file.addressBytes }),
  };
  visitNode(tree, { address: root, records }, depth);
}

/** How many bytes the counts in inner nodes take: enough for the maximum number of records. */
function sizeCounts(sizes: { nodeBytes: number; recordBytes: number; depth: number; addressBytes: number }): {
  countBytes: number;
  totalBytes: number[];
} {
  const overhead = 10;
  let max = Math.floor((sizes.nodeBytes - overhead) / sizes.recordBytes);
  let total = max;
  const countBytes = bytesToHold(max);
  const totalBytes = [0];
  for (let level = 1; level <= sizes.depth; level++) {
    const pointer = sizes.addressBytes + countBytes + totalBytes[level - 1];
    max = Math.floor((sizes.nodeBytes - overhead - pointer) / (sizes.recordBytes + pointer));
    total = (max + 1) * total + max;
    totalBytes.push(bytesToHold(total));
  }
  return { countBytes, totalBytes };
}

function visitNode(tree: Tree, node: { address: number; records: number }, level: number): void {
  const cursor = tree.file.at(node.address);
  cursor.expect(level === 0 ? 'BTLF' : 'BTIN');
  cursor.skip(2);
  tree.file.budget.take(node.records * bytesPerRecord, 'a B-tree');
  for (let i = 0; i < node.records; i++) {
    const next = cursor.position + tree.recordBytes;
    tree.readRecord(cursor);
    cursor.position = next;
  }
  if (level === 0) return;
  for (let i = 0; i <= node.records; i++) {
    const address = cursor.address();
    const records = cursor.unsigned(tree.countBytes);
    cursor.skip(tree.totalBytes[level - 1]);
    visitNode(tree, { address, records }, level - 1);
  }
}
