import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples } from '../../volume/volume.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';

/**
 * Work that hands data to the GPU piece by piece: each step says how many bytes it was; Infinity where the GPU is to finish first. Who does not want to go on calls
 * `return()`, and what was made is deleted.
 */
export type Upload<T> = Generator<number, T, void>;

/** Most bytes of one piece; a row of texels is never cut, and at most 64 KiB. */
export const pieceBytes = 2 ** 20;

/** Room for more than this takes the GPU as long as filling it: who asks for errors at once waits, and the page with it. */
export const slowBytes = 2 ** 25;

/** What a page can hand to the GPU at once without a frame being late for it. */
export const quickBytes = 2 ** 23;

/** Do all of it at once. */
export function finishUpload<T>(upload: Upload<T>): T {
  for (;;) {
    const step = upload.next();
    if (step.done) return step.value;
  }
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Make room for a volume in the bound 3D texture: samples * bytes of each, and nothing more. */
export function allocateTexture3d(gl: WebGL2RenderingContext, { internal }: Texels, [nx, ny, nz]: Vector3): void {
  gl.texStorage3D(gl.TEXTURE_3D, 1, internal, nx, ny, nz);
}

/**
 * Fill a 3D texture that `allocateTexture3d` made room in.
 * @param prepare - what becomes of some samples before the GPU gets them
 */
export function* fillTexture3d(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  { samples, dimensions: [nx, ny, nz], texels: { format, type, bytes } }: { samples: Samples; dimensions: Vector3; texels: Texels },
  prepare: (samples: Samples) => Samples,
): Upload<void> {
  const rowsAtOnce = rowsOfPiece(nx * bytes);
  // Whole slices where there is room for one, else bands of a slice.
  const slices = Math.max(1, Math.floor(rowsAtOnce / ny));
  const rows = Math.min(ny, rowsAtOnce);
  for (let z = 0; z < nz; z += slices) {
    for (let y = 0; y < ny; y += rows) {
      const [height, depth] = [Math.min(rows, ny - y), Math.min(slices, nz - z)];
      const start = (z * ny + y) * nx;
      const piece = prepare(samples.subarray(start, start + nx * height * depth));
      gl.bindTexture(gl.TEXTURE_3D, texture);
      prepareUpload(gl);
      gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, y, z, nx, height, depth, format, type, pixelsOf(piece));
      yield piece.byteLength;
    }
  }
}

/** Fill the bound 2D texture, be it new or not, with samples as they are. */
export function uploadPlane(gl: Gl, samples: Samples, { width, height }: Size): void {
  const { internal, format, type } = texelsOf(gl, samples);
  gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, pixelsOf(samples));
}

export function prepareUpload(gl: Gl): void {
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
}

export function rowsOfPiece(rowBytes: number): number {
  return Math.max(1, Math.floor(pieceBytes / rowBytes));
}

/** What a texture holds. */
export interface Texels {
  readonly internal: number;
  readonly format: number;
  readonly type: number;
  /** Of each of them. */
  readonly bytes: number;
}

/** One channel for 8 bit and float, two for 16 bit: the high byte is in green (WebGL 2) or alpha (WebGL 1). */
export function texelsOf(gl: Gl, samples: Samples): Texels {
  const isFloat = samples instanceof Float32Array;
  const type = isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE;
  const channels = samples instanceof Uint16Array ? 2 : 1;
  const bytes = samples.BYTES_PER_ELEMENT;
  if (!isWebGl2(gl)) {
    const format = channels === 2 ? gl.LUMINANCE_ALPHA : gl.LUMINANCE;
    return { internal: format, format, type, bytes };
  }
  if (channels === 2) return { internal: gl.RG8, format: gl.RG, type, bytes };
  return { internal: isFloat ? gl.R32F : gl.R8, format: gl.RED, type, bytes };
}

export function pixelsOf(samples: Samples): Uint8Array | Float32Array {
  if (!(samples instanceof Uint16Array)) return samples;
  return new Uint8Array(samples.buffer, samples.byteOffset, samples.byteLength);
}
