import type { VolumeViewError } from '../errors.ts';
import { raysOfLattice } from '../optics/rays.ts';
import type { PixelLattice } from '../optics/rays.ts';
import type { Gl } from '../renderer/device.ts';
import type { DrawTarget } from '../renderer/draw-target.ts';
import { GpuTimer } from '../renderer/gpu-timer.ts';
import { joinInputs } from '../renderer/inputs.ts';
import { withoutQuads } from '../renderer/pass-drawing.ts';
import type { Pass, Size } from '../renderer/pass-drawing.ts';
import { rayUniforms } from '../renderer/uniforms.ts';
import type { VolumeLayer } from '../renderer/volume-layer.ts';
import { castableRays, VolumePictures } from '../renderer/volume-pictures.ts';
import type { Cast } from '../renderer/volume-pictures.ts';
import type { OtherShapesLoader } from './other-shapes-loader.ts';
import type { SceneCamera } from './scene-camera.ts';
import type { StartedCanvas } from './start-canvas.ts';
import type { VolumeShape } from './volume-shape.ts';
import type { X3dContext, X3dDrawable } from './x3dom-types.ts';

/** What a scene is drawn of. */
export interface SceneParts {
  readonly started: StartedCanvas;
  readonly layer: VolumeLayer;
  readonly camera: SceneCamera;
  readonly others: OtherShapesLoader;
}

/** Draws the pictures of a scene: x3dom the author's shapes, and in its turn the volume, with textures and uniforms of ours. */
export class SceneDrawing {
  /** Stands for the volume among x3dom's shapes; null until there is one. */
  shape: VolumeShape | null = null;
  /** How much the picture may bend where pixels are interpolated instead of getting rays, 1/255; 0 for none. */
  maxCurvature = 0;
  readonly #started: StartedCanvas;
  readonly #gl: Gl;
  readonly #layer: VolumeLayer;
  readonly #camera: SceneCamera;
  readonly #others: OtherShapesLoader;
  readonly #pictures: VolumePictures;
  readonly #timer: GpuTimer | null;
  #stepLength = 1;
  #error: VolumeViewError | null = null;
  #drawAgain = false;
  #drawing = false;
  /** Whether the next picture is the one that was gathered. */
  #showsGathered = false;
  /** What the last picture was drawn with. */
  #last: { readonly program: WebGLProgram; readonly depth: DrawTarget | null } | null = null;

  constructor({ started, layer, camera, others }: SceneParts) {
    const context = started.canvas.gl!;
    this.#started = started;
    this.#gl = context.ctx3d;
    this.#layer = layer;
    this.#camera = camera;
    this.#others = others;
    this.#pictures = new VolumePictures(this.#gl, layer);
    this.#timer = GpuTimer.create(this.#gl);
    const renderShape = context.renderShape.bind(context);
    context.renderShape = (drawable, ...rest) => this.#renderShape(renderShape, drawable, rest);
  }

  /** Whether a picture is being drawn: what x3dom says meanwhile is no change. */
  get isDrawing(): boolean {
    return this.#drawing;
  }

  /**
   * Draw one picture.
   * @param stepLength - world length
   * @throws {VolumeViewError} `webgl/shader`
   */
  draw(stepLength: number, time = performance.now()): void {
    this.#stepLength = stepLength;
    this.#timer?.begin();
    try {
      this.#drawScene(time);
    } finally {
      this.#timer?.end();
    }
  }

  #drawScene(time: number): void {
    this.#error = null;
    this.#drawing = true;
    try {
      this.#tick(time);
      // The first picture after shapes came or went finds another program in place than it needs.
      if (this.#drawAgain) this.#tick(time);
    } finally {
      this.#drawing = false;
    }
    if (this.#error) throw this.#error;
  }

  #tick(time: number): void {
    const { canvas, document } = this.#started;
    this.#drawAgain = false;
    this.#camera.forgetProjection();
    document.needRender = true;
    canvas.tick(time);
  }

