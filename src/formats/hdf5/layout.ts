import { Cursor, noAddress, unsupportedHdf5 } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import type { Message } from './object-header.ts';

/** Where the elements of an array are. */
export type Layout =
  /** In one piece; `noAddress` if nothing was ever written. */
  { readonly kind: 'whole'; readonly position: number; readonly bytes: number } | ChunkedLayout;

export interface ChunkedLayout {
  readonly kind: 'chunked';
  /** Elements of a chunk along each axis, slowest first. */
  readonly chunk: readonly number[];
  readonly index: ChunkIndexKind;
  /** Chunks that reach beyond the array's end are stored without filters. */
  readonly hasPlainEdges: boolean;
  /** Address of the index; `noAddress` if no chunk was ever written. */
  readonly address: number;
}

export type ChunkIndexKind =
  | { readonly kind: 'b-tree' }
  /** One chunk. If it is filtered: its stored bytes and skipped filters. */
  | { readonly kind: 'single'; readonly bytes?: number; readonly skipped: number }
  /** Chunks one after another. */
  | { readonly kind: 'implicit' }
  | { readonly kind: 'fixed-array' };

/**
 * Source: HDF5 File Format Specification 3.0, IV.A.2.i
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readLayout(file: Hdf5Bytes, message: Message): Layout {
  const cursor = new Cursor(file, message.position);
  const version = cursor.expectVersion('a data layout', 1, 2, 3, 4, 5);
  if (version < 3) return readFirstLayout(cursor);
  const kind = cursor.u8();
  if (kind === 0) {
    const bytes = cursor.u16();
    return { kind: 'whole', position: cursor.position, bytes };
  }
  if (kind === 1) return readWhole(cursor);
  if (kind !== 2) throw unsupportedHdf5('an array that is put together from other files', 'one-file');
  if (version >= 4) return readNewChunks(cursor);
  const axes = cursor.u8();
  const address = cursor.address();
  return {
    kind: 'chunked',
    chunk: readChunk(axes, () => cursor.u32()),
    index: { kind: 'b-tree' },
    hasPlainEdges: false,
    address,
  };
}

function readFirstLayout(cursor: Cursor): Layout {
  const axes = cursor.u8();
  const kind = cursor.u8();
  cursor.skip(5);
  if (kind === 0) {
    cursor.skip(4 * axes);
    const bytes = cursor.u32();
    return { kind: 'whole', position: cursor.position, bytes };
  }
  const address = cursor.address();
  const lengths = Array.from({ length: axes }, () => cursor.u32());
  if (kind === 2)
    return { kind: 'chunked', chunk: lengths.slice(0, -1), index: { kind: 'b-tree' }, hasPlainEdges: false, address };
  return { kind: 'whole', position: place(cursor.file, address), bytes: Infinity };
}

function readWhole(cursor: Cursor): Layout {
  const address = cursor.address();
  return { kind: 'whole', position: place(cursor.file, address), bytes: cursor.length() };
}

function readNewChunks(cursor: Cursor): Layout {
  const flags = cursor.u8();
  const axes = cursor.u8();
  const lengthBytes = cursor.u8();
  const chunk = readChunk(axes, () => cursor.unsigned(lengthBytes));
  const index = readIndexKind(cursor, flags);
  return { kind: 'chunked', chunk, index, hasPlainEdges: (flags & 1) !== 0, address: cursor.address() };
}

function readIndexKind(cursor: Cursor, flags: number): ChunkIndexKind {
  const kind = cursor.u8();
  switch (kind) {
    case 1: {
      const isFiltered = (flags & 2) !== 0;
      if (!isFiltered) return { kind: 'single', skipped: 0 };
      const bytes = cursor.length();
      return { kind: 'single', bytes, skipped: cursor.u32() };
    }
    case 2:
      return { kind: 'implicit' };
    case 3:
      cursor.skip(1);
      return { kind: 'fixed-array' };
    default:
      throw unsupportedHdf5(
        kind <= 5 ? 'chunks of an array without an end, in the newest way' : `chunks in the way number ${kind}`,
      );
  }
}

/** Lengths of a chunk. The last one is the bytes of an element, which its type says too. */
function readChunk(axes: number, readLength: () => number): number[] {
  return Array.from({ length: axes }, readLength).slice(0, -1);
}

function place(file: Hdf5Bytes, address: number): number {
  return address === noAddress ? noAddress : file.base + address;
}
