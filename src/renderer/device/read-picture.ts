import type { Pixels } from '../../optics/rays/between-pixels.ts';
import type { Gl } from './device.ts';

/** Read the picture in the bound framebuffer as it is: RGBA, premultiplied, bottom row first. */
export function readPicture(
  gl: Gl,
  { width, height }: { readonly width: number; readonly height: number },
): Pixels & { readonly data: Uint8Array } {
  const data = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return { data, width, height };
}
