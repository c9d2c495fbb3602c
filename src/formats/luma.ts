import type { GrayImage } from '../volume/mosaic.ts';

/**
 * One channel of an image whose channels lie together (gray, gray + alpha, RGB, RGBA). Gray stored as colours, which
 * most tools write, gives the red channel exactly. Where the channels differ it is a colour picture, and the nearest to
 * one number per voxel is its luma, Rec. ITU-R BT.709 weights on the values as stored, rounded. Alpha plays no part.
 */
export function luma(data: GrayImage['data'] | Uint8ClampedArray, channels: number): GrayImage['data'] {
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
