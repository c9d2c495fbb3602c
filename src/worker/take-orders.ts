// The worker's side of a load: one order after another, each with the device's limits, and reports of it. The page says
// when it gives up an order, and terminates a worker that does not answer.
import { asVolumeViewError } from '../core/errors.ts';
import type { Volume } from '../volume/volume.ts';
import { decodeRequest } from './decode-request.ts';
import { loadReader } from '../formats/base/load-reader.ts';
import type { DeviceLimits, LoadProgress } from '../formats/base/load-request.ts';
import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';
import type { Report, WorkerAnswer, WorkerLimits, WorkerOrder, WorkerReport, WorkerStop } from './worker-messages.ts';

/** Minimum milliseconds between two progress messages. */
const reportEveryMs = 40;

/** The part of a worker's global scope that is used here. The compiler is set up for pages and does not know it. */
export interface WorkerScope {
  onmessage: ((event: MessageEvent<WorkerOrder | WorkerLimits | WorkerStop>) => void) | null;
  postMessage(message: WorkerAnswer, transfer?: Transferable[]): void;
}

/** Takes the orders that come to a worker. */
export function takeOrders(worker: WorkerScope): void {
  let order = new AbortController();
  let work = Promise.resolve();
  let resolveLimits: (limits: DeviceLimits) => void;
  worker.onmessage = ({ data }) => {
    if ('limits' in data) resolveLimits(data.limits);
    else if ('request' in data) {
      const mine = (order = new AbortController());
      const { signal } = mine;
      const limits = new Promise<DeviceLimits>((resolve) => (resolveLimits = resolve));
      // What an order leaves running is not heard any more: the next one may have begun.
      const report: Report = (message, transfer) => signal.aborted || worker.postMessage(message, transfer);
      work = runOrder(data, limits, signal, report).finally(() => mine.abort());
    } else {
      order.abort();
      // If it waits for its limits, the page ends this worker.
      void work.then(() => worker.postMessage({ type: 'stopped' }));
    }
  };
  worker.postMessage({ type: 'ready' });
}

async function runOrder(
  { request, pageOrigin, port }: WorkerOrder,
  limits: Promise<DeviceLimits>,
  signal: AbortSignal,
  report: Report,
): Promise<void> {
  try {
    const environment = {
      signal,
      pageOrigin,
      fetch: port && (await loadReader(() => import('#rare/worker/page-fetch.ts'))).fetchOnPage(port),
      onProgress: throttle(report),
    };
    if ('surface' in request)
      return await (
        await loadReader(() => import('#rare/worker/decode-surface.ts'))
      ).runOther(request, environment, report);
    if ('bricks' in request)
      return await (await loadReader(() => import('#rare/worker/serve-bricks.ts'))).runOther(request, environment);
    const volume = await decodeRequest(
      { ...request, limits },
      {
        ...environment,
        onScans: (times, data) => report({ type: 'scans', times, data }),
        onCoarse: (coarse) => report({ type: 'coarse', coarse }, coarse ? listBuffers(coarse.volume) : undefined),
      },
    );
    report({ type: 'done', volume }, [...listBuffers(volume), volume.histogram.counts.buffer as ArrayBuffer]);
  } catch (error) {
    report(error instanceof NeedsMainThread ? { type: 'needs-main-thread' } : describeFailure(error, request.url));
  }
}

/** The buffers that are transferred to the page instead of copied. */
function listBuffers({ samples, macrocells }: Volume): ArrayBuffer[] {
  return [samples.buffer, macrocells.low.buffer, macrocells.high.buffer, macrocells.roughness.buffer];
}

function describeFailure(error: unknown, url: string): WorkerReport {
  const { code, message, cause } = asVolumeViewError(error, `the file ${url.slice(0, 200)}`);
  return { type: 'failed', code, message, cause: cause instanceof Error ? String(cause) : undefined };
}

/**
 * A message that was held back is sent a little later, so that a stalled transfer shows how far it came. It is sent
 * before another phase begins, so that each phase is reported to its end.
 */
function throttle(report: Report): (progress: LoadProgress) => void {
  let last = -Infinity;
  let held: LoadProgress | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const send = (progress: LoadProgress): void => {
    held = null;
    last = performance.now();
    report({ type: 'progress', progress });
  };
  return (progress) => {
    clearTimeout(timer);
    if (held && held.phase !== progress.phase) send(held);
    const isEnd = progress.loaded === 0 || progress.loaded === progress.total;
    const wait = isEnd ? 0 : last + reportEveryMs - performance.now();
    if (wait <= 0) return send(progress);
    held = progress;
    timer = setTimeout(send, wait, progress);
  };
}
