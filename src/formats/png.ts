import { decode } from 'fast-png';
import type { DecodedPng } from 'fast-png';
import { VolumeViewError } from '../errors.ts';
import type { GrayImage } from '../volume/mosaic.ts';
import { combineChannels } from './channels.ts';
import type { ChannelUse } from './channels.ts';

/** Maximum number of pixels of an image: 2^28 are 16,384 x 16,384, the largest texture of today's devices. */
export const maxPixels = 2 ** 28;

/**
 * Read a PNG as one channel of 8 or 16 bits, exactly as stored: no colour management, alpha left out. Gray of 1, 2 or 4
 * bits is spread over 8, as every viewer does. Colours become luma, see channels.ts.
 *
 * fast-png, because a browser's own decoder applies colour profiles and gamma, gives 8 bits of 16 and premultiplies.
 * The aorta mosaic (4096 x 4096 gray) takes it 0.2 to 0.3 s, where the browser's inflate alone takes as long.
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, `format/unsupported`
 */
export function readPng(bytes: Uint8Array<ArrayBuffer>, use: ChannelUse = 'gray'): GrayImage {
  checkHeader(bytes);
  let png: DecodedPng;
  try {
    png = decode(bytes, { checkCrc: true });
  } catch (cause) {
    throw new VolumeViewError('format/corrupt', `the PNG is damaged or ends early (${describe(cause)}); save or fetch it again`, { cause });
  }
  return { width: png.width, height: png.height, data: toOneChannel(png, use) };
}

/** Read the size before anything is unpacked. The header chunk always comes first, at a fixed position. */
function checkHeader(bytes: Uint8Array<ArrayBuffer>): void {
  const corrupt = (what: string): VolumeViewError => new VolumeViewError('format/corrupt', `the PNG ${what}; save or fetch it again`);
  if (bytes.length < 33) throw corrupt(`of ${bytes.length} bytes ends before its header does`);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  const [depth, colorType] = [bytes[24], bytes[25]];
  if (width === 0 || height === 0) throw corrupt(`header got a size of ${width} x ${height}`);
  if (width * height > maxPixels) {
    throw new VolumeViewError('format/too-large', `the PNG got ${width} x ${height} pixels; expected at most ${maxPixels.toLocaleString('en')} in all`);
  }
  if (bytes[28] === 1 && depth < 8) {
    throw new VolumeViewError('format/unsupported', `an interlaced PNG of ${depth} bits is not supported; save it without interlacing`);
  }
  const channels = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 }[colorType] ?? 0;
  const unpacked = height * (1 + Math.ceil((width * channels * depth) / 8)) * (bytes[28] === 1 ? 2 : 1);
  if (unpacked > 2 ** 31) {
    throw new VolumeViewError('format/too-large', `the PNG unpacks to ${unpacked.toLocaleString('en')} bytes; save it as 8-bit gray`);
  }
  // Deflate never grows data by more than a little, so a longer file unpacks to more than the picture: a bomb.
  const packed = bytes.length - 33;
  if (unpacked * 2 + 2 ** 20 < packed) throw corrupt(`holds ${packed} bytes for a picture of ${unpacked}`);
}

function toOneChannel(png: DecodedPng, use: ChannelUse): GrayImage['data'] {
  const { width, height, depth, channels, data } = png;
  if (png.palette && use === 'gray') {
    const table = paletteLuma(png.palette);
    const indices = depth === 8 ? data : unpackBits(data, { width, height, depth });
    const gray = new Uint8Array(width * height);
    for (let i = 0; i < gray.length; i++) {
      if (indices[i] >= table.length) throw new VolumeViewError('format/corrupt', `the PNG names colour ${indices[i]} of a palette of ${table.length}`);
      gray[i] = table[indices[i]];
    }
    return gray;
  }
  if (depth < 8 && use === 'gray') {
    const gray = unpackBits(data, { width, height, depth });
    const spread = 255 / (2 ** depth - 1);
    return gray.map((value) => value * spread);
  }
  const own = data instanceof Uint16Array ? data : new Uint8Array(data.buffer, data.byteOffset, data.length);
  return combineChannels(own as GrayImage['data'], png.palette ? 1 : channels, use);
}

/** Palettes are 8-bit colours, with alpha after them in transparent ones. */
function paletteLuma(palette: readonly (readonly number[])[]): Uint8Array {
  return combineChannels(new Uint8Array(palette.flatMap(([r, g, b]) => [r, g, b])), 3, 'gray') as Uint8Array;
}

/** Numbers of 1, 2 or 4 bits, the highest bits of a byte first; each row begins with a new byte. */
function unpackBits(data: ArrayLike<number>, size: { width: number; height: number; depth: number }): Uint8Array<ArrayBuffer> {
  const { width, height, depth } = size;
  const bytesPerRow = Math.ceil((width * depth) / 8);
  const mask = 2 ** depth - 1;
  const values = new Uint8Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const bit = x * depth;
      values[y * width + x] = (data[y * bytesPerRow + (bit >> 3)] >> (8 - depth - (bit & 7))) & mask;
    }
  }
  return values;
}

function describe(cause: unknown): string {
  return cause instanceof Error ? cause.message : String(cause);
}
