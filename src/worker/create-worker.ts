/**
 * Bundlers look for exactly this expression and insert the right address. It has its own file, because in dist it lies
 * next to the worker.
 */
export function createWorker(): Worker {
  return new Worker(new URL('./decode-worker.ts', import.meta.url), { type: 'module' });
}
