import type { Pixels } from '../optics/between-pixels.ts';
import type { Gl } from './device.ts';

/** The bound framebuffer's picture as it lies there: RGBA, premultiplied, bottom row first. */
export function readPicture(gl: Gl, { width, height }: { readonly width: number; readonly height: number }): Pixels & { readonly data: Uint8Array } {
  const data = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return { data, width, height };
}

/** The same with the top row first. */
export function turnOver({ data, width, height }: ReturnType<typeof readPicture>): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(data.length);
  for (let row = 0; row < height; row++) {
    const from = (height - 1 - row) * width * 4;
    pixels.set(data.subarray(from, from + width * 4), row * width * 4);
  }
  return pixels;
}
