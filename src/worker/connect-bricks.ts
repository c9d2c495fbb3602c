import { VolumeViewError } from '../core/errors.ts';
import type { Brick } from '../bricks/pyramid.ts';
import type { BrickStore } from '../formats/base/brick-store.ts';
import type { BricksAnswer, BricksFailure, BricksOrder } from './brick-messages.ts';

/** What an order gives. */
interface Waiting {
  readonly resolve: (value: never) => void;
  readonly reject: (reason: unknown) => void;
}

/** The page's end of a pyramid. */
export interface BricksConnection {
  /** Null for what is not read in bricks. */
  readonly opened: Promise<BrickStore | null>;
  /** Ends all that is on its way, with this reason; null where nothing is read in bricks. */
  end(reason: Error | null): void;
}

/**
 * A store whose bricks are read at the other end of a port, by serveBricks.
 * @param signal - gives up opening it; later it does nothing
 * @param onEnd - called once, when the store is closed or could not be opened
 */
export function connectBricks(port: MessagePort, signal: AbortSignal, onEnd: () => void): BricksConnection {
  const waiting = new Map<number, Waiting>();
  let last = 0;
  let over: { readonly reason: Error | null } | null = null;
  let settle: { resolve(store: BrickStore | null): void; reject(reason: unknown): void };
  const opened = new Promise<BrickStore | null>((resolve, reject) => (settle = { resolve, reject }));
  // It may fail while its worker is not there yet, when nobody waits for it.
  opened.catch(() => {});
  const tell = (order: BricksOrder): void => port.postMessage(order);
  const end = (reason: Error | null): void => {
    if (over) return;
    over = { reason };
    signal.removeEventListener('abort', stop);
    tell({ close: true });
    port.onmessage = null;
    for (const { reject } of waiting.values()) reject(reason);
    waiting.clear();
    if (reason === null) settle.resolve(null);
    else settle.reject(reason);
    onEnd();
  };
  const stop = (): void => end(signal.reason as Error);
  const order = <T>(own: AbortSignal, what: { brick: Brick; isAlone?: boolean } | { residuals: true }): Promise<T> =>
    new Promise<T>((resolve, reject) => {
      own.throwIfAborted();
      if (over) throw over.reason ?? closedError();
      const id = ++last;
      const giveUp = (): void => {
        if (!waiting.delete(id)) return;
        tell({ id, stop: true });
        reject(own.reason as Error);
      };
      own.addEventListener('abort', giveUp, { once: true });
      const done = (): void => own.removeEventListener('abort', giveUp);
      waiting.set(id, {
        resolve: (value) => (done(), resolve(value)),
        reject: (reason) => (done(), reject(reason)),
      });
      tell({ id, ...what });
    });
  port.onmessage = ({ data }: MessageEvent<BricksAnswer>) => {
    if ('failed' in data) return end(errorOf(data.failed));
    if ('opened' in data) {
      signal.removeEventListener('abort', stop);
      if (!data.opened) return end(null);
      return settle.resolve({
        ...data.opened,
        read: (brick, own, isAlone) => order(own, { brick, isAlone }),
        residuals: (own) => order(own, { residuals: true }),
        close: () => end(closedError()),
      });
    }
    const one = waiting.get(data.id);
    waiting.delete(data.id);
    if ('failure' in data) one?.reject(errorOf(data.failure));
    else one?.resolve(('brick' in data ? data.brick : data.residuals) as never);
  };
  if (signal.aborted) stop();
  else signal.addEventListener('abort', stop, { once: true });
  return { opened, end };
}

const closedError = (): Error => new DOMException('the bricks are closed', 'AbortError');

const errorOf = ({ code, message }: BricksFailure): Error =>
  code ? new VolumeViewError(code, message) : closedError();