  /**
   * The volume of the last picture at a sparse set of its rays, with other step lengths, in floats.
   * @param stepLengths - world lengths
   * @param lattice - which rays
   * @param picture - pixels of the whole picture
   * @returns for each step length RGBA, premultiplied, 0..1, bottom row first; null where the device can't do it
   */
  probe(stepLengths: readonly number[], lattice: PixelLattice, picture: Size): Float32Array[] | null {
    if (!this.#last || this.#gl.isContextLost()) return null;
    const cast = { ...this.#last, view: this.#camera.viewAt(picture), picture };
    return this.#aside(() => this.#pictures.probe(stepLengths, lattice, cast));
  }

  /**
   * Whether the next picture can be drawn piece by piece: not where the author's shapes end rays, which are drawn with the
   * picture, and only after one that was drawn at once.
   */
  get gatherable(): boolean {
    return this.#last !== null && this.#last.depth === null && !this.#gl.isContextLost();
  }

  /** What a picture of a size is gathered from, one lattice of pixels after the other. */
  passes(picture: Size): Pass[] {
    return this.#pictures.passes(picture, this.#isAdaptive);
  }

  /**
   * Draw some rows of the volume where nobody sees them yet, at the view of the last picture.
   * @param stepLength - world length
   * @param part - a pass of those of the picture, and its rows from the bottom
   * @param picture - pixels of the whole picture
   */
  gather(stepLength: number, { pass, ...rows }: { pass: Pass; firstRow: number; rows: number }, picture: Size): void {
    this.#aside(() => this.#pictures.draw(pass, this.#castAt(picture, stepLength), rows));
  }

  #castAt(picture: Size, stepLength: number): Cast {
    return { ...this.#last!, view: this.#camera.viewAt(picture), picture, stepLength, maxCurvature: this.maxCurvature };
  }

  /** Draw what x3dom does not know of; afterwards it draws into the canvas again, and takes nothing for set any more. */
  #aside<T>(work: () => T): T {
    try {
      return work();
    } finally {
      const { stateManager } = this.#started.canvas.gl!;
      stateManager.bindFramebuffer(this.#gl.FRAMEBUFFER, null);
      stateManager.viewport(0, 0, this.#canvas.width, this.#canvas.height);
    }
  }

  /** Draw one picture, of which the volume has been gathered. */
  drawGathered(time = performance.now()): void {
    this.#showsGathered = true;
    try {
      this.#drawScene(time);
    } finally {
      this.#showsGathered = false;
    }
  }

  /** Whether rays of the next picture may be spared: not among other shapes, at whose edges the picture jumps. */
  get adaptive(): boolean {
    return this.#layer.field !== null && this.#drawables().every(({ shape }) => this.shape?.owns(shape)) && this.#layer.program(false).adaptive;
  }

  get #canvas(): HTMLCanvasElement {
    return this.#started.canvas.canvas;
  }

  get #isAdaptive(): boolean {
    return this.maxCurvature > 0 && this.adaptive;
  }

  /** What the last `draw` took of the GPU's time, ms, once that has finished; null where there are no timer queries. */
  async gpuMs(): Promise<number | null> {
    return (await this.#timer?.read()) ?? null;
  }

  dispose(): void {
    this.#pictures.dispose();
    this.#timer?.dispose();
  }

  /** x3dom draws a shape; for the volume's, textures and uniforms are put in place first. */
  #renderShape(original: X3dContext['renderShape'], drawable: X3dDrawable, rest: unknown[]): void {
    if (!this.shape?.owns(drawable.shape)) return original(drawable, ...rest);
    if (!this.#layer.field || !this.#layer.optics) return;
    try {
      const others = this.#showsGathered ? [] : this.#drawables().filter((d) => !this.shape?.owns(d.shape) && d.sortType !== 'transparent');
      const { shapes } = this.#others;
      const depth = shapes?.depth.draw(this.#canvas, others, (d) => original(d, ...rest)) ?? null;
      this.#layer.surfacesModule = shapes?.depthModule ?? null;
      if (!this.shape.use(this.#layer.program(depth !== null))) {
        this.#drawAgain = true;
        return;
      }
      const program = this.shape.checkedProgram(this.#gl);
      this.#last = program && { program, depth };
      if (program && (this.#showsGathered || this.#isAdaptive)) this.#drawFromGathered();
      else this.#drawDirectly(depth, () => original(drawable, ...rest));
    } catch (error) {
      // Thrown through x3dom it would leave the GL state half way: hand it to the caller of draw().
      this.#error = error as VolumeViewError;
    }
  }

  #drawDirectly(depth: DrawTarget | null, draw: () => void): void {
    const picture = this.#canvas;
    const lattice = { stride: 1, first: 0, width: picture.width, height: picture.height };
    const view = this.#camera.view();
    const rays = castableRays(this.#layer, view);
    const inputs = withoutQuads(this.#gl, this.#layer.inputs(rays, depth && { depth, projection: view.projection, picture, lattice }));
    const ray = rayUniforms(raysOfLattice(rays, picture, lattice), picture, this.#stepLength);
    this.shape!.bind(joinInputs(inputs, { uniforms: ray, units: [] }));
    draw();
  }

  #drawFromGathered(): void {
    if (!this.#showsGathered) {
      const cast = this.#castAt(this.#canvas, this.#stepLength);
      this.#aside(() => this.passes(this.#canvas).forEach((pass) => this.#pictures.draw(pass, cast)));
    }
    this.#aside(() => this.#pictures.show(this.#canvas));
  }

  #drawables(): X3dDrawable[] {
    const collection = this.#started.document._scene.drawableCollection;
    return Array.from({ length: collection?.length ?? 0 }, (_, i) => collection!.get(i));
  }
}
