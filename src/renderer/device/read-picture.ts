import type { Pixels } from '../../optics/rays/between-pixels.ts';
import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';

/** Pixels across and down. */
interface Size {
  readonly width: number;
  readonly height: number;
}

/** Read the picture in the bound framebuffer as it is: RGBA, premultiplied, bottom row first. */
export function readPicture(gl: Gl, { width, height }: Size): Pixels & { readonly data: Uint8Array } {
  const data = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return { data, width, height };
}

/**
 * Read the bound framebuffer as it is now: RGBA, bottom row first. In WebGL 2 the GPU copies it into a buffer, in order with its drawing.
 * @param data - gets the pixels; its type is that of the channels
 * @returns a function that fills and returns `data`, once. The page waits in it unless the GPU has finished (gpu-finished.ts), whatever
 * the GPU draws meanwhile. In WebGL 1 the page waits at once
 */
export function startReading<Data extends Uint8Array | Float32Array>(
  gl: Gl,
  { width, height }: Size,
  data: Data,
): () => Data {
  const type = data instanceof Float32Array ? gl.FLOAT : gl.UNSIGNED_BYTE;
  if (!isWebGl2(gl)) {
    gl.readPixels(0, 0, width, height, gl.RGBA, type, data);
    return () => data;
  }
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, data.byteLength, gl.STREAM_READ);
  gl.readPixels(0, 0, width, height, gl.RGBA, type, 0);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  return () => {
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, data);
    gl.deleteBuffer(buffer); // It is then no longer bound.
    return data;
  };
}
