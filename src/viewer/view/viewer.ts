import { loadPart } from '../../core/load-part.ts';
import { boundingSphere } from '../../volume/grid.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { AuthorView } from '../camera/author-view.ts';
import { CameraRig } from '../camera/camera-rig.ts';
import type { CameraAttributes, CameraLimits } from '../model/camera-attributes.ts';
import type { Cuts } from '../cuts/cuts.ts';
import { FrameDrawing } from '../frames/frame-drawing.ts';
import { FrameLoop } from '../scenes/frame-loop.ts';
import type { createFraming } from '../camera/framing.ts';
import type { FrameHost } from '../scenes/frame-loop.ts';
import { prefersLessMotion } from '../scenes/page-watcher.ts';
import { PictureDrawing } from '../frames/picture-drawing.ts';
import { QualityControl } from '../frames/quality-control.ts';
import type { QualityTargets } from '../model/quality-targets.ts';
import type { RenderStats } from '../model/render-stats.ts';
import type { RingLabels, RingWriter } from '../cuts/ring-labels.ts';
import { opticsByPlace } from '../model/optics-by-place.ts';
import type { Scene } from '../model/scene.ts';
import type { VolumeOptics } from '../model/volume-info.ts';
import { socketOf } from '../model/view-socket.ts';
import type { SocketViewer, ViewSocket } from '../model/view-socket.ts';
import { SceneController } from '../scenes/scene-controller.ts';
import type { ScenePlace, SceneUser } from '../scenes/scene-controller.ts';
import { ShownVolume } from '../cuts/shown-volume.ts';
import type { FileGoal } from '../frames/take-picture.ts';
import type { CameraState } from './write-camera.ts';

/** What a viewer reports. */
export interface ViewerListener {
  rendered(stats: RenderStats): void;
  /** A person, or something in the scene, moved the camera. */
  cameraMoved(): void;
  drawingFailed(error: unknown): void;
  /** Write the label of a ring around a radar: its radius, metres, or null for the mark of the north. */
  labelRing: RingWriter;
}

/**
 * Draws one volume in an element: what is visible (ShownVolume), from where (CameraRig), when (FrameLoop), at which quality
 * (QualityControl), and with which scene (SceneKeeper). Everything except the scene stays when the WebGL context is given back.
 */
export class Viewer implements FrameHost, SceneUser, SocketViewer {
  readonly rig = new CameraRig();
  readonly socket: ViewSocket;
  readonly shown: ShownVolume;
  readonly #quality = new QualityControl();
  readonly #author = new AuthorView(this.rig);
  /** null until there are rings. */
  #labels: RingLabels | null = null;
  readonly loop = new FrameLoop(this);
  readonly controller: SceneController;
  readonly pictures: PictureDrawing;
  readonly frames: FrameDrawing;
  /** Identifies the last volume that is still loading into the scene; earlier ones are given up. */
  #entry: object | null = null;
  #framingComing: Promise<void> | null = null;
  #createFraming: typeof createFraming | null = null;
  /** Whether the camera moved before the present frame. */
  #wasMoving = false;
  #disposed = false;

  constructor(
    readonly place: ScenePlace,
    readonly listener: ViewerListener,
  ) {
    this.socket = socketOf(place.host);
    this.shown = new ShownVolume(this.socket);
    this.controller = new SceneController(place, this);
    this.pictures = new PictureDrawing({
      shown: this.shown,
      author: this.#author,
      socket: this.socket,
      loop: this.loop,
      controller: this.controller,
    });
    this.frames = new FrameDrawing(place.host, this.#quality, this.pictures, (stats) => {
      if (!this.#disposed) listener.rendered(stats);
    });
  }

  /** The volume in the last picture. */
  get drawn(): Volume | null {
    return this.pictures.drawn;
  }

  /** The volume in the pictures. */
  get volume(): Volume | null {
    return this.shown.volume;
  }

  get optics(): VolumeOptics | null {
    return this.shown.optics;
  }

  /** The camera of the picture; null before there is a volume. */
  get camera(): CameraState | null {
    return this.ready ? { ...this.rig.camera, orbit: this.rig.orbit } : null;
  }

  /** Whether the camera is not where the attributes place it. */
  get leftAttributes(): boolean {
    return this.rig.touched || this.rig.spun || this.#author.drives;
  }

