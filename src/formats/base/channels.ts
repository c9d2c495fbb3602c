import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';

/**
 * How an image's channels make one number per pixel: as gray (colours are converted), or as 16 bits, with the high byte
 * in red and the low byte in green.
 */
export type ChannelUse = 'gray' | 'high-low';

/** Channels that differ by more than this, of 255, are a colour; by less, what packing has left of gray. */
const colorStep = 16;

/** Bytes that the colours of a voxel take while a file is read: as they come, as they are drawn, and as values. */
export const bytesOfColors = 10;

/** @param bytes - of a channel, the highest one first */
function findColor(data: ArrayLike<number>, channels: number, bytes: number): boolean {
  for (let at = 0; at < data.length; at += channels * bytes)
    if (isColor(data[at], data[at + bytes], data[at + 2 * bytes])) return true;
  return false;
}

/** Whether some pixels are in colour. @param channels - numbers of a pixel, red first; 2 and fewer are gray */
export function hasColors(data: ArrayLike<number>, channels: number): boolean {
  return channels > 2 && findColor(data, channels, 1);
}

const isColor = (red: number, green: number, blue: number): boolean =>
  Math.max(Math.abs(red - green), Math.abs(red - blue)) > colorStep;

/**
 * What of an image is lost where it becomes gray: its colours, and that it is transparent in places.
 * @param channels - 2 and 4 have alpha as the last one
 * @param bytes - of a channel, the highest one first
 */
export function describeLoss(data: Uint8Array | Uint8ClampedArray, channels: number, bytes = 1): string[] {
  const isColored = channels > 2 && findColor(data, channels, bytes);
  return [
    ...(isColored ? ['the colours of the image: their brightness is shown (luma, Rec. ITU-R BT.709)'] : []),
    ...describeAlpha(data, channels, bytes),
  ];
}

/** What of an image is lost where its alpha is left out. The parameters are those of describeLoss. */
export function describeAlpha(data: Uint8Array | Uint8ClampedArray, channels: number, bytes = 1): string[] {
  if (channels % 2 === 1) return [];
  for (let at = (channels - 1) * bytes; at < data.length; at += channels * bytes)
    if (data[at] < 0xff) return ['where the image is transparent: its pixels are shown as if they were not'];
  return [];
}

/** Bring an image whose channels lie together (gray, gray + alpha, RGB, RGBA) to one channel. */
export function combineChannels(
  data: GrayImage['data'] | Uint8ClampedArray,
  channels: number,
  use: ChannelUse,
): GrayImage['data'] {
  return use === 'gray' ? luma(data, channels) : joinBytes(data, channels);
}

/** The brightness of a colour: Rec. ITU-R BT.709 weights on the values as stored, rounded. */
export function lumaOf(red: number, green: number, blue: number): number {
  return Math.floor(0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.5);
}

/**
 * Most tools store gray as colours: then the red channel has the exact value. Where the channels differ it is a colour
 * picture, and the best single number per voxel is its luma. Alpha is ignored.
 */
function luma(data: GrayImage['data'] | Uint8ClampedArray, channels: number): GrayImage['data'] {
  if (channels === 1 && !(data instanceof Uint8ClampedArray)) return data;
  const length = data.length / channels;
  const gray = data instanceof Uint16Array ? new Uint16Array(length) : new Uint8Array(length);
  for (let i = 0, at = 0; i < length; i++, at += channels) {
    const red = data[at];
    const isGray = channels < 3 || (red === data[at + 1] && red === data[at + 2]);
    gray[i] = isGray ? red : lumaOf(red, data[at + 1], data[at + 2]);
  }
  return gray;
}

/** The paper's "more than 8 bits a sample": 256 * red + green. */
function joinBytes(data: GrayImage['data'] | Uint8ClampedArray, channels: number): GrayImage['data'] {
  if (channels < 3 || data instanceof Uint16Array) {
    throw new VolumeViewError(
      'mosaic/layout',
      'channels "high-low" got an image without red and green of 8 bits; expected an 8-bit RGB image with the high byte in red and the low byte in green',
    );
  }
  const joined = new Uint16Array(data.length / channels);
  for (let i = 0, at = 0; i < joined.length; i++, at += channels) joined[i] = data[at] * 256 + data[at + 1];
  return joined;
}
