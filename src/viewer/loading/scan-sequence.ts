import { VolumeViewError } from '../../core/errors.ts';
import { chooseScan } from '../../formats/base/choose-scan.ts';
import type { ScanTimes, ScanTarget } from '../../formats/base/choose-scan.ts';
import type { LoadProgressListener, LoadRequest } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import { VolumeCache } from '../model/volume-cache.ts';

/** One of several scans: a file of its own, or one that a manifest lists. */
export interface ScanSource {
  readonly url: string;
  /** Its number in the manifest. */
  readonly index?: number;
  /** ISO 8601, if it is known before the scan is loaded. */
  readonly time?: string | null;
}

/** As many as a manifest may list. */
const maxScans = 10_000;

/** Loads one scan. */
export type LoadScan = (source: Pick<LoadRequest, 'url' | 'scan'>, signal: AbortSignal, onProgress: LoadProgressListener) => Promise<Volume>;

interface RunningLoad {
  readonly controller: AbortController;
  readonly volume: Promise<Volume>;
  onProgress: LoadProgressListener;
}

const ignore = (): void => {};

/**
 * Scans, one after another in time: loaded when they are wanted, their neighbours ahead of that, and kept for a while. What
 * is neither wanted nor next to it is given up.
 */
export class ScanSequence {
  readonly #sources: readonly ScanSource[];
  readonly #load: LoadScan;
  readonly #times: (string | null | undefined)[];
  readonly #cache = new VolumeCache();
  readonly #running = new Map<number, RunningLoad>();
  #wanted = 0;

  constructor(sources: readonly ScanSource[], load: LoadScan) {
    if (sources.length > maxScans) {
      throw new VolumeViewError('attribute/invalid', `src got ${sources.length.toLocaleString('en')} files; expected at most ${maxScans.toLocaleString('en')}.`);
    }
    this.#sources = sources;
    this.#load = load;
    this.#times = sources.map(({ time }) => time);
  }

  get count(): number {
    return this.#sources.length;
  }

  /** When the scans began, as far as it is known by now. */
  get times(): (string | null)[] {
    return this.#times.map((time) => time ?? null);
  }

  /** The same, undefined for a scan that may yet tell. */
  get knownTimes(): ScanTimes {
    return this.#times;
  }

  /**
   * The number of the target scan. Scans are loaded where only they themselves know their times.
   * @throws {VolumeViewError} `attribute/invalid`, and what loading throws
   */
  async find(wanted: ScanTarget, signal: AbortSignal): Promise<number> {
    for (;;) {
      const { index, certain } = chooseScan(this.#times, wanted);
      if (certain) return index;
      await this.get(index);
      signal.throwIfAborted();
    }
  }

  has(index: number): boolean {
    return this.#cache.has(index);
  }

  /** Take in a scan that has been loaded already. */
  keep(index: number, volume: Volume): void {
    this.#cache.set(index, volume);
    this.#times[index] ??= volume.radar?.time ?? null;
  }

  /** A scan, from now on the wanted one; @throws {VolumeViewError} as loadVolume does, AbortError where another came to be wanted */
  async get(index: number, onProgress: LoadProgressListener = ignore): Promise<Volume> {
    this.#wanted = index;
    for (const [other, { controller }] of this.#running) if (!this.#isNear(other)) controller.abort();
    return this.#cache.get(index) ?? this.#start(index, onProgress).volume;
  }

  /**
   * Load the wanted scan's neighbours, the next one first, where memory has room for three such volumes.
   * @param loops - whether the first one comes after the last
   */
  async prefetch(loops: boolean): Promise<void> {
    const wanted = this.#wanted;
    const volume = this.#cache.get(wanted);
    if (!volume || !VolumeCache.holds(volume, 3)) return;
    for (const neighbour of [wanted + 1, wanted - 1]) {
      const index = this.#wrap(neighbour);
      if (index !== neighbour && !loops) continue;
      // What fails here is told when the scan is wanted.
      if (!this.#cache.has(index)) await this.#start(index).volume.catch(ignore);
      if (wanted !== this.#wanted) return;
    }
  }

  /** Give up all loading. */
  stop(): void {
    this.#wanted = -2; // Nobody's neighbour: a prefetch that is under way ends.
    for (const { controller } of this.#running.values()) controller.abort();
    this.#running.clear();
  }

  #start(index: number, onProgress?: LoadProgressListener): RunningLoad {
    const running = this.#running.get(index);
    if (running && !running.controller.signal.aborted) {
      if (onProgress) running.onProgress = onProgress;
      return running;
    }
    const controller = new AbortController();
    const load: RunningLoad = { controller, volume: this.#run(index, controller.signal), onProgress: onProgress ?? ignore };
    this.#running.set(index, load);
    load.volume.catch(ignore).finally(() => {
      if (this.#running.get(index) === load) this.#running.delete(index);
    });
    return load;
  }

  async #run(index: number, signal: AbortSignal): Promise<Volume> {
    const { url, index: number } = this.#sources[index];
    const request = number === undefined ? { url } : { url, scan: { index: number } };
    const volume = await this.#load(request, signal, (progress) => this.#running.get(index)?.onProgress(progress));
    signal.throwIfAborted();
    this.keep(index, volume);
    return volume;
  }

  /** Whether a scan is the wanted one or next to it, the first being next to the last. */
  #isNear(index: number): boolean {
    return [-1, 0, 1].some((step) => this.#wrap(this.#wanted + step) === index);
  }

  #wrap(index: number): number {
    return (index + this.count) % this.count;
  }
}
