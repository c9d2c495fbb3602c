import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples } from '../../volume/volume.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';

/**
 * Work that uploads data to the GPU piece by piece. Each step yields how many bytes it uploaded, or Infinity if the GPU has to finish
 * before the next step. To stop early, call `return()`: it deletes what was made so far.
 */
export type Upload<T> = Generator<number, T, void>;

/** The maximum bytes of one piece. A row of texels is never cut; it has at most 64 KiB. */
export const pieceBytes = 2 ** 20;

/** To allocate more bytes than this takes the GPU as long as to fill them: a check for errors directly afterwards would block the page. */
export const slowBytes = 2 ** 25;

/** The bytes that a page can upload to the GPU at once without a late frame. */
export const quickBytes = 2 ** 23;

/** Do all steps of an upload at once. */
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

/** Allocate the memory for a volume in the bound 3D texture: the number of samples times the bytes of each, and no more (no mipmaps). */
export function allocateTexture3d(gl: WebGL2RenderingContext, { internal }: Texels, [nx, ny, nz]: Vector3): void {
  gl.texStorage3D(gl.TEXTURE_3D, 1, internal, nx, ny, nz);
}

/**
 * Fill a 3D texture that `allocateTexture3d` allocated.
 * @param prepare - converts samples before their upload
 */
export function* fillTexture3d(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  {
    samples,
    dimensions: [nx, ny, nz],
    texels: { format, type, bytes },
  }: { samples: Samples; dimensions: Vector3; texels: Texels },
  prepare: (samples: Samples) => Samples,
): Upload<void> {
  const rowsAtOnce = rowsOfPiece(nx * bytes);
  // A piece has whole slices if at least one fits; else a band of a slice.
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

/** Fill the bound 2D texture, new or not, with samples as they are. */
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

/** The format of a texture's texels. */
export interface Texels {
  readonly internal: number;
  readonly format: number;
  readonly type: number;
  /** Bytes of each texel. */
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
