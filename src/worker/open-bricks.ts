// Reads a pyramid in bricks, in a worker that all pyramids of a page share. Loaded when it is needed.
import { VolumeViewError } from '../core/errors.ts';
import { loadPart } from '../core/load-part.ts';
import type { BrickStore } from '../formats/base/brick-store.ts';
import type { LoadRequest } from '../formats/base/load-request.ts';
import type { BricksRequest } from './brick-messages.ts';
import { connectBricks } from './connect-bricks.ts';
import { resolveUrl } from './load.ts';
import type { LiveWorker } from './spare-worker.ts';
import { listWorkerStarts } from './worker-client.ts';
import type { WorkerAnswer, WorkerOrder } from './worker-messages.ts';

export interface BricksOptions {
  /** Gives up opening it. */
  readonly signal: AbortSignal;
  /** Fetches in place of the browser's own function, which is used if undefined. */
  readonly fetch?: typeof globalThis.fetch | null;
  /** Of the ordinary volume: numbers of more than 16 bits become samples by it. */
  readonly scaling?: BricksRequest['scaling'];
}

/** The worker of all open pyramids. */
interface SharedWorker {
  /** Null where the page allows no worker. */
  readonly started: Promise<LiveWorker | null>;
  /** Ends each pyramid that is open or on its way to be. */
  readonly users: Set<(reason: Error | null) => void>;
}

let shared: SharedWorker | null = null;

/**
 * Opens what a volume was loaded from to read it in bricks. Close it when it is not shown any more.
 * @param request - of the volume @returns null for what is not read in bricks: what is no OME-Zarr, several channels, labels, voxels of a length that the page sets; and where
 * the page allows no worker
 * @throws {VolumeViewError} `source/…`, `format/…`; the signal's reason
 */
export async function openBricks(
  { limits: _ofVolume, ...request }: LoadRequest,
  { signal, fetch, scaling }: BricksOptions,
): Promise<BrickStore | null> {
  signal.throwIfAborted();
  const url = resolveUrl(request.url);
  const mine = (shared ??= shareWorker(url));
  const { port1, port2 } = new MessageChannel();
  const page = new AbortController();
  const { opened, end } = connectBricks(port1, signal, () => {
    page.abort();
    mine.users.delete(end);
    if (mine.users.size === 0) endWorker(mine);
  });
  mine.users.add(end);
  try {
    const worker = await mine.started;
    if (!worker) end(null);
    else {
      // Of this order only: those of several pyramids may be under way.
      let sender = Object.create({ postMessage: worker.postMessage.bind(worker) }) as LiveWorker;
      // Files, and what a function of the page fetches, come over ports of their own.
      if (fetch || request.local) {
        const { withPage } = await loadPart(import('./serve-fetch.ts'), 'reads files');
        sender = await withPage([async () => sender], fetch, page.signal)[0]();
      }
      const order: BricksRequest = { ...request, url, bricks: port2, scaling };
      if (!page.signal.aborted)
        sender.postMessage({ request: order, pageOrigin: origin } satisfies WorkerOrder, [port2]);
    }
  } catch (cause) {
    end(cause as Error);
  }
  return opened;
}

function shareWorker(url: string): SharedWorker {
  const users: SharedWorker['users'] = new Set();
  const endAll = (reason: Error | null): void => [...users].forEach((end) => end(reason));
  const start = async (): Promise<LiveWorker | null> => {
    const worker = await startWorker(url);
    if (!worker) return null;
    worker.onmessageerror = worker.onerror = (event: Event) => {
      event.preventDefault();
      endAll(new VolumeViewError('format/too-large', 'the decoder ran out of memory; use a smaller file'));
    };
    // It speaks of pyramids on their own ports. Here it says only that it lacks a part.
    worker.onmessage = () => endAll(null);
    return worker;
  };
  return { started: start(), users };
}

function endWorker(own: SharedWorker): void {
  if (shared === own) shared = null;
  void own.started.then((worker) => worker?.terminate());
}

/** A worker that has said that it is ready. */
async function startWorker(url: string): Promise<LiveWorker | null> {
  for (const start of listWorkerStarts(url)) {
    const worker = await start().catch(() => null); // SecurityError: an opaque origin, or a policy that forbids workers.
    if (worker && (worker.isReady || (await isReady(worker)))) return worker;
    worker?.terminate();
  }
  return null;
}

/** Whether a worker's script runs: its first message says it. */
function isReady(worker: LiveWorker): Promise<boolean> {
  return new Promise((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<WorkerAnswer>) => resolve(data.type === 'ready');
    worker.onerror = (event) => {
      event.preventDefault();
      resolve(false);
    };
  });
}
