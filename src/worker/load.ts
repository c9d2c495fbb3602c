import { VolumeViewError } from '../core/errors.ts';
import { loadPart } from '../core/load-part.ts';
import type { Volume } from '../volume/volume.ts';
import type { CoarseListener, LoadProgressListener, LoadRequest, ScansListener } from '../formats/base/load-request.ts';
import { keepWorker } from './spare-worker.ts';
import type { LiveWorker } from './spare-worker.ts';
import { listWorkerStarts } from './worker-client.ts';
import { watchLoad } from './watch-load.ts';
import type { WorkerLimits, WorkerOrder, WorkerReport } from './worker-messages.ts';

export type {
  CoarseVolume,
  DeviceLimits,
  LoadProgress,
  LoadProgressListener,
  LoadRequest,
} from '../formats/base/load-request.ts';

export interface LoadOptions {
  /** Stops the work at once; the promise is rejected with its reason. */
  readonly signal: AbortSignal;
  readonly onProgress: LoadProgressListener;
  /** Fetches in place of the browser's own function, which is used if undefined. */
  readonly fetch?: typeof globalThis.fetch | null;
  readonly onScans?: ScansListener;
  /** Receives a small stand-in for a large volume, before the volume itself is ready. */
  readonly onCoarse?: CoarseListener;
}

/** A worker that read more bytes is not kept: engines return its memory late, unless it ends. */
const maxKeptBytes = 2 ** 22;

/** To send more chosen files than this at once takes the page longer than a frame: the browser looks at each. */
const many = 48;

/** Resolves a worker's task that has to run on the main thread. */
const notHere = Symbol('not in a worker');

/**
 * Loads a volume: fetched, decoded and fitted to the device in a worker, or on this thread if the page allows no
 * worker.
 * @throws {VolumeViewError} `source/…`, `format/…`, `mosaic/layout`, `manifest/invalid`, `internal`; the signal's
 * reason
 */
export async function loadVolume(request: LoadRequest, options: LoadOptions): Promise<Volume> {
  options.signal.throwIfAborted();
  const { limits, ...rest } = request;
  const absolute = { ...rest, url: resolveUrl(request.url), files: request.files?.map(resolveUrl) };
  return workOff({ order: { request: absolute, pageOrigin: origin }, limits }, options, (watched) =>
    loadHere({ ...absolute, limits }, watched),
  );
}

/**
 * Runs a task in a worker, or on this thread if the page allows none.
 * @param here - runs it on this thread
 */
export async function workOff<T>(
  task: WorkerTask,
  options: LoadOptions,
  here: (watched: LoadOptions) => Promise<T>,
): Promise<T> {
  const { url, local } = task.order.request as LoadRequest;
  const { end, ...watched } = watchLoad(url, options.signal, options.onProgress);
  try {
    let starts = listWorkerStarts(url);
    if (options.fetch || local?.files[many])
      starts = (await loadPart(import('./serve-fetch.ts'), 'reads files')).withPage(
        starts,
        options.fetch,
        watched.signal,
      );
    for (const start of starts) {
      const worker = await start().catch(() => null); // SecurityError: an opaque origin, or a policy that forbids workers.
      const result = worker ? await loadInWorker(worker, task, { ...options, ...watched }) : notHere;
      if (result !== notHere) return result as T;
    }
    return await here({ ...options, ...watched });
  } finally {
    end();
  }
}

export function resolveUrl(url: string): string {
  try {
    // An image named "baseURI" can hide the document's own property.
    return new URL(url, Reflect.get(Node.prototype, 'baseURI', document)).href;
  } catch (cause) {
    throw new VolumeViewError('source/not-found', `src got "${url}"; expected a URL`, { cause });
  }
}

/** The messages for a worker. */
interface WorkerTask {
  readonly order: WorkerOrder;
  /** Only for volumes. */
  readonly limits?: LoadRequest['limits'];
}

function loadInWorker(
  worker: LiveWorker,
  { order, limits }: WorkerTask,
  { signal, onProgress, onScans, onCoarse }: LoadOptions,
): Promise<unknown> {
  return new Promise((resolve, reject) => {
    let size = 0;
    let isOver = false;
    /** @param isReady - as keepWorker says; undefined for a worker that the next load must not have */
    const end = (settle: () => void, isReady?: boolean): void => {
      if (isOver) return;
      isOver = true;
      if (isReady === undefined || size > maxKeptBytes) worker.terminate();
      else keepWorker(worker, isReady);
      settle();
    };
    const stop = (): void => end(() => reject(signal.reason as Error), false);
    if (signal.aborted) return stop();
    signal.addEventListener('abort', stop);
    worker.onmessage = ({ data }: MessageEvent<WorkerReport>) => {
      switch (data.type) {
        case 'ready':
          worker.isReady = true;
          return;
        case 'progress':
          size = Math.max(size, data.progress.loaded);
          return onProgress(data.progress);
        case 'scans':
          return onScans?.(data.times, data.data);
        case 'coarse':
          return onCoarse?.(data.coarse);
        case 'done':
          return end(() => resolve(data.volume), true);
        case 'failed':
          return end(() => reject(new VolumeViewError(data.code, data.message, data)), true);
        case 'needs-main-thread':
          return end(() => resolve(notHere));
      }
    };
    worker.onmessageerror = worker.onerror = (event: Event & { readonly message?: string }) => {
      event.preventDefault();
      // An error before the first message means that the script could not be loaded; after it, only lack of memory ends
      // a worker like this, or keeps a message from being read.
      const cause = event.message;
      end(() =>
        worker.isReady
          ? reject(
              new VolumeViewError('format/too-large', 'the decoder ran out of memory; use a smaller file', { cause }),
            )
          : resolve(notHere),
      );
    };
    // Sent at once: the page may be busy when the worker is ready.
    worker.postMessage(order);
    if (limits)
      Promise.resolve(limits).then(
        (known) => isOver || worker.postMessage({ limits: known } satisfies WorkerLimits),
        (error) => end(() => reject(error), false),
      );
  });
}

async function loadHere(request: LoadRequest, options: LoadOptions): Promise<Volume> {
  const { decodeHere } = await loadPart(import('./decode-here.ts'), 'reads files');
  return decodeHere(request, { ...options, pageOrigin: origin });
}
