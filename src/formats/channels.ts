import { VolumeViewError } from '../errors.ts';
import type { GrayImage } from '../volume/mosaic.ts';

/**
 * How an image's channels make one number per pixel: as gray (which colours are turned into), or as 16 bits, the high
 * byte in red and the low byte in green.
 */
export type ChannelUse = 'gray' | 'high-low';

/** Bring an image whose channels lie together (gray, gray + alpha, RGB, RGBA) to one channel. */
export function combineChannels(data: GrayImage['data'] | Uint8ClampedArray, channels: number, use: ChannelUse): GrayImage['data'] {
  return use === 'gray' ? luma(data, channels) : joinBytes(data, channels);
}

/**
 * Gray stored as colours, which most tools write, gives the red channel exactly. Where the channels differ it is a
 * colour picture, and the nearest to one number per voxel is its luma, Rec. ITU-R BT.709 weights on the values as
 * stored, rounded. Alpha is ignored.
 */
function luma(data: GrayImage['data'] | Uint8ClampedArray, channels: number): GrayImage['data'] {
  if (channels === 1 && !(data instanceof Uint8ClampedArray)) return data;
  const length = data.length / channels;
  const gray = data instanceof Uint16Array ? new Uint16Array(length) : new Uint8Array(length);
  for (let i = 0, at = 0; i < length; i++, at += channels) {
    const red = data[at];
    const isGray = channels < 3 || (red === data[at + 1] && red === data[at + 2]);
    gray[i] = isGray ? red : Math.floor(0.2126 * red + 0.7152 * data[at + 1] + 0.0722 * data[at + 2] + 0.5);
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
