// The worker's entry. It receives one order and the device's limits, and sends reports. The page stops it by
// terminating it.
import { asVolumeViewError } from '../core/errors.ts';
import type { Volume } from '../volume/volume.ts';
import { decodeRequest } from './decode-request.ts';
import { loadReader } from '../formats/base/load-reader.ts';
import type { DeviceLimits, LoadProgress } from '../formats/base/load-request.ts';
import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';
import type { WorkerLimits, WorkerOrder, WorkerReport } from './worker-messages.ts';

/** Minimum milliseconds between two progress messages. */
const reportEveryMs = 40;

/** The part of a worker's global scope that is used here. The compiler is set up for pages and does not know it. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<WorkerOrder | WorkerLimits>) => void) | null;
  postMessage(message: WorkerReport, transfer: Transferable[]): void;
}

const worker = globalThis as unknown as WorkerScope;
const report = (message: WorkerReport, transfer: Transferable[] = []): void => worker.postMessage(message, transfer);

let resolveLimits: (limits: DeviceLimits) => void;
const limits = new Promise<DeviceLimits>((resolve) => (resolveLimits = resolve));

worker.onmessage = ({ data }) => ('limits' in data ? resolveLimits(data.limits) : void runOrder(data));
report({ type: 'ready' });

async function runOrder({ request, pageOrigin }: WorkerOrder): Promise<void> {
  try {
    if ('surface' in request) {
      const { decodeSurface, listSurfaceBuffers } = await loadReader(() => import('#rare/worker/decode-surface.ts'));
      const surface = await decodeSurface(request, { pageOrigin, onProgress: throttle() });
      return report({ type: 'done', volume: surface }, listSurfaceBuffers(surface));
    }
    const volume = await decodeRequest(
      { ...request, limits },
      {
        pageOrigin,
        onProgress: throttle(),
        onScans: (times) => report({ type: 'scans', times }),
        onCoarse: (coarse) => report({ type: 'coarse', coarse }, coarse ? listBuffers(coarse.volume) : []),
      },
    );
    report({ type: 'done', volume }, [...listBuffers(volume), volume.histogram.counts.buffer as ArrayBuffer]);
  } catch (error) {
    if (error instanceof NeedsMainThread) report({ type: 'needs-main-thread' });
    else reportFailure(error, request.url);
  }
}

/** The buffers that are transferred to the page instead of copied. */
function listBuffers({ samples, macrocells }: Volume): ArrayBuffer[] {
  return [samples.buffer, macrocells.low.buffer, macrocells.high.buffer, macrocells.roughness.buffer];
}

function reportFailure(error: unknown, url: string): void {
  const { code, message, cause } = asVolumeViewError(error, `the file ${url.slice(0, 200)}`);
  report({ type: 'failed', code, message, cause: cause instanceof Error ? String(cause) : '' });
}

/**
 * A message that was held back is sent a little later, so that a stalled transfer shows how far it came. It is sent
 * before another phase begins, so that each phase is reported to its end.
 */
function throttle(): (progress: LoadProgress) => void {
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
