import { VolumeViewError } from '../../core/errors.ts';
import type { ScanTarget } from '../../formats/base/choose-scan.ts';
import type { LoadProgress, LoadProgressListener, LoadRequest } from '../../formats/base/load-request.ts';
import type { LoadOptions } from '../../worker/load.ts';
import { loadPart } from '../../core/load-part.ts';
import { deviceLimits } from '../../renderer/device/device.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import { probeDevice } from '../../renderer/probes/probe-device.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ErrorState } from '../model/error-state.ts';
import { mayBeLit } from '../appearance/default-look.ts';
import { loads } from '../loading/load-queue.ts';
import { openSource } from '../loading/open-source.ts';
import type { Source, SourceRequest } from '../loading/opening.ts';
import type { Playback } from '../loading/playback.ts';
import type { ScanPlayer } from '../loading/scan-player.ts';
import type { SceneFactory } from '../model/scene.ts';
import type { Settings } from '../model/settings.ts';
import { sharedVolumes } from '../loading/shared-volumes.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

/** Volumes with fewer bytes than this are not made smaller where the GPU's memory is full: it would not help. */
const minReduced = 2 ** 20;

/** An element that may fetch by a function of its page. */
export interface FetchingElement extends HTMLElement {
  readonly fetch?: typeof globalThis.fetch | null;
}

/** What a loader needs of its view. */
export interface LoaderHost {
  /** The element. */
  readonly host: FetchingElement;
  readonly settings: Settings;
  /** Whether the element is in a page, where it can show something. */
  readonly inPage: boolean;
  /** Whether the element is near enough to be visible soon, a script waits for it, or it is eager. */
  readonly awake: boolean;
  readonly inSight: boolean;
  readonly scenes: SceneFactory;
  /** The page has removed the source. */
  sourceGone(): void;
  /** The visible state of loading has changed. */
  changed(): void;
  /** The scans, their known times, or whether they play, has changed. */
  scansChanged(): void;
  /** Send an event to the page. */
  emit(type: string, detail: unknown): void;
  /** Add work that scripts wait for when they wait for the picture. */
  track(work: Promise<unknown>): void;
}

/** The objects that a loader works with. */
export interface LoaderParts {
  readonly presenter: VolumePresenter;
  readonly errors: ErrorState;
  readonly playback: Playback;
}

/**
 * Loads the volume of a source: at once, or when the element comes near; again and smaller where the GPU's memory is full; of
 * several scans the requested one. A new load stops the previous one.
 */
export class SourceLoader {
  #scans: ScanPlayer | null = null;
  #isCurrent = false;
  #loading: AbortController | null = null;
  /** The work that waits until the element comes near the visible part of the page, or until a script requests its picture. */
  #putOff: (() => void) | null = null;
  /** From the attribute `time`, or from a later choice by a person. */
  #wanted: ScanTarget = { index: 0 };
  #progress: LoadProgress | null = null;
  /** Bytes of samples that fit into the GPU's memory, as far as it is known. */
  #maxBytes = Infinity;
  /** Settles when the coarse picture of a loading volume is shown, or has failed. */
  #standIn: Promise<void> = Promise.resolve();

  constructor(
    readonly host: LoaderHost,
    readonly parts: LoaderParts,
  ) {}

  /** The player of several scans; null where the source is a single volume, or not open yet. */
  get scans(): ScanPlayer | null {
    return this.#scans;
  }

  /** Whether the volume belongs to the present source; false if it is an old one that stays until a new one is there. */
  get isCurrent(): boolean {
    return this.#isCurrent;
  }

  get isLoading(): boolean {
    return this.#loading !== null;
  }

  /** Whether a load is running or waiting. */
  get isExpecting(): boolean {
    return this.#loading !== null || this.#putOff !== null;
  }

  /** The progress of loading, where a person should see it. */
  get progress(): LoadProgress | null {
    return this.#progress;
  }

