import { VolumeViewError } from '../core/errors.ts';
import type { LoadProgressListener } from '../formats/base/load-request.ts';

/** Seconds without a byte after which other loads may start, and after which the load is ended. */
const [polite, patient] = [5, 30];

/** Seconds that a decoder may be silent (it can't report while it works): this many, and one more for so many bytes. */
const [working, bytesPerSecond] = [60, 1e6];

export interface LoadWatch {
  /** Aborts if the given signal does, or if the load stalls. */
  readonly signal: AbortSignal;
  readonly onProgress: LoadProgressListener;
  /** Call this when the load has ended. */
  readonly end: () => void;
}

/**
 * Watches a load, and aborts it if it reports nothing for too long. Only seconds in which the page runs count, not
 * those in which it sleeps.
 */
export function watchLoad(url: string, signal: AbortSignal, onProgress: LoadProgressListener): LoadWatch {
  const controller = new AbortController();
  const stop = (): void => controller.abort(signal.reason);
  signal.addEventListener('abort', stop);
  let last: Parameters<LoadProgressListener>[0] = { loaded: 0, total: 0, phase: 'fetch' };
  let silent = 0;
  const clock = setInterval(() => {
    silent++;
    const { phase, loaded, total } = last;
    const isFetching = phase === 'fetch' && (!total || loaded < total);
    if (silent === polite && isFetching) onProgress({ ...last, isStill: true });
    // A fetch of unknown length may be complete.
    if (silent < (isFetching && (total || !loaded) ? patient : working + loaded / bytesPerSecond)) return;
    controller.abort(
      new VolumeViewError(
        'source/stalled',
        `${url.slice(0, 300)} came no further for ${silent} seconds, after ${loaded} bytes; check the network, and load it again`,
      ),
    );
  }, 1000);
  return {
    signal: controller.signal,
    onProgress: (progress) => {
      silent = 0;
      onProgress((last = progress));
    },
    end: () => {
      clearInterval(clock);
      signal.removeEventListener('abort', stop);
    },
  };
}
