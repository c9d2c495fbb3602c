// The worker's side of a pyramid that is read in bricks. Loaded when it is needed.
import { asVolumeViewError } from '../core/errors.ts';
import type { BrickStore } from '../formats/base/brick-store.ts';
import { loadReader } from '../formats/base/load-reader.ts';
import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';
import type { OpenTree } from '../formats/zarr/brick-trees.ts';
import { Queue } from '../formats/base/queue.ts';
import { isZarr } from '../sources/is-zarr.ts';
import type { BricksAnswer, BricksFailure, BricksOrder, BricksRequest, OpenedBricks } from './brick-messages.ts';

/** Requests of all pyramids of a page together. */
const requests = new Queue(8);

interface Environment {
  readonly pageOrigin: string;
  /** Fetches in place of the browser's own function, which is used if undefined. */
  readonly fetch?: typeof globalThis.fetch | null;
}

/** Opens a pyramid and reads bricks of it until the page closes it. */
export function runOther(request: BricksRequest, environment: Environment): Promise<void> {
  return serveBricks(request.bricks, (signal) => openBricks(request, environment, signal));
}

async function openBricks(
  request: BricksRequest,
  { pageOrigin, fetch }: Environment,
  signal: AbortSignal,
): Promise<BrickStore | null> {
  const { url, local, files, scan, scaling } = request;
  if (files?.[1] || (!local && !isZarr(url))) return null;
  const settings = { ...request.settings, scan };
  const load = { request: { limits: endless, settings }, onProgress: () => undefined };
  const [{ openFiles }, { takeTree }, { openZarrBricks }] = await loadReader(() =>
    Promise.all([
      import('#rare/sources/open-files.ts'),
      import('#rare/formats/zarr/brick-trees.ts'),
      import('#rare/formats/zarr/zarr-bricks.ts'),
    ]),
  );
  const { credentials } = settings;
  const open: OpenTree = (until) =>
    openFiles(local ?? url, { isStack: false, load, signal: until }, { pageOrigin, fetch, credentials, signal: until });
  // What a function of a page fetches, and files that a person chose, are those of one view.
  const key = local || fetch ? null : JSON.stringify([url, settings]);
  const tree = await takeTree(key, { open, requests }, signal);
  return tree && openZarrBricks(tree, settings, { signal, scaling });
}

/** No volume is made here that a device would have to hold. */
const endless = { maxVoxelsPerAxis: Infinity, maxAtlasSize: null, maxBytes: Infinity };

/**
 * Answers orders for bricks until the last one.
 * @param open - its signal gives it up; null for what is not read in bricks
 */
export async function serveBricks(
  port: MessagePort,
  open: (signal: AbortSignal) => Promise<BrickStore | null>,
): Promise<void> {
  const closed = new AbortController();
  const running = new Map<number, AbortController>();
  let store: BrickStore | null = null;
  const send = (answer: BricksAnswer, transfer: Transferable[] = []): void => {
    if (!closed.signal.aborted) port.postMessage(answer, transfer);
  };
  const answer = async (order: Extract<BricksOrder, { brick: unknown } | { residuals: true }>): Promise<void> => {
    const { id } = order;
    const mine = new AbortController();
    running.set(id, mine);
    try {
      if ('residuals' in order) send({ id, residuals: await store!.residuals(mine.signal) });
      else {
        const brick = await store!.read(order.brick, mine.signal, order.isAlone);
        send({ id, brick }, [brick.samples.buffer]);
      }
    } catch (error) {
      send({ id, failure: describe(error, mine.signal) });
    } finally {
      running.delete(id);
    }
  };
  const end = new Promise<void>((resolve) => closed.signal.addEventListener('abort', () => resolve()));
  port.onmessage = ({ data }: MessageEvent<BricksOrder>) => {
    if ('close' in data) closed.abort(new DOMException('the bricks are closed', 'AbortError'));
    else if ('stop' in data) running.get(data.id)?.abort(new DOMException('given up', 'AbortError'));
    else void answer(data);
  };
  try {
    store = await open(closed.signal);
    send({ opened: store && describeStore(store) });
    if (store) await end;
  } catch (error) {
    if (error instanceof NeedsMainThread) send({ opened: null });
    else send({ failed: describe(error, closed.signal) });
  } finally {
    store?.close();
    port.close();
  }
}

function describeStore({ side, type, slope, intercept, levels }: BrickStore): OpenedBricks {
  return { side, type, slope, intercept, levels };
}

function describe(error: unknown, signal: AbortSignal): BricksFailure {
  if (signal.aborted) return { message: 'given up' };
  const { code, message } = asVolumeViewError(error, 'the pyramid');
  return { code, message };
}
