/** Bundlers look for exactly this and put the right address there. A file of its own, because in dist it lies beside the worker. */
export function createWorker(): Worker {
  return new Worker(new URL('./decode-worker.ts', import.meta.url), { type: 'module' });
}
