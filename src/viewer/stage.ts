import { VolumeViewError } from '../errors.ts';
import { countSamples } from '../optics/count-samples.ts';
import type { PictureError } from '../quality/error-estimate.ts';
import type { FramePlan } from '../quality/plan-frame.ts';
import { stepLengthOf } from '../quality/steps.ts';
import { allRays } from '../quality/adaptive-sampling.ts';
import type { SamplingOutcome } from '../quality/adaptive-sampling.ts';
import { boundingSphere } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import { fieldProviders } from '../../components/field-providers.ts';
import { VolumeScene } from '../x3d/scene.ts';
import type { Optics } from '../x3d/scene.ts';
import { AuthorView } from './author-view.ts';
import { CameraRig } from './camera-rig.ts';
import type { CameraAttributes } from './camera-rig.ts';
import { noCuts } from './cuts.ts';
import type { Cuts } from './cuts.ts';
import { askedSize, pictureSize } from './picture-size.ts';
import type { PictureSize } from './picture-size.ts';
import { contextPool } from './context-pool.ts';
import type { Need, ContextHolder } from './context-pool.ts';
import type { Presence } from './presence.ts';
import { gatherPicture } from './gather-picture.ts';
import { firstFrame, QualityControl } from './quality-control.ts';
import type { QualityTargets } from './quality-control.ts';
import { RingLabels } from './ring-labels.ts';
import { Snapshot } from './snapshot.ts';

/** What one drawn frame was. */
export interface RenderStats {
  /** From the call to the GPU having finished, ms. */
  readonly frameMs: number;
  /** Steps along the longest ray, each of one sample or, where something may be seen, several. */
  readonly steps: number;
  /** World length between samples. */
  readonly stepLength: number;
  /** Rays that were cast, as a share of the pixels, about; what lies between them is interpolated where it is smooth. */
  readonly rays: number;
  /** How much the picture may bend where it is interpolated, 1/255, see docs/maths.md; 0 where every pixel got a ray. */
  readonly maxCurvature: number;
  /** Steps of all rays of the picture, those through empty space and behind opaque things too; estimated from 1,024 rays. */
  readonly samples: number;
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
  /** Whether this is the picture at its full number of steps, with nothing on its way to change it. */
  readonly converged: boolean;
  /**
   * How far the picture is from what it would be with endlessly many steps and a ray for each pixel, in 1/255: estimated
   * on the GPU from this very view. null while moving, and where the device can't measure it.
   */
  readonly error: PictureError | null;
}

/** What a stage tells its element. */
export interface StageListener {
  rendered(stats: RenderStats): void;
  /** A person, or something in the scene, moved the camera. */
  cameraMoved(): void;
  failed(error: VolumeViewError): void;
}

/** Contexts that may be lost while a volume is on its way into them, until it is given up. */
const maxLost = 3;

/** Rests between frames that are longer than this are rests, not time that the camera has to make up for. */
const longestStepMs = 100;

/**
 * Draws one volume: it decides when a frame is due and how many steps it gets. At rest it draws nothing and holds no timer.
 * It holds a scene, and with it a WebGL context, while it has one of the page's places; without, its last picture stands
 * there, and all that the next one will need is kept.
 */
