import type { Volume } from '../../volume/volume.ts';
import type { ToldFile } from '../model/beside-notices.ts';
import type { Aspect } from '../model/error-board.ts';
import type { Scene } from '../model/scene.ts';
import type { SocketView, ViewPart, ViewSocket } from '../model/view-socket.ts';

/** A <volume-view> as the place of something that is shown with its volume, and the part of the view that shows it. */
export abstract class PresenterPlace<Value extends { readonly shown: unknown }> implements ViewPart {
  abstract readonly key: 'labels' | 'overlay';
  /** What is shown from here; null for nothing. */
  protected value: Value | null = null;
  /** Scenes that have or had it. */
  readonly #told = new WeakSet<Scene>();

  /** @param aspect - of what can fail */
  constructor(readonly socket: ViewSocket, readonly aspect: Aspect) {}

  /** Nobody makes such a place before its element is defined. */
  get view(): SocketView {
    return this.socket.view!;
  }

  /** The last good volume; null before there is one. */
  get volume(): Volume | null {
    return this.view.volume;
  }

  /** Whether a volume is being loaded, or would be: the picture is near enough to be seen soon. */
  get awake(): boolean {
    return this.view.awake;
  }

  /** The file of that volume, for messages. */
  get file(): string {
    return this.view.settings.src ?? '';
  }

  /** Show something else; null for nothing. @returns resolves when the next picture shows it @throws {VolumeViewError} */
  async wear(value: Value | null): Promise<void> {
    const before = this.value;
    this.value = value;
    if (!value) await this.socket.leave(this);
    else if (!before) await this.socket.join(this);
    else if (before.shown !== value.shown) await this.socket.update(this);
  }

  apply(scene: Scene): Promise<void> | void {
    // Whichever place it is from. What draws it is loaded with the first.
    const shown = this.socket.last(this.key)?.shown ?? null;
    if (!shown && !this.#told.has(scene)) return;
    this.#told.add(scene);
    return this.tell(scene, shown);
  }

  remove(scene: Scene): Promise<void> | void {
    return this.apply(scene);
  }

  protected abstract tell(scene: Scene, shown: Value['shown'] | null): Promise<void>;

  /** Work that a script that waits for the picture has to wait for. It does not reject. */
  track(work: Promise<unknown>): void {
    this.view.track(work);
  }

  failed(error: unknown): void {
    this.view.errors.report(this.aspect, error);
  }

  cleared(): void {
    this.view.errors.clear(this.aspect);
  }

  reportFiles(files: readonly ToldFile[]): void {
    this.view.reportFiles(this, files);
  }
}
