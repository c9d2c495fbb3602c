import { chooseScan } from '../../formats/base/choose-scan.ts';
import type { ScanTarget } from '../../formats/base/choose-scan.ts';
import type { PlaceData } from '../../formats/base/scan-data.ts';
import type { LoadProgressListener } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ScanSource, ScansOfView } from '../model/scans-of-view.ts';
import { ScanSequence } from './scan-sequence.ts';
import type { LoadScan } from './scan-sequence.ts';

/** One of several scans, as pages get it in events. */
export interface TimeChangeDetail {
  /** Its number, from 0. */
  readonly index: number;
  /** When it began, ISO 8601 in UTC, or a number with its unit, `12.5 s`; null where it is not known. */
  readonly time: string | null;
  /** Number of all scans. */
  readonly count: number;
}

/** What a player needs of its element, and what it reports to it. */
export interface ScanHost {
  readonly load: LoadScan;
  /** Request that another scan is shown, by its number. */
  readonly go: (index: number) => void;
  /** Another scan is in the picture. */
  readonly shown: (scan: TimeChangeDetail) => void;
  /** Times became known, or the player started or stopped waiting for a scan. */
  readonly changed: () => void;
  /** All scans failed one after another: there is nothing to play. */
  readonly giveUp: () => void;
}

export interface PlaySettings {
  readonly on: boolean;
  /** Scans a second. */
  readonly speed: number;
}

/** A timer ends at once if its milliseconds need more than 31 bits. */
const longestWaitMs = 2 ** 31 - 1;

/** Decides which of several scans is shown, what is loaded in advance, and when the next one is due. */
export class ScanPlayer implements ScansOfView {
  readonly #sequence: ScanSequence;
  readonly #host: ScanHost;
  #settings: PlaySettings = { on: false, speed: 1 };
  /** The scan that was requested last. */
  #target = 0;
  #shown: TimeChangeDetail | null = null;
  #waiting = false;
  /** The scan that the viewer has got, but that is not in the picture yet. */
  #entering: number | null = null;
  #failures = 0;
  #lastChange = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(sources: readonly ScanSource[], host: ScanHost) {
    this.#sequence = new ScanSequence(sources, host.load);
    this.#host = host;
  }

  /** When the scans began, as far as it is known now. */
  get times(): (string | null)[] {
    return this.#sequence.times;
  }

  /** All scans, of which few are kept. */
  get sources(): readonly ScanSource[] {
    return this.#sequence.sources;
  }

  /** The scan of this number, where it is kept now. */
  findKept(index: number): Volume | null {
    return this.#sequence.findKept(index);
  }

  /** See `ScansOfView`. */
  async loadAside(
    index: number,
    signal: AbortSignal,
    onProgress?: LoadProgressListener,
    place?: PlaceData,
  ): Promise<Volume> {
    const volume = await this.#sequence.loadAside(index, signal, onProgress, place);
    this.#host.changed(); // Its time may now be known.
    return volume;
  }

  /** The scan in the picture; null before the first. */
  get shown(): TimeChangeDetail | null {
    return this.#shown;
  }

  /** Whether a scan has been requested and is not in the picture yet. */
  get waiting(): boolean {
    return this.#waiting;
  }

  /** Go to the next scan (1) or the previous one (-1). @returns whether there is one */
  step(by: number): boolean {
    const index = this.#target + by;
    if (index < 0 || index >= this.#sequence.count) return false;
    this.#go(index);
    return true;
  }

  play(settings: PlaySettings): void {
    this.#settings = settings;
    this.#schedule();
    if (settings.on && !this.#waiting) void this.#loadAhead();
  }

  /** The load of the manifest also loads this scan, or the one whose time must be known first. */
  aim(wanted: ScanTarget): this {
    this.#target = chooseScan(this.#sequence.knownTimes, wanted).index;
    return this;
  }

  /** Keep the scan that was loaded with the manifest. */
  keep(volume: Volume): void {
    this.#sequence.keep(this.#target, volume);
  }

  /** @param signal - aborted where something else is to be shown; it does not stop the loads, which belong to the sequence */
  async load(wanted: ScanTarget, signal: AbortSignal, onProgress: LoadProgressListener): Promise<Volume> {
    clearTimeout(this.#timer);
    this.#entering = null;
    this.#wait(true);
    const index = await this.#sequence.find(wanted, signal);
    signal.throwIfAborted();
    this.#target = index;
    const volume = await this.#sequence.get(index, onProgress);
    signal.throwIfAborted();
    return volume;
  }

  /** The viewer has got the loaded volume, or loading it has failed. */
  settled(done: boolean): void {
    if (done) {
      this.#entering = this.#target;
      return;
    }
    this.#failures++;
    this.#lastChange = performance.now();
    this.#wait(false);
    if (this.#settings.on && this.#failures >= this.#sequence.count) this.#host.giveUp();
    this.#schedule();
  }

  /** A picture of the viewer's present volume has been drawn. */
  drawn(): void {
    if (this.#entering === null) return;
    const index = this.#entering;
    const { times, count } = this.#sequence;
    this.#entering = null;
    this.#failures = 0;
    this.#lastChange = performance.now();
    const isAnother = index !== this.#shown?.index;
    this.#shown = { index, time: times[index], count };
    if (isAnother) this.#host.shown(this.#shown);
    this.#wait(false);
    this.#schedule();
    void this.#loadAhead();
  }

  /** The element is gone: stop everything. */
  stop(): void {
    clearTimeout(this.#timer);
    this.#sequence.stop();
    this.#entering = null;
    this.#waiting = false;
  }

  #go(index: number): void {
    this.#target = index;
    this.#host.go(index);
  }

  #schedule(): void {
    clearTimeout(this.#timer);
    const { on, speed } = this.#settings;
    if (!on || this.#waiting || this.#sequence.count < 2) return;
    const due = this.#lastChange + 1000 / speed - performance.now();
    this.#timer = setTimeout(
      () => this.#go((this.#target + 1) % this.#sequence.count),
      Math.min(longestWaitMs, Math.max(0, due)),
    );
  }

  async #loadAhead(): Promise<void> {
    await this.#sequence.prefetch(this.#settings.on);
    this.#host.changed(); // The times of the loaded scans are now known.
  }

  #wait(waiting: boolean): void {
    this.#waiting = waiting;
    this.#host.changed();
  }
}
