import type { Samples } from '../../volume/volume.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import { pixelsOf, prepareUpload, rowsOfPiece } from './fill-texture.ts';
import type { Size, Texels, Upload } from './fill-texture.ts';

/** Allocate the memory of the bound 2D texture. */
export function allocatePlane(gl: Gl, { internal, format, type }: Texels, { width, height }: Size): void {
  if (isWebGl2(gl)) gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
  else gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, null);
}

/**
 * Fill a 2D texture that `allocatePlane` allocated.
 * @param readRows - returns the texels of `count` rows, from the row `first` on
 */
export function* fillPlane(
  gl: Gl,
  texture: WebGLTexture,
  { texels: { format, type, bytes }, width, height }: Size & { readonly texels: Texels },
  readRows: (first: number, count: number) => Samples,
): Upload<void> {
  const rows = rowsOfPiece(width * bytes);
  for (let y = 0; y < height; y += rows) {
    const count = Math.min(rows, height - y);
    const piece = readRows(y, count);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    prepareUpload(gl);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, y, width, count, format, type, pixelsOf(piece));
    yield piece.byteLength;
  }
}
