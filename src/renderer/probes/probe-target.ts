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

/** Read the pixels of a float target: RGBA, premultiplied, 0..1, bottom row first. Binds its framebuffer. */
export function readProbe({ gl, framebuffer, width, height }: DrawTarget): Float32Array<ArrayBuffer> {
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  const pixels = new Float32Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
  return pixels;
}
