import { VolumeViewError } from '../../core/errors.ts';
import { loadPart } from '../../core/load-part.ts';
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import { deviceLimits } from '../../renderer/device/device.ts';
import { probeDevice } from '../../renderer/probes/probe-device.ts';
import { isPolar } from '../../volume/volume.ts';
import { withoutIds } from '../../volume/label-volume.ts';
import type { PolarVolume, Volume } from '../../volume/volume.ts';
import { noticesOf } from '../model/report-notices.ts';
import { AttachmentController } from './attachment-controller.ts';
import type { AttachmentHost } from './attachment-controller.ts';
import { LastWork } from '../model/last-work.ts';
import { loadAttachment } from '../loading/load-attachment.ts';
import { makeOverlay } from './make-overlay.ts';
import { resolveOverlayAppearance } from '../appearance/overlay-appearance.ts';
import type { OverlayAppearance, OverlayAttributes } from '../appearance/overlay-appearance.ts';
import type { OverlayTarget } from './overlay-target.ts';
import { placeOverlay } from './place-overlay.ts';
import { sharedVolumes } from '../loading/shared-volumes.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';

/** The layer as its author requests it. */
export interface OverlayWishes extends OverlayAttributes {
  readonly src: string | null;
  readonly label: string | null;
  readonly hidden: boolean;
}

/** What the controller of a layer needs of its element. */
export interface OverlayControllerHost extends AttachmentHost<OverlayTarget> {
  readonly wanted: () => OverlayWishes;
  /** The layer, or its appearance, has changed. */
  changed(): void;
}

/** Loads a layer, reads its appearance, and puts it over the volume. */
export class OverlayController extends AttachmentController<OverlayTarget, OverlayControllerHost> {
  readonly #files = new LastWork<Volume>();
  #volume: Volume | null = null;
  #look: OverlayAppearance | null = null;
  /** The volume below the layer. */
  #over: Volume | null = null;

  /** The layer's own volume; null before it is there. */
  get volume(): Volume | null {
    return this.#volume;
  }

  get look(): OverlayAppearance | null {
    return this.#look;
  }

  protected override unread(target: OverlayTarget): void {
    // The layer of another volume does not fit this one.
    if (this.#over !== target.volume) this.#drop(target).catch(() => {});
  }

  protected override forget(target: OverlayTarget): void {
    this.#files.forget();
    sharedVolumes.release(this);
    target.track(this.#drop(target).catch(() => {}));
  }

  async #drop(target: OverlayTarget): Promise<void> {
    this.#volume = null;
    this.#look = null;
    this.#over = null;
    const applied = target.show(null);
    this.host.changed();
    await applied;
  }

  protected override async read(target: OverlayTarget, signal: AbortSignal): Promise<void> {
    const { src, hidden, label, ...words } = this.host.wanted();
    if (hidden) {
      target.cleared();
      target.reportFiles([]);
      return this.#drop(target);
    }
    const url = src?.trim();
    if (!url || /\s/.test(url))
      throw new VolumeViewError(
        'attribute/invalid',
        `<volume-layer> got ${url ? 'several files' : 'no src'}; expected src="map.nii.gz", one file with the layer.`,
      );
    const loaded = await this.#files.get(url, signal, (stop) =>
      loadAttachment({ url, limits: deviceLimits(probeDevice()) }, stop, { holder: this, fetch: target.fetch }),
    );
    signal.throwIfAborted();
    const { volume: over } = target;
    if (!over) return; // The target reports the volume when it is there.
    const volume = placeOverlay(withoutIds(loaded), over, url);
    const appearance = await resolveOverlayAppearance(words, volume);
    const name = label ?? volume.title ?? volume.radar?.moment ?? '';
    const shown = { volume, over, missing: null, ...appearance };
    const overlay = isPolar(volume)
      ? await this.#overRadar(shown, name, words.transferFunction === null)
      : makeOverlay(shown, name);
    signal.throwIfAborted();
    await target.show(overlay);
    signal.throwIfAborted();
    [this.#volume, this.#look, this.#over] = [volume, appearance, over];
    target.cleared();
    target.reportFiles([[url, noticesOf(loaded)]]);
    this.host.changed();
  }

  /** Another moment of the same scan. @param plain - whether it has its own colours, with the same strength everywhere */
  async #overRadar(shown: ShownOverlay, name: string, plain: boolean): Promise<ViewOverlay> {
    const { colorByMoment, overRadar } = await loadPart(import('./color-moment.ts'), 'shows a second moment');
    return plain && shown.blend === 'color'
      ? colorByMoment(shown.over as PolarVolume, shown.volume as PolarVolume, name)
      : overRadar(shown, name);
  }
}
