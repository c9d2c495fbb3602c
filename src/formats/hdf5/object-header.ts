import { corruptHdf5, Cursor, unsupportedHdf5 } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';

/** Message types. Source: HDF5 File Format Specification 3.0, IV.A.2 */
export const messageTypes = {
  dataspace: 0x01,
  linkInfo: 0x02,
  datatype: 0x03,
  fillValueOld: 0x04,
  fillValue: 0x05,
  link: 0x06,
  externalFiles: 0x07,
  layout: 0x08,
  filters: 0x0b,
  attribute: 0x0c,
  continuation: 0x10,
  symbolTable: 0x11,
  attributeInfo: 0x15,
} as const;

/** A message of an object's header: each describes one property of the object. */
export interface Message {
  readonly type: number;
  /** Position of its data in the file. */
  readonly position: number;
  readonly size: number;
}

interface OwnMessage extends Message {
  /** Whether the data are the address of an object that holds the message. */
  readonly isShared: boolean;
}

/** A part of a header that is yet to be read. */
interface Block {
  readonly position: number;
  readonly size: number;
}

const sharedFlag = 0x02;

/** Memory for a message, bytes. */
const bytesPerMessage = 96;

/**
 * Reads all messages of the object at an address, also those that it shares with other objects.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 * Source: HDF5 File Format Specification 3.0, IV.A.1
 */
export function readMessages(file: Hdf5Bytes, address: number): readonly Message[] {
  return readHeader(file, address).map((message) =>
    message.isShared ? followShared(new Cursor(file, message.position), message.type) : message,
  );
}

/** The first message of a type. */
export function findMessage(messages: readonly Message[], type: number): Message | undefined {
  return messages.find((message) => message.type === type);
}

function readHeader(file: Hdf5Bytes, address: number): OwnMessage[] {
  const cursor = file.at(address);
  return file.bytes[cursor.position] === 0x4f /* O of OHDR */ ? readNewHeader(cursor) : readOldHeader(cursor);
}

function readOldHeader(cursor: Cursor): OwnMessage[] {
  cursor.expectVersion('an object header', 1);
  cursor.skip(1);
  const count = cursor.u16();
  cursor.skip(4);
  const size = cursor.u32();
  cursor.skip(4);
  const messages = readBlocks({ position: cursor.position, size }, cursor, { fixed: 8, checksum: 0 });
  return messages.slice(0, count);
}

function readNewHeader(cursor: Cursor): OwnMessage[] {
  cursor.expect('OHDR');
  cursor.expectVersion('an object header', 2);
  const flags = cursor.u8();
  if (flags & 0x20) cursor.skip(16); // Times.
  if (flags & 0x10) cursor.skip(4); // Limits at which attributes move out of the header.
  const size = cursor.unsigned(1 << (flags & 3));
  return readBlocks({ position: cursor.position, size }, cursor, { fixed: flags & 0x04 ? 6 : 4, checksum: 4 });
}

/** Messages of the first block and of all its continuations; `fixed` is the number of bytes before a message's data. */
function readBlocks(first: Block, cursor: Cursor, form: { fixed: number; checksum: number }): OwnMessage[] {
  const messages: OwnMessage[] = [];
  const blocks = [first];
  const visited = new Set<number>();
  for (let block = blocks.pop(); block; block = blocks.pop()) {
    if (visited.has(block.position)) throw corruptHdf5('has an object header that leads back into itself');
    visited.add(block.position);
    cursor.file.check(block.position, block.size);
    const before = messages.length;
    const end = block.position + block.size;
    cursor.position = block.position;
    while (cursor.position + form.fixed <= end) {
      const type = form.checksum ? cursor.u8() : cursor.u16();
      const size = cursor.u16();
      const flags = cursor.u8();
      cursor.skip(form.fixed - (form.checksum ? 4 : 5));
      const message = { type, position: cursor.position, size, isShared: (flags & sharedFlag) !== 0 };
      cursor.skip(size);
      if (cursor.position > end) throw corruptHdf5('has an object header that is longer than its block');
      if (type === messageTypes.continuation) blocks.push(readContinuation(cursor, message, form.checksum));
      else messages.push(message);
    }
    cursor.file.budget.take((messages.length - before) * bytesPerMessage, 'an object header');
  }
  return messages;
}

function readContinuation(cursor: Cursor, message: Message, checksum: number): Block {
  const after = cursor.position;
  cursor.position = message.position;
  const address = cursor.address();
  const size = cursor.length();
  const block = cursor.file.at(address);
  if (checksum) block.expect('OCHK');
  cursor.position = after;
  return { position: block.position, size: checksum ? size - 8 : size };
}

/**
 * Finds a message that another object holds, such as a named type.
 * @param cursor - at the reference to it
 * Source: HDF5 File Format Specification 3.0, IV.A.2, "Shared Message"
 */
export function followShared(cursor: Cursor, type: number): Message {
  const version = cursor.expectVersion('a shared message', 1, 2, 3);
  const kind = cursor.u8();
  if (version === 1) cursor.skip(6);
  if (version === 3 && kind === 1) throw unsupportedHdf5('messages in a shared heap');
  const found = readHeader(cursor.file, cursor.address()).find((message) => message.type === type && !message.isShared);
  if (!found) throw corruptHdf5('shares a message with an object that has none such');
  return found;
}
