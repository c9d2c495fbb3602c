import { VolumeViewError } from '../../core/errors.ts';
import { chooseScan } from '../../formats/base/choose-scan.ts';
import type { ScanTimes, ScanTarget } from '../../formats/base/choose-scan.ts';
import type { PlaceData } from '../../formats/base/scan-data.ts';
import type { LoadProgressListener, LoadRequest } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ScanSource } from '../model/scans-of-view.ts';
import { VolumeCache } from '../model/volume-cache.ts';

/** The number of scans that a manifest may list. */
const maxScans = 10_000;

/** Loads one scan. */
export type LoadScan = (
  source: Pick<LoadRequest, 'url' | 'files' | 'scan' | 'data'>,
  signal: AbortSignal,
  onProgress: LoadProgressListener,
) => Promise<Volume>;

interface RunningLoad {
  readonly controller: AbortController;
  readonly volume: Promise<Volume>;
  onProgress: LoadProgressListener;
}

const ignore = (): void => {};

/**
 * Scans in the order of time. A scan is loaded when it is requested, its neighbours in advance, and all are kept for a while.
 * Loading stops for scans that are neither requested nor next to the requested one.
 */
export class ScanSequence {
  readonly #load: LoadScan;
  readonly #times: (string | null | undefined)[];
  readonly #cache = new VolumeCache();
  readonly #running = new Map<number, RunningLoad>();
  #wanted = 0;

  constructor(
    readonly sources: readonly ScanSource[],
    load: LoadScan,
  ) {
    if (sources.length > maxScans) {
      throw new VolumeViewError(
        'attribute/invalid',
        `src got ${sources.length.toLocaleString('en')} files; expected at most ${maxScans.toLocaleString('en')}.`,
      );
    }
    this.#load = load;
    this.#times = sources.map(({ time }) => time);
  }

  get count(): number {
    return this.sources.length;
  }

  /** When the scans began, as far as it is known now. */
  get times(): (string | null)[] {
    return this.#times.map((time) => time ?? null);
  }

  /** The same, with undefined for a scan whose time may still become known. */
  get knownTimes(): ScanTimes {
    return this.#times;
  }

  /**
   * The number of the target scan. Where only the scans themselves contain their times, scans are loaded for this.
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

  /** A scan that is kept now. */
  findKept(index: number): Volume | null {
    return this.#cache.peek(index);
  }

  /**
   * Load a scan that is not to be shown, and do not keep it; or the numbers of one place in several scans, of which it is the first.
   * @throws as loadVolume does
   */
  async loadAside(
    index: number,
    signal: AbortSignal,
    onProgress: LoadProgressListener = ignore,
    place?: PlaceData,
  ): Promise<Volume> {
    const volume = await this.#request(index, signal, onProgress, place);
    if (!place) this.#learnTime(index, volume);
    return volume;
  }

  /** Keep a scan that has already been loaded. */
  keep(index: number, volume: Volume): void {
    this.#cache.set(index, volume);
    this.#learnTime(index, volume);
  }

  /** A scan may contain its time. */
  #learnTime(index: number, { radar }: Pick<Volume, 'radar'>): void {
    this.#times[index] ??= radar?.time ?? null;
  }

  /**
   * Load a scan, which is now the requested one.
   * @throws {VolumeViewError} as loadVolume does, AbortError where another one was requested meanwhile
   */
  async get(index: number, onProgress: LoadProgressListener = ignore): Promise<Volume> {
    this.#wanted = index;
    for (const [other, { controller }] of this.#running) if (!this.#isNear(other)) controller.abort();
    return this.#cache.get(index) ?? this.#start(index, onProgress).volume;
  }

  /**
   * Load the neighbours of the requested scan, the next one first, where memory has room for three such volumes.
   * @param loops - whether the first one comes after the last
   */
  async prefetch(loops: boolean): Promise<void> {
    const wanted = this.#wanted;
    const volume = this.#cache.get(wanted);
    if (!volume || !VolumeCache.holds(volume, 3)) return;
    for (const neighbour of [wanted + 1, wanted - 1]) {
      const index = this.#wrap(neighbour);
      if (index !== neighbour && !loops) continue;
      // An error here is reported when the scan is requested.
      if (!this.#cache.has(index)) await this.#start(index).volume.catch(ignore);
      if (wanted !== this.#wanted) return;
    }
  }

  /** Stop all loading. */
  stop(): void {
    this.#wanted = -2; // No scan is next to this number, so a running prefetch ends.
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
    const load: RunningLoad = {
      controller,
      volume: this.#run(index, controller.signal),
      onProgress: onProgress ?? ignore,
    };
    this.#running.set(index, load);
    load.volume.catch(ignore).finally(() => {
      if (this.#running.get(index) === load) this.#running.delete(index);
    });
    return load;
  }

  async #run(index: number, signal: AbortSignal): Promise<Volume> {
    const volume = await this.#request(index, signal, (progress) => this.#running.get(index)?.onProgress(progress));
    signal.throwIfAborted();
    this.keep(index, volume);
    return volume;
  }

  #request(index: number, signal: AbortSignal, onProgress: LoadProgressListener, place?: PlaceData): Promise<Volume> {
    const { url, files, index: number, data } = this.sources[index];
    return this.#load(
      number === undefined ? { url, files } : { url, scan: { index: number }, data: place ?? data },
      signal,
      onProgress,
    );
  }

  /** Whether a scan is the requested one or next to it; the first scan is next to the last. */
  #isNear(index: number): boolean {
    return [-1, 0, 1].some((step) => this.#wrap(this.#wanted + step) === index);
  }

  #wrap(index: number): number {
    return (index + this.count) % this.count;
  }
}
