import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import { DrawTarget } from '../device/draw-target.ts';

/**
 * A small float picture that can be read back: it shows errors far below 1/255.
 * @returns null where the device can't draw into float textures and blend there
 */
export function createProbeTarget(gl: Gl): DrawTarget | null {
  const drawable = gl.getExtension(isWebGl2(gl) ? 'EXT_color_buffer_float' : 'WEBGL_color_buffer_float') !== null;
  const blendable = gl.getExtension('EXT_float_blend') !== null;
  if (!drawable || (!blendable && !isWebGl2(gl))) return null;
  const internal = isWebGl2(gl) ? (blendable ? gl.RGBA32F : gl.RGBA16F) : gl.RGBA;
  return new DrawTarget(gl, [
    { point: gl.COLOR_ATTACHMENT0, internal, format: gl.RGBA, type: gl.FLOAT, samplerName: 'uProbe' },
  ]);
}
