import { VolumeViewError } from '../../core/errors.ts';
import { buildScene, contextLost } from './build-scene.ts';
import type { SceneContents } from './build-scene.ts';
import { contextPool } from './context-pool.ts';
import type { ContextHolder, Need } from './context-pool.ts';
import type { FrameLoop } from './frame-loop.ts';
import type { Visibility } from './visibility.ts';
import type { RayTwins } from '../../renderer/ray/ray-twin.ts';
import type { Scene, SceneFactory } from '../model/scene.ts';
import { Snapshot } from './snapshot.ts';

/** The place of a scene in the page. */
export interface ScenePlace {
  /** The element whose X3D children join the scene. */
  readonly host: HTMLElement;
  /** Holds the canvas. */
  readonly container: Element;
  readonly visibility: Visibility;
  readonly scenes: SceneFactory;
}

/** What the controller of a scene needs of its owner. */
export interface SceneUser extends SceneContents {
  /** Whether the volume and its appearance are known. */
  readonly ready: boolean;
  readonly loop: FrameLoop;
  /** Apply the rest to a scene that has the volume but is not in use yet. */
  applyTo(scene: Scene): void;
  /** The scene is in use now. */
  entered(scene: Scene): void;
  /** Something in the scene changed. */
  sceneChanged(scene: Scene): void;
  /** Something changed that must be drawn; there may be no scene at the moment. */
  invalidate(): void;
  failed(error: unknown): void;
}

/**
 * Holds a scene, and with it a WebGL context, while it is a holder of the page's context pool. Without a scene, a snapshot of the
 * last picture is on the page. A lost context is replaced.
 */
