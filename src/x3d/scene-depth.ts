import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';
import { bytesAttachment, DrawTarget } from './draw-target.ts';

/**
 * A target for the depth of the scene's opaque shapes, so that rays can end at them. The page's own depth buffer can't
 * be read in WebGL, hence a second drawing of the shapes (only where there are any) into this target. 24 or more bits;
 * x3dom's own depth textures have 16.
 * @returns null where the device has no depth textures (a few WebGL 1 ones): the volume then is drawn over the shapes
 */
export function createSceneDepth(gl: Gl): DrawTarget | null {
  if (!isWebGl2(gl) && !gl.getExtension('WEBGL_depth_texture')) return null;
  const internal = isWebGl2(gl) ? gl.DEPTH_COMPONENT24 : gl.DEPTH_COMPONENT;
  const depth = { point: gl.DEPTH_ATTACHMENT, internal, format: gl.DEPTH_COMPONENT, type: gl.UNSIGNED_INT, samplerName: 'uSceneDepth' };
  return new DrawTarget(gl, [depth, bytesAttachment(gl, 'uSceneColor')]);
}
