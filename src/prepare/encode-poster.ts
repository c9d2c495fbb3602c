import { encode } from 'fast-png';
import type { Poster } from './draw-poster.ts';

/** A picture with its transparency, as PNG: so it suits light and dark pages. */
export function encodePoster({ size, pixels }: Poster): Uint8Array {
  const data = new Uint8Array(pixels.length);
  for (let at = 0; at < pixels.length; at += 4) {
    const alpha = pixels[at + 3];
    // PNG has colours that are not multiplied by the opacity.
    for (let c = 0; c < 3; c++) data[at + c] = alpha > 0 ? Math.round(255 * Math.min(1, pixels[at + c] / alpha)) : 0;
    data[at + 3] = Math.round(255 * Math.min(1, alpha));
  }
  return encode({ width: size, height: size, data, channels: 4, depth: 8 }, { zlib: { level: 9 } });
}
