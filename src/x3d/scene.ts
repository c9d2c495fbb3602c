import type { Pixels } from '../optics/rays/between-pixels.ts';
import type { SceneLights } from '../optics/transfer/lights.ts';
import type { Camera } from '../optics/rays/camera.ts';
import type { PixelLattice, RaySetup } from '../optics/rays/rays.ts';
import { isPolar } from '../volume/volume.ts';
import type { VolumeData } from '../volume/volume.ts';
import type { Device, Gl } from '../renderer/device/device.ts';
import { describe } from '../renderer/probes/probe-device.ts';
import { gpuFinished } from '../renderer/device/gpu-finished.ts';
import { loadX3dom } from './load-x3dom.ts';
import type { Pass, Size } from '../renderer/passes/pass-drawing.ts';
import { OtherShapesLoader } from './other-shapes-loader.ts';
import type { Ground, SceneLines } from './scene-lines.ts';
import { SceneCamera } from './scene-camera.ts';
import type { AuthorCamera } from './author-camera.ts';
import { LayerScene } from './layer-scene.ts';
import { isAnimating, startCanvas } from './start-canvas.ts';
import type { StartedCanvas } from './start-canvas.ts';
import type { Optics } from '../renderer/ray/ray-module.ts';
import { plainRays } from '../renderer/ray/ray-plan.ts';
import type { RayPlan } from '../renderer/ray/ray-plan.ts';
import { VolumeLayer } from '../renderer/layers/volume-layer.ts';
import type { FieldProviders, View } from '../renderer/layers/volume-layer.ts';
import { readPicture, startReading } from '../renderer/device/read-picture.ts';
import type { GpuTimer } from '../renderer/device/gpu-timer.ts';
import { LayerDrawing } from './layer-drawing.ts';
import type { VolumePicture } from './read-volume.ts';
import { buildScene } from './volume-shape.ts';
import type { X3dom } from './x3dom-types.ts';

/** The scene's place in the page, and its callbacks. */
interface Place {
  readonly host: Element;
  readonly container: Element;
  readonly needsFrame: () => void;
  readonly fieldProviders: FieldProviders;
}

/** What a picture is drawn with: `FramePlan` of the viewer is one. */
export interface ScenePlan extends RayPlan {
  /** Device pixels. */
  readonly picture: Size;
  /** null leaves the author's viewpoint, or else the last camera. */
  readonly camera: Camera | null;
  readonly ground: Ground | null;
}

/** A volume and the author's nodes in a running x3dom scene. It draws only when its owner calls `draw`. */
export class VolumeScene extends LayerScene {
  readonly device: Device;
  readonly #started: StartedCanvas;
  readonly #gl: Gl;
  /** What is drawn; only one at present. */
  readonly layers: readonly [VolumeLayer];
  readonly #drawing: LayerDrawing;
  readonly #camera: SceneCamera;
  readonly #others: OtherShapesLoader;
  #timer: GpuTimer | null = null;
  #isDrawing = false;
  /** The plan of the last picture, or of the next one: `apply` sets it. */
  plan: ScenePlan;

  /**
   * @param host - the element whose X3D children join the scene
   * @param container - the parent of the canvas
   * @param needsFrame - called when something in the scene changed and `draw` should be called soon
   * @param fieldProviders - how to draw volumes that are not on cartesian grids; none if absent
   */
  static async create(
    host: Element,
    container: Element,
    needsFrame: () => void,
    fieldProviders: FieldProviders = {},
  ): Promise<VolumeScene> {
    const x3dom = await loadX3dom();
    const scene = new VolumeScene(x3dom, { host, container, needsFrame, fieldProviders });
    await scene.othersReady();
    return scene;
  }

