import { countElements } from '../base/data-tree.ts';
import type { AttributeValue } from '../base/data-tree.ts';
import { decodeNumbers } from '../base/decode-numbers.ts';
import { decodeText } from '../base/decode-text.ts';
import { readTree2 } from './b-tree-2.ts';
import { readFractalHeap } from './fractal-heap.ts';
import { readTextsElsewhere } from './global-heap.ts';
import { corruptHdf5, Cursor, noAddress } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import { findMessage, followShared, messageTypes } from './object-header.ts';
import type { Message } from './object-header.ts';
import { readDataType, readShape } from './types.ts';
import type { DataType } from './types.ts';

/** Bytes that an attribute takes in addition to its name and its value, and a text in addition to its characters. */
const overhead = 128;

/**
 * The attributes of an object, in its header or, where they are many, in a heap of their own.
 * Source: HDF5 File Format Specification 3.0, IV.A.2.m and IV.A.2.v
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readAttributes(file: Hdf5Bytes, messages: readonly Message[]): Map<string, AttributeValue> {
  const attributes = new Map<string, AttributeValue>();
  const add = (place: Place): void => {
    const { name, value } = readAttribute(new Cursor(file, place.position), place.position + place.size);
    if (value !== null) attributes.set(name, value);
  };
  for (const message of messages) if (message.type === messageTypes.attribute) add(message);
  const info = findMessage(messages, messageTypes.attributeInfo);
  if (info) for (const place of listInHeap(file, info)) add(place);
  return attributes;
}

/** Bytes of an attribute in the file. */
type Place = Pick<Message, 'position' | 'size'>;

function listInHeap(file: Hdf5Bytes, info: Message): Place[] {
  const cursor = new Cursor(file, info.position);
  cursor.expectVersion('attribute information', 0);
  if (cursor.u8() & 1) cursor.skip(2);
  const heapAddress = cursor.address();
  const treeAddress = cursor.address();
  if (heapAddress === noAddress || treeAddress === noAddress) return [];
  const heap = readFractalHeap(file, heapAddress);
  const places: Place[] = [];
  readTree2(file, treeAddress, (record) => {
    const found = heap.find(record);
    if (found) places.push(found);
  });
  return places;
}

/** @param end - of its message: what it refers to beyond belongs to other messages */
function readAttribute(cursor: Cursor, end: number): { name: string; value: AttributeValue | null } {
  const version = cursor.expectVersion('an attribute', 1, 2, 3);
  const flags = cursor.u8();
  const [nameBytes, typeBytes, shapeBytes] = [cursor.u16(), cursor.u16(), cursor.u16()];
  if (version === 3) cursor.skip(1);
  const padded = (bytes: number): number => (version === 1 ? Math.ceil(bytes / 8) * 8 : bytes);
  if (cursor.position + nameBytes > end) throw corruptHdf5('has an attribute that is longer than its message');
  cursor.file.budget.take(2 * nameBytes + overhead, 'the name of an attribute');
  const name = decodeText(cursor.slice(nameBytes));
  cursor.skip(padded(nameBytes) - nameBytes);
  const typeAt = new Cursor(cursor.file, cursor.position);
  const shapeAt = new Cursor(cursor.file, cursor.position + padded(typeBytes));
  cursor.skip(padded(typeBytes) + padded(shapeBytes));
  const isShared = version > 1 && (flags & 1) !== 0;
  const type = readDataType(
    isShared ? new Cursor(cursor.file, followShared(typeAt, messageTypes.datatype).position) : typeAt,
  );
  const shape = readShape(shapeAt);
  if (shape === null || type.kind === 'other') return { name, value: null };
  const count = countElements(shape);
  if (!(cursor.position + count * type.bytes <= end))
    throw corruptHdf5(`has an attribute "${name.slice(0, 40)}" that is longer than its message`);
  cursor.file.budget.take(
    count * (type.kind === 'number' ? 8 : 2 * type.bytes + overhead),
    `the attribute "${name.slice(0, 40)}"`,
  );
  return { name, value: readValue(cursor, type, count) };
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
