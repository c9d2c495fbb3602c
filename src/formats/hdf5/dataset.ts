import { VolumeViewError } from '../../core/errors.ts';
import { countElements, refuseTooMany } from '../base/data-tree.ts';
import type { AttributeValue, DataArray, ElementType, Numbers } from '../base/data-tree.ts';
import { decodeNumbers } from '../base/decode-numbers.ts';
import { maxDeflateRatio } from '../codecs/gunzip.ts';
import { decodeText } from '../base/decode-text.ts';
import { takeDuring } from '../base/take-during.ts';
import { readAttributes } from './attributes.ts';
import { listChunks } from './chunks.ts';
import type { Chunk } from './chunks.ts';
import { copyBox } from './copy-box.ts';
import { readFilters, scaleOffset, undoFilters } from './filters.ts';
import type { Filter } from './filters.ts';
import { readTextsElsewhere } from './global-heap.ts';
import { corruptHdf5, Cursor, noAddress, unsupportedHdf5 } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import { readLayout } from './layout.ts';
import type { ChunkedLayout, Layout } from './layout.ts';
import { findMessage, messageTypes } from './object-header.ts';
import type { Message } from './object-header.ts';
import { readDataType, readExtent } from './types.ts';
import type { DataType } from './types.ts';

/**
 * Maximum bytes of unpacked chunks that are kept: sweeps of one array are read one after another, and may share a
 * chunk.
 */
const maxKeptBytes = 2 ** 26;

/**
 * A chunk may be larger than an array that will grow. This is the maximum ratio, and the size below which the ratio
 * does not matter.
 */
const maxChunkShare = 8;
const anyChunkBytes = 2 ** 24;

/** Memory for a text in addition to its characters, bytes. */
const bytesPerText = 64;

/** An array of an HDF5 file. */
export class Hdf5Dataset implements DataArray {
  readonly path: string;
  readonly shape: readonly number[];
  readonly type: ElementType;
  /** Lengths that it may grow to. */
  readonly #maxShape: readonly number[];
  readonly #file: Hdf5Bytes;
  readonly #messages: readonly Message[];
  readonly #dataType: DataType;
  readonly #layout: Layout;
  readonly #filters: readonly Filter[];
  #attributes: Map<string, AttributeValue> | null = null;
  #chunks: readonly Chunk[] | null = null;
  readonly #kept = new Map<Chunk, Uint8Array<ArrayBuffer>>();
  #keptBytes = 0;

