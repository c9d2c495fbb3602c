import type { Volume } from '../../volume/volume.ts';
import { tellBeside } from '../model/beside-notices.ts';
import type { ToldFile } from '../model/beside-notices.ts';
import type { Aspect } from '../model/error-board.ts';
import type { Scene } from '../model/scene.ts';
import type { ShownVolume } from '../cuts/shown-volume.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

/** A <volume-view> as the place of something that is shown with its volume. */
export class PresenterPlace {
  /** @param aspect - of what can fail */
  constructor(readonly presenter: VolumePresenter, readonly aspect: Aspect) {}

  /** The last good volume; null before there is one. */
  get volume(): Volume | null {
    return this.presenter.volume;
  }

  /** Whether a volume is being loaded, or would be: the picture is near enough to be seen soon. */
  get awake(): boolean {
    return this.presenter.user.awake;
  }

  /** The file of that volume, for messages. */
  get file(): string {
    return this.presenter.settings.src ?? '';
  }

  /**
   * Keep something for scenes to come, and tell the present one.
   * @param keep - returns whether the scene has to be told
   */
  protected async tellScene(keep: (shown: ShownVolume) => boolean, tell: (scene: Scene) => Promise<void>): Promise<void> {
    const { viewer } = this.presenter;
    if (!viewer) return;
    const { shown, keeper } = viewer.pictures.parts;
    if (!keep(shown)) return;
    // A scene that is being built may have looked for it just before, and is in place when all that waits for nothing is done.
    if (!keeper.scene) await new Promise((resolve) => setTimeout(resolve));
    if (keeper.scene) await tell(keeper.scene);
    viewer.invalidate();
  }

  /** Work that a script that waits for the picture has to wait for. It does not reject. */
  track(work: Promise<unknown>): void {
    this.presenter.track(work);
  }

  failed(error: unknown): void {
    this.presenter.errors.report(this.aspect, error);
  }

  cleared(): void {
    this.presenter.errors.clear(this.aspect);
  }

  tell(files: readonly ToldFile[]): void {
    tellBeside(this.presenter, this, files);
  }
}
