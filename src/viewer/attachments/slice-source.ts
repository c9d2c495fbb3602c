import { VolumeViewError } from '../../core/errors.ts';
import type { LoadProgress } from '../../formats/base/load-request.ts';
import { loads } from '../loading/load-queue.ts';
import { sharedVolumes } from '../loading/shared-volumes.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Volume } from '../../volume/volume.ts';

/** No GPU sets a limit here: the whole file is shown, as far as the memory of a page allows. */
const limits: DeviceLimits = { maxVoxelsPerAxis: 2 ** 14, maxAtlasSize: null, maxBytes: 2 ** 30 };

/** What loading needs of the pane. */
export interface SliceSourceHost {
  progress(progress: LoadProgress | null): void;
  loaded(volume: Volume): void;
  failed(error: unknown): void;
}

/** Loads the single file of a pane that stands alone; the last good volume stays until a new one is there. */
export class SliceSource {
  #url: string | null = null;
  #loading: AbortController | null = null;
  #loaded: Promise<void> = Promise.resolve();

  constructor(readonly host: SliceSourceHost) {}

  /** Resolves when the last request is loaded, has failed, or is no longer needed. */
  get loaded(): Promise<void> {
    return this.#loaded;
  }

  /** Load a file, unless it is already loaded or loading. */
  load(url: string): void {
    if (url === this.#url) return;
    this.stop();
    this.#url = url;
    const { signal } = (this.#loading = new AbortController());
    this.#loaded = this.#load(url, signal);
  }

  /** Stop loading; the next load starts from the beginning. */
  stop(): void {
    this.#loading?.abort();
    this.#url = null;
    sharedVolumes.release(this);
  }

  async #load(url: string, signal: AbortSignal): Promise<void> {
    this.host.progress({ loaded: 0, total: 0, phase: 'fetch' });
    try {
      if (url.trim().split(/\s+/).length > 1)
        throw new VolumeViewError(
          'attribute/invalid',
          'src of <volume-slice-view> names several files; it shows one. For scans in time use <volume-view>, and for="…" here.',
        );
      const onProgress = (progress: LoadProgress): void => {
        if (!signal.aborted && !progress.isStill) this.host.progress(progress);
      };
      const volume = await loads.run(
        () => true,
        signal,
        () => sharedVolumes.get(this, { url: url.trim(), limits }, { signal, onProgress }),
      );
      signal.throwIfAborted();
      this.host.progress(null);
      this.host.loaded(volume);
    } catch (error) {
      if (signal.aborted) return;
      this.#url = null;
      this.host.progress(null);
      this.host.failed(error);
    }
  }
}
