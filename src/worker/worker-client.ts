import { trust } from '../core/trust.ts';
import { createWorker } from './create-worker.ts';
import { isTextSurer, listWorkerTexts } from './worker-source.ts';

/**
 * Ways to start the decode worker, the best first. Each returns a worker that may still fail before its first message:
 * a Content-Security-Policy, an opaque origin or a missing file show only then. Where a browser has none, all of them fail.
 * @param dataUrl - of the file that it is to read
 */
export function listWorkerStarts(dataUrl: string): readonly (() => Promise<Worker>)[] {
  const [url, options] = findWorker();
  const isOwn = url?.origin === origin;
  const starts = isOwn ? [async () => new Worker(trust(url.href, 'createScriptURL'), options)] : [];
  // The classic script has it, which may stand in a page alone, or where scripts have no file that a worker may be; and the
  // modules for bundlers, of which some leave the file behind.
  const texts = listWorkerTexts(dataUrl).map((load) => async () => startFromText(await load()));
  if (texts.length > 0) starts[isTextSurer(url?.href) ? 'unshift' : 'push'](...texts);
  // A script of another origin, such as a CDN's, may not be a worker. A script of this page's that imports it may.
  else if (url && !isOwn) starts.push(async () => startFromText(`import ${JSON.stringify(url.href)};`, options));
  return starts;
}

/** A worker from its text, which is given back with it. */
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
 * Where the worker's script is, and of which kind. Bundlers look for exactly `new Worker(new URL(…))` and put the right address
 * there, and some make a classic script of it, but do not tell it: so the expression is run once against a stand-in that keeps
 * what it is given and starts nothing.
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
    // No address, no worker: the work is then done on the main thread.
  } finally {
    globalThis.Worker = native;
  }
  return found;
}
