import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { NumberType } from '../base/number-types.ts';
import { PieceReader } from '../base/piece-reader.ts';
import { maxDeflateRatio } from '../codecs/gunzip.ts';
import { isZlib, unzlib } from '../codecs/unzlib.ts';
import { readTextNumbers } from '../grid-files/read-text-numbers.ts';
import { decodeBase64Parts } from './base64-parts.ts';
import type { VtiArray, VtiDocument } from './vti-document.ts';

const what = 'the VTI file';

/** How a file writes its binary arrays. */
interface Binary {
  readonly littleEndian: boolean;
  /** Bytes of a number in the header of an array. */
  readonly headerBytes: 4 | 8;
  readonly isPacked: boolean;
}

/**
 * The bytes of an array's numbers; of text, in this machine's byte order.
 * @param count - numbers that are needed
 * @returns bytes that are taken from the budget
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export async function readVtiNumbers(
  array: VtiArray,
  document: VtiDocument,
  { type, count, budget }: { type: NumberType; count: number; budget: Budget },
): Promise<Uint8Array<ArrayBuffer>> {
  const wanted = count * type.bytesPerSample;
  const form = array.attributes.get('format') ?? 'ascii';
  if (form === 'ascii') {
    budget.take(array.data.length, what);
    const text = new TextEncoder().encode(array.data);
    array.data = '';
    budget.take(wanted, what);
    const numbers = readTextNumbers(what, text, count, type);
    budget.giveBack(text.length);
    return numbers;
  }
  const binary = readBinaryForm(document);
  const bytes = form === 'binary' ? decodeText(array, budget) : findAppended(array, document, wanted, budget);
  return binary.isPacked ? unpackBlocks(bytes, binary, wanted, budget) : takePlain(bytes, binary, wanted, budget);
}

function readBinaryForm({ file }: VtiDocument): Binary {
  const compressor = file.get('compressor') ?? '';
  if (compressor !== '' && compressor !== 'vtkZLibDataCompressor')
    throw unsupportedFile(
      what,
      `is packed by ${compressor.slice(0, 60)}; expected zlib or none. Save it again in ParaView with the compressor ZLib`,
    );
  const header = file.get('header_type') ?? 'UInt32';
  if (header !== 'UInt32' && header !== 'UInt64')
    throw corruptFile(what, `got the header_type "${header.slice(0, 40)}"; expected UInt32 or UInt64`);
  return {
    littleEndian: isLittleEndian(file),
    headerBytes: header === 'UInt32' ? 4 : 8,
    isPacked: compressor !== '',
  };
}

export const isLittleEndian = (file: VtiDocument['file']): boolean => file.get('byte_order') !== 'BigEndian';

function decodeText(array: VtiArray, budget: Budget): Uint8Array<ArrayBuffer> {
  budget.take(2 * array.data.length, what);
  const text = new TextEncoder().encode(array.data);
  array.data = '';
  return decodeBase64Parts(text, Infinity) ?? failBase64();
}

function findAppended(
  { attributes }: VtiArray,
  { appended }: VtiDocument,
  wanted: number,
  budget: Budget,
): Uint8Array<ArrayBuffer> {
  const offset = Number(attributes.get('offset') ?? NaN);
  if (!appended || !(Number.isSafeInteger(offset) && offset >= 0 && offset < appended.bytes.length))
    throw corruptFile(
      what,
      `has an array at the offset ${offset} of its appended data, which are ${appended?.bytes.length ?? 0} bytes; the file is damaged or cut short`,
    );
  const from = appended.bytes.subarray(offset);
  if (appended.encoding === 'raw') return from;
  // Other arrays follow. Packed data are rarely larger than what they unpack to; the header of blocks is in addition.
  const most = 2 * wanted + 2 ** 20;
  budget.take(Math.min(most, from.length), what);
  return decodeBase64Parts(from, most) ?? failBase64();
}

function failBase64(): never {
  throw corruptFile(what, 'has data that are no Base64; the file is damaged');
}

/** A number of a header; NaN if the bytes end before it. */
function readNumber(bytes: Uint8Array, index: number, { headerBytes, littleEndian }: Binary): number {
  if ((index + 1) * headerBytes > bytes.length) return NaN;
  const view = new DataView(bytes.buffer, bytes.byteOffset + index * headerBytes, headerBytes);
  return headerBytes === 4 ? view.getUint32(0, littleEndian) : Number(view.getBigUint64(0, littleEndian));
}

function checkCount(got: number, wanted: number): void {
  if (got !== wanted)
    throw corruptFile(what, `has an array of ${got} bytes; its extent and type ask for ${wanted}: the file is damaged`);
}

/** Data that are not packed: their length, then the numbers. */
function takePlain(
  bytes: Uint8Array<ArrayBuffer>,
  binary: Binary,
  wanted: number,
  budget: Budget,
): Uint8Array<ArrayBuffer> {
  checkCount(readNumber(bytes, 0, binary), wanted);
  const end = binary.headerBytes + wanted;
  if (end > bytes.length)
    throw corruptFile(what, `ends early: got ${bytes.length} bytes of an array; its header asks for ${end}`);
  budget.take(wanted, what);
  return bytes.slice(binary.headerBytes, end);
}

/** Packed data: the number of blocks, the length of a block and of the last one if it is shorter, each block's packed length. */
async function unpackBlocks(
  bytes: Uint8Array<ArrayBuffer>,
  binary: Binary,
  wanted: number,
  budget: Budget,
): Promise<Uint8Array<ArrayBuffer>> {
  const [count, length, last] = [0, 1, 2].map((index) => readNumber(bytes, index, binary));
  let at = (3 + count) * binary.headerBytes;
  if (!(at <= bytes.length))
    throw corruptFile(what, `has an array of ${count} packed blocks in ${bytes.length} bytes; the file is damaged`);
  const lengthOf = (block: number): number => (block === count - 1 && last > 0 ? last : length);
  checkCount(count > 0 ? (count - 1) * length + lengthOf(count - 1) : 0, wanted);
  if (wanted > (bytes.length - at) * maxDeflateRatio)
    throw corruptFile(
      what,
      `ends early: got ${bytes.length - at} packed bytes; its header asks for ${wanted} unpacked`,
    );
  budget.take(wanted, what);
  const all = new Uint8Array(wanted);
  let to = 0;
  for (let block = 0; block < count; block++) {
    const packed = readNumber(bytes, 3 + block, binary);
    if (!(at + packed <= bytes.length))
      throw corruptFile(what, `ends early: block ${block + 1} of ${count} of an array is not all there`);
    all.set(await unpackBlock(bytes.subarray(at, at + packed), lengthOf(block)), to);
    at += packed;
    to += lengthOf(block);
  }
  return all;
}

async function unpackBlock(packed: Uint8Array<ArrayBuffer>, length: number): Promise<Uint8Array> {
  if (!isZlib(packed)) throw corruptFile(what, 'has a block that is not packed by zlib; the file is damaged');
  const reader = new PieceReader(unzlib(packed));
  try {
    const bytes = await reader.readRange(0, length, () => undefined);
    // The checksum is at the end.
    await reader.drain(1);
    if (bytes.length === length && reader.total === length) return bytes;
    throw corruptFile(what, `has a block that unpacks to ${reader.total} bytes or more; expected ${length}`);
  } finally {
    await reader.stop();
  }
}
