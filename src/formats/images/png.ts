import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import { Budget } from '../base/budget.ts';
import { combineChannels, describeLoss } from '../base/channels.ts';
import type { ChannelUse } from '../base/channels.ts';
import { refusePixels } from './max-pixels.ts';
import { hostIsLittleEndian } from '../base/number-types.ts';
import { corruptPng, readPngHeader, readPngParts } from './png-chunks.ts';
import type { PngHeader, PngParts } from './png-chunks.ts';
import { bytesPerRow, unpackRows } from './png-rows.ts';
import { joinPieces } from '../base/join-pieces.ts';

const what = 'the PNG';

/**
 * Reads a PNG as one channel of 8 or 16 bits, exactly as stored: without colour management and alpha. Gray of 1, 2 or 4
 * bits is scaled to 8, as every viewer does. Colours become luma, see channels.ts.
 * It is our own reader around the browser's decompressor. A browser's image decoder applies colour profiles and gamma,
 * gives 8 bits of 16 and premultiplies. fast-png, which writes this package's mosaics, unpacks everything in a file,
 * its profile too, before it compares that with the picture's size, and holds it three times.
 * @param budget - the bytes of the returned samples stay taken from it
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, `format/unsupported`
 */
export async function readPng(
  bytes: Uint8Array<ArrayBuffer>,
  use: ChannelUse = 'gray',
  budget = Budget.ofFile(bytes.length),
): Promise<GrayImage> {
  const header = readPngHeader(bytes);
  const unpacked = checkSize(header);
  const parts = readPngParts(bytes, header);
  const packed = joinPacked(parts, budget);
  // Deflate makes data longer only by a little. So packed data longer than this unpack to more than the picture: a
  // bomb.
  if (unpacked * 2 + 2 ** 20 < packed.length)
    throw corruptPng(`holds ${packed.length} bytes for a picture of ${unpacked}`);
  budget.take(unpacked, what);
  const rows = await unpackRows(parts, packed);
  if (parts.packed.length > 1) budget.giveBack(packed.length);
  const { width, height } = header;
  const left = use === 'gray' ? listLeft(parts, rows) : [];
  const data = toOneChannel(parts, rows, use, budget);
  if (data.buffer !== rows.buffer) budget.giveBack(unpacked);
  return { width, height, data, ...(left.length > 0 ? { left } : {}) };
}

/** A palette is a picture of its own. */
function listLeft(
  { header: { depth, channels, isPalette }, palette }: PngParts,
  rows: Uint8Array<ArrayBuffer>,
): string[] {
  if (isPalette) return describeLoss(palette, 3);
  if (channels === 1) return [];
  return describeLoss(rows, channels, Math.max(1, depth / 8));
}

/** @returns bytes of all rows */
function checkSize(header: PngHeader): number {
  const { height, depth } = header;
  refusePixels('the PNG', header);
  if (header.isInterlaced && depth < 8) {
    throw new VolumeViewError(
      'format/unsupported',
      `an interlaced PNG of ${depth} bits is not supported; save it without interlacing`,
    );
  }
  const unpacked = height * bytesPerRow(header);
  if (unpacked > 2 ** 31) {
    throw new VolumeViewError(
      'format/too-large',
      `the PNG unpacks to ${unpacked.toLocaleString('en')} bytes; save it as 8-bit gray`,
    );
  }
  return unpacked;
}

/** The packed picture in one piece. */
function joinPacked({ packed }: PngParts, budget: Budget): Uint8Array<ArrayBuffer> {
  if (packed.length === 1) return packed[0];
  const length = packed.reduce((sum, part) => sum + part.length, 0);
  budget.take(length, what);
  return joinPieces(packed);
}

function toOneChannel(
  { header, palette }: PngParts,
  rows: Uint8Array<ArrayBuffer>,
  use: ChannelUse,
  budget: Budget,
): GrayImage['data'] {
  const { width, height, depth, channels, isPalette } = header;
  const pixels = width * height;
  if (depth === 16 && hostIsLittleEndian) swapPairs(rows);
  const data = depth === 16 ? new Uint16Array(rows.buffer) : rows;
  if (use === 'gray' && (isPalette || depth < 8)) {
    if (isPalette && palette.length === 0) throw corruptPng('has no palette');
    budget.take(pixels, what);
    const values = depth === 8 ? rows.slice() : unpackBits(rows, header);
    const table = isPalette
      ? combineChannels(palette.slice(), 3, 'gray')
      : Uint8Array.from({ length: 2 ** depth }, (_, i) => (i * 255) / (2 ** depth - 1));
    for (let i = 0; i < pixels; i++) {
      if (values[i] >= table.length) throw corruptPng(`names colour ${values[i]} of a palette of ${table.length}`);
      values[i] = table[values[i]];
    }
    return values;
  }
  if (channels > 1) budget.take(pixels * (use === 'gray' ? depth / 8 : 2), what);
  return combineChannels(data, channels, use);
}

/** Unpacks numbers of 1, 2 or 4 bits, the highest bits of a byte first; each row begins with a new byte. */
function unpackBits(data: Uint8Array, header: PngHeader): Uint8Array<ArrayBuffer> {
  const { width, height, depth } = header;
  const stride = bytesPerRow(header);
  const mask = 2 ** depth - 1;
  const values = new Uint8Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const bit = x * depth;
      values[y * width + x] = (data[y * stride + (bit >> 3)] >> (8 - depth - (bit & 7))) & mask;
    }
  }
  return values;
}

/** PNG has the high byte first. */
function swapPairs(bytes: Uint8Array): void {
  for (let i = 0; i + 1 < bytes.length; i += 2) {
    const high = bytes[i];
    bytes[i] = bytes[i + 1];
    bytes[i + 1] = high;
  }
}
