// Shows the second volume of X3D's BlendedVolumeStyle as a layer over the first: loaded with the first such style.
import { VolumeViewError } from '../../core/errors.ts';
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import { childrenOf } from '../../page/page-children.ts';
import { deviceLimits } from '../../renderer/device/device.ts';
import { probeDevice } from '../../renderer/probes/probe-device.ts';
import { isPolar } from '../../volume/volume.ts';
import { withoutIds } from '../../volume/label-volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { noticesOf } from '../model/report-notices.ts';
import { AttachmentController } from './attachment-controller.ts';
import type { AttachmentHost } from './attachment-controller.ts';
import { LastWork } from '../model/last-work.ts';
import { loadAttachment } from '../loading/load-attachment.ts';
import { makeOverlay } from './make-overlay.ts';
import { OverlayTarget } from './overlay-target.ts';
import { placeOverlay } from './place-overlay.ts';
import { stretchOver } from './stretch-over.ts';
import { readOpacityMap } from '../../x3d/nodes/read-opacity-map.ts';
import { sharedVolumes } from '../loading/shared-volumes.ts';
import type { SecondVolume } from '../../x3d/nodes/volume-textures.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';
import type { ViewSocket } from '../model/view-socket.ts';

/** X3D's default: bright values are opaque. */
const gray = '0% #000 0, 100% #fff 100%';

/** The value in an image that X3D calls 1. */
const white = 255;

/** A page's own layer has priority over a blend. */
class BlendTarget extends OverlayTarget {
  get isTaken(): boolean {
    return childrenOf(this.view.host, 'volume-layer').length > 0;
  }

  override async show(overlay: ViewOverlay | null): Promise<void> {
    if (!overlay || !this.isTaken) await super.show(overlay);
  }
}

/** Controls the second volume of a view. */
export class BlendController extends AttachmentController<BlendTarget, AttachmentHost<BlendTarget>> {
  readonly #target: BlendTarget;
  readonly #files = new LastWork<Volume>();
  #second: SecondVolume | null = null;

  constructor(socket: ViewSocket) {
    const target = new BlendTarget(socket);
    super({ target: () => (this.#second ? target : null), failed: () => {} });
    this.#target = target;
    socket.view!.host.addEventListener('load', () => this.refresh());
  }

  /** @throws {VolumeViewError} `attribute/invalid` */
  async show(second: SecondVolume): Promise<void> {
    if (this.#target.isTaken) {
      throw new VolumeViewError(
        'attribute/invalid',
        '<BlendedVolumeStyle> got voxels and a <volume-layer>; expected one of the two, as a volume has one other over it. The <volume-layer> is drawn.',
      );
    }
    this.#second = second;
    this.refresh();
  }

  hide(): void {
    if (this.#second) this.leave(this.#target);
    this.#second = null;
  }

  protected override forget(target: BlendTarget): void {
    this.#files.forget();
    sharedVolumes.release(this);
    target.track(target.show(null).catch(() => {}));
  }

  protected override async read(target: BlendTarget, signal: AbortSignal): Promise<void> {
    const { voxels, texture, ratio, opacityFactor } = this.#second!;
    const file = await this.#files.get(JSON.stringify(voxels), signal, (stop) =>
      loadAttachment({ ...voxels, limits: deviceLimits(probeDevice()) }, stop, { holder: this, fetch: target.fetch }),
    );
    const loaded = withoutIds(file);
    const colors = texture || opacityFactor !== null ? await readOpacityMap(texture, opacityFactor) : gray;
    signal.throwIfAborted();
    const { volume: over } = target;
    if (!over) return; // The target reports the volume when it is there.
    const volume =
      voxels.settings?.mosaic && !isPolar(over) && !isPolar(loaded)
        ? stretchOver(loaded, over)
        : placeOverlay(loaded, over, voxels.url);
    const window = voxels.settings?.mosaic ? ([0, white] as const) : (volume.window ?? volume.range);
    const transferFunction = await resolveTransferFunction(colors, window);
    signal.throwIfAborted();
    await target.show(
      makeOverlay(
        { volume, over, missing: null, transferFunction, blend: 'mix', opacityFactor: ratio },
        volume.title ?? '',
      ),
    );
    signal.throwIfAborted();
    target.cleared();
    target.reportFiles([[voxels.url, noticesOf(file)]]);
  }
}
