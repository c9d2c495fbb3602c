import type { VolumeViewError } from '../core/errors.ts';
import { raysOfLattice } from '../optics/rays/rays.ts';
import type { PixelLattice } from '../optics/rays/rays.ts';
import type { Gl } from '../renderer/device/device.ts';
import { joinInputs } from '../renderer/device/inputs.ts';
import { withoutQuads } from '../renderer/passes/pass-drawing.ts';
import type { Pass, Size } from '../renderer/passes/pass-drawing.ts';
import type { ShapeDepths } from '../renderer/ray/ray-module.ts';
import { compileProgram, useProgram } from '../renderer/device/program.ts';
import { composeRay, programKey } from '../renderer/ray/compose-ray.ts';
import type { RayPlan } from '../renderer/ray/ray-plan.ts';
import { rayUniforms } from '../renderer/ray/uniforms.ts';
import type { VolumeLayer } from '../renderer/layers/volume-layer.ts';
import { castableRays, VolumePictures } from '../renderer/pictures/volume-pictures.ts';
import type { Cast, SmoothEdges } from '../renderer/pictures/volume-pictures.ts';
import type { VolumeData } from '../volume/volume.ts';
import type { SceneCamera } from './scene-camera.ts';
import type { OtherShapes } from './other-shapes.ts';
import type { VolumePicture } from './read-volume.ts';
import type { StartedCanvas } from './start-canvas.ts';
import { VolumeShape } from './volume-shape.ts';
import type { RenderShape, X3dDrawable } from './x3dom-types.ts';

/** Where a layer is drawn, and the other shapes around it. */
interface Surroundings {
  readonly started: StartedCanvas;
  readonly camera: SceneCamera;
  /** Draws the author's shapes and knows their depth; null if there are none. */
  readonly others: () => OtherShapes | null;
}

/**
 * Draws a layer: in x3dom's turn, when it comes to the layer's shape, and into targets of its own that are not shown
 * yet.
 */
export class LayerDrawing {
  readonly #gl: Gl;
  readonly pictures: VolumePictures;
  #shape: VolumeShape | null = null;
  #error: VolumeViewError | null = null;
  #drawAgain = false;
  /** The inputs of the last picture. */
  #last: { readonly program: WebGLProgram; readonly depths: ShapeDepths | null } | null = null;
  /** A program whose steps are cut differently from those of the last picture. */
  #other: { readonly key: string; readonly program: WebGLProgram } | null = null;
  /** Whether the next picture shows what was gathered. */
  showsGathered = false;

  constructor(
    readonly layer: VolumeLayer,
    readonly surroundings: Surroundings,
  ) {
    this.#gl = layer.gl;
    this.pictures = new VolumePictures(layer.gl, layer);
    layer.lights = () => surroundings.others()?.lights() ?? null;
    const context = surroundings.started.canvas.gl!;
    const renderShape = context.renderShape.bind(context);
    context.renderShape = (drawable, ...rest) => this.#renderShape(renderShape, drawable, rest);
  }