export class Stage implements ContextHolder {
  readonly rig = new CameraRig();
  #scene: VolumeScene | null = null;
  #building = false;
  /** Why there is no scene, until something changes. */
  #failure: VolumeViewError | null = null;
  /** The scene has drawn nothing yet. */
  #isNew = false;
  /** Work under way that needs the scene. */
  #pins = 0;
  readonly #snapshot: Snapshot;
  #volume: Volume | null = null;
  #drawn: Volume | null = null;
  /** The last volume that was to be shown and is not in place yet; what came before it is given up. */
  #entrance: object | null = null;
  #optics: Optics | null = null;
  #cuts: Cuts = noCuts;
  readonly #labels: RingLabels;
  readonly #quality = new QualityControl();
  #frame = 0;
  #drawing: Promise<void> | null = null;
  #dirty = true;
  #lastTime = 0;
  readonly #author = new AuthorView(this.rig);
  readonly #authorWatch = new MutationObserver((records) => {
    if (records.some(({ type, target }) => type === 'childList' || target !== this.host)) this.invalidate();
  });
  #waiting: (() => void)[] = [];
  #disposed = false;

  constructor(
    readonly host: HTMLElement,
    readonly container: Element,
    readonly presence: Presence,
    readonly listener: StageListener,
  ) {
    this.#snapshot = new Snapshot(container);
    const labels = document.createElement('div');
    labels.className = 'labels';
    labels.ariaHidden = 'true';
    container.after(labels);
    this.#labels = new RingLabels(labels);
    contextPool.add(this);
  }

  /** The volume in the last picture. */
  get drawn(): Volume | null {
    return this.#drawn;
  }

  /** Whether it is known what to draw. */
  get ready(): boolean {
    return this.#volume !== null && this.#optics !== null;
  }

  get inSight(): boolean {
    return this.presence.inSight;
  }

  get asked(): boolean {
    return this.presence.asked;
  }

  get mayHold(): boolean {
    return this.ready && this.presence.mayBeNear && this.#failure === null;
  }

  get need(): Need {
    if (!this.mayHold) return 'none';
    if (this.presence.inHand) return 'hand';
    if (this.#pins > 0 || this.#unfinished) return 'picture';
    return this.inSight ? 'ready' : 'none';
  }

  get busy(): boolean {
    return this.#building || this.#drawing !== null || this.#pins > 0 || (this.#isNew && this.need !== 'none');
  }

  /** Whether the last picture is not the last word on the scene as it stands. */
  get #unfinished(): boolean {
    return this.#dirty || this.#drawing !== null || this.rig.moving || (this.#scene?.animating ?? false);
  }

  /** The volume that pictures are of. */
  get volume(): Volume | null {
    return this.#volume;
  }

  /**
   * Put a volume on the stage. Until all of it is on the GPU the old picture stays.
   * @param readCuts - called when the volume is in place: what changes from then on has to be told
   * @param signal - aborted where the volume is no longer wanted; nothing happens then
   */
  async show(volume: Volume, optics: Optics, readCuts = (): Cuts => this.#cuts, signal?: AbortSignal): Promise<void> {
    const entrance = (this.#entrance = {});
    const givenUp = (): boolean => this.#disposed || this.#entrance !== entrance || signal?.aborted === true;
    try {
      // Where the scene goes or comes meanwhile, it is done again in the next one, or left to what builds that.
      for (let isThere = false; !isThere; ) {
        const scene = this.#scene;
        await scene?.prepare(volume);
        if (givenUp()) return;
        if (scene === this.#scene) isThere = !scene || (await scene.bringVolume(volume, () => givenUp() || scene !== this.#scene));
      }
    } finally {
      if (this.#entrance === entrance) this.#entrance = null;
    }
    const first = this.#volume === null;
    if (first) this.#quality.forgetAll();
    this.#volume = volume;
    this.setCuts(readCuts());
    if (first || this.#author.drives) this.#author.follow(this.#scene, true);
    this.setOptics(optics);
  }

  setOptics(optics: Optics): void {
    this.#optics = optics;
    this.#scene?.setOptics(optics);
    this.#quality.forgetProbes();
    this.invalidate();
  }

  /** Show one part of the present volume, slices of it, and rings around it. */
  setCuts(cuts: Cuts): void {
    this.#cuts = cuts;
    if (this.#scene) this.#cut(this.#scene);
    this.#labels.set(cuts.rings?.labels ?? []);
    if (this.#volume) this.rig.setSubject({ ...boundingSphere(cuts.framed ?? this.#shown), isWeather: isPolar(this.#volume) });
    this.invalidate();
  }

  #cut(scene: VolumeScene): void {
    const { region, slices, rings } = this.#cuts;
    scene.setRegion(region);
    scene.setSlices(slices);
    scene.setLines(rings?.lines ?? []);
  }

  /** What of the volume is shown: cameras frame it, and steps are counted along its diagonal. */
  get #shown(): GridFrame {
    return this.#cuts.region ?? this.#volume!.grid;
  }

  setQuality(targets: QualityTargets): void {
    if (this.#quality.set(targets)) this.#request();
  }

  /** Something changed: draw soon. */
  invalidate(): void {
    this.#quality.forget();
    this.#failure = null;
    this.#request();
  }

  /** The element came nearer, went away, or is asked for. */
  followPresence(): void {
    contextPool.review();
  }

  #request(): void {
    this.#dirty = true;
    if (this.#scene) this.#plan();
    else contextPool.review();
  }

  #plan(): void {
    if (this.#frame === 0 && !this.#drawing && this.#scene && !this.#disposed) {
      this.#frame = requestAnimationFrame((time) => void this.#onFrame(time));
    }
  }

  /** Place the camera by attributes. The author's viewpoint wins. */
  setCamera(attributes: CameraAttributes): void {
    this.rig.setAttributes(attributes);
    this.#resetAuthorCamera();
  }

  /** Back to the author's view. */
  resetCamera(): void {
    this.rig.reset();
    this.#resetAuthorCamera();
  }

  #resetAuthorCamera(): void {
    this.#scene?.resetAuthorCamera();
    this.#author.follow(this.#scene, true);
    this.invalidate();
  }

  /** Resolves when the picture is final: full steps, nothing moving, nothing changed since. */
  async settled(): Promise<void> {
    while (this.ready && !this.#disposed && !this.#failure && (this.#dirty || this.#drawing || this.rig.moving)) {
      this.#request();
      await this.#change();
    }
  }

  /** Resolves after the next frame, and when there is a scene, or will be none. */
  #change(): Promise<void> {
    return new Promise((resolve) => this.#waiting.push(resolve));
  }

  /** Do something with the scene, which stays meanwhile. */
  async #withScene<T>(work: (scene: VolumeScene) => Promise<T>): Promise<T> {
    this.#pins++;
    try {
      while (!this.#scene || this.#drawing) {
        if (this.#failure) throw this.#failure;
        if (this.#disposed) throw new Error('the element has been taken out of the page');
        contextPool.review();
        await this.#change();
      }
      return await work(this.#scene);
    } finally {
      this.#pins--;
      contextPool.drew(this);
    }
  }

  /** Draw one frame at once and wait for the GPU. */
  redraw(): Promise<RenderStats> {
    return this.#withScene(async () => {
      const drawing = this.#draw(performance.now(), this.#planAtRest()).then((stats) => this.#tell(stats));
      this.#drawing = drawing.then(() => {}, () => {});
      try {
        return await drawing;
      } finally {
        this.#drawing = null;
        this.#wake();
      }
    });
  }

  /** A picture file of the view; width and height in device pixels, what is absent follows from the element's shape. */
  toBlob(type: string, goal: Partial<PictureSize>): Promise<Blob> {
    return this.#withScene(async (scene) => {
      const { width, height } = askedSize(this.host, goal, scene.device.maxTextureSize);
      this.#drawAtRest(scene, { width, height }, allRays);
      const blob = await new Promise<Blob | null>((resolve) => {
        scene.canvas.toBlob(resolve, type);
        // The snapshot is taken by the call; the element's own picture has to be back before the page is painted.
        this.#drawAtRest(scene, this.#size(), this.#planAtRest().sampling);
      });
      if (!blob) throw new Error(`toBlob() got the type "${type}", which this browser can't write`);
      return blob;
    });
  }

  #drawAtRest(scene: VolumeScene, { width, height }: PictureSize, { maxCurvature }: SamplingOutcome): void {
    scene.resize(width, height);
    this.#author.aim(scene, width / height);
    scene.setMaxCurvature(maxCurvature);
    scene.draw(stepLengthOf(this.#shown, this.#planAtRest().steps));
    this.#hasDrawn();
  }

  /** The scene's own picture stands there. */
  #hasDrawn(): void {
    this.#isNew = false;
    this.#snapshot.remove();
  }

  /** Give the context and the GPU's memory back. */
  dispose(): void {
    this.#disposed = true;
    this.#takeDown();
    this.#authorWatch.disconnect();
    this.#snapshot.remove();
    this.#labels.container.remove();
    contextPool.remove(this);
    this.#wake();
  }

  #takeDown(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#lastTime = 0;
    const scene = this.#scene;
    this.#scene = null; // First, as being taken down is a change that no frame should follow.
    scene?.dispose();
  }

  enter(): void {
    void this.#build();
  }

  leave(): void {
    if (!this.#scene) return;
    if (this.#unfinished) this.#dirty = true; // An animation of the author's goes on from where it then is.
    if (!this.#isNew) this.#snapshot.keep(this.#scene.canvas);
    this.#takeDown();
    // x3dom sees no more what the author does with the X3D elements.
    this.#authorWatch.observe(this.host, { childList: true, subtree: true, attributes: true });
  }

  /** @param explain - what an error that has no words of its own means here */
  async #build(explain = asVolumeViewError): Promise<void> {
    this.#building = true;
    this.#authorWatch.disconnect();
    try {
      const scene = await this.#buildScene();
      if (scene) this.#furnish(scene, this.#optics!);
    } catch (error) {
      if (!this.#disposed) this.listener.failed((this.#failure = explain(error)));
    }
    this.#building = false;
    this.#wake();
    contextPool.review();
  }

  /** @returns a scene with the volume in it; null where it is no longer wanted */
  async #buildScene(): Promise<VolumeScene | null> {
    for (let lost = 0; lost < maxLost; lost++) {
      const scene = await VolumeScene.create(this.host, this.container, () => this.#sceneChanged(), fieldProviders);
      try {
        if ((await this.#fill(scene)) && !this.#disposed) return scene;
      } catch (error) {
        scene.dispose();
        throw error;
      }
      scene.dispose();
      if (this.#disposed) return null;
    }
    throw new Error('the WebGL context was lost again and again');
  }

  /** Bring the volume into a scene, whichever it is in the end. @returns whether it is there; not where the context was lost */
  async #fill(scene: VolumeScene): Promise<boolean> {
    for (;;) {
      const volume = this.#volume!;
      const givenUp = (): boolean => this.#disposed || volume !== this.#volume;
      await scene.prepare(volume);
      const isThere = await scene.bringVolume(volume, givenUp);
      if (this.#disposed || volume === this.#volume) return isThere;
    }
  }

  #furnish(scene: VolumeScene, optics: Optics): void {
    scene.setOptics(optics);
    this.#cut(scene);
    scene.canvas.addEventListener('webglcontextlost', () => void this.#recover(scene));
    this.#scene = scene;
    this.#isNew = true;
    this.#author.enter(scene);
    this.#plan();
  }

  /** The context is gone (driver reset, too many on the page): build the scene again on a new canvas. */
  async #recover(scene: VolumeScene): Promise<void> {
    while (this.#drawing) await this.#drawing;
    if (this.#scene !== scene) return; // It was given back.
    this.#takeDown();
    await this.#build((cause) => new VolumeViewError(
      'webgl/context-lost',
      'The graphics driver stopped and did not come back. Reload the page.',
      { cause },
    ));
  }

  #sceneChanged(): void {
    if (!this.#scene) return; // It is being built.
    this.#author.follow(this.#scene);
    this.invalidate();
  }

  async #onFrame(time: number): Promise<void> {
    this.#frame = 0;
    const elapsed = this.#lastTime ? Math.min(time - this.#lastTime, longestStepMs) : 16;
    this.#lastTime = time;
    const wasMoving = this.rig.moving;
    this.rig.advance(elapsed, matchMedia('(prefers-reduced-motion: reduce)').matches);
    const inMotion = this.rig.moving || this.#scene!.animating;
    const drawing = this.#drawFrame(time, inMotion);
    this.#drawing = drawing.then(() => {}, () => {});
    let again = false;
    try {
      again = await drawing;
      if (wasMoving) this.listener.cameraMoved();
    } catch (error) {
      this.listener.failed(asVolumeViewError(error));
    } finally {
      this.#drawing = null;
    }
    if (this.#disposed) return;
    if (again || this.rig.moving || this.#scene?.animating || this.#dirty) this.#request();
    else this.#lastTime = 0;
    this.#wake();
    contextPool.drew(this);
  }

  /** @returns whether another frame has to follow, as this one is not the last word on the scene as it stands */
  async #drawFrame(time: number, inMotion: boolean): Promise<boolean> {
    if (this.#quality.untimed) await this.#time(time);
    if (this.#disposed) return false;
    const { width, height } = this.#size();
    // At rest too, the first picture of a view comes within a frame's time, and a better one follows.
    const quick = inMotion || this.#quality.undecided;
    const plan = quick ? this.#quality.moving(this.#shown, width * height) : this.#planAtRest();
    const rows = quick || !this.#scene!.gatherable ? null : this.#quality.rowsOfPieces({ width, height }, plan);
    const stats = rows ? await this.#gather(plan, rows) : await this.#draw(time, plan);
    if (!stats) return true;
    const atRest = !inMotion && !this.#dirty && !this.#disposed;
    const again = atRest && this.#quality.look(this.#scene!, this.#shown, plan, { width, height });
    this.#tell(stats);
    return again || inMotion;
  }

  /** A picture at rest that takes long. @returns null where something changed meanwhile */
  async #gather({ steps, sampling }: FramePlan, rows: number): Promise<RenderStats | null> {
    const scene = this.#scene!;
    scene.setMaxCurvature(sampling.maxCurvature);
    const [volume, { width, height }, stepLength] = [this.#volume, this.#size(), stepLengthOf(this.#shown, steps)];
    this.#dirty = false;
    const goesOn = (): boolean => !this.#dirty && !this.rig.moving && !scene.animating && this.#scene === scene;
    const frameMs = await gatherPicture(scene, { stepLength, width, height, rows }, goesOn);
    if (frameMs === null) return null;
    scene.resize(width, height);
    this.#author.aim(scene, width / height);
    scene.drawGathered();
    this.#labels.place(scene.getView());
    await scene.finished();
    this.#drawn = volume;
    return this.#describe({ frameMs, steps, stepLength, width, height, rays: sampling.share, maxCurvature: sampling.maxCurvature });
  }

  /** A small picture tells what larger ones take; the first of all compiles the shader, and tells nothing. */
  async #time(time: number): Promise<void> {
    await this.#draw(time, firstFrame, false);
    if (!this.#disposed) await this.#draw(time, firstFrame);
  }

  #planAtRest(): FramePlan {
    return this.#quality.still(this.#shown);
  }

  /** Say what has been drawn, together with the error that was measured of it. */
  #tell(drawn: RenderStats): RenderStats {
    const converged = this.#scene !== null && !this.#dirty && !this.rig.moving && !this.#volume!.coarse && !this.#quality.undecided && this.#isFinal(drawn);
    const stats = { ...drawn, converged, error: converged ? this.#quality.error : null };
    if (!this.#disposed) this.listener.rendered(stats);
    return stats;
  }

  #isFinal({ width, height, steps, maxCurvature }: RenderStats): boolean {
    const full = this.#size();
    const plan = this.#planAtRest();
    return width === full.width && height === full.height && steps === plan.steps && maxCurvature === plan.sampling.maxCurvature;
  }

  async #draw(time: number, plan: FramePlan, counts = true): Promise<RenderStats> {
    const { scale, steps, sampling } = plan;
    const scene = this.#scene!;
    const volume = this.#volume;
    this.#dirty = false;
    const full = this.#size();
    const [width, height] = [full.width, full.height].map((pixels) => Math.max(1, Math.round(pixels * scale)));
    scene.resize(width, height);
    this.#author.aim(scene, full.width / full.height);
    const stepLength = stepLengthOf(this.#shown, steps);
    const began = performance.now();
    const compiles = this.#isNew;
    scene.setMaxCurvature(sampling.maxCurvature);
    scene.draw(stepLength, time);
    this.#hasDrawn();
    this.#labels.place(scene.getView());
    await scene.finished();
    this.#drawn = volume;
    const frameMs = performance.now() - began;
    const gpuMs = await scene.gpuMs();
    if (counts && !compiles) this.#quality.took(plan, full.width * full.height, frameMs, gpuMs);
    return this.#describe({ frameMs, steps, stepLength, width, height, rays: sampling.share, maxCurvature: sampling.maxCurvature });
  }

  #describe(frame: Omit<RenderStats, 'samples' | 'converged' | 'error'>): RenderStats {
    const rays = this.#scene?.getRays();
    const samples = rays ? countSamples(rays, frame.stepLength, frame.width * frame.height * frame.rays) : 0;
    return { ...frame, samples, converged: false, error: null };
  }

  #size(): PictureSize {
    return pictureSize(this.host, this.#scene!.device.maxTextureSize);
  }

  #wake(): void {
    for (const resolve of this.#waiting.splice(0)) resolve();
  }
}

function asVolumeViewError(error: unknown): VolumeViewError {
  if (error instanceof VolumeViewError) return error;
  return new VolumeViewError('webgl/context-lost', 'The picture could not be drawn. Reload the page.', { cause: error });
}
