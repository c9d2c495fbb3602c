/** Work that callers may wait for, and that may start more work. */
export class PendingWork {
  #last: Promise<unknown> = Promise.resolve();

  /** @param work - does not reject */
  track(work: Promise<unknown>): void {
    this.#last = Promise.all([this.#last, work]);
  }

  /**
   * Resolves when no work is running any longer.
   * @param comesMore - returns what may start more work, and is waited for first; null where nothing is pending
   */
  async done(comesMore: () => Promise<unknown> | null): Promise<void> {
    let seen: Promise<unknown> | null = null;
    for (let more = comesMore(); seen !== this.#last || more; more = comesMore()) {
      seen = this.#last;
      await more;
      await seen;
    }
  }
}
