import type { VolumeViewError } from '../errors.ts';
import type { Pixels } from '../optics/between-pixels.ts';
import type { Camera } from '../optics/camera.ts';
import { raysOfLattice } from '../optics/rays.ts';
import type { PixelLattice, RaySetup } from '../optics/rays.ts';
import type { Slice } from '../radar/slices.ts';
import type { GridFrame } from '../volume/grid.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import type { AuthorCamera } from './author-camera.ts';
import type { Device, Gl } from '../renderer/device.ts';
import { describe } from '../renderer/probe-device.ts';
import type { DrawTarget } from '../renderer/draw-target.ts';
import { gpuFinished } from '../renderer/gpu-finished.ts';
import { GpuTimer } from '../renderer/gpu-timer.ts';
import { loadX3dom } from './load-x3dom.ts';
import { withoutQuads } from '../renderer/pass-drawing.ts';
import type { Pass, Size } from '../renderer/pass-drawing.ts';
import { OtherShapesLoader } from './other-shapes-loader.ts';
import type { Lines } from './scene-lines.ts';
import { SceneCamera } from './scene-camera.ts';
import { startCanvas } from './start-canvas.ts';
import type { StartedCanvas } from './start-canvas.ts';
import { joinInputs } from '../renderer/inputs.ts';
import type { Optics, RayModule } from '../renderer/ray/ray-module.ts';
import { rayUniforms } from '../renderer/uniforms.ts';
import { VolumeLayer } from '../renderer/volume-layer.ts';
import type { FieldProviders, View } from '../renderer/volume-layer.ts';
import { castableRays, VolumePictures } from '../renderer/volume-pictures.ts';
import type { Cast } from '../renderer/volume-pictures.ts';
import { buildScene, VolumeShape } from './volume-shape.ts';
import type { X3dContext, X3dDrawable, X3dNode, X3dom } from './x3dom-types.ts';

export type { Optics } from '../renderer/ray/ray-module.ts';
export type { View } from '../renderer/volume-layer.ts';

/** A volume and the author's nodes in a running x3dom scene. It draws when told to, and never by itself. */
export class VolumeScene {
  readonly device: Device;
  readonly #started: StartedCanvas;
  readonly #gl: Gl;
  readonly #layer: VolumeLayer;
  readonly #pictures: VolumePictures;
  #shape: VolumeShape | null = null;
  readonly #camera: SceneCamera;
  readonly #others: OtherShapesLoader;
  readonly #timer: GpuTimer | null;
  #stepLength = 1;
  #maxCurvature = 0;
  #error: VolumeViewError | null = null;
  #drawAgain = false;
  #drawing = false;
  /** Whether the next picture is the one that was gathered. */
  #showsGathered = false;
  /** What the last picture was drawn with. */
  #last: { readonly program: WebGLProgram; readonly depth: DrawTarget | null } | null = null;

  /**
   * @param host - the element whose X3D children join the scene
   * @param container - where the canvas goes
   * @param needsFrame - called when something in the scene changed and `draw` should be called soon
   * @param fieldProviders - how volumes are drawn that are not on cartesian grids; none where absent
   */
  static async create(host: Element, container: Element, needsFrame: () => void, fieldProviders: FieldProviders = {}): Promise<VolumeScene> {
    const x3dom = await loadX3dom();
    const scene = new VolumeScene(x3dom, { host, container, needsFrame, fieldProviders });
    await scene.othersReady();
    return scene;
  }

  private constructor(
    x3dom: X3dom,
    { host, container, needsFrame, fieldProviders }: { host: Element; container: Element; needsFrame: () => void; fieldProviders: FieldProviders },
  ) {
    this.#started = startCanvas(x3dom, container, {
      buildScene,
      needsFrame: () => {
        if (!this.#drawing) needsFrame();
      },
    });
    const context = this.#started.canvas.gl!;
    this.#gl = context.ctx3d;
    this.device = describe(this.#gl);
    this.#layer = new VolumeLayer(this.#gl, this.device, fieldProviders);
    this.#pictures = new VolumePictures(this.#gl, this.#layer);
    this.#timer = GpuTimer.create(this.#gl);
    this.#camera = new SceneCamera(x3dom, this.#started, () => this.#others.shapes?.author.viewpoint ?? null);
    this.#others = new OtherShapesLoader(x3dom, this.#started, host);
    const renderShape = context.renderShape.bind(context);
    context.renderShape = (drawable, ...rest) => this.#renderShape(renderShape, drawable, rest);
  }

  get canvas(): HTMLCanvasElement {
    return this.#started.canvas.canvas;
  }

