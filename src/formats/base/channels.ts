import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';

/**
 * How an image's channels make one number per pixel: as gray (colours are converted), or as 16 bits, with the high byte
 * in red and the low byte in green.
 */
export type ChannelUse = 'gray' | 'high-low';

/** Channels that differ by more than this, of 255, are a colour; by less, what packing has left of gray. */
const colorStep = 16;

/**
 * What of an image is lost where it becomes gray: its colours, and that it is transparent in places.
 * @param channels - 2 and 4 have alpha as the last one
 * @param bytes - of a channel, the highest one first
 */
export function describeLoss(data: Uint8Array | Uint8ClampedArray, channels: number, bytes = 1): string[] {
  const alpha = channels % 2 === 0 ? (channels - 1) * bytes : 0;
  let [hasColors, isTransparent] = [false, false];
  for (let at = 0; at < data.length && !(hasColors && isTransparent); at += channels * bytes) {
    if (
      channels > 2 &&
      Math.max(Math.abs(data[at] - data[at + bytes]), Math.abs(data[at] - data[at + 2 * bytes])) > colorStep
    )
      hasColors = true;
    if (alpha > 0 && data[at + alpha] < 0xff) isTransparent = true;
  }
  return [
    ...(hasColors ? ['the colours of the image: their brightness is shown (luma, Rec. ITU-R BT.709)'] : []),
    ...(isTransparent ? ['where the image is transparent: its pixels are shown as if they were not'] : []),
  ];
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
