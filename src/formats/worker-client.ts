import { inlineWorkerSource } from './worker-source.ts';

/**
 * Ways to start the decode worker, the best first. Each returns a worker that may still fail before its first message:
 * a Content-Security-Policy, an opaque origin or a missing file show only then.
 */
export function listWorkerStarts(): readonly (() => Worker)[] {
  if (typeof Worker === 'undefined') return [];
  if (inlineWorkerSource !== null) {
    const source = inlineWorkerSource;
    return [() => startFromText(source, {})];
  }
  const url = findWorkerUrl();
  if (!url) return [];
  // A script of another origin, such as a CDN's, may not be a worker. A script of this page's that imports it may.
  return new URL(url).origin === location.origin
    ? [() => new Worker(url, { type: 'module' })]
    : [() => startFromText(`import ${JSON.stringify(url)};`, { type: 'module' })];
}

function startFromText(text: string, options: WorkerOptions): Worker {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  const worker = new Worker(url, options);
  // The worker has been given the script once it speaks or fails; until then the address must stay.
  const release = (): void => URL.revokeObjectURL(url);
  worker.addEventListener('message', release, { once: true });
  worker.addEventListener('error', release, { once: true });
  return worker;
}

/**
 * Where the worker's script is. Bundlers look for exactly `new Worker(new URL(…))` and put the right address
 * there, but do not tell it: so the expression is run once against a stand-in that keeps the address and starts nothing.
 */
function findWorkerUrl(): string | null {
  const native = globalThis.Worker;
  let found: string | null = null;
  function Recorder(url: string | URL): void {
    found = String(url);
  }
  try {
    globalThis.Worker = Recorder as unknown as typeof Worker;
    createWorker();
  } catch {
    // No address, no worker: the work is then done on the main thread.
  } finally {
    globalThis.Worker = native;
  }
  return found && new URL(found, location.href).href;
}

/** Null in the classic script, whose build uses `inlineWorkerSource` instead of this address. */
function createWorker(): Worker | null {
  return new Worker(new URL('./decode-worker.ts', import.meta.url), { type: 'module' });
}
