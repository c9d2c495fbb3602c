import { createWorker } from '#create-worker';

/**
 * Finds the URL and the kind of the worker's script, one for all files. Bundlers look for exactly `new Worker(new URL(…))` and insert the
 * right address there, and some change it to a classic script without saying so. So the expression runs once with a
 * stand-in for Worker, which keeps its arguments and starts nothing.
 */
export function findWorkers(_dataUrl: string): readonly [url?: URL, options?: WorkerOptions][] {
  const native = globalThis.Worker;
  let found: [URL?, WorkerOptions?] = [];
  function Recorder(url: string | URL, options?: WorkerOptions): void {
    const address = new URL(url, location.href);
    // Vite's development server adds it. The worker's parts import its script without: they would get another copy of it.
    if (address.searchParams.has('worker_file')) address.search = '';
    found = [address, options];
  }
  try {
    globalThis.Worker = Recorder as unknown as typeof Worker;
    createWorker();
  } catch {
    // Without an address there is no worker: the main thread does the work.
  } finally {
    globalThis.Worker = native;
  }
  return [found];
}
