/** Keeps the result of the last work, so that the same request again and again does the work only once. */
export class LastWork<T> {
  #key: string | null = null;
  #result: Promise<T> | null = null;
  #stop = new AbortController();

  /**
   * @param key - identifies the request
   * @param signal - of the caller; it does not stop the work, which goes on for later callers with the same key
   * @throws what the work throws; the next call with the same key then starts the work again
   */
  async get(key: string, signal: AbortSignal, work: (stop: AbortSignal) => Promise<T>): Promise<T> {
    signal.throwIfAborted();
    if (key !== this.#key) {
      this.forget();
      this.#key = key;
      this.#result = work(this.#stop.signal);
    }
    const result = this.#result!;
    try {
      return await result;
    } catch (error) {
      if (this.#result === result) this.forget();
      throw error;
    }
  }

  /** Stop the work, and drop its result. */
  forget(): void {
    this.#stop.abort();
    this.#stop = new AbortController();
    this.#key = null;
    this.#result = null;
  }
}
