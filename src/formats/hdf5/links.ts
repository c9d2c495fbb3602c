import { decodeText } from '../base/decode-text.ts';
import { readTree } from './b-tree-1.ts';
import { readTree2 } from './b-tree-2.ts';
import { readFractalHeap } from './fractal-heap.ts';
import { corruptHdf5, Cursor, noAddress } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import { findMessage, messageTypes } from './object-header.ts';
import type { Message } from './object-header.ts';

/** What a name leads to. */
export type Link =
  /** The object whose header is at an address. */
  | { readonly kind: 'hard'; readonly address: number }
  /** Another name in the file, from the root or from the group. */
  | { readonly kind: 'soft'; readonly path: string }
  /** Another file, or a link type that some program defines. */
  | { readonly kind: 'elsewhere' };

/** Memory for a link in addition to its name, bytes. */
const bytesPerLink = 160;

/** Longer than any name, bytes. Names may overlap in a damaged file, so each one is cut here. */
const maxNameBytes = 2 ** 16;

/** Links by name and, if the file stores it, their creation order. */
class Links {
  readonly #file: Hdf5Bytes;
  readonly #found: { name: string; link: Link; order: number }[] = [];

  constructor(file: Hdf5Bytes) {
    this.#file = file;
  }

  /** @param nameBytes - may continue after the name's end */
  add(nameBytes: Uint8Array, link: Link, order = this.#found.length): void {
    this.#found.push({ name: this.readText(nameBytes), link, order });
  }

  /** The text up to its first 0. */
  readText(bytes: Uint8Array): string {
    const within = bytes.subarray(0, maxNameBytes + 1);
    const end = within.indexOf(0);
    const length = end < 0 ? bytes.length : end;
    if (length > maxNameBytes) throw corruptHdf5(`has a name of more than ${maxNameBytes} bytes`);
    this.#file.budget.take(2 * length + bytesPerLink, 'a list of names');
    return decodeText(bytes.subarray(0, length));
  }

  inOrder(): Map<string, Link> {
    this.#found.sort((a, b) => a.order - b.order);
    return new Map(this.#found.map(({ name, link }) => [name, link]));
  }
}

/**
 * A group's links by name, in the order of their creation if the file stores it.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readLinks(file: Hdf5Bytes, messages: readonly Message[]): Map<string, Link> {
  const links = new Links(file);
  const table = findMessage(messages, messageTypes.symbolTable);
  if (table) readSymbolTable(new Cursor(file, table.position), links);
  for (const message of messages)
    if (message.type === messageTypes.link) readLink(new Cursor(file, message.position), links);
  const info = findMessage(messages, messageTypes.linkInfo);
  if (info) readLinkHeap(new Cursor(file, info.position), links);
  return links.inOrder();
}

/** Groups of old files. Source: HDF5 File Format Specification 3.0, III.B to III.D */
function readSymbolTable(cursor: Cursor, links: Links): void {
  const { file } = cursor;
  const tree = cursor.address();
  const names = readLocalHeap(file.at(cursor.address()));
  for (const { address } of readTree(file, tree, 0, (key) => key.length())) {
    const node = file.at(address);
    node.expect('SNOD');
    node.skip(2);
    const count = node.u16();
    for (let i = 0; i < count; i++) {
      const name = names.subarray(node.unsigned(file.addressBytes));
      const header = node.address();
      const isSoft = node.u32() === 2;
      node.skip(4);
      const pathAt = node.u32();
      node.skip(12);
      if (isSoft) links.add(name, { kind: 'soft', path: links.readText(names.subarray(pathAt)) });
      else if (header !== noAddress) links.add(name, { kind: 'hard', address: header });
    }
  }
}

function readLocalHeap(cursor: Cursor): Uint8Array {
  cursor.expect('HEAP');
  cursor.skip(4);
  const size = cursor.length();
  cursor.length();
  const start = cursor.file.at(cursor.address()).position;
  return cursor.file.slice(start, size);
}

/** Groups of newer files. Source: HDF5 File Format Specification 3.0, IV.A.2.g */
function readLink(cursor: Cursor, links: Links): void {
  cursor.expectVersion('a link', 1);
  const flags = cursor.u8();
  const kind = flags & 0x08 ? cursor.u8() : 0;
  const order = flags & 0x04 ? cursor.unsigned(8) : undefined;
  if (flags & 0x10) cursor.skip(1);
  const name = cursor.slice(cursor.unsigned(1 << (flags & 3)));
  if (kind === 1) return links.add(name, { kind: 'soft', path: links.readText(cursor.slice(cursor.u16())) }, order);
  if (kind !== 0) return links.add(name, { kind: 'elsewhere' }, order);
  const address = cursor.address();
  if (address === noAddress) throw corruptHdf5('has a link that leads nowhere');
  links.add(name, { kind: 'hard', address }, order);
}

/** Links that do not fit into the header. Source: HDF5 File Format Specification 3.0, IV.A.2.c */
function readLinkHeap(cursor: Cursor, links: Links): void {
  const { file } = cursor;
  cursor.expectVersion('link information', 0);
  if (cursor.u8() & 1) cursor.skip(8);
  const heapAddress = cursor.address();
  const treeAddress = cursor.address();
  if (heapAddress === noAddress || treeAddress === noAddress) return;
  const heap = readFractalHeap(file, heapAddress);
  readTree2(file, treeAddress, (record) => {
    record.skip(4); // The name's hash.
    const found = heap.find(record);
    if (found) readLink(new Cursor(file, found.position), links);
  });
}