  /** Whether x3dom animates something by itself (a running TimeSensor, say), so that frames have to go on. */
  get animating(): boolean {
    const { document } = this.#started;
    const running = ({ _vf }: X3dNode) => Boolean(_vf.enabled) && Boolean(_vf.isActive || _vf.loop);
    return document.isAnimating() || document._nodeBag.timer.some(running);
  }

  /**
   * Load what only some volumes need, before `setVolume`.
   * @throws {VolumeViewError} `format/unsupported` where that part of the package is not there
   */
  async prepare(volume: Volume): Promise<void> {
    await this.#layer.prepare(volume);
    if (isPolar(volume)) await this.#others.load(); // There may be rings around it.
  }

  /** Resolves when the author's children that came meanwhile are in the scene: what grafts them is loaded with the first. */
  othersReady(): Promise<void> {
    return this.#others.ready();
  }

  /** Put a volume on the GPU in place of the one before, at once. */
  setVolume(volume: Volume): void {
    this.#layer.set(volume);
    this.#shapeVolume(volume);
  }

  /**
   * Put a volume on the GPU in place of the one before: a large one bit by bit between frames, which show the one before
   * until all of it is there.
   * @param givenUp - whether it is still wanted
   * @returns whether it is in place; not where it was given up or the context was lost
   */
  async bringVolume(volume: Volume, givenUp: () => boolean): Promise<boolean> {
    const isThere = await this.#layer.bring(volume, givenUp);
    if (isThere) this.#shapeVolume(volume);
    return isThere;
  }

  #shapeVolume(volume: Volume): void {
    if (this.#shape) this.#shape.setBounds(volume);
    else this.#shape = new VolumeShape(this.#started.document, volume, this.#layer.program(false));
  }

  setOptics(optics: Optics): void {
    this.#layer.optics = optics;
  }

  /** Modules of the rays besides the usual ones, or in place of them: see renderer/ray/ray-module.ts */
  setModules(modules: readonly RayModule[]): void {
    this.#layer.setModules(modules);
  }

  /** Show one part of the volume alone, see volume/region.ts; null for all of it. */
  setRegion(region: GridFrame | null): void {
    this.#layer.region = region;
  }

  /** Slices of the present volume, at most `maxSlices`; a volume that is not a radar's has none. */
  setSlices(slices: readonly Slice[]): void {
    this.#layer.slices = slices;
  }

  /** Thin lines around the volume, in world coordinates. */
  setLines(lines: Lines): void {
    this.#others.shapes?.lines.show(lines);
  }

  /** Whether rays cross empty space without looking, which changes nothing but the time. On unless a test compares. */
  setSkipping(on: boolean): void {
    this.#layer.skipping = on;
  }

  /**
   * How much the picture may bend where pixels are interpolated instead of getting rays of their own, 1/255, see
   * quality/adaptive-sampling.ts; 0 for none. Where other shapes stand in the scene all pixels get rays.
   */
  setMaxCurvature(maxCurvature: number): void {
    this.#maxCurvature = maxCurvature;
  }

  /** The most parts that a step is cut into, up to what the shader knows. All of them unless a test compares. */
  setMaxSubsteps(most: number): void {
    this.#layer.maxSubsteps = most;
  }

  /** The author's viewpoint as a camera, or null where there is none. */
  authorCamera(): AuthorCamera | null {
    return this.#others.shapes?.camera ?? null;
  }

  /** Undo what `setCamera` did to the author's viewpoint. */
  resetAuthorCamera(): void {
    this.#others.shapes?.author.viewpoint?.resetView();
  }

  /** Look at the scene through a camera. */
  setCamera(camera: Camera): void {
    this.#camera.set(camera);
  }

  /** Size of the picture in device pixels. */
  resize(width: number, height: number): void {
    this.#camera.resize(width, height);
  }

  /** The view that the next picture will have. */
  getView(): View {
    return this.#camera.view();
  }

