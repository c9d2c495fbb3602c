import { loadSurface } from '../formats/load-surface.ts';
import type { LoadProgress } from '../formats/load-request.ts';
import type { ShownSurface } from '../renderer/shown-surfaces.ts';
import type { Surface } from '../volume/surface.ts';
import type { Volume } from '../volume/volume.ts';
import { LastWork } from './last-work.ts';
import { loads } from './load-queue.ts';
import { placesOf } from './surface-places.ts';
import type { WantedSurface } from './surface-attributes.ts';
import type { SurfaceTarget } from './surface-target.ts';

/** Whose surface it is. */
export interface SurfaceKeeperHost {
  readonly localName: string;
  /** null where nothing is to be shown. @throws {VolumeViewError} */
  wanted(volume: Volume | null): WantedSurface | null;
  /** null while it is in no page. */
  target(): SurfaceTarget | null;
  came(surface: Surface): void;
  progress(progress: LoadProgress): void;
  failed(error: unknown): void;
}

/** Loads a surface and shows it. What fails leaves the last good one. */
export class SurfaceKeeper {
  readonly #files = new LastWork<Surface>();
  #run = new AbortController();
  #shown: ShownSurface | null = null;
  /** Where the radar is that terrain was made for. */
  #site = '';

  constructor(readonly host: SurfaceKeeperHost) {}

  /** The surface in the picture, or the last one. */
  get surface(): Surface | null {
    return this.#shown?.surface ?? null;
  }

  /** Load and show what is asked for now. */
  refresh(): void {
    this.#run.abort();
    const { signal } = (this.#run = new AbortController());
    const target = this.host.target();
    if (!target || (!target.volume && !target.awake)) return; // What is far away is loaded with its volume.
    target.track(this.#read(target, signal).catch((error: unknown) => {
      if (signal.aborted) return;
      target.failed(error);
      this.host.failed(error);
    }));
  }

  /** The element has left its page. @param target - where it was */
  leave(target: SurfaceTarget): void {
    this.#run.abort();
    this.#files.forget();
    this.#shown = null;
    target.track(target.leave());
  }

  async #read(target: SurfaceTarget, signal: AbortSignal): Promise<void> {
    const site = JSON.stringify(target.volume?.radar?.site);
    // Under another radar, or none, it would lie where it is not.
    if (this.#shown?.surface.terrain && site !== this.#site) await target.show((this.#shown = null));
    signal.throwIfAborted();
    const wanted = this.host.wanted(target.volume);
    if (!wanted) {
      target.cleared();
      return target.show((this.#shown = null));
    }
    const { request, look } = wanted;
    if (!request) return; // The volume tells when it is there.
    const surface = await this.#files.get(JSON.stringify(request), signal, (stop) => this.#load(request, stop));
    signal.throwIfAborted();
    const before = this.#shown;
    const isSame = before?.surface === surface && before.usesOwnColors === look.usesOwnColors && String(before.color) === String(look.color);
    if (!isSame) this.#shown = { surface, ...look, places: placesOf(surface) };
    this.#site = site;
    await target.show(this.#shown);
    signal.throwIfAborted();
    target.cleared();
    if (before?.surface !== surface) this.host.came(surface);
  }

  async #load(request: NonNullable<WantedSurface['request']>, signal: AbortSignal): Promise<Surface> {
    const surface = await loads.run(() => true, signal, () => loadSurface(request, { signal, onProgress: (progress) => this.host.progress(progress) }));
    if (surface.notes.length > 0) console.warn(`<${this.host.localName}>: ${surface.notes.join('. ')}.`);
    return surface;
  }
}
