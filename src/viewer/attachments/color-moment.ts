// Shows a radar scan in the colours of another of its moments: loaded where a view requests it.
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import type { Color } from '../../optics/transfer/transfer-function.ts';
import { VolumeViewError } from '../../core/errors.ts';
import { secondMomentField } from '../../radar/polar-field.ts';
import { deviceLimits } from '../../renderer/device/device.ts';
import { probeDevice } from '../../renderer/probes/probe-device.ts';
import { isPolar } from '../../volume/volume.ts';
import type { PolarVolume, Volume } from '../../volume/volume.ts';
import { loadAttachment } from '../loading/load-attachment.ts';
import { makeOverlay } from './make-overlay.ts';
import { OverlayTarget } from './overlay-target.ts';
import { readSource } from '../loading/read-source.ts';
import { checkSameGates } from '../loading/same-gates.ts';
import type { TimeChangeDetail } from '../loading/scan-player.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';
import { socketOf } from '../model/view-socket.ts';

/** A <volume-view> that may request such colours. */
export interface ColoredView extends HTMLElement {
  readonly colorMoment: string | null;
  readonly scan: TimeChangeDetail | null;
}

/** The colour of gates without a value of that moment. */
const missing: Color = [0.55, 0.55, 0.55];

const known = new WeakMap<ColoredView, ColorMoment>();

/** The colours of a view; to be refreshed after each of its updates. */
export function colorsOf(view: ColoredView): ColorMoment {
  if (!known.has(view)) known.set(view, new ColorMoment(view));
  return known.get(view)!;
}

/**
 * A layer that colours a scan with the same strength everywhere.
 * @throws {VolumeViewError} `format/unsupported` where its gates differ
 */
export async function colorByMoment(over: PolarVolume, volume: PolarVolume, name: string): Promise<ViewOverlay> {
  checkSameGates(over, volume);
  const stops = await resolveTransferFunction(volume.transferFunction ?? 'turbo', volume.window ?? volume.range);
  const transferFunction = stops.map((stop) => ({ ...stop, opacity: 1 }));
  return makeOverlay(
    { volume, over, transferFunction, blend: 'color', opacityFactor: 1, missing },
    name,
    secondMomentField(over, volume),
  );
}

/** A layer over a radar scan, with the appearance that its author gives. */
export function overRadar(shown: ShownOverlay, name: string): ViewOverlay {
  return makeOverlay(shown, name, secondMomentField(shown.over as PolarVolume, shown.volume as PolarVolume));
}

class ColorMoment {
  readonly #target: OverlayTarget;
  #run = new AbortController();
  /** What is shown or loading: the moment, the volume, the viewer, and the scan. */
  #of: readonly unknown[] = [];
  #isShown = false;

  constructor(readonly view: ColoredView) {
    this.#target = new OverlayTarget(socketOf(view));
    for (const type of ['load', 'time-change']) view.addEventListener(type, () => void this.refresh());
  }

  /**
   * Load and show the present request, unless it is shown already.
   * @returns resolves when the next picture shows it, with whether that picture is different
   */
  async refresh(): Promise<boolean> {
    const { view } = this;
    const { volume, viewer } = this.#target.view;
    const moment = view.colorMoment?.trim() || null;
    const of = [moment, volume, viewer, view.scan?.index];
    if (of.every((one, i) => one === this.#of[i])) return false;
    const [before] = this.#of;
    this.#of = of;
    this.#run.abort();
    const { signal } = (this.#run = new AbortController());
    if (!moment && before) this.#target.cleared(); // Else the error may belong to a <volume-layer>.
    const isWanted = moment !== null && volume !== null && viewer !== null;
    if (!isWanted && !this.#isShown) return false;
    const work = (isWanted ? this.#read(moment, volume, signal) : this.#apply(null)).catch((error: unknown) =>
      this.#fail(error, signal),
    );
    this.#target.track(work);
    await work;
    return true;
  }

  async #read(moment: string, over: Volume, signal: AbortSignal): Promise<void> {
    if (!isPolar(over))
      throw new VolumeViewError(
        'attribute/invalid',
        `color-moment got "${moment.slice(0, 60)}" and a volume that is no radar scan; expected a radar file with several moments. Another volume over this one is a <volume-layer>.`,
      );
    const moments = over.radar?.moments ?? [];
    if (!moments.includes(moment))
      throw new VolumeViewError(
        'attribute/invalid',
        `color-moment got "${moment.slice(0, 60)}"; expected one that the file holds: ${moments
          .slice(0, 40)
          .map((one) => one.slice(0, 40))
          .join(', ')}. The moment of another file is a <volume-layer blend="color">.`,
      );
    const volume = await this.#load(moment, signal);
    signal.throwIfAborted();
    if (!isPolar(volume))
      throw new VolumeViewError(
        'format/unsupported',
        `color-moment got "${moment.slice(0, 60)}", which is on no radar's gates; expected another moment of the scan.`,
      );
    // Meanwhile another scan may have come; another refresh works for that one.
    if (volume.radar?.time !== over.radar?.time) return;
    const overlay = await colorByMoment(over, volume, moment);
    signal.throwIfAborted();
    await this.#apply(overlay);
    this.#target.cleared();
  }

  #load(moment: string, signal: AbortSignal): Promise<Volume> {
    const { settings } = this.#target.view;
    const { scan } = this.view;
    const urls = settings.src!.trim().split(/\s+/);
    const index = scan?.index ?? 0;
    const several = scan !== null && scan.count > 1;
    const which = settings.stack
      ? { url: urls[0], files: urls }
      : urls.length > 1
        ? { url: urls[index] }
        : { url: urls[0], ...(several ? { scan: { index } } : {}) };
    const request = {
      ...which,
      local: settings.local,
      settings: { ...(settings.source && readSource(settings.source)), moment },
      limits: deviceLimits(probeDevice()),
    };
    return loadAttachment(request, signal, { fetch: this.#target.fetch }); // Nobody reports when the view is gone, so the volume is not kept.
  }

  async #apply(overlay: ViewOverlay | null): Promise<void> {
    this.#isShown = overlay !== null;
    await this.#target.show(overlay);
    this.view.dispatchEvent(new CustomEvent('layer-change', { detail: null }));
  }

  #fail(error: unknown, signal: AbortSignal): void {
    if (signal.aborted) return;
    if (this.#isShown) this.#apply(null).catch(() => {});
    this.#target.failed(error);
  }
}
