import type { Volume } from '../../volume/volume.ts';
import type { ReportedFile } from '../model/file-notices.ts';
import { fetchOf } from '../loading/fetch-of-view.ts';
import { reportFileNotices } from '../model/report-notices.ts';
import type { Aspect } from '../model/error-state.ts';
import type { Scene } from '../model/scene.ts';
import type { SocketView, ViewPart, ViewSocket } from '../model/view-socket.ts';

/** A <volume-view> as the target of something that is shown with its volume; it is also the part that shows it in the view. */
export abstract class PresenterPlace<Value extends { readonly shown: unknown }> implements ViewPart {
  abstract readonly key: 'labels' | 'overlay';
  /** What this place shows; null for nothing. */
  protected value: Value | null = null;
  /** Scenes that have, or had, a value. */
  readonly #appliedTo = new WeakSet<Scene>();

  /** @param aspect - under which errors are reported */
  constructor(
    readonly socket: ViewSocket,
    readonly aspect: Aspect,
  ) {}

  /** Such a place is only made after its element is defined. */
  get view(): SocketView {
    return this.socket.view!;
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

  /** The file of that volume, for messages. */
  get file(): string {
    return this.view.settings.src ?? '';
  }

  /** Show another value; null for nothing. @returns resolves when the next picture shows it @throws {VolumeViewError} */
  async show(value: Value | null): Promise<void> {
    const before = this.value;
    this.value = value;
    if (!value) await this.socket.leave(this);
    else if (!before) await this.socket.join(this);
    else if (before.shown !== value.shown) await this.socket.update(this);
  }

  apply(scene: Scene): Promise<void> | void {
    // The last value counts, from whichever place it is. The code that draws it is loaded with the first value.
    const shown = this.socket.last(this.key)?.shown ?? null;
    if (!shown && !this.#appliedTo.has(scene)) return;
    this.#appliedTo.add(scene);
    return this.applyTo(scene, shown);
  }

  remove(scene: Scene): Promise<void> | void {
    return this.apply(scene);
  }

  protected abstract applyTo(scene: Scene, shown: Value['shown'] | null): Promise<void>;

  /** Add work that scripts wait for when they wait for the picture. It does not reject. */
  track(work: Promise<unknown>): void {
    this.view.track(work);
  }

  failed(error: unknown): void {
    this.view.errors.report(this.aspect, error);
  }

  cleared(): void {
    this.view.errors.clear(this.aspect);
  }

  reportFiles(files: readonly ReportedFile[]): void {
    reportFileNotices(this.view, this, files);
  }
}
