import { VolumeViewError } from '../../core/errors.ts';
import { crc32 } from '../codecs/crc32.ts';

/** What a PNG's first chunk says. */
export interface PngHeader {
  readonly width: number;
  readonly height: number;
  /** Bits of a channel. */
  readonly depth: number;
  /** 1 for gray and for a palette, 2 for gray with alpha, 3 and 4 for colours. */
  readonly channels: number;
  readonly isPalette: boolean;
  readonly isInterlaced: boolean;
}

/** The parts of a PNG that are needed to compute its pixels. */
export interface PngParts {
  readonly header: PngHeader;
  /** Red, green and blue of each colour; empty if there is no palette. */
  readonly palette: Uint8Array<ArrayBuffer>;
  /** The packed picture, which may lie in many chunks. */
  readonly packed: readonly Uint8Array<ArrayBuffer>[];
}

/** Valid pairs of channels and depth. Source: the PNG specification, table 12. */
const colorTypes = new Map<number, { channels: number; depths: readonly number[] }>([
  [0, { channels: 1, depths: [1, 2, 4, 8, 16] }],
  [2, { channels: 3, depths: [8, 16] }],
  [3, { channels: 1, depths: [1, 2, 4, 8] }],
  [4, { channels: 2, depths: [8, 16] }],
  [6, { channels: 4, depths: [8, 16] }],
]);

const signatureBytes = 8;
/** Length, type and checksum of a chunk. */
const chunkFrame = 12;

/** Reads the header of a PNG, which always comes first, at a fixed position. @throws {VolumeViewError} `format/corrupt` */
export function readPngHeader(bytes: Uint8Array<ArrayBuffer>): PngHeader {
  if (bytes.length < 33) throw corruptPng(`of ${bytes.length} bytes ends before its header does`);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  if (view.getUint32(8) !== 13 || typeAt(bytes, 8) !== 'IHDR') throw corruptPng('does not begin with its header');
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  const [depth, colorType, method, filter, interlace] = bytes.subarray(24, 29);
  if (width === 0 || height === 0) throw corruptPng(`header got a size of ${width} x ${height}`);
  const color = colorTypes.get(colorType);
  if (!color?.depths.includes(depth) || method !== 0 || filter !== 0 || interlace > 1) {
    throw corruptPng(
      `header got ${depth} bits of colour type ${colorType}, methods ${method}, ${filter} and ${interlace}, which no PNG has`,
    );
  }
  return { width, height, depth, channels: color.channels, isPalette: colorType === 3, isInterlaced: interlace === 1 };
}

/**
 * Walks through all chunks, without unpacking any. Chunks that a picture does not need (profiles, texts, times) are
 * skipped.
 * @throws {VolumeViewError} `format/corrupt` for a wrong checksum, a second header, or a critical chunk that is unknown
 * here
 */
export function readPngParts(bytes: Uint8Array<ArrayBuffer>, header: PngHeader): PngParts {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let palette = new Uint8Array(0);
  const packed: Uint8Array<ArrayBuffer>[] = [];
  for (let at = signatureBytes; ;) {
    const length = at + chunkFrame <= bytes.length ? view.getUint32(at) : Infinity;
    if (at + chunkFrame + length > bytes.length) throw corruptPng('ends early');
    const type = typeAt(bytes, at);
    const body = bytes.subarray(at + 8, at + 8 + length);
    // A capital letter marks a critical chunk, which every reader must know; others are not even checked.
    const isCritical = (bytes[at + 4] & 0x20) === 0;
    if (isCritical && crc32(bytes.subarray(at + 4, at + 8 + length)) !== view.getUint32(at + 8 + length)) {
      throw corruptPng(`got a wrong checksum in its part ${type}`);
    }
    if (type === 'IEND') return { header, palette, packed };
    if (type === 'IDAT') packed.push(body);
    else if (type === 'PLTE') palette = readPalette(body, palette);
    else if (isCritical && at > signatureBytes)
      throw corruptPng(type === 'IHDR' ? 'has two headers' : `needs what is unknown here, its part "${type}"`);
    at += chunkFrame + length;
  }
}

function readPalette(body: Uint8Array<ArrayBuffer>, before: Uint8Array): Uint8Array<ArrayBuffer> {
  if (before.length === 0 && body.length % 3 === 0 && body.length > 0 && body.length <= 768) return body;
  throw corruptPng(`got ${before.length > 0 ? 'two palettes' : `a palette of ${body.length} bytes`}`);
}

export function corruptPng(what: string, options?: { cause: unknown }): VolumeViewError {
  return new VolumeViewError('format/corrupt', `the PNG ${what}; save or fetch it again`, options);
}

/** The type of the chunk that begins there. Only letters, as it may end up in a message. */
function typeAt(bytes: Uint8Array, at: number): string {
  return String.fromCharCode(...bytes.subarray(at + 4, at + 8)).replace(/[^A-Za-z]/g, '?');
}