  get scene(): Scene | null {
    return this.controller.scene;
  }

  /** Whether the volume and its appearance are known. */
  get ready(): boolean {
    return this.shown.isReady;
  }

  /**
   * Show a volume. The old picture stays until the GPU has all of the volume.
   * @param readCuts - called when the volume is in place; callers must report later changes of cuts
   * @param signal - aborted where the volume is no longer needed; nothing happens then
   */
  async show(volume: Volume, optics: VolumeOptics, readCuts: () => Cuts, signal?: AbortSignal): Promise<void> {
    await this.#framingComing;
    if (volume.ids) optics = await opticsByPlace(volume.ids, optics);
    const first = this.shown.volume === null;
    if (!(await this.#bring(volume, optics, signal))) return;
    if (first) this.#quality.forgetAll();
    this.setCuts(readCuts(), optics);
    if (first || (this.#author.drives && !this.rig.touched)) this.#author.follow(this.controller.scene, true);
    await this.#apply(optics);
  }

  /** Put a volume into the scene, where there is one. @returns whether it is still needed */
  async #bring(volume: Volume, optics: VolumeOptics, signal?: AbortSignal): Promise<boolean> {
    const entry = (this.#entry = {});
    const controller = this.controller;
    const givenUp = (): boolean => this.#disposed || this.#entry !== entry || signal?.aborted === true;
    try {
      // If the scene goes or comes meanwhile, try again with the next scene, or leave it to the code that builds that scene.
      for (let isThere = false; !isThere;) {
        const { scene } = controller;
        await scene?.prepare(volume, optics);
        if (givenUp()) return false;
        if (scene === controller.scene)
          isThere = !scene || (await scene.bringVolume(volume, () => givenUp() || scene !== controller.scene));
      }
      this.shown.volume = volume; // At once: a scene that comes a moment later must have it.
      return true;
    } finally {
      if (this.#entry === entry) this.#entry = null;
    }
  }

  /** @throws {VolumeViewError} `format/unsupported` where a part of the package that they need could not be loaded */
  async setOptics(optics: VolumeOptics): Promise<void> {
    const ids = this.volume?.ids;
    await this.#apply(ids ? await opticsByPlace(ids, optics) : optics);
  }

  async #apply(optics: VolumeOptics): Promise<void> {
    const { scene } = this.controller;
    this.shown.optics = optics;
    await scene?.setAppearance({ optics, style: this.shown.style });
    if (scene !== this.controller.scene) return; // A new scene already has them.
    this.#quality.forgetProbes();
    this.invalidate();
  }

  /** Write the labels again: the language may have changed. */
  relabel(): void {
    this.#labels?.writeTexts();
  }

  /** A volume is loading, or no longer is. */
  readonly expect = (isComing: boolean): void => this.controller.expect(isComing);
  /** Show one part of the present volume, slices of it, and rings around it. @param optics - used to frame it */
  setCuts(cuts: Cuts, optics = this.optics): void {
    const { volume } = this.shown;
    this.shown.cuts = cuts;
    if (!this.#labels && cuts.rings) {
      this.#labels = cuts.rings.labelsAfter(this.place.container, (what) => this.listener.labelRing(what));
      void this.socket.join(this.#labels, true); // Other texts make room for themselves among these.
    }
    this.#labels?.set(cuts.rings?.labels ?? [], cuts.rings?.facts ?? null);
    if (volume) {
      const [{ grid }, create] = [this.shown, this.#createFraming];
      const findFraming =
        create && optics ? () => create(volume, optics.transferFunction, grid, this.place.host) : undefined;
      this.rig.setSubject({
        ...boundingSphere(cuts.framed ?? grid),
        isWeather: isPolar(volume),
        isCoarse: volume.coarse,
        findFraming,
      });
    }
    for (const part of this.socket.parts) part.cutsChanged?.();
    this.invalidate();
  }

  setQuality(targets: QualityTargets): void {
    if (this.#quality.set(targets)) this.loop.request();
  }

  /** Something changed: draw soon. */
  invalidate(): void {
    this.#quality.forget();
    this.controller.clearErrors();
    this.loop.request();
  }

  /** The element came nearer or went away, or a script waits for its picture. */
  followVisibility(): void {
    this.controller.review();
  }

  /** Set how far interaction and attributes may move the camera, and how fast it gets there. */
  setLimits(limits: CameraLimits): void {
    this.rig.setLimits(limits);
    this.invalidate();
  }

  /** Place the camera by attributes: it moves there smoothly if there is a picture. The author's viewpoint has priority. */
  setCamera(attributes: CameraAttributes): void {
    this.rig.setAttributes(attributes, !this.drawn);
    if (this.rig.framesItself) this.#framingComing ??= this.#loadFraming();
    this.#resetAuthorCamera();
  }

  /** Go back to the author's view. */
  resetCamera(): void {
    this.rig.reset();
    this.#resetAuthorCamera();
  }

  /** Load the framing code at the same time as the data. Without it the whole volume is framed. */
  async #loadFraming(): Promise<void> {
    const part = await import('../camera/framing.ts').catch(() => null);
    this.#createFraming = part?.createFraming ?? null;
    if (!this.shown.volume) return;
    this.setCuts(this.shown.cuts);
    if (this.#author.drives) this.#author.follow(this.controller.scene, true);
  }

  /** Move the camera at once to where attributes or a person send it. */
  jumpToGoal(): void {
    this.rig.jump();
    this.invalidate();
  }

  /** Frame the subject again, if nobody has moved the camera. */
  reframe(): void {
    if (!this.leftAttributes) this.rig.resetAtOnce();
  }

  /** Turn to a side of the world, radians. */
  turnTo(theta: number, phi: number): void {
    this.rig.turnTo(theta, phi);
    this.invalidate();
  }

  #resetAuthorCamera(): void {
    this.controller.scene?.resetAuthorCamera();
    this.#author.follow(this.controller.scene, true);
    this.invalidate();
  }

  /** Resolves when the picture is final: all steps, nothing moves, nothing has changed since. */
  async settled(): Promise<void> {
    await this.controller.scene?.othersReady();
    await this.loop.settled(() => this.frames.isFinal && !this.loop.dirty && !this.moving);
  }

  /** Draw one frame at once and wait for the GPU. */
  async redraw(): Promise<RenderStats> {
    await this.controller.scene?.othersReady();
    if (this.rig.placing) this.rig.jump(); // The frame must have the camera of the present settings.
    return this.controller.withScene((scene) => this.loop.drawNow(() => this.frames.drawNow(scene)));
  }

  /** A picture file of the view at rest. */
  async toBlob(goal: FileGoal): Promise<Blob> {
    const { takePicture } = await loadPart(import('../frames/take-picture.ts'), 'shows pictures');
    return this.controller.withScene((scene) => takePicture(scene, this.frames, goal));
  }

  /** Give back the context and the GPU's memory. */
  dispose(): void {
    this.#disposed = true;
    this.loop.end();
    this.controller.dispose();
    if (this.#labels) {
      this.#labels.container.remove();
      void this.socket.leave(this.#labels);
    }
    this.loop.wake();
  }

  // What the frame loop needs.

  get canDraw(): boolean {
    return this.controller.scene !== null;
  }

  get wantsPicture(): boolean {
    return this.ready && !this.controller.hasFailed;
  }

  get moving(): boolean {
    return this.rig.moving;
  }

  get animating(): boolean {
    return this.rig.spin !== 0 || (this.controller.scene?.animating ?? false);
  }

  askForScene(): void {
    this.controller.review();
  }

  advance(elapsedMs: number): void {
    this.#wasMoving = this.rig.moving && !this.rig.placing;
    this.rig.advance(elapsedMs, prefersLessMotion());
  }

  async draw(time: number): Promise<boolean> {
    const again = await this.frames.drawFrame(time);
    if (this.#wasMoving) this.listener.cameraMoved();
    return again;
  }

  drew(): void {
    this.controller.endFrame();
  }

  // What the controller of the scene needs.

  get givenUp(): boolean {
    return this.#disposed;
  }

  applyTo(scene: Scene): void {
    void scene.setAppearance({ optics: this.shown.optics!, style: this.shown.style }); // At once: what they need is loaded.
  }

  entered(scene: Scene): void {
    this.#author.enter(scene);
  }

  sceneChanged(scene: Scene): void {
    this.#author.follow(scene);
    this.invalidate();
  }

  failed(error: unknown): void {
    this.listener.drawingFailed(error);
  }
}
