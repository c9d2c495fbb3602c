/** Timers that end when the test says that time passes. */
export class FakeTimers {
  #now = 0;
  #last = 0;
  readonly #waiting = new Map<number, { readonly due: number; readonly act: () => void }>();

  /** Run with these timers in place of setTimeout. */
  async run<T>(work: (timers: this) => T | Promise<T>): Promise<T> {
    const { setTimeout, clearTimeout } = globalThis;
    Object.assign(globalThis, {
      setTimeout: (act: () => void, ms = 0) => {
        this.#waiting.set(++this.#last, { due: this.#now + ms, act });
        return this.#last;
      },
      clearTimeout: (id: number) => void this.#waiting.delete(id),
    });
    try {
      return await work(this);
    } finally {
      Object.assign(globalThis, { setTimeout, clearTimeout });
    }
  }

  /** The number of timers that wait. */
  get count(): number {
    return this.#waiting.size;
  }

  pass(ms: number): void {
    this.#now += ms;
    for (const [id, { due, act }] of this.#waiting) {
      if (due > this.#now) continue;
      this.#waiting.delete(id);
      act();
    }
  }
}
