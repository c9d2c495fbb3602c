import type { WorkerAnswer, WorkerStop } from './worker-messages.ts';

/** Milliseconds that a worker without an order is kept, and that one may take to stop: a busy decoder hears nothing. */
const [idleMs, stopMs] = [30_000, 500];

/** A worker that takes one order after another. */
export interface LiveWorker extends Worker {
  /** What it was started from. */
  readonly source: unknown;
  /** Whether its script has run, and it works for no load that was given up. */
  isReady?: boolean;
}

/** The worker that no load has. */
let spare: LiveWorker | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;

/**
 * The worker that was started from this source and is ready, if there is one, else a new one.
 * @throws what `start` throws
 */
export async function takeWorker(source: unknown, start: () => Worker | Promise<Worker>): Promise<LiveWorker> {
  const worker = spare;
  if (!worker?.isReady || worker.source !== source) return Object.assign(await start(), { source });
  endSpare(worker);
  return worker;
}

/**
 * Keeps a worker for the next load, and ends it if none comes. Only the last one is kept.
 * @param isReady - false if it has an order: it receives the message to stop, and is ended if it does not answer soon
 */
export function keepWorker(worker: LiveWorker, isReady: boolean): void {
  endSpare(worker);
  spare = worker;
  timer = setTimeout(endSpare, isReady ? idleMs : stopMs);
  worker.isReady = isReady;
  worker.onerror = () => endSpare();
  worker.onmessage = ({ data }: MessageEvent<WorkerAnswer>) => {
    if (data.type === 'stopped') keepWorker(worker, true);
  };
  if (!isReady) worker.postMessage({ stop: true } satisfies WorkerStop);
}

/** Ends the worker that no load has. @param taken - does not end: a load takes it */
export function endSpare(taken?: LiveWorker): void {
  clearTimeout(timer);
  if (spare !== taken) spare?.terminate();
  spare = undefined;
}
