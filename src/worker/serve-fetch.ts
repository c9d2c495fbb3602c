// What a worker has of the page besides its orders: fetches with a function of the page, which may add tokens, and chosen
// files, where there are many. Loaded when it is needed.
import { VolumeViewError } from '../core/errors.ts';
import type { FetchAnswer, FetchOrder } from './page-fetch.ts';
import { sendFiles } from './send-files.ts';
import type { LiveWorker } from './spare-worker.ts';
import type { WorkerOrder, WorkerStop } from './worker-messages.ts';

/**
 * The function of a page, checked: what it throws, or gives in place of a response, is an error in words.
 * @param ask - whatever a script has set
 */
export function checkedFetch(ask: typeof fetch): typeof fetch {
  if (typeof ask !== 'function')
    throw new VolumeViewError(
      'attribute/invalid',
      `fetch got ${typeof ask}; expected a function like the browser's own fetch.`,
    );
  return async (url, options) => {
    let answer: unknown;
    try {
      answer = await ask.call(undefined, url, options);
    } catch (cause) {
      options?.signal?.throwIfAborted();
      throw new VolumeViewError(
        'source/unavailable',
        `the function that the page has set as fetch has failed: ${String(cause).slice(0, 200)}`,
        { cause },
      );
    }
    if (answer instanceof Response) return answer;
    throw new VolumeViewError(
      'attribute/invalid',
      "fetch got a function that gives no Response; expected one like the browser's own fetch.",
    );
  };
}

/**
 * Ways to have a worker: with the first order that it gets, it can ask the page for files, and gets many chosen files in
 * groups.
 * @param ask - the page's own function, if it has one
 * @param signal - of the load
 */
export function withPage(
  starts: readonly (() => Promise<LiveWorker>)[],
  ask: typeof fetch | null | undefined,
  signal: AbortSignal,
): readonly (() => Promise<LiveWorker>)[] {
  const checked = ask && checkedFetch(ask);
  return starts.map((start) => async () => {
    const worker = await start();
    worker.postMessage = (order: WorkerOrder | WorkerStop) => {
      // From now on it is the browser's own again.
      Reflect.deleteProperty(worker, 'postMessage');
      // The load may be given up before it has begun.
      if ('stop' in order) return worker.postMessage(order);
      const port = checked ? serveFetch(checked, signal) : undefined;
      const request = sendFiles(order.request, signal);
      const rest = 'local' in request ? request.local?.rest : undefined;
      const bricks = 'bricks' in request ? request.bricks : undefined;
      worker.postMessage(
        { ...order, request, port } satisfies WorkerOrder,
        [port, rest, bricks].filter((one) => one !== undefined),
      );
    };
    return worker;
  });
}

/**
 * Answers what a worker asks for.
 * @param signal - ends all that is on its way
 * @returns the worker's end
 */
function serveFetch(checked: typeof fetch, signal: AbortSignal): MessagePort {
  const { port1, port2 } = new MessageChannel();
  const running = new Map<number, AbortController>();
  const send = (answer: FetchAnswer, transfer: Transferable[] = []): void => port1.postMessage(answer, transfer);
  const answer = async ({ id, url, headers, credentials }: Extract<FetchOrder, { url: string }>): Promise<void> => {
    const mine = new AbortController();
    running.set(id, mine);
    try {
      const response = await checked(url, { headers, credentials, signal: mine.signal });
      const { status, statusText, url: from } = response;
      send({ id, head: { status, statusText, headers: [...response.headers], url: from } });
      const reader = response.body?.getReader();
      for (;;) {
        const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
        if (done || !value) break;
        // A part of a larger buffer is copied: the rest of it belongs to others.
        const piece = value.byteLength === value.buffer.byteLength ? value : value.slice();
        send({ id, piece }, [piece.buffer]);
      }
      send({ id, end: true });
    } catch (error) {
      const { code, message } = error instanceof VolumeViewError ? error : { code: undefined, message: String(error) };
      send({ id, failure: { code, message } });
    } finally {
      running.delete(id);
    }
  };
  port1.onmessage = ({ data }: MessageEvent<FetchOrder>) => {
    if ('url' in data) void answer(data);
    else running.get(data.id)?.abort();
  };
  signal.addEventListener('abort', () => {
    running.forEach((one) => one.abort());
    port1.close();
  });
  return port2;
}
