import type { Pixels } from '../optics/rays/between-pixels.ts';
import type { SceneLights } from '../optics/transfer/lights.ts';
import type { Camera } from '../optics/rays/camera.ts';
import type { PixelLattice, RaySetup } from '../optics/rays/rays.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import type { Device, Gl } from '../renderer/device/device.ts';
import { describe } from '../renderer/probes/probe-device.ts';
import { gpuFinished } from '../renderer/device/gpu-finished.ts';
import { loadX3dom } from './load-x3dom.ts';
import type { Pass, Size } from '../renderer/passes/pass-drawing.ts';
import { OtherShapesLoader } from './other-shapes-loader.ts';
import type { GroundMap } from '../radar/ground-map.ts';
import type { Lines, SceneLines } from './scene-lines.ts';
import { SceneCamera } from './scene-camera.ts';
import type { AuthorCamera } from './author-camera.ts';
import { LayerScene } from './layer-scene.ts';
import { isAnimating, startCanvas } from './start-canvas.ts';
import type { StartedCanvas } from './start-canvas.ts';
import type { Optics } from '../renderer/ray/ray-module.ts';
import { VolumeLayer } from '../renderer/layers/volume-layer.ts';
import type { FieldProviders, View } from '../renderer/layers/volume-layer.ts';
import { readPicture } from '../renderer/device/read-picture.ts';
import type { GpuTimer } from '../renderer/device/gpu-timer.ts';
import { LayerDrawing } from './layer-drawing.ts';
import type { VolumePicture } from './read-volume.ts';
import { buildScene } from './volume-shape.ts';
import type { X3dom } from './x3dom-types.ts';

/** Where a scene stands, and what it is told. */
interface Place {
  readonly host: Element;
  readonly container: Element;
  readonly needsFrame: () => void;
  readonly fieldProviders: FieldProviders;
}

