// Asks workers for what a web server would have under the paths of the stone's folder.

/**
 * @param {number} count - of workers
 * @param {number} [more] - levels that are finer than the stone's own
 * @returns {{ ask: (path: string, signal?: AbortSignal | null) => Promise<string | Uint8Array<ArrayBuffer> | null>, close: () => void }} `ask` resolves with null for
 *   nothing, and rejects when the signal stops it
 */
export function startWorkers(count, more = 0) {
  /** Questions that wait for a worker: each gets one, and returns whether it needs it. @type {((worker: Worker) => boolean)[]} */
  const waiting = [];
  const workers = Array.from({ length: count }, () => new Worker(new URL('stone.js', import.meta.url)));
  for (const worker of workers) worker.postMessage(more);
  const idle = [...workers];
  const next = () => {
    while (idle.length > 0 && waiting.length > 0) if (waiting.shift()?.(idle[0])) idle.shift();
  };
  return {
    ask: (path, signal) =>
      new Promise((resolve, reject) => {
        signal?.addEventListener('abort', () => reject(signal.reason));
        waiting.push((worker) => {
          if (signal?.aborted) return false;
          worker.onmessage = ({ data }) => {
            resolve(data);
            idle.push(worker);
            next();
          };
          worker.postMessage(path);
          return true;
        });
        next();
      }),
    close: () => workers.forEach((worker) => worker.terminate()),
  };
}