  /** Gives the layer's volume a shape in the scene. */
  shapeVolume(volume: VolumeData): void {
    if (this.#shape) this.#shape.setBounds(volume);
    else this.#shape = new VolumeShape(this.surroundings.started.document, volume);
  }

  /**
   * Lets x3dom draw; it draws twice if another program is needed than the present one, as in the first picture after
   * shapes were added or removed.
   * @throws {VolumeViewError} `webgl/shader`
   */
  drawWith(tick: () => void): void {
    this.#error = null;
    // Before x3dom compiles the present program.
    if (!this.showsGathered && this.layer.field) {
      const shapes = this.#knowShapes();
      this.#shape?.use(this.layer.program(Boolean(this.#last ? this.#last.depths : shapes?.hasAny)));
    }
    for (let times = 0; times < 2; times++) {
      this.#drawAgain = false;
      tick();
      if (!this.#drawAgain) break;
    }
    if (this.#error) throw this.#error;
  }

  /** See `VolumeScene.startProbe`. */
  startProbe(
    rays: Partial<RayPlan>,
    lattice: PixelLattice,
    picture: Size,
    alone: boolean,
  ): (() => Float32Array | null) | null {
    if (!this.#last || this.#gl.isContextLost()) return null;
    const depths = alone ? null : this.#last.depths;
    const read = this.layer.with(rays, () =>
      this.#aside(() => this.pictures.probe(lattice, this.#castAt(picture, depths))),
    );
    return read && (() => (this.#gl.isContextLost() ? null : this.#aside(read)));
  }

  get gatherable(): boolean {
    return this.#last !== null && !this.#gl.isContextLost();
  }

  /** Whether rays of the last picture end at shapes. */
  get endsAtShapes(): boolean {
    return Boolean(this.#last?.depths);
  }

  /** Whether some rays of the next picture may be skipped, if it contains shapes as the last one did. */
  get adaptive(): boolean {
    return this.layer.field !== null && this.layer.program(Boolean(this.#last?.depths)).adaptive;
  }

  /** See `VolumeScene.readVolume`. */
  readVolume(): VolumePicture | null {
    return this.#last?.depths
      ? this.surroundings.others()!.readVolume(this.shownCast!, this.pictures, (work) => this.#aside(work))
      : null;
  }

  get isAdaptive(): boolean {
    return this.layer.plan.maxCurvature > 0 && this.adaptive;
  }

  /** Smooths edges; null if there are no edges, or they are not smoothed. */
  get #smooth(): SmoothEdges | null {
    const {
      layer,
      layer: {
        plan: { edgeCurvature },
      },
    } = this;
    const module =
      Number.isFinite(edgeCurvature) && layer.volume ? layer.modules(false).find(({ edges }) => edges) : undefined;
    return module ? { edges: module.edges!(), edgeCurvature, asPoints: this.adaptive } : null;
  }

  /** The cast of the last picture; null if it could not be drawn. */
  get shownCast(): Cast | null {
    return this.#last && this.#castAt(this.#canvas);
  }

  #passes(picture: Size): Pass[] {
    const passes = this.pictures.passes(picture, this.isAdaptive, this.#smooth);
    return this.endsAtShapes
      ? [
          ...passes,
          ...this.#aside(() =>
            this.surroundings
              .others()!
              .edgePasses(this.layer, this.#castAt(picture), Number.isFinite(this.layer.plan.edgeCurvature)),
          ),
        ]
      : passes;
  }

  /** Prepares the pieces of a picture, and the depth of shapes in all its pixels. @returns its passes */
  startGathering(rays: Partial<RayPlan>, picture: Size): Pass[] {
    const { others, camera } = this.surroundings;
    return this.layer.with(rays, () => {
      if (this.endsAtShapes)
        this.#last = {
          ...this.#last!,
          depths: this.#aside(() => others()!.drawDepthsAt(picture, camera, this.#shape!, this)),
        };
      return this.#passes(picture);
    });
  }

  /** Draws some rows of a pass into a target that is not shown yet. */
  gather(
    rays: Partial<RayPlan>,
    { pass, ...rows }: { pass: Pass; firstRow: number; rows: number },
    picture: Size,
  ): void {
    this.layer.with(rays, () => this.#aside(() => this.pictures.draw(pass, this.#castAt(picture), rows)));
  }

  dispose(): void {
    if (this.#other) this.#gl.deleteProgram(this.#other.program);
    this.layer.dispose();
    this.pictures.dispose();
  }

  /** The program for the layer's rays with the present cutting of steps: x3dom's, or one made for it. */
  #program(depths: ShapeDepths | null): WebGLProgram {
    const wanted = this.layer.program(depths !== null);
    if (this.#shape!.has(wanted)) return this.#last!.program;
    const key = programKey(wanted);
    if (this.#other?.key === key) return this.#other.program;
    if (this.#other) this.#gl.deleteProgram(this.#other.program);
    this.#other = null;
    return (this.#other = { key, program: compileProgram(this.#gl, composeRay(wanted)) }).program;
  }

  #knowShapes(): OtherShapes | null {
    const shapes = this.surroundings.others();
    this.layer.surfacesModule = shapes?.depthModule ?? null;
    return shapes;
  }

  get #canvas(): HTMLCanvasElement {
    return this.surroundings.started.canvas.canvas;
  }

  #castAt(picture: Size, depths = this.#last!.depths): Cast {
    const { stepLength, maxCurvature } = this.layer.plan;
    return {
      program: this.#program(depths),
      depths,
      view: this.surroundings.camera.viewAt(picture),
      picture,
      stepLength,
      maxCurvature,
    };
  }

  /** Draws outside of x3dom's own drawing. Afterwards it binds the canvas again, with its whole size as viewport. */
  #aside<T>(work: () => T): T {
    try {
      return work();
    } finally {
      const { stateManager } = this.surroundings.started.canvas.gl!;
      stateManager.bindFramebuffer(this.#gl.FRAMEBUFFER, null);
      stateManager.viewport(0, 0, this.#canvas.width, this.#canvas.height);
    }
  }

  /** Called by x3dom to draw a shape. For the volume's shape, it sets textures and uniforms first. */
  #renderShape(original: RenderShape, drawable: X3dDrawable, rest: unknown[]): void {
    if (!this.#shape?.owns(drawable.shape)) return original(drawable, ...rest);
    if (!this.layer.field || !this.layer.optics) return;
    try {
      const shapes = this.#knowShapes();
      const depths =
        shapes?.drawDepths(this.#shape, this, {
          view: this.surroundings.camera.view(),
          draw: (shape) => original(shape, ...rest),
        }) ?? null;
      // Gathered pixels are shown as they are, whichever program cast their rays.
      if (!this.showsGathered && !this.#shape.use(this.layer.program(depths !== null))) {
        this.#drawAgain = true;
        this.#last = null;
        return;
      }
      const program = this.#shape.checkedProgram(this.#gl);
      this.#last = program && { program, depths };
      if (program && (depths || this.showsGathered || this.isAdaptive || this.#smooth)) this.#drawFromGathered();
      else this.#drawDirectly(() => original(drawable, ...rest));
    } catch (error) {
      // Thrown through x3dom it would leave the GL state incomplete: keep it for the caller of x3dom.
      this.#error = error as VolumeViewError;
    }
  }

  /** Draws without shapes that end rays. */
  #drawDirectly(draw: () => void): void {
    const picture = this.#canvas;
    const rays = castableRays(this.layer, this.surroundings.camera.view());
    const inputs = withoutQuads(this.#gl, this.layer.inputs(rays, null));
    const ray = rayUniforms(
      raysOfLattice(rays, picture, { stride: 1, first: [0, 0], width: picture.width, height: picture.height }),
      picture,
      this.layer.plan.stepLength,
    );
    const read = joinInputs(inputs, { uniforms: ray, units: [] });
    // x3dom sets only the first sampler3D.
    if (this.#last) this.#aside(() => useProgram(this.#gl, this.#last!.program, read));
    this.#shape!.bind(read);
    draw();
  }

  #drawFromGathered(): void {
    if (!this.showsGathered) {
      this.#aside(() => this.#passes(this.#canvas).forEach((pass) => this.pictures.draw(pass, this.shownCast!)));
    }
    const { depths } = this.#last!;
    this.#aside(() => (depths ? this.surroundings.others()!.showVolume(this) : this.pictures.show(this.#canvas)));
  }
}