/** A volume and the author's nodes in a running x3dom scene. It draws when told to, and never by itself. */
export class VolumeScene extends LayerScene {
  readonly device: Device;
  readonly #started: StartedCanvas;
  readonly #gl: Gl;
  /** What is drawn; one for now. */
  readonly layers: readonly [VolumeLayer];
  readonly #drawing: LayerDrawing;
  readonly #camera: SceneCamera;
  readonly #others: OtherShapesLoader;
  #timer: GpuTimer | null = null;
  #isDrawing = false;

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
    this.layers = [new VolumeLayer(this.#gl, this.device, fieldProviders)];
    // The first frames do without it.
    import('../renderer/device/gpu-timer.ts').then((part) => (this.#timer = part.GpuTimer.create(this.#gl)), () => {});
    this.#camera = new SceneCamera(x3dom, this.#started, () => this.#others.shapes?.author.viewpoint ?? null);
    this.#others = new OtherShapesLoader(x3dom, this.#started, host);
    const surroundings = { started: this.#started, camera: this.#camera, others: () => this.#others.shapes };
    this.#drawing = new LayerDrawing(this.layers[0], surroundings);
  }

  get canvas(): HTMLCanvasElement {
    return this.#started.canvas.canvas;
  }

  /** Whether x3dom animates something by itself (a running TimeSensor, say), so that frames have to go on. */
  get animating(): boolean {
    return isAnimating(this.#started);
  }

  /** Load what only some volumes and some optics need, before `setVolume` and `setOptics`. @throws {VolumeViewError} `format/unsupported` */
  async prepare(volume: Volume, optics?: Optics): Promise<void> {
    await this.layers[0].prepare(volume, optics);
    if (isPolar(volume)) await this.#others.load(); // There may be rings around it.
  }

  /** Resolves when the author's children that came meanwhile are in the scene: what grafts them is loaded with the first. */
  othersReady(): Promise<void> {
    return this.#others.ready();
  }

  /** Put a volume on the GPU in place of the one before, at once. */
  setVolume(volume: Volume): void {
    this.layers[0].set(volume);
    this.#drawing.shapeVolume(volume);
  }

  /**
   * Put a volume on the GPU in place of the one before: a large one bit by bit between frames, which show the one before
   * until all of it is there.
   * @param givenUp - whether it is still wanted
   * @returns whether it is in place; not where it was given up or the context was lost
   */
  async bringVolume(volume: Volume, givenUp: () => boolean): Promise<boolean> {
    const isThere = await this.layers[0].bring(volume, givenUp);
    if (isThere) this.#drawing.shapeVolume(volume);
    return isThere;
  }

  /** Thin lines around the volume, in world coordinates. */
  setLines(lines: Lines, map?: GroundMap): void {
    this.#others.shapes?.lines.showGround(lines, map);
  }

  /** What shows lines of others; null where that part of the package is not there. */
  readonly loadLines = (): Promise<SceneLines | null> => this.#others.load().then(() => this.#others.shapes?.lines ?? null);

  /** See `Scene`. */
  setMaxCurvature(maxCurvature: number, edgeCurvature = Infinity): void {
    this.#drawing.maxCurvature = maxCurvature;
    this.#drawing.edgeCurvature = edgeCurvature;
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

  resize(width: number, height: number): void {
    this.#camera.resize(width, height);
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

  /** Draw one picture. @param stepLength - world length @throws {VolumeViewError} `webgl/shader` */
  draw(stepLength: number, time = performance.now()): void {
    this.#drawing.stepLength = stepLength;
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
    const draw = (): void => this.#drawing.drawWith(() => {
      this.#camera.forgetProjection();
      document.needRender = true;
      canvas.tick(time);
    });
    this.#isDrawing = true;
    try {
      if (shapes) shapes.draw(draw);
      else draw();
    } finally {
      this.#isDrawing = false;
    }
  }

  /**
   * Draw the volume of the last picture at a lattice of its rays, with another step length (world), in floats.
   * @param alone - shapes end none of them
   * @returns reads it, before another is drawn: RGBA, premultiplied, 0..1, bottom row first; it waits for the GPU unless that
   *   has `finished`. null where the device can't do it
   */
  startProbe(stepLength: number, lattice: PixelLattice, picture: Size, alone = false): (() => Float32Array | null) | null {
    return this.#drawing.startProbe(stepLength, lattice, picture, alone);
  }

  /** What shines on a lit volume; null for a light at the eye. */
  lights(): SceneLights | null {
    return this.layers[0].lights();
  }

  /** Whether the next picture can be drawn piece by piece: after one that was drawn at once. */
  get gatherable(): boolean {
    return this.#drawing.gatherable;
  }

  /** Whether rays of the last picture end at shapes. */
  get endsAtShapes(): boolean {
    return this.#drawing.endsAtShapes;
  }

  /** See `Scene`. */
  startGathering(stepLength: number, picture: Size): void {
    this.#drawing.startGathering(stepLength, picture);
  }

  /** What a picture of a size is gathered from, one lattice of pixels after the other. */
  passes(picture: Size): Pass[] {
    return this.#drawing.passes(picture);
  }

  /** Draw some rows of a pass, from the bottom, where nobody sees them yet, at the view of the last picture. */
  gather(stepLength: number, part: { pass: Pass; firstRow: number; rows: number }, picture: Size): void {
    this.#drawing.gather(stepLength, part, picture);
  }

  /** Whether rays of the next picture may be spared. */
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

  /** Resolves when the GPU has drawn everything that it was told to. */
  finished(): Promise<void> {
    return gpuFinished(this.#gl);
  }

  /** What the last `draw` took of the GPU's time, ms, once that has finished; null where there are no timer queries. */
  readonly gpuMs = async (): Promise<number | null> => (await this.#timer?.read()) ?? null;

  /** The last picture as it lies in the canvas: premultiplied, bottom row first. */
  readPicture(): Pixels & { readonly data: Uint8Array } {
    return readPicture(this.#gl, this.canvas);
  }

  /** The volume of the last picture, which got all its rays, without the shapes around it; null where there are none. */
  readVolume(): VolumePicture | null {
    return this.#drawing.readVolume();
  }

  /** Take the scene down: the author's elements, the GPU's memory and the context are given back. */
  dispose(): void {
    this.#others.dispose();
    const { element, canvas, document } = this.#started;
    document.mutationObserver.disconnect();
    this.#drawing.dispose();
    this.#timer?.dispose();
    if (!this.#gl.isContextLost()) document.shutdown(canvas.gl!);
    document.removeX3DOMBackendGraph(element); // x3dom keeps all shapes in a list of the page's.
    this.#gl.getExtension('WEBGL_lose_context')?.loseContext();
    element.remove();
    canvas.canvas.width = canvas.canvas.height = 0;
  }
}