  private constructor(x3dom: X3dom, { host, container, needsFrame, fieldProviders }: Place) {
    super();
    this.#started = startCanvas(x3dom, container, {
      buildScene,
      needsFrame: () => {
        if (!this.#isDrawing) needsFrame();
      },
    });
    this.#gl = this.#started.canvas.gl!.ctx3d;
    this.device = describe(this.#gl);
    this.plan = { ...plainRays, picture: this.canvas, camera: null, ground: null };
    this.layers = [new VolumeLayer(this.#gl, this.device, fieldProviders)];
    // The first frames run without it.
    import('../renderer/device/gpu-timer.ts').then(
      (part) => (this.#timer = part.GpuTimer.create(this.#gl)),
      () => {},
    );
    this.#camera = new SceneCamera(x3dom, this.#started, () => this.#others.shapes?.author.viewpoint ?? null);
    this.#others = new OtherShapesLoader(x3dom, this.#started, host);
    const surroundings = { started: this.#started, camera: this.#camera, others: () => this.#others.shapes };
    this.#drawing = new LayerDrawing(this.layers[0], surroundings);
  }

  get canvas(): HTMLCanvasElement {
    return this.#started.canvas.canvas;
  }

  /** Whether x3dom animates something by itself (a running TimeSensor, for example), so that frames have to continue. */
  get animating(): boolean {
    return isAnimating(this.#started);
  }

  /**
   * Loads the code that only some volumes and some optics need, before `setVolume` and `setAppearance`. @throws
   * {VolumeViewError} `format/unsupported`
   */
  async prepare(volume: VolumeData, optics?: Optics): Promise<void> {
    await this.layers[0].prepare(volume, optics);
    if (isPolar(volume)) await this.#others.load(); // Radar volumes may have rings.
  }

  /**
   * Resolves when the author's children that were added meanwhile are in the scene: the code for them is loaded with
   * the first.
   */
  othersReady(): Promise<void> {
    return this.#others.ready();
  }

  /** Puts a volume on the GPU, in place of the one before, at once. */
  setVolume(volume: VolumeData): void {
    this.layers[0].set(volume);
    this.#drawing.shapeVolume(volume);
  }

  /**
   * Puts a volume on the GPU in place of the one before. A large one is uploaded bit by bit between frames, which show
   * the one before until the upload is complete.
   * @param givenUp - whether the volume is no longer wanted
   * @returns whether it is in place; false if it was given up or the context was lost
   */
  async bringVolume(volume: VolumeData, givenUp: () => boolean): Promise<boolean> {
    const isThere = await this.layers[0].bring(volume, givenUp);
    if (isThere) this.#drawing.shapeVolume(volume);
    return isThere;
  }

  /** Loads what shows lines of other parts; null if that part of the package is not there. */
  readonly loadLines = (): Promise<SceneLines | null> =>
    this.#others.load().then(() => this.#others.shapes?.lines ?? null);

  /** The author's viewpoint as a camera, or null if there is none. */
  authorCamera(): AuthorCamera | null {
    return this.#others.shapes?.camera ?? null;
  }

  /** Undoes what the plans of pictures did to the author's viewpoint. */
  resetAuthorCamera(): void {
    this.#others.shapes?.author.viewpoint?.resetView();
  }

  /** See `Scene`. */
  apply(plan: ScenePlan): void {
    const { picture, camera, ground } = plan;
    this.#quietly(() => {
      this.#camera.resize(picture);
      if (camera && camera !== this.plan.camera) this.#camera.set(camera);
      this.#others.shapes?.lines.showGround(ground);
    });
    this.layers[0].plan = this.plan = plan;
  }

  getView(): View {
    return this.#camera.view();
  }

  viewAt(picture: Size): View {
    return this.#camera.viewAt(picture);
  }

  getRays(): RaySetup | null {
    return this.layers[0].raysOf(this.getView());
  }

  /** Draws one picture. @throws {VolumeViewError} `webgl/shader` */
  draw(time = performance.now()): void {
    this.#timer?.begin();
    try {
      this.#drawScene(time);
    } finally {
      this.#timer?.end();
    }
  }

  #drawScene(time: number): void {
    const { canvas, document } = this.#started;
    const { shapes } = this.#others;
    const draw = (): void =>
      this.#drawing.drawWith(() => {
        this.#camera.forgetProjection();
        document.needRender = true;
        canvas.tick(time);
      });
    this.#quietly(() => (shapes ? shapes.draw(draw) : draw()));
  }

