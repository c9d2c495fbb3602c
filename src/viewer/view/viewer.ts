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
import { SceneKeeper } from '../scenes/scene-keeper.ts';
import type { ScenePlace, SceneUser } from '../scenes/scene-keeper.ts';
import { ShownVolume } from '../cuts/shown-volume.ts';
import type { FileGoal } from '../frames/take-picture.ts';
import type { CameraState } from './write-camera.ts';

/** What a viewer tells. */
export interface ViewerListener {
  rendered(stats: RenderStats): void;
  /** A person, or something in the scene, moved the camera. */
  cameraMoved(): void;
  drawingFailed(error: unknown): void;
  /** The words for a ring around a radar: its radius, metres, or null for the mark of the north. */
  labelRing: RingWriter;
}

/**
 * Draws one volume in an element: what is to be seen (ShownVolume), from where (CameraRig), when (FrameLoop), how well
 * (QualityControl), and with which scene (SceneKeeper). All but the scene stays when the WebGL context is given back.
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
  readonly #keeper: SceneKeeper;
  readonly pictures: PictureDrawing;
  readonly frames: FrameDrawing;
  /** The last volume that was to be shown and is not in place yet; what came before it is given up. */
  #entrance: object | null = null;
  #framingComing: Promise<void> | null = null;
  #createFraming: typeof createFraming | null = null;
  /** Before the frame that is being drawn. */
  #wasMoving = false;
  #disposed = false;

  constructor(readonly place: ScenePlace, readonly listener: ViewerListener) {
    this.socket = socketOf(place.host);
    this.shown = new ShownVolume(this.socket);
    this.#keeper = new SceneKeeper(place, this);
    this.pictures = new PictureDrawing({ shown: this.shown, author: this.#author, socket: this.socket, loop: this.loop, keeper: this.#keeper });
    this.frames = new FrameDrawing(place.host, this.#quality, this.pictures, (stats) => {
      if (!this.#disposed) listener.rendered(stats);
    });
  }

  /** The volume in the last picture. */
  get drawn(): Volume | null {
    return this.pictures.drawn;
  }

  /** The volume that pictures are of. */
  get volume(): Volume | null {
    return this.shown.volume;
  }

  get optics(): VolumeOptics | null {
    return this.shown.optics;
  }

  /** What the picture is seen through; null before there is a volume. */
  get camera(): CameraState | null {
    return this.ready ? { ...this.rig.camera, orbit: this.rig.orbit } : null;
  }

  /** Whether the camera is elsewhere than where attributes place it. */
  get leftAttributes(): boolean {
    return this.rig.touched || this.rig.spun || this.#author.drives;
  }

  get scene(): Scene | null {
    return this.#keeper.scene;
  }

  /** Whether it is known what to draw. */
  get ready(): boolean {
    return this.shown.isReady;
  }

  /**
   * Show a volume. Until all of it is on the GPU the old picture stays.
   * @param readCuts - called when the volume is in place: what changes from then on has to be told
   * @param signal - aborted where the volume is no longer wanted; nothing happens then
   */
  async show(volume: Volume, optics: VolumeOptics, readCuts: () => Cuts, signal?: AbortSignal): Promise<void> {
    await this.#framingComing;
    if (volume.ids) optics = await opticsByPlace(volume.ids, optics);
    const first = this.shown.volume === null;
    if (!(await this.#bring(volume, optics, signal))) return;
    if (first) this.#quality.forgetAll();
    this.setCuts(readCuts(), optics);
    if (first || (this.#author.drives && !this.rig.touched)) this.#author.follow(this.#keeper.scene, true);
    await this.#wear(optics);
  }

  /** Bring a volume into the scene, where there is one. @returns whether it is still wanted */
  async #bring(volume: Volume, optics: VolumeOptics, signal?: AbortSignal): Promise<boolean> {
    const entrance = (this.#entrance = {});
    const keeper = this.#keeper;
    const givenUp = (): boolean => this.#disposed || this.#entrance !== entrance || signal?.aborted === true;
    try {
      // Where the scene goes or comes meanwhile, it is done again in the next one, or left to what builds that.
      for (let isThere = false; !isThere; ) {
        const { scene } = keeper;
        await scene?.prepare(volume, optics);
        if (givenUp()) return false;
        if (scene === keeper.scene) isThere = !scene || (await scene.bringVolume(volume, () => givenUp() || scene !== keeper.scene));
      }
      this.shown.volume = volume; // At once: a scene that comes a moment later has to have it.
      return true;
    } finally {
      if (this.#entrance === entrance) this.#entrance = null;
    }
  }

  /** @throws {VolumeViewError} `format/unsupported` where a part of the package that they need is not there */
  async setOptics(optics: VolumeOptics): Promise<void> {
    const ids = this.volume?.ids;
    await this.#wear(ids ? await opticsByPlace(ids, optics) : optics);
  }

  async #wear(optics: VolumeOptics): Promise<void> {
    const { scene } = this.#keeper;
    if (this.shown.wear(optics)) await scene?.setStyle(this.shown.style);
    if (scene !== this.#keeper.scene) return; // A new one knows already.
    await scene?.setOptics(this.shown.optics!);
    this.#quality.forgetProbes();
    this.invalidate();
  }

  /** The language may be another one. */
  relabel(): void {
    this.#labels?.writeTexts();
  }

  /** A volume is on its way, or it is no more. */
  readonly expect = (isComing: boolean): void => this.#keeper.expect(isComing);
  /** Show one part of the present volume, slices of it, and rings around it. @param optics - with which it is framed */
  setCuts(cuts: Cuts, optics = this.optics): void {
    const { volume } = this.shown;
    this.shown.cuts = cuts;
    if (this.#keeper.scene) this.shown.cut(this.#keeper.scene);
    if (!this.#labels && cuts.rings) {
      this.#labels = cuts.rings.labelsAfter(this.place.container, (what) => this.listener.labelRing(what));
      void this.socket.join(this.#labels, true); // Other texts make room for themselves among these.
    }
    this.#labels?.set(cuts.rings?.labels ?? [], cuts.rings?.facts ?? null);
    if (volume) {
      const [{ grid }, create] = [this.shown, this.#createFraming];
      const findFraming = create && optics ? () => create(volume, optics.transferFunction, grid, this.place.host) : undefined;
      this.rig.setSubject({ ...boundingSphere(cuts.framed ?? grid), isWeather: isPolar(volume), isCoarse: volume.coarse, findFraming });
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
    this.#keeper.forgive();
    this.loop.request();
  }

  /** The element came nearer, went away, or is asked for. */
  followPresence(): void {
    this.#keeper.review();
  }

  /** How far hands and attributes may bring the camera, and how it gets there. */
  setLimits(limits: CameraLimits): void {
    this.rig.setLimits(limits);
    this.invalidate();
  }

  /** Place the camera by attributes: it glides there where there is a picture. The author's viewpoint wins. */
  setCamera(attributes: CameraAttributes): void {
    this.rig.setAttributes(attributes, !this.drawn);
    if (this.rig.framesItself) this.#framingComing ??= this.#loadFraming();
    this.#resetAuthorCamera();
  }

  /** Back to the author's view. */
  resetCamera(): void {
    this.rig.reset();
    this.#resetAuthorCamera();
  }

  /** Comes while the data do. Without it the whole volume is framed. */
  async #loadFraming(): Promise<void> {
    const part = await import('../camera/framing.ts').catch(() => null);
    this.#createFraming = part?.createFraming ?? null;
    if (!this.shown.volume) return;
    this.setCuts(this.shown.cuts);
    if (this.#author.drives) this.#author.follow(this.#keeper.scene, true);
  }

  /** Be at once where attributes or a person send the camera. */
  jumpToGoal(): void {
    this.rig.jump();
    this.invalidate();
  }

  /** Frame the subject again, where there is no picture yet and nobody has moved the camera. */
  reframe(): void {
    if (!this.drawn && !this.leftAttributes) this.rig.resetAtOnce();
  }

  /** Turn to a side of the world, radians. */
  turnTo(theta: number, phi: number): void {
    this.rig.turnTo(theta, phi);
    this.invalidate();
  }

  #resetAuthorCamera(): void {
    this.#keeper.scene?.resetAuthorCamera();
    this.#author.follow(this.#keeper.scene, true);
    this.invalidate();
  }

  /** Resolves when the picture is final: full steps, nothing moving, nothing changed since. */
  async settled(): Promise<void> {
    await this.#keeper.scene?.othersReady();
    await this.loop.settled();
  }

  /** Draw one frame at once and wait for the GPU. */
  async redraw(): Promise<RenderStats> {
    await this.#keeper.scene?.othersReady();
    if (this.rig.placing) this.rig.jump(); // The frame is one of the present settings.
    return this.#keeper.withScene((scene) => this.loop.drawNow(() => this.frames.drawNow(scene)));
  }

  /** A picture file of the view at rest. */
  async toBlob(goal: FileGoal): Promise<Blob> {
    const { takePicture } = await loadPart(import('../frames/take-picture.ts'), 'writes pictures to files');
    return this.#keeper.withScene((scene) => takePicture(scene, this.frames, goal));
  }

  /** Give the context and the GPU's memory back. */
  dispose(): void {
    this.#disposed = true;
    this.loop.end();
    this.#keeper.dispose();
    if (this.#labels) {
      this.#labels.container.remove();
      void this.socket.leave(this.#labels);
    }
    this.loop.wake();
  }

  // What the frame loop asks.

  get canDraw(): boolean {
    return this.#keeper.scene !== null;
  }

  get wantsPicture(): boolean {
    return this.ready && !this.#keeper.hasFailed;
  }

  get moving(): boolean {
    return this.rig.moving;
  }

  get animating(): boolean {
    return this.rig.spin !== 0 || (this.#keeper.scene?.animating ?? false);
  }

  askForScene(): void {
    this.#keeper.review();
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
    this.#keeper.endFrame();
  }

  // What the keeper of the scene asks.

  get givenUp(): boolean {
    return this.#disposed;
  }

  furnish(scene: Scene): void {
    this.shown.furnish(scene);
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
