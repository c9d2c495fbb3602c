import type { DeviceRectangle } from '../optics/cells/bound-seen-cells.ts';
import type { DrawTarget } from '../renderer/device/draw-target.ts';
import { TranslucentMixing } from '../renderer/passes/mix-translucent.ts';
import { VolumePictures } from '../renderer/pictures/volume-pictures.ts';
import type { Cast, CastLayer } from '../renderer/pictures/volume-pictures.ts';
import { createDepthTarget } from './scene-depth.ts';
import { boundShapes, isThin } from './shape-bounds.ts';
import type { X3dContext, X3dDrawable } from './x3dom-types.ts';

/** Number of pixels around a shape for which rays are cast too, because pixels between skipped rays are interpolated. */
const margin = 24;

/** How a picture's volume was drawn. */
export interface VolumeDrawing {
  readonly layer: CastLayer;
  readonly isAdaptive: boolean;
  readonly shownCast: Cast | null;
  readonly pictures: VolumePictures;
}

/** Draws translucent shapes inside a volume that is drawn already, one after the other, the farthest first. */
export class TranslucentShapes {
  readonly #mixing: TranslucentMixing;
  readonly #before: VolumePictures;
  readonly #shape: DrawTarget;
  #bounds: DeviceRectangle = [-1, -1, 1, 1];

  /** The device must have depth textures. */
  constructor(
    readonly context: X3dContext,
    layer: CastLayer,
  ) {
    const { ctx3d: gl } = context;
    this.#mixing = new TranslucentMixing(gl);
    this.#shape = createDepthTarget(gl)!;
    this.#before = new VolumePictures(gl, {
      surfacesModule: null,
      inputs: (...frame) => layer.inputs(...frame),
      raysOf: (view) => {
        const rays = layer.raysOf(view);
        return rays && { ...rays, bounds: meet(rays.bounds, this.#bounds) };
      },
    });
  }

  /** @param render - lets x3dom draw a shape */
  draw(drawable: X3dDrawable, { shownCast, isAdaptive }: VolumeDrawing, render: (drawable: X3dDrawable) => void): void {
    const { ctx3d: gl, stateManager } = this.context;
    const { picture, view } = shownCast!;
    const bounds = boundShapes([drawable], view, picture)!;
    this.#bounds = widen(bounds, [margin / picture.width, margin / picture.height]);
    this.#drawShape(drawable, picture, render);
    const ends = { all: this.#shape, solid: this.#shape, bounds, solidBounds: bounds };
    for (const pass of this.#before.passes(picture, isAdaptive && !isThin(drawable)))
      this.#before.draw(pass, { ...shownCast!, depths: ends });
    stateManager.bindFramebuffer(gl.FRAMEBUFFER, null);
    stateManager.viewport(0, 0, picture.width, picture.height);
    this.#markShape(drawable, render);
    const [depth, color] = this.#shape.units;
    this.#mixing.draw({ before: this.#before.gathered!.units[0], color, depth }, picture);
    gl.depthMask(true); // Else the next frame would not be cleared.
    stateManager.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Draws only its nearest layer: first the depth, then the pixels that have that depth. */
  #drawShape(drawable: X3dDrawable, { width, height }: Cast['picture'], render: (drawable: X3dDrawable) => void): void {
    const { ctx3d: gl, stateManager } = this.context;
    this.#shape.resize(width, height);
    stateManager.bindFramebuffer(gl.FRAMEBUFFER, this.#shape.framebuffer);
    stateManager.viewport(0, 0, width, height);
    gl.depthMask(true);
    gl.clearDepth(1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    render({ ...drawable, sortType: 'opaque' });
    gl.clear(gl.COLOR_BUFFER_BIT);
    render(drawable);
  }

  /**
   * Marks a shape in the stencil of the canvas, which has several samples a pixel: edges are smooth, and parts behind
   * opaque shapes are left out.
   */
  #markShape(drawable: X3dDrawable, render: (drawable: X3dDrawable) => void): void {
    const { ctx3d: gl } = this.context;
    const nodes = drawable.shape._cf.appearance!.node!._cf;
    const own = nodes.colorMaskMode;
    nodes.colorMaskMode = { node: { _vf: { maskR: false, maskG: false, maskB: false, maskA: false } } };
    gl.enable(gl.STENCIL_TEST);
    gl.stencilMask(1);
    gl.stencilFunc(gl.ALWAYS, 1, 1);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE);
    try {
      render(drawable);
    } finally {
      nodes.colorMaskMode = own;
      gl.disable(gl.STENCIL_TEST);
      gl.colorMask(true, true, true, true);
    }
  }

  dispose(): void {
    this.#mixing.dispose();
    this.#before.dispose();
    this.#shape.dispose();
  }
}

/** Whether x3dom would blend a shape with its background in the usual way; an author may set other ways. */
export function isTranslucent({ shape, sortType }: X3dDrawable): boolean {
  const modes = shape._cf.appearance?.node?._cf;
  return (
    sortType === 'transparent' && !modes?.blendMode?.node && !modes?.depthMode?.node && !modes?.colorMaskMode?.node
  );
}

function meet(a: DeviceRectangle, b: DeviceRectangle): DeviceRectangle {
  return [Math.max(a[0], b[0]), Math.max(a[1], b[1]), Math.min(a[2], b[2]), Math.min(a[3], b[3])];
}

/** Widens a rectangle. @param by - shares of the picture */
function widen([left, bottom, right, top]: DeviceRectangle, by: readonly [number, number]): DeviceRectangle {
  return [left - 2 * by[0], bottom - 2 * by[1], right + 2 * by[0], top + 2 * by[1]];
}
