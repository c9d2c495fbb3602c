import { isWebGl2 } from '../renderer/device.ts';
import type { Gl } from '../renderer/device.ts';
import { bytesAttachment, DrawTarget } from '../renderer/draw-target.ts';
import type { Size } from '../renderer/pass-drawing.ts';
import type { X3dContext, X3dDrawable } from './x3dom-types.ts';

/**
 * A target for the depth of the scene's opaque shapes, so that rays can end at them. The page's own depth buffer can't
 * be read in WebGL, hence a second drawing of the shapes (only where there are any) into this target. 24 or more bits;
 * x3dom's own depth textures have 16.
 * @returns null where the device has no depth textures (a few WebGL 1 ones): the volume then is drawn over the shapes
 */
function createSceneDepth(gl: Gl): DrawTarget | null {
  if (!isWebGl2(gl) && !gl.getExtension('WEBGL_depth_texture')) return null;
  const internal = isWebGl2(gl) ? gl.DEPTH_COMPONENT24 : gl.DEPTH_COMPONENT;
  const depth = { point: gl.DEPTH_ATTACHMENT, internal, format: gl.DEPTH_COMPONENT, type: gl.UNSIGNED_INT, samplerName: 'uSceneDepth' };
  return new DrawTarget(gl, [depth, bytesAttachment(gl, 'uSceneColor')]);
}

/** The depth of the scene's opaque shapes, drawn for each picture in which there are some. */
export class SceneDepth {
  #target: DrawTarget | null | undefined;

  constructor(readonly context: X3dContext) {}

  /**
   * @param picture - pixels of the canvas, which is bound again afterwards
   * @param draw - has x3dom draw a shape
   * @returns null where there is none, or the device can't
   */
  draw({ width, height }: Size, shapes: readonly X3dDrawable[], draw: (shape: X3dDrawable) => void): DrawTarget | null {
    if (shapes.length === 0) return null;
    const { ctx3d: gl, stateManager } = this.context;
    if (this.#target === undefined) this.#target = createSceneDepth(gl);
    if (!this.#target) return null;
    this.#target.resize(width, height);
    stateManager.bindFramebuffer(gl.FRAMEBUFFER, this.#target.framebuffer);
    stateManager.viewport(0, 0, width, height);
    gl.depthMask(true);
    gl.clearDepth(1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const shape of shapes) draw(shape);
    stateManager.bindFramebuffer(gl.FRAMEBUFFER, null);
    stateManager.viewport(0, 0, width, height);
    return this.#target;
  }

  dispose(): void {
    this.#target?.dispose();
  }
}
