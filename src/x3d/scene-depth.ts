import type { DeviceRectangle } from '../optics/cells/bound-seen-cells.ts';
import { isWebGl2 } from '../renderer/device/device.ts';
import type { Gl } from '../renderer/device/device.ts';
import { bytesAttachment, DrawTarget } from '../renderer/device/draw-target.ts';
import type { Size } from '../renderer/passes/pass-drawing.ts';
import type { ShapeDepths } from '../renderer/ray/ray-module.ts';
import type { View } from '../renderer/layers/volume-layer.ts';
import { boundShapes, isThin } from './shape-bounds.ts';
import type { X3dContext, X3dDrawable } from './x3dom-types.ts';

/**
 * A target for the depth of the scene's opaque shapes, so that rays can end at them. WebGL can't read the page's own
 * depth buffer, so the shapes (if there are any) are drawn a second time into this target. It has 24 bits or more;
 * x3dom's own depth textures have 16.
 * @returns null if the device has no depth textures (a few WebGL 1 devices): then the volume is drawn over the shapes
 */
export function createDepthTarget(gl: Gl): DrawTarget | null {
  if (!isWebGl2(gl) && !gl.getExtension('WEBGL_depth_texture')) return null;
  const internal = isWebGl2(gl) ? gl.DEPTH_COMPONENT24 : gl.DEPTH_COMPONENT;
  const depth = {
    point: gl.DEPTH_ATTACHMENT,
    internal,
    format: gl.DEPTH_COMPONENT,
    type: gl.UNSIGNED_INT,
    samplerName: 'uSceneDepth',
  };
  return new DrawTarget(gl, [depth, bytesAttachment(gl, 'uSceneColor')]);
}

/** An empty rectangle. */
const nowhere: DeviceRectangle = [1, 1, -1, -1];

/** The shapes of a picture. */
export interface DrawnShapes {
  readonly shapes: readonly X3dDrawable[];
  readonly view: View;
  /** Lets x3dom draw a shape. */
  readonly draw: (shape: X3dDrawable) => void;
  /** Whether a picture without opaque shapes gets a depth too. */
  readonly isNeeded: boolean;
}

/** The depth of the scene's opaque shapes, drawn for each picture that contains some. */
export class SceneDepth {
  #all: DrawTarget | null | undefined;
  #solid: DrawTarget | null = null;

  constructor(readonly context: X3dContext) {}

  /**
   * @param picture - pixels of the canvas, which is bound again afterwards
   * @returns null if there are no shapes, or the device can't do it
   */
  draw(picture: Size, { shapes, view, draw, isNeeded }: DrawnShapes): ShapeDepths | null {
    if (shapes.length === 0 && !isNeeded) return null;
    const { ctx3d: gl, stateManager } = this.context;
    if (this.#all === undefined) this.#all = createDepthTarget(gl);
    const all = this.#all;
    if (!all) return null;
    const solids = shapes.filter((shape) => !isThin(shape));
    this.#fill(all, shapes.length === 0 ? { width: 1, height: 1 } : picture, () => shapes.forEach(draw));
    let solid = all;
    if (solids.length < shapes.length) {
      solid = this.#solid ??= createDepthTarget(gl)!;
      this.#fill(solid, solids.length === 0 ? { width: 1, height: 1 } : picture, () => solids.forEach(draw));
    }
    stateManager.bindFramebuffer(gl.FRAMEBUFFER, null);
    stateManager.viewport(0, 0, picture.width, picture.height);
    return {
      all,
      solid,
      bounds: boundShapes(shapes, view, picture) ?? nowhere,
      solidBounds: boundShapes(solids, view, picture),
    };
  }

  #fill(target: DrawTarget, { width, height }: Size, draw: () => void): void {
    const { ctx3d: gl, stateManager } = this.context;
    target.resize(width, height);
    stateManager.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    stateManager.viewport(0, 0, width, height);
    gl.depthMask(true);
    gl.clearDepth(1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    draw();
  }

  dispose(): void {
    this.#all?.dispose();
    this.#solid?.dispose();
  }
}
