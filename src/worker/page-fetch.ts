// The worker's end of fetches that the page does for it.
import { VolumeViewError } from '../core/errors.ts';
import type { ErrorCode } from '../core/errors.ts';

/** What the worker wants: a file, or that one is given up. */
export type FetchOrder =
  | {
      readonly id: number;
      readonly url: string;
      readonly headers?: Readonly<Record<string, string>>;
      readonly credentials?: RequestCredentials;
    }
  | { readonly id: number; readonly stop: true };

/** What the page sends of a file: the head of the answer, its bytes in pieces, and the end or a failure. */
export type FetchAnswer =
  | {
      readonly id: number;
      readonly head: {
        readonly status: number;
        readonly statusText: string;
        readonly headers: [string, string][];
        readonly url: string;
      };
    }
  | { readonly id: number; readonly piece: Uint8Array<ArrayBuffer> }
  | { readonly id: number; readonly end: true }
  | { readonly id: number; readonly failure: { readonly code?: ErrorCode; readonly message: string } };

/** Answers to these have no body. Source: Fetch Standard, 2.2.3 */
const withoutBody = [101, 103, 204, 205, 304];

interface Waiting {
  readonly resolve: (response: Response) => void;
  readonly reject: (reason: unknown) => void;
  body?: ReadableStreamDefaultController<Uint8Array>;
}

/** A function like `fetch` whose requests the page makes. @param port - to serveFetch */
export function fetchOnPage(port: MessagePort): typeof fetch {
  const waiting = new Map<number, Waiting>();
  let last = 0;
  const tell = (order: FetchOrder): void => port.postMessage(order);
  const stop = (id: number): void => {
    if (waiting.delete(id)) tell({ id, stop: true });
  };
  port.onmessage = ({ data }: MessageEvent<FetchAnswer>) => {
    const { id } = data;
    const one = waiting.get(id);
    if (!one) return;
    if ('head' in data) one.resolve(respond(one, data.head, () => stop(id)));
    else if ('piece' in data) one.body?.enqueue(data.piece);
    else {
      waiting.delete(id);
      if ('end' in data) return one.body?.close();
      const { code, message } = data.failure;
      const error = code ? new VolumeViewError(code, message) : new TypeError(message);
      one.reject(error);
      one.body?.error(error);
    }
  };
  return (url, { headers, credentials, signal } = {}) =>
    new Promise((resolve, reject) => {
      const id = ++last;
      if (signal?.aborted) return reject(signal.reason as Error);
      const one: Waiting = { resolve, reject };
      waiting.set(id, one);
      signal?.addEventListener('abort', () => {
        if (!waiting.has(id)) return;
        stop(id);
        reject(signal.reason as Error);
        one.body?.error(signal.reason);
      });
      tell({ id, url: url as string, headers: headers as Record<string, string>, credentials });
    });
}

function respond(
  one: Waiting,
  { status, statusText, headers, url }: Extract<FetchAnswer, { head: unknown }>['head'],
  stop: () => void,
): Response {
  const body = withoutBody.includes(status)
    ? null
    : new ReadableStream<Uint8Array>({
        start: (controller) => void (one.body = controller),
        cancel: stop,
      });
  // A response of an opaque kind has the status 0, which none may be made with.
  const response = new Response(body, { status: status >= 200 && status <= 599 ? status : 599, statusText, headers });
  Object.defineProperty(response, 'url', { value: url });
  return response;
}
