// Cuts surfaces: loaded with the first surface that is cut together with its volume.
import { stretchOf } from '../../radar/polar-geometry.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import { cutSurface } from '../../volume/cut-surface.ts';
import { boundsBetween, sidesOf } from '../../volume/world-cut.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import type { SocketView } from '../model/view-socket.ts';

/** Time that a cut may take in a frame, ms. */
const frameShareMs = 8;

/** A frame of the page, ms. */
const frameMs = 16;

/** A drag has paused when nothing has moved for this time, ms. */
const pauseMs = 150;

/** After a slow cut, wait for this many times its duration: then at most a tenth of the time is for cuts. */
const restPerCut = 10;

/**
 * Cuts a surface where its volume is cut. While the cuts change, the surface follows in each frame if that leaves time for the
 * picture; else it follows when the change pauses, or has gone on for ten times as long as the last cut took.
 */
export class SurfaceCutter {
  #whole: ShownSurface | null = null;
  #key = '';
  #left: ShownSurface | null = null;
  #tookMs = 0;
  #endedMs = 0;
  /** Time of the page's frame in which it was cut. */
  #frame: unknown = null;
  /** When the next cut is due, and the work that waits for it. */
  #dueMs = 0;
  #waiting: Promise<void> | null = null;

  /** @param again - shows the surface again, newly cut */
  constructor(
    readonly view: SocketView,
    readonly again: () => Promise<void>,
  ) {}

  /** The rest of a surface after the cuts; null where nothing is left. The same object where nothing has changed. */
  cut(whole: ShownSurface): ShownSurface | null {
    const away = this.#away;
    const key = JSON.stringify(away);
    if (whole === this.#whole && key === this.#key) return this.#left;
    const begunMs = performance.now();
    const surface = cutSurface(whole.surface, away);
    [this.#whole, this.#key] = [whole, key];
    this.#left =
      surface === whole.surface ? whole : surface && { ...whole, surface, cut: { whole: whole.surface, away } };
    this.#endedMs = performance.now();
    this.#tookMs = this.#endedMs - begunMs;
    this.#frame = document.timeline.currentTime;
    return this.#left;
  }

  /** Called when the cuts of the volume may have changed. */
  readonly follow = (): void => {
    if (JSON.stringify(this.#away) === this.#key) return;
    const now = performance.now();
    const wait =
      this.#tookMs > frameShareMs
        ? Math.min(pauseMs, this.#endedMs + restPerCut * this.#tookMs - now)
        : document.timeline.currentTime === this.#frame
          ? frameMs
          : 0;
    if (wait <= 0) return this.view.track(this.again());
    this.#dueMs = now + wait;
    if (!this.#waiting) this.view.track((this.#waiting = this.#wait()));
  };

  async #wait(): Promise<void> {
    do await new Promise((resolve) => setTimeout(resolve, this.#dueMs - performance.now()));
    while (performance.now() < this.#dueMs);
    this.#waiting = null;
    await this.again();
  }

  get #away(): WorldCut {
    const { viewer, settings } = this.view;
    const { cuts } = viewer?.shown ?? {};
    const { grid } = viewer?.volume ?? {};
    const { value: box } = settings.region;
    const sides = cuts?.region && grid && box ? sidesOf([boundsBetween(box, stretchOf(grid))]) : [];
    return { kept: [...(cuts?.away?.kept ?? []), ...sides], removed: cuts?.away?.removed ?? null };
  }
}
