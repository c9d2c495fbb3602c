import { loadVolume } from '../../worker/load.ts';
import type { LoadOptions } from '../../worker/load.ts';
import type { CoarseListener, LoadProgressListener, LoadRequest } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';

/** A volume that is loading, and the listeners of this load. */
interface Coming {
  /** null where it can't be shared, or was given up; an error concerns all who wait for it. */
  readonly volume: Promise<Volume | null>;
  readonly onProgress: Set<LoadProgressListener>;
  readonly onCoarse: Set<CoarseListener>;
}

/**
 * The volumes that the elements of a page show. A volume that several elements show is loaded and stored once, as browsers do with
 * images. It is loaded again for an element that requests it again, and when no element has shown it any longer.
 */
export class SharedVolumes {
  readonly #shown = new Map<object, { readonly key: string; readonly volume: Volume }>();
  readonly #coming = new Map<string, Coming>();
  /** The last request of each element: an element that repeats it wants the volume loaded again. */
  readonly #given = new WeakMap<object, string>();

  /** The number of requests with functions of their own. */
  #apart = 0;

  constructor(readonly load: typeof loadVolume) {}

  /**
   * Load a volume, or take the one that another element shows or loads.
   * @param element - the element that will show it, until it requests another volume or is released
   * @throws as loadVolume does
   */
  async get(element: object, request: LoadRequest, options: LoadOptions): Promise<Volume> {
    // What a page fetches by a function of its own is not shared: who may see it depends on the function.
    const key = JSON.stringify(request) + (options.fetch ? ++this.#apart : '');
    while (this.#given.get(element) !== key) {
      const coming = this.#coming.get(key);
      const volume = this.#find(key) ?? (coming && (await join(coming, options)));
      if (volume) return this.#hold(element, key, volume);
      if (!coming) break;
    }
    return this.#loadNew(element, key, request, options);
  }

  /** An element no longer shows anything. */
  release(element: object): void {
    this.#shown.delete(element);
  }

  #find(key: string): Volume | null {
    for (const shown of this.#shown.values()) if (shown.key === key) return shown.volume;
    return null;
  }

  #hold(element: object, key: string, volume: Volume): Volume {
    this.#shown.set(element, { key, volume });
    this.#given.set(element, key);
    return volume;
  }

  async #loadNew(element: object, key: string, request: LoadRequest, options: LoadOptions): Promise<Volume> {
    const onProgress = new Set([options.onProgress]);
    const onCoarse = new Set(options.onCoarse ? [options.onCoarse] : []);
    let isApart = false;
    const loading = this.load(request, {
      ...options,
      onProgress: (progress) => onProgress.forEach((notify) => notify(progress)),
      onCoarse: (coarse) => onCoarse.forEach((notify) => notify(coarse)),
      onScans: (times, data) => {
        // Each element may show another scan.
        isApart = true;
        this.#coming.delete(key);
        options.onScans?.(times, data);
      },
    });
    const volume = loading.then(
      (loaded) => (isApart ? null : loaded),
      (error: unknown) => {
        if (options.signal.aborted || isApart) return null;
        throw error;
      },
    );
    volume.catch(() => {}); // Perhaps nobody else waits for it.
    const coming: Coming = { volume, onProgress, onCoarse };
    this.#coming.set(key, coming);
    try {
      const loaded = await loading;
      return isApart ? loaded : this.#hold(element, key, loaded);
    } finally {
      if (this.#coming.get(key) === coming) this.#coming.delete(key);
    }
  }
}

/** Wait for a volume that another element loads, and get its progress. @throws the signal's reason */
async function join(coming: Coming, { signal, onProgress, onCoarse }: LoadOptions): Promise<Volume | null> {
  coming.onProgress.add(onProgress);
  if (onCoarse) coming.onCoarse.add(onCoarse);
  try {
    return await unlessAborted(coming.volume, signal);
  } finally {
    coming.onProgress.delete(onProgress);
    if (onCoarse) coming.onCoarse.delete(onCoarse);
  }
}

/** @throws the signal's reason */
function unlessAborted<T>(work: Promise<T>, signal: AbortSignal): Promise<T> {
  return new Promise((resolve, reject) => {
    const stop = (): void => reject(signal.reason as Error);
    if (signal.aborted) return stop();
    signal.addEventListener('abort', stop);
    work.then(resolve, reject);
  });
}

/** The shared volumes of this page. */
export const sharedVolumes = new SharedVolumes(loadVolume);