export class SceneController implements ContextHolder {
  #scene: Scene | null = null;
  #lastTwins: RayTwins | null = null;
  #isBuilding = false;
  /** Scenes are built one after the other. */
  #built: Promise<void> = Promise.resolve();
  /** Whether a volume is loading. */
  #expecting = false;
  /** While a scene waits for its contents: lets it check again whether they have come. */
  #lookAgain: (() => void) | null = null;
  /** Work to do with a scene that has nothing to show yet. */
  #rehearsal: ((scene: Scene) => Promise<void>) | null = null;
  /** Whether the context was given up because others need it. */
  #gaveWay = false;
  /** Why there is no scene; null again when something changes. */
  #failure: { readonly error: unknown } | null = null;
  /** Whether the scene has drawn nothing yet. */
  #isNew = false;
  /** The number of running tasks that need the scene. */
  #pins = 0;
  #disposed = false;
  readonly #snapshot: Snapshot;
  readonly #authorWatch = new MutationObserver((records) => {
    if (records.some(({ type, target }) => type === 'childList' || target !== this.place.host)) this.user.invalidate();
  });

  constructor(
    readonly place: ScenePlace,
    readonly user: SceneUser,
  ) {
    this.#snapshot = new Snapshot(place.container);
    contextPool.add(this);
  }

  get scene(): Scene | null {
    return this.#scene;
  }

  /**
   * The rays of the picture on the page, in float64: from the scene, or from the one before it.
   * @param looks - as in `Scene.twins`, for the present scene
   */
  twins(looks: boolean): RayTwins | null {
    return this.#scene?.twins(looks) ?? this.#lastTwins;
  }

  /** Whether there is no scene, and none will be built until something changes. */
  get hasFailed(): boolean {
    return this.#failure !== null;
  }

  /** Whether the first picture of the scene, which compiles its program, is still to come. */
  get isNew(): boolean {
    return this.#isNew;
  }

  get inSight(): boolean {
    return this.place.visibility.inSight;
  }

  get asked(): boolean {
    return this.place.visibility.asked;
  }

  get mayHold(): boolean {
    return (this.user.ready || this.#expecting) && this.place.visibility.mayBeNear && !this.hasFailed;
  }

  get need(): Need {
    if (!this.mayHold) return 'none';
    if (!this.user.ready) return 'ready'; // It takes no context from viewers that have something to show.
    if (this.place.visibility.inHand) return 'hand';
    if (this.#pins > 0 || this.user.loop.unfinished) return 'picture';
    return this.inSight ? 'ready' : 'none';
  }

  get busy(): boolean {
    return (
      (this.#isBuilding && (!this.#lookAgain || this.user.ready)) ||
      this.user.loop.drawing !== null ||
      this.#pins > 0 ||
      (this.#isNew && this.need !== 'none')
    );
  }

  enter(): void {
    this.#gaveWay = false;
    this.#built = this.#built.then(() => this.#build((error) => error));
  }

  leave(): void {
    this.#gaveWay = true;
    this.#lookAgain?.();
    if (!this.#scene) return;
    if (!this.#isNew) this.#snapshot.keep(this.#scene.canvas);
    this.#takeDown();
    // Without a scene, only this observer notices changes of the author's X3D elements.
    this.#authorWatch.observe(this.place.host, { childList: true, subtree: true, attributes: true });
  }

  /** Something changed: a scene that could not be built may work now. */
  clearErrors(): void {
    this.#failure = null;
  }

  /** A volume is loading, so that a scene can be prepared for it; or it no longer is. */
  expect(isComing: boolean): void {
    if (this.#expecting === isComing) return;
    this.#expecting = isComing;
    this.review();
  }

  /** Do some work with a scene that waits for its contents; nothing where no scene waits. */
  precompile(act: (scene: Scene) => Promise<void>): void {
    if (!this.#isBuilding || this.user.ready) return;
    this.#rehearsal = act;
    this.#lookAgain?.();
  }

  /** The need for a scene may have changed. */
  review(): void {
    this.#lookAgain?.();
    contextPool.review();
  }

  /** The scene's own picture is on the page. */
  hasDrawn(): void {
    this.#isNew = false;
    this.#snapshot.remove();
  }

  /** A frame is over: others may need the context more. */
  endFrame(): void {
    contextPool.drew(this);
  }

  /** Do some work with the scene, which stays until the work ends. @throws where there is no scene, and none will come */
  async withScene<T>(work: (scene: Scene) => Promise<T>): Promise<T> {
    const { loop } = this.user;
    this.#pins++;
    try {
      while (!this.#scene || loop.drawing) {
        if (this.#failure) throw this.#failure.error;
        if (this.#disposed) throw new Error('the element has been taken out of the page');
        contextPool.review();
        await loop.change();
      }
      return await work(this.#scene);
    } finally {
      this.#pins--;
      contextPool.drew(this);
    }
  }

  /** Give back the context and the GPU's memory. */
  dispose(): void {
    this.#disposed = true;
    this.#lookAgain?.();
    this.#takeDown();
    this.#authorWatch.disconnect();
    this.#snapshot.remove();
    contextPool.remove(this);
  }

  #takeDown(): void {
    this.user.loop.rest();
    const scene = this.#scene;
    this.#lastTwins = (!this.#disposed && scene?.twins(true)) || null;
    this.#scene = null; // First: taking down changes the scene, and no frame should follow.
    scene?.dispose();
  }

  /** @param explain - turns an error without a message for users into one for this case */
  async #build(explain: (error: unknown) => unknown): Promise<void> {
    const { host, container, scenes } = this.place;
    if (this.#gaveWay || this.#scene) return; // It had to give its context back before its turn.
    this.#isBuilding = true;
    this.#authorWatch.disconnect();
    try {
      await buildScene(
        () => scenes.create(host, container, () => this.#changed()),
        this.user,
        (scene) => this.#hasContents(scene),
        (scene) => this.#put(scene),
      );
    } catch (error) {
      this.#fail(error instanceof VolumeViewError ? error : explain(error));
    }
    this.#isBuilding = false;
    this.user.loop.wake();
    if (this.#scene) contextPool.review();
    else contextPool.release(this);
  }

  /** Resolves when the contents are known, or when none will come. */
  async #hasContents(scene: Scene): Promise<boolean> {
    while (!this.user.ready && this.#expecting && !this.#gaveWay && !this.#disposed) {
      const act = this.#rehearsal;
      this.#rehearsal = null;
      await (act ? act(scene) : new Promise<void>((resolve) => (this.#lookAgain = resolve)));
      this.#lookAgain = null;
    }
    this.#rehearsal = null;
    return this.user.ready && !this.#gaveWay;
  }

  #put(scene: Scene): void {
    this.user.applyTo(scene);
    scene.canvas.addEventListener('webglcontextlost', () => void this.#recover(scene));
    this.user.entered(scene);
    this.#scene = scene;
    this.#lastTwins = null; // They keep the earlier volume in memory.
    this.#isNew = true;
    this.user.loop.plan();
  }

  #fail(error: unknown): void {
    if (this.#disposed) return;
    this.#failure = { error };
    // If nothing was to be shown yet, it is tried again later, and the error is reported then.
    if (this.user.ready) this.user.failed(error);
  }

  /** The context is lost (driver reset, too many on the page): build the scene again on a new canvas. */
  async #recover(scene: Scene): Promise<void> {
    const { loop } = this.user;
    while (loop.drawing) await loop.drawing;
    if (this.#scene !== scene) return; // The scene was given back.
    this.#takeDown();
    await this.#build(contextLost);
    this.#changed(); // What was measured in the lost scene may no longer be valid.
  }

  #changed(): void {
    if (this.#scene) this.user.sceneChanged(this.#scene);
  }
}