  /** The rays of the next picture, or null without a volume. */
  getRays(): RaySetup | null {
    return this.#layer.raysOf(this.getView());
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
    return { ...this.#last!, view: this.#camera.viewAt(picture), picture, stepLength, maxCurvature: this.#maxCurvature };
  }

  /** Draw what x3dom does not know of; afterwards it draws into the canvas again, and takes nothing for set any more. */
  #aside<T>(work: () => T): T {
    try {
      return work();
    } finally {
      const { stateManager } = this.#started.canvas.gl!;
      stateManager.bindFramebuffer(this.#gl.FRAMEBUFFER, null);
      stateManager.viewport(0, 0, this.canvas.width, this.canvas.height);
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

  /** Whether rays of the next picture may be thinned: not among other shapes, at whose edges the picture jumps. */
  get adaptive(): boolean {
    return this.#layer.field !== null && this.#drawables().every(({ shape }) => this.#shape?.owns(shape)) && this.#layer.program(false).adaptive;
  }

  get #isAdaptive(): boolean {
    return this.#maxCurvature > 0 && this.adaptive;
  }

  /** Resolves when the GPU has drawn everything that it was told to. */
  finished(): Promise<void> {
    return gpuFinished(this.#gl);
  }

  /** What the last `draw` took of the GPU's time, ms, once that has finished; null where there are no timer queries. */
  async gpuMs(): Promise<number | null> {
    return (await this.#timer?.read()) ?? null;
  }

  /** Pixels of the last picture: width * height * 4 bytes, premultiplied, top row first. */
  readPixels(): Uint8ClampedArray<ArrayBuffer> {
    const { data, width, height } = this.readPicture();
    const pixels = new Uint8ClampedArray(data.length);
    for (let row = 0; row < height; row++) {
      const from = (height - 1 - row) * width * 4;
      pixels.set(data.subarray(from, from + width * 4), row * width * 4);
    }
    return pixels;
  }

  /** The last picture as it lies in the canvas: premultiplied, bottom row first. */
  readPicture(): Pixels & { readonly data: Uint8Array } {
    const { width, height } = this.canvas;
    const data = new Uint8Array(width * height * 4);
    this.#gl.readPixels(0, 0, width, height, this.#gl.RGBA, this.#gl.UNSIGNED_BYTE, data);
    return { data, width, height };
  }

  /** Take the scene down: the author's elements, the GPU's memory and the context are given back. */
  dispose(): void {
    this.#others.dispose();
    const { element, canvas, document } = this.#started;
    document.mutationObserver.disconnect();
    this.#layer.dispose();
    this.#pictures.dispose();
    this.#timer?.dispose();
    if (!this.#gl.isContextLost()) document.shutdown(canvas.gl!);
    document.removeX3DOMBackendGraph(element); // x3dom keeps all shapes in a list of the page's.
    this.#gl.getExtension('WEBGL_lose_context')?.loseContext();
    element.remove();
    canvas.canvas.width = canvas.canvas.height = 0;
  }

  /** x3dom draws a shape; for the volume's, textures and uniforms are put in place first. */
  #renderShape(original: X3dContext['renderShape'], drawable: X3dDrawable, rest: unknown[]): void {
    if (!this.#shape?.owns(drawable.shape)) return original(drawable, ...rest);
    if (!this.#layer.field || !this.#layer.optics) return;
    try {
      const others = this.#showsGathered ? [] : this.#drawables().filter((d) => !this.#shape?.owns(d.shape) && d.sortType !== 'transparent');
      const { shapes } = this.#others;
      const depth = shapes?.depth.draw(this.canvas, others, (d) => original(d, ...rest)) ?? null;
      this.#layer.surfacesModule = shapes?.depthModule ?? null;
      if (!this.#shape.use(this.#layer.program(depth !== null))) {
        this.#drawAgain = true;
        return;
      }
      const program = this.#shape.checkedProgram(this.#gl);
      this.#last = program && { program, depth };
      if (program && (this.#showsGathered || this.#isAdaptive)) this.#drawFromGathered();
      else this.#drawDirectly(depth, () => original(drawable, ...rest));
    } catch (error) {
      // Thrown through x3dom it would leave the GL state half way: hand it to the caller of draw().
      this.#error = error as VolumeViewError;
    }
  }

  #drawDirectly(depth: DrawTarget | null, draw: () => void): void {
    const picture = this.canvas;
    const lattice = { stride: 1, first: 0, width: picture.width, height: picture.height };
    const view = this.getView();
    const rays = castableRays(this.#layer, view);
    const inputs = withoutQuads(this.#gl, this.#layer.inputs(rays, depth && { depth, projection: view.projection, picture, lattice }));
    const ray = rayUniforms(raysOfLattice(rays, picture, lattice), picture, this.#stepLength);
    this.#shape!.bind(joinInputs(inputs, { uniforms: ray, units: [] }));
    draw();
  }

  #drawFromGathered(): void {
    if (!this.#showsGathered) {
      const cast = this.#castAt(this.canvas, this.#stepLength);
      this.#aside(() => this.passes(this.canvas).forEach((pass) => this.#pictures.draw(pass, cast)));
    }
    this.#aside(() => this.#pictures.show(this.canvas));
  }

  #drawables(): X3dDrawable[] {
    const collection = this.#started.document._scene.drawableCollection;
    return Array.from({ length: collection?.length ?? 0 }, (_, i) => collection!.get(i));
  }
}
