import { countElements } from '../data-tree.ts';
import type { AttributeValue } from '../data-tree.ts';
import { decodeNumbers } from '../decode-numbers.ts';
import { decodeText } from '../decode-text.ts';
import { readTree2 } from './b-tree-2.ts';
import { readFractalHeap } from './fractal-heap.ts';
import { readTextsElsewhere } from './global-heap.ts';
import { Cursor, noAddress } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import { findMessage, followShared, messageTypes } from './object-header.ts';
import type { Message } from './object-header.ts';
import { readDataType, readShape } from './types.ts';
import type { DataType } from './types.ts';

/**
 * The attributes of an object, in its header or, where they are many, in a heap of their own.
 * Source: HDF5 File Format Specification 3.0, IV.A.2.m and IV.A.2.v
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readAttributes(file: Hdf5Bytes, messages: readonly Message[]): Map<string, AttributeValue> {
  const attributes = new Map<string, AttributeValue>();
  const add = (position: number): void => {
    const { name, value } = readAttribute(new Cursor(file, position));
    if (value !== null) attributes.set(name, value);
  };
  for (const message of messages) if (message.type === messageTypes.attribute) add(message.position);
  const info = findMessage(messages, messageTypes.attributeInfo);
  if (info) for (const position of listInHeap(file, info)) add(position);
  return attributes;
}

function listInHeap(file: Hdf5Bytes, info: Message): number[] {
  const cursor = new Cursor(file, info.position);
  cursor.expectVersion('attribute information', 0);
  if (cursor.u8() & 1) cursor.skip(2);
  const heapAddress = cursor.address();
  const treeAddress = cursor.address();
  if (heapAddress === noAddress || treeAddress === noAddress) return [];
  const heap = readFractalHeap(file, heapAddress);
  const positions: number[] = [];
  readTree2(file, treeAddress, (record) => {
    const found = heap.find(record);
    if (found) positions.push(found.position);
  });
  return positions;
}

function readAttribute(cursor: Cursor): { name: string; value: AttributeValue | null } {
  const version = cursor.expectVersion('an attribute', 1, 2, 3);
  const flags = cursor.u8();
  const [nameBytes, typeBytes, shapeBytes] = [cursor.u16(), cursor.u16(), cursor.u16()];
  if (version === 3) cursor.skip(1);
  const padded = (bytes: number): number => (version === 1 ? Math.ceil(bytes / 8) * 8 : bytes);
  const name = decodeText(cursor.slice(nameBytes));
  cursor.skip(padded(nameBytes) - nameBytes);
  const typeAt = new Cursor(cursor.file, cursor.position);
  const shapeAt = new Cursor(cursor.file, cursor.position + padded(typeBytes));
  cursor.skip(padded(typeBytes) + padded(shapeBytes));
  const isShared = version > 1 && (flags & 1) !== 0;
  const type = readDataType(isShared ? new Cursor(cursor.file, followShared(typeAt, messageTypes.datatype).position) : typeAt);
  const shape = readShape(shapeAt);
  if (shape === null || type.kind === 'other') return { name, value: null };
  return { name, value: readValue(cursor, type, countElements(shape)) };
}

function readValue(cursor: Cursor, type: Exclude<DataType, { kind: 'other' }>, count: number): AttributeValue {
  const bytes = cursor.slice(count * type.bytes);
  if (type.kind === 'number') return Float64Array.from(decodeNumbers(bytes.slice(), type.type, type.littleEndian));
  const texts =
    type.kind === 'text'
      ? Array.from({ length: count }, (_, i) => decodeText(bytes.subarray(i * type.bytes, (i + 1) * type.bytes)))
      : readTextsElsewhere(cursor.file, bytes);
  return texts.length === 1 ? texts[0] : texts;
}