  /** Load the present source; a load in progress is stopped. */
  load(): void {
    this.#giveUp();
    this.#isCurrent = false;
    this.#scans?.stop();
    this.#scans = null;
    this.parts.playback.forget();
    const { errors, presenter } = this.parts;
    errors.clear('source');
    presenter.forgetModel();
    const { src, stack } = this.host.settings;
    if (src === null && (presenter.volume || presenter.viewer?.volume)) {
      presenter.empty();
      this.host.sourceGone();
    }
    if (!this.host.inPage || !src) return;
    if (!this.host.awake) {
      this.#putOff = () => this.load();
      return;
    }
    const look = this.host.settings.look.value;
    this.host.scenes.warmUp(look && mayBeLit(look) ? 'lit' : undefined); // This code loads at the same time as the data.
    this.#readTime();
    this.#begin((wanted, signal, onProgress) => {
      this.#setProgress({ loaded: 0, total: 0, phase: 'fetch' });
      return this.#open({ src, stack }, wanted, signal, onProgress);
    });
  }

  /** Load again what failed. */
  reload(): void {
    if (!this.#scans) return this.load();
    this.parts.errors.clear('source');
    this.showWanted();
  }

  /** Show the scan of the settings. */
  showTime(): void {
    if (!this.#scans && !this.#loading) return; // A source that is loaded later starts with this time.
    const before = this.#wanted;
    this.#readTime();
    if (JSON.stringify(before) === JSON.stringify(this.#wanted)) this.#wanted = before;
    else this.showWanted();
  }

  /** Show one of several scans, by its number. */
  showScan(index: number): void {
    this.#wanted = { index };
    this.parts.errors.clear('time');
    this.showWanted();
  }

  /** The requested scan may have changed. A source that is still opening checks this when it has opened. */
  showWanted(): void {
    const scans = this.#scans;
    if (!scans || !this.host.inPage) return;
    if (!this.host.awake) this.#putOff = () => this.showWanted();
    else this.#begin((wanted, signal, onProgress) => scans.load(wanted, signal, onProgress));
  }

  /** The element came nearer or went away: start the waiting work, or stop the load and let it wait. */
  followVisibility(): void {
    if (this.host.awake) {
      const act = this.#putOff;
      this.#putOff = null;
      act?.();
    } else if (this.#loading) {
      this.stop();
      this.#putOff = () => (this.#isCurrent ? this.showWanted() : this.load());
    }
  }

  /** Stop all loading. */
  stop(): void {
    this.#giveUp();
    this.#scans?.stop();
  }

  /** The element has left its page. */
  leave(): void {
    this.stop();
    sharedVolumes.release(this);
  }

  /** The load in progress has failed. */
  fail(): void {
    this.#loading = null;
    this.#setProgress(null);
  }

  #giveUp(): void {
    this.#loading?.abort();
    this.#loading = null;
    this.#putOff = null;
    this.#setProgress(null);
  }

  #readTime(): void {
    this.#wanted = { index: 0 };
    this.parts.errors.take('time', this.host.settings.time, (wanted) => (this.#wanted = wanted));
  }

  /** Load a volume and show it; a load in progress is stopped, and the old picture stays meanwhile. */
  #begin(load: (wanted: ScanTarget, signal: AbortSignal, onProgress: LoadProgressListener) => Promise<Volume>): void {
    this.#giveUp();
    const controller = (this.#loading = new AbortController());
    const { signal } = controller;
    const wanted = this.#wanted;
    const loaded = this.parts.errors.run('source', signal, async () => {
      const volume = await load(wanted, signal, (progress) => this.#onProgress(progress, signal));
      signal.throwIfAborted();
      await this.#show(volume, signal).catch((error: unknown) => this.#loadSmaller(volume, error));
    });
    this.host.track(loaded.then((done) => this.#end(done, wanted, signal)));
  }

  async #show(volume: Volume, signal: AbortSignal): Promise<void> {
    await this.#standIn; // Else the coarse volume might be shown after the full one.
    signal.throwIfAborted();
    const { presenter } = this.parts;
    const optics = await presenter.show(volume, signal);
    this.#loading = null;
    this.#isCurrent = true;
    this.#setProgress(null);
    presenter.announce(optics);
  }

  async #end(done: boolean, wanted: ScanTarget, signal: AbortSignal): Promise<void> {
    if (signal.aborted) return;
    await this.parts.presenter.endLoad(done);
    if (!this.#scans) this.parts.playback.giveUp();
    this.#scans?.settled(done);
    if (wanted !== this.#wanted) this.showWanted();
  }

  /** Load a volume again that does not fit into the GPU's memory, now reduced to a quarter. */
  #loadSmaller(volume: Volume, error: unknown): void {
    const { byteLength } = volume.samples;
    const isTooLarge = error instanceof VolumeViewError && error.code === 'format/too-large';
    if (!isTooLarge || isPolar(volume) || byteLength < minReduced) throw error;
    this.#maxBytes = byteLength / 4;
    this.load();
  }

  #open(source: Source, wanted: ScanTarget, signal: AbortSignal, onProgress: LoadProgressListener): Promise<Volume> {
    return openSource(
      source,
      {
        load: (request, options) =>
          loads.run(
            () => this.host.inSight,
            options.signal,
            (lend) =>
              this.#loadShared(request, {
                ...options,
                onProgress: (progress) => (progress.isStill ? lend() : options.onProgress(progress)),
              }),
          ),
        opened: (player) => {
          this.#scans = player;
          this.parts.playback.follow(player, this.host.settings.autoplay);
        },
        go: (index) => this.showScan(index),
        shown: (scan) => this.host.emit('time-change', scan),
        changed: () => this.host.scansChanged(),
        giveUp: () => this.parts.playback.pause(),
      },
      {
        wanted,
        signal,
        onProgress,
        onCoarse: (coarse) =>
          coarse
            ? void (this.#standIn = this.parts.presenter.showCoarse(coarse, signal))
            : this.host.scenes.warmUp('radar'),
      },
    );
  }

  async #loadShared(request: SourceRequest, options: LoadOptions): Promise<Volume> {
    const { source, local } = this.host.settings;
    const reader = source && (await loadPart(import('../loading/read-source.ts'), 'reads attributes'));
    options.signal.throwIfAborted();
    const limits = this.#askLimits();
    limits.catch(() => {}); // The load that waits for it reports the error, if there is such a load.
    const load = (whole: LoadRequest): Promise<Volume> =>
      sharedVolumes.get(this, whole, { ...options, fetch: this.host.host.fetch });
    const settings = reader?.readSource(source!);
    const whole = { ...request, local, settings, limits, maxBytes: this.#maxBytes, finer: true };
    const volume = await load(whole);
    return volume.levels
      ? (await loadPart(import('../loading/brick-view.ts'), 'reads bricks')).follow(volume, whole, this, load)
      : volume;
  }

  /** After a moment: the first context takes long to create, and the file starts to load meanwhile. */
  async #askLimits(): Promise<DeviceLimits> {
    const maxBytes = this.#maxBytes;
    await new Promise((resolve) => setTimeout(resolve));
    return deviceLimits(probeDevice(), maxBytes);
  }

  #onProgress(progress: LoadProgress, signal: AbortSignal): void {
    if (signal.aborted) return;
    // While scans play, a progress bar that comes and goes with each of them would disturb.
    if (!this.#scans || this.parts.playback.paused) this.#setProgress(progress);
    this.host.emit('progress', progress);
  }

  #setProgress(progress: LoadProgress | null): void {
    if (progress === this.#progress) return;
    this.#progress = progress;
    // Of many small files, some may be decoded while the counts of others are still 0: the volume is coming all the same.
    if (!progress || progress.loaded || progress.phase !== 'fetch') this.parts.presenter.viewer?.expect(!!progress);
    this.host.changed();
  }
}
