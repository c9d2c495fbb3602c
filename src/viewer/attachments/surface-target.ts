import { VolumeViewError } from '../../core/errors.ts';
import { loadPart } from '../../core/load-part.ts';
import type { ShownSurface, SurfacedElement } from '../../renderer/layers/shown-surfaces.ts';
import type { Volume } from '../../volume/volume.ts';
import { tellBeside } from '../model/beside-notices.ts';
import type { ToldFile } from '../model/beside-notices.ts';
import type { Scene } from '../model/scene.ts';
import type { SurfaceCutter } from './surface-cutter.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

/** What is wrong with surfaces of a view, by the elements that ask for them. */
const problems = new WeakMap<Element, Map<Element, unknown>>();

/** A surface's place in a <volume-view>. */
export class SurfaceTarget {
  /** Has what is shown, or is about to. */
  #scene: Scene | null = null;
  /** It could not be brought there. */
  #isLacking = false;
  #waitNoMore = (): void => {};
  readonly #view: SurfacedElement;
  /** What was last to be shown, whole. */
  #whole: ShownSurface | null = null;
  /** null until it is to be cut. */
  #cutter: SurfaceCutter | null = null;

  /** @param owner - asks for the surface */
  constructor(readonly presenter: VolumePresenter, readonly owner: Element) {
    this.#view = presenter.user.host;
    this.#view.addEventListener('render', this.#follow);
  }

  /** The last good volume; null before there is one. */
  get volume(): Volume | null {
    return this.presenter.volume;
  }

  /** Whether a volume is being loaded, or would be: the picture is near enough to be seen soon. */
  get awake(): boolean {
    return this.presenter.user.awake;
  }

  /** Load what cuts surfaces, before one is shown that is to be cut. @throws {VolumeViewError} `format/unsupported` */
  async prepareCuts(): Promise<void> {
    const { SurfaceCutter } = await loadPart(import('./surface-cutter.ts'), 'cuts surfaces');
    this.#cutter ??= new SurfaceCutter(this.presenter, () => this.show(this.#whole).catch((error: unknown) => this.failed(error)));
  }

  /** @param whole - null for none @throws {VolumeViewError} `format/unsupported` where what draws it can not be loaded */
  async show(whole: ShownSurface | null): Promise<void> {
    this.#whole = whole;
    const cutter = this.#cutter;
    if (cutter && whole?.isCut) (this.#view._cutSurfaces ??= new Set()).add(cutter.follow);
    else if (cutter) this.#view._cutSurfaces?.delete(cutter.follow);
    const shown = cutter && whole?.isCut ? cutter.cut(whole) : whole;
    const all = new Map(this.#view._surfaces);
    const isKept = all.get(this.owner) === (shown ?? undefined);
    if (isKept && (!shown || this.#isInScene)) return;
    if (shown) all.set(this.owner, shown);
    else all.delete(this.owner);
    this.#view._surfaces = all.size > 0 ? all : undefined;
    if (!isKept) this.#frame();
    await this.#sceneComes();
    await this.#bring();
  }

  /** Work that a script that waits for the picture has to wait for. It does not reject. */
  track(work: Promise<unknown>): void {
    this.presenter.track(work);
  }

  failed(error: unknown): void {
    const all = problems.get(this.#view) ?? new Map<Element, unknown>();
    problems.set(this.#view, all.set(this.owner, error));
    this.presenter.errors.report('surfaces', error);
  }

  cleared(): void {
    const all = problems.get(this.#view);
    if (!all?.delete(this.owner)) return;
    const other = [...all.values()].at(-1);
    if (other === undefined) this.presenter.errors.clear('surfaces');
    else this.presenter.errors.report('surfaces', other);
  }

  tell(files: readonly ToldFile[]): void {
    tellBeside(this.presenter, this.owner, files);
  }

  /** The surface is of this view no longer. */
  async leave(): Promise<void> {
    this.#view.removeEventListener('render', this.#follow);
    this.#waitNoMore();
    await this.show(null).catch(() => {}); // Nothing of it is to be drawn.
  }

  /** Before the first picture the camera takes it in. */
  #frame(): void {
    const { viewer } = this.presenter;
    if (viewer && !viewer.pictures.drawn && !viewer.leftAttributes) viewer.rig.resetAtOnce();
  }

  get #isInScene(): boolean {
    return this.#scene !== null && this.#scene === this.#present && !this.#isLacking;
  }

  get #present(): Scene | null {
    return this.presenter.viewer?.pictures.parts.keeper.scene ?? null;
  }

  /** A scene may be half built: it has looked for surfaces, and is not in use yet. */
  async #sceneComes(): Promise<void> {
    const { viewer } = this.presenter;
    if (this.#present || !viewer?.volume) return;
    viewer.invalidate(); // Of an element that is out of sight there may be a picture that seems to be done.
    const waiting = new AbortController();
    const { signal } = waiting;
    await new Promise<void>((resolve) => {
      this.#waitNoMore = resolve;
      for (const type of ['render', 'error']) this.#view.addEventListener(type, () => resolve(), { signal });
      // Without a volume there will be no picture.
      this.#view.addEventListener('optics-change', () => this.volume || resolve(), { signal });
    });
    waiting.abort();
  }

  readonly #follow = (): void => {
    if (this.#present !== this.#scene && this.#view._surfaces) this.track(this.#bring().catch((error: unknown) => this.failed(error)));
  };

  async #bring(): Promise<void> {
    const scene = (this.#scene = this.#present);
    try {
      await (await scene?.loadLines())?.bringSurfaces();
      this.#isLacking = false;
    } catch (cause) {
      this.#isLacking = true;
      throw new VolumeViewError('format/unsupported', 'the part of volume-view that draws surfaces could not be loaded; check that all files of the package are on the server', { cause });
    }
    this.presenter.viewer?.invalidate();
  }
}

/** The error for a surface that has no volume around it. */
export function noSurfaceTarget(tag: string): VolumeViewError {
  return new VolumeViewError('attribute/invalid', `<${tag}> got no volume around it; expected it between the tags of a <volume-view>.`);
}
