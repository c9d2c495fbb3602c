/** Work that several wait for: it is given up when none of them waits any longer. */
export class SharedWork<T> {
  readonly #controller = new AbortController();
  readonly #result: Promise<T>;
  #users = 0;
  #isOver = false;

  /**
   * @param start - begins at once
   * @param onEnd - called once, when the work is done, has failed, or was given up: nobody may begin to wait for it after that
   */
  constructor(
    start: (signal: AbortSignal) => Promise<T>,
    private readonly onEnd: () => void,
  ) {
    this.#result = start(this.#controller.signal).finally(() => this.#end());
    // Those who wait hear of it; that there may be none of them is no fault.
    this.#result.catch(() => undefined);
  }

  /** Begins to wait: who calls this must leave later. The result is for those who wait. */
  join(): Promise<T> {
    this.#users++;
    return this.#result;
  }

  /** Waits no longer. @param reason - that the work is given up with if nobody waits any longer, and it is not done */
  leave(reason: unknown): void {
    if (--this.#users > 0 || this.#isOver) return;
    this.#controller.abort(reason);
    this.#end();
  }

  #end(): void {
    if (this.#isOver) return;
    this.#isOver = true;
    this.onEnd();
  }
}

/** Waits for something that goes on by itself, but no longer than until the signal. @throws what it throws; the signal's reason */
export function untilAborted<T>(result: Promise<T>, signal: AbortSignal): Promise<T> {
  return new Promise((resolve, reject) => {
    const stop = (): void => reject(signal.reason as Error);
    if (signal.aborted) stop();
    else signal.addEventListener('abort', stop, { once: true });
    void result.then(resolve, reject).finally(() => signal.removeEventListener('abort', stop));
  });
}
