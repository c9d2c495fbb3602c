import type { Slice } from '../slices.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Sweep } from '../../volume/polar-grid.ts';
import { isWebGl2 } from '../../renderer/device/device.ts';
import type { Gl } from '../../renderer/device/device.ts';
import { prepareUpload } from '../../renderer/textures/fill-texture.ts';
import type { Uniforms } from '../../renderer/device/inputs.ts';
import { textureUnit } from '../../renderer/device/texture-unit.ts';
import type { TextureUnit } from '../../renderer/device/texture-unit.ts';

/** A transfer function's own stops on the GPU. Slices show single values; a table of means would blur these at jumps. */
export interface StopsTexture {
  readonly unit: TextureUnit;
  readonly uniforms: Uniforms;
}

/**
 * @param transferFunction - already brightened
 * @param domain - the data values at 0 and 1 of the transfer function's domain
 */
export function uploadStops(
  gl: Gl,
  transferFunction: TransferFunction,
  [low, high]: readonly [number, number],
  previous: WebGLTexture | null,
): StopsTexture {
  const count = transferFunction.length;
  const texels = new Float32Array(2 * 4 * count);
  transferFunction.forEach(({ value, color, opacity }, i) => {
    texels[4 * i] = (value - low) / (high - low);
    texels.set([...color.map((channel) => channel * opacity), opacity], 4 * (count + i));
  });
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  gl.texImage2D(gl.TEXTURE_2D, 0, isWebGl2(gl) ? gl.RGBA32F : gl.RGBA, count, 2, 0, gl.RGBA, gl.FLOAT, texels);
  return {
    unit: textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uStops' }),
    uniforms: { uStopTexels: [count, 1 / count] },
  };
}

/** Longer than any line on the ground, metres. */
const endless = 1e9;

/**
 * @param slices - at most as many as the shader has room for; four numbers for each, and zeros for absent ones
 * @param sweeps - of the volume that the slices cut
 */
export function sliceUniforms(slices: readonly Slice[], sweeps: readonly Sweep[]): Uniforms {
  const fill = (numbers: readonly number[]): number[] => Array.from({ length: 16 }, (_, i) => numbers[i] ?? 0);
  return {
    uSlices: fill(slices.flatMap((slice) => shapeOf(slice, sweeps))),
    uSliceLines: fill(
      slices.flatMap((slice) => (slice.kind === 'upright' ? [...slice.from, ...slice.direction] : [0, 0, 0, 0])),
    ),
  };
}

function shapeOf(slice: Slice, sweeps: readonly Sweep[]): number[] {
  if (slice.kind === 'level') return [2, slice.height, 0, 0];
  if (slice.kind === 'upright') return [3, Math.min(slice.length, endless), 0, 0];
  const angle = (sweeps[slice.sweep].elevation * Math.PI) / 180;
  return [1, slice.sweep, Math.cos(angle), Math.sin(angle)];
}
