// Two floats in each texel: a second field needs them, and loads this file.
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import type { Texels } from './fill-texture.ts';

/** Texels of two floats. The second float is in green (WebGL 2) or alpha (WebGL 1). */
export function pairTexels(gl: Gl): Texels {
  const shared = { type: gl.FLOAT, bytes: 8 };
  return isWebGl2(gl)
    ? { internal: gl.RG32F, format: gl.RG, ...shared }
    : { internal: gl.LUMINANCE_ALPHA, format: gl.LUMINANCE_ALPHA, ...shared };
}

/** Interleave two lists of the same length: one number of each in turn. */
export function pairUp(first: Float32Array, second: Float32Array): Float32Array<ArrayBuffer> {
  const pairs = new Float32Array(2 * first.length);
  for (let i = 0; i < first.length; i++) {
    pairs[2 * i] = first[i];
    pairs[2 * i + 1] = second[i];
  }
  return pairs;
}
