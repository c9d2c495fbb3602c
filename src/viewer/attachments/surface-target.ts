import { VolumeViewError } from '../../core/errors.ts';
import { loadPart } from '../../core/load-part.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ReportedFile } from '../model/file-notices.ts';
import { fetchOf } from '../loading/fetch-of-view.ts';
import { reportFileNotices } from '../model/report-notices.ts';
import type { AttachmentTarget } from '../model/label-target.ts';
import type { Scene } from '../model/scene.ts';
import type { SocketView, ViewPart, ViewSocket } from '../model/view-socket.ts';
import type { SurfaceCutter } from './surface-cutter.ts';

/** The errors of surfaces in a view, by the elements that own them. */
const problems = new WeakMap<ViewSocket, Map<Element, unknown>>();

/** The place of a surface in a <volume-view>; it is also the part that shows it in the view. */
export class SurfaceTarget implements AttachmentTarget, ViewPart {
  readonly key: string;
  /** Whether it was in the page before the first picture: where its file comes later, the camera frames it too. */
  readonly isExpected: boolean;
  #waitNoMore = (): void => {};
  /** The last surface to be shown, uncut. */
  #whole: ShownSurface | null = null;
  #shown: ShownSurface | null = null;
  /** null until a surface must be cut. */
  #cutter: SurfaceCutter | null = null;
  /** Whether the surface could not be put into the last scene. */
  #isLacking = false;
  /** The work that puts it there. */
  #bringing: Promise<void> | null = null;
  /** The number of waiting calls of `show`: they report errors themselves. */
  #waiting = 0;

  /** @param element - owns the surface */
  constructor(
    readonly socket: ViewSocket,
    readonly element: HTMLElement,
  ) {
    this.key = element.localName;
    this.isExpected = !socket.view?.viewer?.drawn;
  }

  /** Such a place is only made after its view is defined. */
  get view(): SocketView {
    return this.socket.view!;
  }

  /** The surface in the picture: what is left of it after cuts. */
  get surface(): ShownSurface | null {
    return this.#shown;
  }

  /** The last good volume; null before there is one. */
  get volume(): Volume | null {
    return this.view.volume;
  }

  /** Whether a volume is loading, or would load if there were one: the picture is near enough to be visible soon. */
  get awake(): boolean {
    return this.view.awake;
  }

  get fetch(): typeof globalThis.fetch | null | undefined {
    return fetchOf(this.view);
  }

  bounds(): readonly Vector3[] {
    return this.#shown?.places ?? [];
  }

  cutsChanged(): void {
    if (this.#whole?.isCut) this.#cutter?.follow();
  }

  /** Load the code that cuts surfaces, before a surface with cuts is shown. @throws {VolumeViewError} `format/unsupported` */
  async prepareCuts(): Promise<void> {
    const { SurfaceCutter } = await loadPart(import('./surface-cutter.ts'), 'cuts surfaces');
    this.#cutter ??= new SurfaceCutter(this.view, () =>
      this.show(this.#whole).catch((error: unknown) => this.failed(error)),
    );
  }

  /** @param whole - null for none @throws {VolumeViewError} `format/unsupported` where the code that draws it can not be loaded */
  async show(whole: ShownSurface | null): Promise<void> {
    const hasJoined = this.#whole !== null;
    this.#whole = whole;
    const before = this.#shown;
    this.#shown = this.#cutter && whole?.isCut ? this.#cutter.cut(whole) : whole;
    if (!whole) return this.socket.leave(this);
    if (hasJoined && this.#shown === before && (!before || this.#isInScene)) return;
    this.#waiting++;
    try {
      const coming = this.#sceneComes();
      const isJoining = hasJoined ? this.socket.update(this) : this.socket.join(this);
      const { viewer } = this.view;
      if (viewer && (!viewer.drawn || (this.isExpected && !hasJoined))) viewer.reframe();
      await isJoining;
      await coming;
      await this.#bringing;
    } finally {
      this.#waiting--;
    }
  }

  /** The picture does not wait for the code that draws surfaces. */
  apply(scene: Scene): void {
    const bringing = (this.#bringing = this.#bring(scene));
    const isAwaited = this.#waiting > 0;
    this.track(bringing.catch((error: unknown) => isAwaited || this.failed(error)));
  }

  remove(scene: Scene): Promise<void> {
    return this.#bring(scene);
  }

  /** Add work that scripts wait for when they wait for the picture. It does not reject. */
  track(work: Promise<unknown>): void {
    this.view.track(work);
  }

  failed(error: unknown): void {
    const all = problems.get(this.socket) ?? new Map<Element, unknown>();
    problems.set(this.socket, all.set(this.element, error));
    this.view.errors.report('surfaces', error);
  }

  cleared(): void {
    const all = problems.get(this.socket);
    if (!all?.delete(this.element)) return;
    const other = [...all.values()].at(-1);
    if (other === undefined) this.view.errors.clear('surfaces');
    else this.view.errors.report('surfaces', other);
  }

  reportFiles(files: readonly ReportedFile[]): void {
    reportFileNotices(this.view, this.element, files);
  }

  /** The surface no longer belongs to this view. */
  async leave(): Promise<void> {
    this.#waitNoMore();
    await this.show(null).catch(() => {}); // Errors do not matter: nothing of it must be drawn.
  }

  get #isInScene(): boolean {
    return Boolean(this.view.viewer?.scene) && !this.#isLacking;
  }

  /** Wait for a scene that is half built: it has already applied its parts, and is not in use yet. */
  async #sceneComes(): Promise<void> {
    const { viewer, host } = this.view;
    if (viewer?.scene || !viewer?.volume) return;
    const waiting = new AbortController();
    const { signal } = waiting;
    await new Promise<void>((resolve) => {
      this.#waitNoMore = resolve;
      for (const type of ['render', 'error']) host.addEventListener(type, () => resolve(), { signal });
      // Without a volume there will be no picture.
      host.addEventListener('optics-change', () => this.volume || resolve(), { signal });
    });
    waiting.abort();
  }

  async #bring(scene: Scene): Promise<void> {
    try {
      await (await scene.loadLines())?.showSurface(this.#shown, this.element);
      this.#isLacking = false;
    } catch (cause) {
      this.#isLacking = true;
      throw new VolumeViewError(
        'format/unsupported',
        'the part of volume-view that draws surfaces could not be loaded; check that all files of the package are on the server',
        { cause },
      );
    }
    this.view.viewer?.invalidate();
  }
}

/** The error for a surface that has no volume around it. */
export function noSurfaceTarget(tag: string): VolumeViewError {
  return new VolumeViewError(
    'attribute/invalid',
    `<${tag}> got no volume around it; expected it between the tags of a <volume-view>.`,
  );
}