  /** Asks for no frame meanwhile: what changes is in the picture that is drawn now. */
  #quietly(work: () => void): void {
    this.#isDrawing = true;
    try {
      work();
    } finally {
      this.#isDrawing = false;
    }
  }

  /**
   * Draws the volume of the last picture at a lattice of its rays, in floats.
   * @param rays - what differs from the plan of that picture
   * @param alone - whether rays ignore shapes
   * @returns a function that reads the result, before another is drawn: RGBA, premultiplied, 0..1, bottom row first; it
   * waits for the GPU unless that has `finished`. null if the device can't do it
   */
  startProbe(
    rays: Partial<RayPlan>,
    lattice: PixelLattice,
    picture: Size,
    alone = false,
  ): (() => Float32Array | null) | null {
    return this.#drawing.startProbe(rays, lattice, picture, alone);
  }

  /** The lights of a lit volume; null for a light at the eye. */
  lights(): SceneLights | null {
    return this.layers[0].lights();
  }

  /** Whether the next picture can be drawn piece by piece: only after one that was drawn at once. */
  get gatherable(): boolean {
    return this.#drawing.gatherable;
  }

  /** Whether rays of the last picture end at shapes. */
  get endsAtShapes(): boolean {
    return this.#drawing.endsAtShapes;
  }

  /** See `Scene`. */
  startGathering(rays: Partial<RayPlan>, picture: Size): Pass[] {
    return this.#drawing.startGathering(rays, picture);
  }

  /** Draws some rows of a pass, from the bottom, into a target that is not shown yet, with the view of the last picture. */
  gather(rays: Partial<RayPlan>, part: { pass: Pass; firstRow: number; rows: number }, picture: Size): void {
    this.#drawing.gather(rays, part, picture);
  }

  /** Whether some rays of the next picture may be skipped. */
  get adaptive(): boolean {
    return this.#drawing.adaptive;
  }

  drawGathered(time = performance.now()): void {
    this.#drawing.showsGathered = true;
    try {
      this.#drawScene(time);
    } finally {
      this.#drawing.showsGathered = false;
    }
  }

  /** Resolves when the GPU has finished all commands so far. */
  finished(): Promise<void> {
    return gpuFinished(this.#gl);
  }

  /** The GPU time of the last `draw`, ms, when it has finished; null without timer queries. */
  readonly gpuMs = async (): Promise<number | null> => (await this.#timer?.read()) ?? null;

  /** The last picture in the canvas: premultiplied, bottom row first. */
  readPicture(): Pixels & { readonly data: Uint8Array } {
    return readPicture(this.#gl, this.canvas);
  }

  /** The same: the function waits for the GPU only if that has not `finished` since. */
  startReading(): () => Pixels {
    const { width, height } = this.canvas;
    const read = startReading(this.#gl, { width, height }, new Uint8Array(4 * width * height));
    return () => ({ data: read(), width, height });
  }

  /** The volume of the last picture, if it got all its rays, without the shapes around it; null if it did not. */
  readVolume(): VolumePicture | null {
    return this.#drawing.readVolume();
  }

  /** Removes the scene: it releases the author's elements, the GPU's memory and the context. */
  dispose(): void {
    this.#others.dispose();
    const { element, canvas, document } = this.#started;
    document.mutationObserver.disconnect();
    this.#drawing.dispose();
    this.#timer?.dispose();
    if (!this.#gl.isContextLost()) document.shutdown(canvas.gl!);
    document.removeX3DOMBackendGraph(element); // x3dom keeps all shapes in a list of the whole page.
    this.#gl.getExtension('WEBGL_lose_context')?.loseContext();
    element.remove();
    canvas.canvas.width = canvas.canvas.height = 0;
  }
}
