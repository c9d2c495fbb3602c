import { VolumeViewError } from '../../core/errors.ts';
import { buildScene, contextLost } from './build-scene.ts';
import type { SceneContents } from './build-scene.ts';
import { contextPool } from './context-pool.ts';
import type { ContextHolder, Need } from './context-pool.ts';
import type { FrameLoop } from './frame-loop.ts';
import type { Presence } from './presence.ts';
import type { RayTwins } from '../../renderer/ray/ray-twin.ts';
import type { Scene, SceneFactory } from '../model/scene.ts';
import { Snapshot } from './snapshot.ts';

/** Where a scene is in the page. */
export interface ScenePlace {
  /** The element whose X3D children join the scene. */
  readonly host: HTMLElement;
  /** Holds the canvas. */
  readonly container: Element;
  readonly presence: Presence;
  readonly scenes: SceneFactory;
}

/** Who needs a scene. */
export interface SceneUser extends SceneContents {
  /** Whether it is known what to draw. */
  readonly ready: boolean;
  readonly loop: FrameLoop;
  /** A scene that is not in use yet has the volume: give it the rest. */
  furnish(scene: Scene): void;
  /** It is in use now. */
  entered(scene: Scene): void;
  /** Something in the scene changed. */
  sceneChanged(scene: Scene): void;
  /** Something changed that a scene would show, were there one. */
  invalidate(): void;
  failed(error: unknown): void;
}

/**
 * Holds a scene, and with it a WebGL context, while it is a holder of the page's context pool. Without one, its last
 * picture stands there as a snapshot. A context that is lost is replaced.
 */
export class SceneKeeper implements ContextHolder {
  #scene: Scene | null = null;
  #lastTwins: RayTwins | null = null;
  #isBuilding = false;
  /** One after the other. */
  #built: Promise<void> = Promise.resolve();
  /** What to draw is on its way. */
  #expecting = false;
  /** There is a scene, and nothing yet to put into it: looks again whether there is. */
  #lookAgain: (() => void) | null = null;
  /** What is to be done with a scene that has nothing to show yet. */
  #rehearsal: ((scene: Scene) => Promise<void>) | null = null;
  /** Others need the context of a scene that has nothing to show. */
  #gaveWay = false;
  /** Why there is no scene, until something changes. */
  #failure: { readonly error: unknown } | null = null;
  /** The scene has drawn nothing yet. */
  #isNew = false;
  /** Work under way that needs the scene. */
  #pins = 0;
  #disposed = false;
  readonly #snapshot: Snapshot;
  readonly #authorWatch = new MutationObserver((records) => {
    if (records.some(({ type, target }) => type === 'childList' || target !== this.place.host)) this.user.invalidate();
  });

  constructor(readonly place: ScenePlace, readonly user: SceneUser) {
    this.#snapshot = new Snapshot(place.container);
    contextPool.add(this);
  }

  get scene(): Scene | null {
    return this.#scene;
  }

  /** The rays of the picture that stands there, in float64: of the scene, or of the one before it. @param looks - as in `Scene.twins`, of the present scene */
  twins(looks: boolean): RayTwins | null {
    return this.#scene?.twins(looks) ?? this.#lastTwins;
  }

  /** Whether there is no scene, and there will be none until something changes. */
  get hasFailed(): boolean {
    return this.#failure !== null;
  }

  /** Whether the first picture of the scene, which compiles its program, is still to come. */
  get isNew(): boolean {
    return this.#isNew;
  }

  get inSight(): boolean {
    return this.place.presence.inSight;
  }

  get asked(): boolean {
    return this.place.presence.asked;
  }

  get mayHold(): boolean {
    return (this.user.ready || this.#expecting) && this.place.presence.mayBeNear && !this.hasFailed;
  }

  get need(): Need {
    if (!this.mayHold) return 'none';
    if (!this.user.ready) return 'ready'; // It takes the context of nobody who has something to show.
    if (this.place.presence.inHand) return 'hand';
    if (this.#pins > 0 || this.user.loop.unfinished) return 'picture';
    return this.inSight ? 'ready' : 'none';
  }

  get busy(): boolean {
    return (this.#isBuilding && (!this.#lookAgain || this.user.ready)) || this.user.loop.drawing !== null || this.#pins > 0 || (this.#isNew && this.need !== 'none');
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
    // Nobody else sees now what the author does with the X3D elements.
    this.#authorWatch.observe(this.place.host, { childList: true, subtree: true, attributes: true });
  }

  /** Something changed, with which a scene may come about that failed before. */
  forgive(): void {
    this.#failure = null;
  }

  /** What to draw is on its way, for which a scene can be made ready; or it is no more. */
  expect(isComing: boolean): void {
    if (this.#expecting === isComing) return;
    this.#expecting = isComing;
    this.review();
  }

  /** Do something with a scene that waits for what to draw; nothing where none does. */
  rehearse(act: (scene: Scene) => Promise<void>): void {
    if (!this.#isBuilding || this.user.ready) return;
    this.#rehearsal = act;
    this.#lookAgain?.();
  }

  /** Something may be otherwise with the need for a scene. */
  review(): void {
    this.#lookAgain?.();
    contextPool.review();
  }

  /** The scene's own picture stands there. */
  hasDrawn(): void {
    this.#isNew = false;
    this.#snapshot.remove();
  }

  /** A frame is over: others may need the context more. */
  endFrame(): void {
    contextPool.drew(this);
  }

  /** Do something with the scene, which stays meanwhile. @throws where there is no scene, and none will come */
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

  /** Give the context and the GPU's memory back. */
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
    this.#scene = null; // First, as being taken down is a change that no frame should follow.
    scene?.dispose();
  }

  /** @param explain - what an error that has no words of its own means here */
  async #build(explain: (error: unknown) => unknown): Promise<void> {
    const { host, container, scenes } = this.place;
    if (this.#gaveWay || this.#scene) return; // It had to leave again before its turn.
    this.#isBuilding = true;
    this.#authorWatch.disconnect();
    try {
      await buildScene(() => scenes.create(host, container, () => this.#changed()), this.user, (scene) => this.#hasContents(scene), (scene) => this.#put(scene));
    } catch (error) {
      this.#fail(error instanceof VolumeViewError ? error : explain(error));
    }
    this.#isBuilding = false;
    this.user.loop.wake();
    if (this.#scene) contextPool.review();
    else contextPool.release(this);
  }

  /** Resolves when it is known what to draw, or that nothing comes. */
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
    this.user.furnish(scene);
    scene.canvas.addEventListener('webglcontextlost', () => void this.#recover(scene));
    this.user.entered(scene);
    this.#scene = scene;
    this.#lastTwins = null; // With it goes the volume that they are of.
    this.#isNew = true;
    this.user.loop.plan();
  }

  #fail(error: unknown): void {
    if (this.#disposed) return;
    this.#failure = { error };
    // It is tried again when there is something to show, and told then.
    if (this.user.ready) this.user.failed(error);
  }

  /** The context is gone (driver reset, too many on the page): build the scene again on a new canvas. */
  async #recover(scene: Scene): Promise<void> {
    const { loop } = this.user;
    while (loop.drawing) await loop.drawing;
    if (this.#scene !== scene) return; // It was given back.
    this.#takeDown();
    await this.#build(contextLost);
    this.#changed(); // What was measured in the lost one may mean nothing.
  }

  #changed(): void {
    if (this.#scene) this.user.sceneChanged(this.#scene);
  }
}
