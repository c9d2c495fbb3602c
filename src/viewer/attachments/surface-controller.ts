import { loadSurface } from '../../worker/load-surface.ts';
import type { LoadProgress } from '../../formats/base/load-request.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import type { Surface } from '../../volume/surface.ts';
import type { Volume } from '../../volume/volume.ts';
import { AttachmentController } from './attachment-controller.ts';
import type { AttachmentHost } from './attachment-controller.ts';
import { LastWork } from '../model/last-work.ts';
import { loads } from '../loading/load-queue.ts';
import { noteOnPlace } from './note-on-place.ts';
import { placesOf } from './surface-places.ts';
import type { WantedSurface } from './surface-attributes.ts';
import type { SurfaceTarget } from './surface-target.ts';

/** What the controller of a surface needs of its element. */
export interface SurfaceControllerHost extends AttachmentHost<SurfaceTarget> {
  readonly localName: string;
  /** null where nothing must be shown. @throws {VolumeViewError} */
  wanted(volume: Volume | null): WantedSurface | null;
  came(surface: Surface): void;
  progress(progress: LoadProgress): void;
}

/** Loads a surface and shows it. */
export class SurfaceController extends AttachmentController<SurfaceTarget, SurfaceControllerHost> {
  readonly #files = new LastWork<Surface>();
  #shown: ShownSurface | null = null;
  /** The surface that was last reported to the page. */
  #reported: Surface | null = null;
  /** The place of the radar for which the terrain was made. */
  #site = '';

  /** The surface in the picture, or the last one. */
  get surface(): Surface | null {
    return this.#shown?.surface ?? null;
  }

  protected override forget(target: SurfaceTarget): void {
    this.#files.forget();
    this.#shown = this.#reported = null;
    target.track(target.leave());
  }

  protected override async read(target: SurfaceTarget, signal: AbortSignal): Promise<void> {
    const site = JSON.stringify(target.volume?.radar?.site);
    // Under another radar, or none, the terrain would be in a wrong place.
    if (this.#shown?.surface.terrain && site !== this.#site) await target.show((this.#shown = this.#reported = null));
    signal.throwIfAborted();
    const wanted = this.host.wanted(target.volume);
    if (!wanted) {
      target.cleared();
      target.reportFiles([]);
      return target.show((this.#shown = this.#reported = null));
    }
    const { request, look: appearance } = wanted;
    if (!request) return; // The volume reports itself when it is there.
    const surface = await this.#files.get(JSON.stringify(request), signal, (stop) =>
      this.#load(request, stop, target.fetch),
    );
    if (appearance.isCut) await target.prepareCuts();
    signal.throwIfAborted();
    const before = this.#shown;
    const isSame =
      before?.surface === surface &&
      before.isCut === appearance.isCut &&
      before.usesOwnColors === appearance.usesOwnColors &&
      String(before.color) === String(appearance.color);
    if (!isSame) this.#shown = { surface, ...appearance, places: placesOf(surface) };
    this.#site = site;
    await target.show(this.#shown);
    signal.throwIfAborted();
    target.cleared();
    target.reportFiles([[request.surface === 'mesh' ? request.url : '', surface.notes]]);
    if (this.#reported === surface) return;
    this.#reported = surface;
    const note = target.volume && !surface.terrain && noteOnPlace(surface, target.volume.grid);
    if (note) this.#warn(note);
    this.host.came(surface);
  }

  async #load(
    request: NonNullable<WantedSurface['request']>,
    signal: AbortSignal,
    fetch: SurfaceTarget['fetch'],
  ): Promise<Surface> {
    const surface = await loads.run(
      () => true,
      signal,
      () => loadSurface(request, { signal, fetch, onProgress: (progress) => this.host.progress(progress) }),
    );
    if (surface.notes.length > 0) this.#warn(surface.notes.join('. '));
    return surface;
  }

  #warn(text: string): void {
    console.warn(`<${this.host.localName}>: ${text}.`);
  }
}
