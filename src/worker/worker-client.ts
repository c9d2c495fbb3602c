import { trust } from '../core/trust.ts';
import { createWorker } from '#create-worker';
import { isTextSurer, listWorkerTexts } from '#worker-texts';
import { takeWorker } from './spare-worker.ts';
import type { LiveWorker } from './spare-worker.ts';

/**
 * Ways to have a decode worker, the best first: the free one, or a new one. Each returns a worker that may still fail before its first message,
 * because a Content-Security-Policy, an opaque origin or a missing file show only then. In a browser without workers
 * all of them fail.
 * @param dataUrl - URL of the file that the worker will read
 */
export function listWorkerStarts(dataUrl: string): readonly (() => Promise<LiveWorker>)[] {
  const [url, options] = findWorker();
  const href = url?.href;
  const isOwn = url?.origin === origin;
  const starts = isOwn ? [() => takeWorker(href, () => new Worker(trust(href!, 'createScriptURL'), options))] : [];
  // Two builds carry the worker's text: the classic script, which may be a page's only file, or have no file that a
  // worker may load; and the modules for bundlers, some of which leave the worker's file out.
  const texts = listWorkerTexts(dataUrl).map((load) => () => takeWorker(load, async () => startFromText(await load())));
  if (texts.length > 0) starts[isTextSurer(href) ? 'unshift' : 'push'](...texts);
  // A script of another origin, such as a CDN's, may not be a worker. A script of this page's that imports it may.
  else if (url && !isOwn)
    starts.push(() => takeWorker(href, () => startFromText(`import ${JSON.stringify(href)};`, options)));
  return starts;
}

/** Starts a worker from its text. */
export function startFromText(text: string, options?: WorkerOptions): Worker {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  const release = (): void => URL.revokeObjectURL(url);
  try {
    const worker = new Worker(trust(url, 'createScriptURL'), options);
    worker.terminate = () => {
      release();
      Worker.prototype.terminate.call(worker);
    };
    return worker;
  } catch (error) {
    release();
    throw error;
  }
}

/**
 * Finds the URL and the kind of the worker's script. Bundlers look for exactly `new Worker(new URL(…))` and insert the
 * right address there, and some change it to a classic script without saying so. So the expression runs once with a
 * stand-in for Worker, which keeps its arguments and starts nothing.
 */
function findWorker(): [url?: URL, options?: WorkerOptions] {
  const native = globalThis.Worker;
  let found: [URL?, WorkerOptions?] = [];
  function Recorder(url: string | URL, options?: WorkerOptions): void {
    found = [new URL(url, location.href), options];
  }
  try {
    globalThis.Worker = Recorder as unknown as typeof Worker;
    createWorker();
  } catch {
    // Without an address there is no worker: the main thread does the work.
  } finally {
    globalThis.Worker = native;
  }
  return found;
}