  /** @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
  constructor(file: Hdf5Bytes, path: string, messages: readonly Message[]) {
    const find = (type: number): Message => {
      const message = findMessage(messages, type);
      if (!message) throw corruptHdf5(`does not say how ${path} is stored`);
      return message;
    };
    this.path = path;
    this.#file = file;
    this.#messages = messages;
    this.#dataType = readDataType(new Cursor(file, find(messageTypes.datatype).position));
    const { shape, maxShape } = readExtent(new Cursor(file, find(messageTypes.dataspace).position)) ?? {
      shape: [0],
      maxShape: [0],
    };
    this.shape = shape;
    this.#maxShape = maxShape;
    this.type = elementTypeOf(this.#dataType);
    this.#layout = readLayout(file, find(messageTypes.layout));
    const filters = findMessage(messages, messageTypes.filters);
    this.#filters = filters ? readFilters(file, filters) : [];
  }

  get attributes(): ReadonlyMap<string, AttributeValue> {
    this.#attributes ??= readAttributes(this.#file, this.#messages);
    return this.#attributes;
  }

  readRows(from: number, count: number): Numbers {
    const type = this.#dataType;
    if (type.kind !== 'number')
      throw unsupportedHdf5(`${this.path} as ${type.kind === 'other' ? type.name : 'text'}`, 'plain-numbers');
    const made = count * countElements(this.shape.slice(1)) * bytesOfDecoding(type);
    return takeDuring(this.#file.budget, { bytes: made, what: this.path }, () =>
      decodeNumbers(this.#readBytes(from, count), type.type, type.littleEndian),
    );
  }

  readTexts(): readonly string[] {
    const made = countElements(this.shape) * this.#dataType.bytes;
    return takeDuring(this.#file.budget, { bytes: made, what: this.path }, () => this.#readTexts());
  }

  #readTexts(): readonly string[] {
    const type = this.#dataType;
    const bytes = this.#readBytes(0, this.shape[0] ?? 1);
    if (type.kind === 'text-elsewhere') return readTextsElsewhere(this.#file, bytes);
    if (type.kind !== 'text')
      throw unsupportedHdf5(
        `${this.path} as ${type.kind === 'other' ? type.name : 'numbers'}, where text belongs`,
        'plain-numbers',
      );
    // NetCDF stores characters one by one; a row of them is a text.
    const textBytes = type.bytes === 1 ? (this.shape.at(-1) ?? 1) : type.bytes;
    const texts = textBytes === 0 ? 0 : Math.floor(bytes.length / textBytes);
    this.#file.budget.take(bytesPerText * texts + bytes.length, this.path);
    return Array.from({ length: texts }, (_, i) => decodeText(bytes.subarray(i * textBytes, (i + 1) * textBytes)));
  }

  #readBytes(from: number, count: number): Uint8Array<ArrayBuffer> {
    const rows = this.shape[0] ?? 1;
    if (!(from >= 0 && count >= 0 && from + count <= rows)) {
      throw corruptHdf5(`asks for rows ${from} to ${from + count} of ${this.path}, which has ${rows}`);
    }
    if (findMessage(this.#messages, messageTypes.externalFiles))
      throw unsupportedHdf5(`the values of ${this.path} in other files`, 'one-file');
    const rowElements = countElements(this.shape.slice(1));
    const rowBytes = rowElements * this.#dataType.bytes;
    refuseTooMany(this.path, Math.max(count * rowElements, (count * rowBytes) / 8));
    if (this.#layout.kind === 'chunked')
      return this.#readChunked(this.#layout, { from, count, bytes: count * rowBytes });
    const { position, bytes } = this.#layout;
    if (position === noAddress) return this.#makeFilled(count * rowBytes);
    if ((from + count) * rowBytes > bytes)
      throw corruptHdf5(`holds ${bytes} bytes of ${this.path}; expected ${(from + count) * rowBytes}`);
    return this.#file.slice(position + from * rowBytes, count * rowBytes).slice();
  }

  #readChunked(layout: ChunkedLayout, rows: { from: number; count: number; bytes: number }): Uint8Array<ArrayBuffer> {
    const elementBytes = this.#dataType.bytes;
    this.#chunks ??= listChunks(this.#file, {
      layout,
      shape: this.shape,
      elementBytes,
      isFiltered: this.#filters.length > 0,
      maxShape: this.#maxShape,
    });
    const chunkBytes = countElements(layout.chunk) * elementBytes;
    this.#checkChunk(chunkBytes);
    const shape = [rows.count, ...this.shape.slice(1)];
    // Copying works in runs along the last axis.
    const runs = countElements(shape.slice(0, -1)) * Math.ceil(shape.at(-1)! / (layout.chunk.at(-1) ?? 1));
    this.#file.budget.step(this.#chunks.length + runs, this.path);
    const target = this.#makeFilled(rows.bytes);
    for (const chunk of this.#chunks) {
      if (chunk.start[0] >= rows.from + rows.count || chunk.start[0] + layout.chunk[0] <= rows.from) continue;
      const bytes = this.#unpack(chunk, chunkBytes, layout);
      const start = [chunk.start[0] - rows.from, ...chunk.start.slice(1)];
      copyBox({ bytes, shape: layout.chunk }, { bytes: target, shape }, start, elementBytes);
    }
    return target;
  }

  #checkChunk(bytes: number): void {
    refuseTooMany(`a chunk of ${this.path}`, bytes / this.#dataType.bytes);
    const needed = countElements(this.shape) * this.#dataType.bytes;
    if (bytes > anyChunkBytes && bytes > maxChunkShare * needed) {
      throw new VolumeViewError(
        'format/too-large',
        `${this.path} comes in chunks of ${bytes.toLocaleString('en')} bytes for an array of ${needed.toLocaleString('en')}; ` +
          `expected chunks of at most ${maxChunkShare} times the array. Write the file again with smaller chunks`,
      );
    }
  }

  #unpack(chunk: Chunk, expected: number, layout: ChunkedLayout): Uint8Array<ArrayBuffer> {
    const known = this.#kept.get(chunk);
    if (known) return known;
    const { budget } = this.#file;
    const isPlain = layout.hasPlainEdges && chunk.start.some((at, axis) => at + layout.chunk[axis] > this.shape[axis]);
    const filters = isPlain ? [] : this.#filters;
    // Refuse a size that the stored bytes can't expand to before memory is allocated. Scale-offset has no limit: no bits for equal numbers.
    if (expected > maxDeflateRatio * chunk.bytes && !filters.some(({ id }) => id === scaleOffset))
      throw corruptHdf5(`has a chunk of ${chunk.bytes} bytes for ${expected} of ${this.path}`);
    const bytes = undoFilters(this.#file.slice(chunk.position, chunk.bytes), filters, {
      skipped: chunk.skipped,
      expected,
      budget,
    });
    if (this.#keptBytes + bytes.length > maxKeptBytes) {
      this.#kept.clear();
      budget.giveBack(this.#keptBytes);
      this.#keptBytes = 0;
    }
    budget.take(bytes.length, this.path);
    this.#kept.set(chunk, bytes);
    this.#keptBytes += bytes.length;
    return bytes;
  }

  /** Bytes for parts that were never written: the fill value, or 0. */
  #makeFilled(bytes: number): Uint8Array<ArrayBuffer> {
    const filled = new Uint8Array(bytes);
    const fill =
      this.#layout.kind === 'chunked' || this.#layout.position === noAddress
        ? readFillValue(this.#file, this.#messages)
        : null;
    if (!fill || fill.length !== this.#dataType.bytes || fill.every((byte) => byte === 0)) return filled;
    filled.set(fill.subarray(0, bytes));
    for (let done = fill.length; done < bytes; done *= 2) filled.copyWithin(done, 0, Math.min(done, bytes - done));
    return filled;
  }
}

/** Bytes of memory per element during decoding: as stored and, if the type differs, as a number. */
function bytesOfDecoding({ type, bytes }: Extract<DataType, { kind: 'number' }>): number {
  return type === 'int64' || type === 'uint64' || type === 'float16' ? 3 * bytes : bytes;
}

function elementTypeOf(type: DataType): ElementType {
  if (type.kind === 'number') return type.type;
  return type.kind === 'other' ? 'other' : 'text';
}

/** Source: HDF5 File Format Specification 3.0, IV.A.2.e and IV.A.2.f */
function readFillValue(file: Hdf5Bytes, messages: readonly Message[]): Uint8Array | null {
  const old = findMessage(messages, messageTypes.fillValueOld);
  const message = findMessage(messages, messageTypes.fillValue);
  if (!message) {
    if (!old) return null;
    const cursor = new Cursor(file, old.position);
    return cursor.slice(cursor.u32());
  }
  const cursor = new Cursor(file, message.position);
  const version = cursor.expectVersion('a fill value', 1, 2, 3);
  if (version === 3) return cursor.u8() & 0x20 ? cursor.slice(cursor.u32()) : null;
  cursor.skip(2);
  const isDefined = cursor.u8() !== 0;
  return version === 1 || isDefined ? cursor.slice(cursor.u32()) : null;
}
