import type { WorkerReport, WorkerStop } from './worker-messages.ts';

/** Milliseconds that a worker without an order is kept, and that one may take to stop: a busy decoder hears nothing. */
const [idleMs, stopMs] = [30_000, 500];

/** The worker that no load has. */
let spare: { readonly worker: Worker; readonly source: unknown; readonly isFree: boolean } | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;

/** Takes the worker that was started from this source and is free, if there is one. */
export function takeSpare(source: unknown): Worker | undefined {
  if (!spare?.isFree || spare.source !== source) return;
  const { worker } = spare;
  forget();
  return worker;
}

/**
 * Keeps a worker for the next load, and ends it if none comes. Only the last one is kept.
 * @param source - what it was started from
 * @param isFree - whether it has no order. If false, it receives the message to stop, and is ended if it does not answer
 * soon. If undefined, it is ended now: of one that lacks memory, or a part that could not be loaded, the next load would
 * not get more
 */
export function keepSpare(worker: Worker, source: unknown, isFree?: boolean): void {
  if (isFree === undefined) return worker.terminate();
  endSpare();
  spare = { worker, source, isFree };
  timer = setTimeout(endSpare, isFree ? idleMs : stopMs);
  worker.onerror = endSpare;
  worker.onmessage = ({ data }: MessageEvent<WorkerReport>) => {
    if (data.type !== 'stopped') return;
    forget();
    keepSpare(worker, source, true);
  };
  if (!isFree) worker.postMessage({ stop: true } satisfies WorkerStop);
}

/** Ends the worker that no load has. */
export function endSpare(): void {
  spare?.worker.terminate();
  forget();
}

function forget(): void {
  clearTimeout(timer);
  spare = undefined;
}
