/** Work that is done once for what is asked for again and again; only the last is kept. */
export class LastWork<T> {
  #key: string | null = null;
  #result: Promise<T> | null = null;
  #stop = new AbortController();

  /**
   * @param key - of what is asked for
   * @param signal - of who asks; the work goes on for who asks for the same next
   * @throws what the work throws, which is begun anew when it is asked for again
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

  /** Nothing of it goes on. */
  forget(): void {
    this.#stop.abort();
    this.#stop = new AbortController();
    this.#key = null;
    this.#result = null;
  }
}
