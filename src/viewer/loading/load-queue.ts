/** The number of files that are fetched and decoded at the same time: each needs a worker, and memory for the file and for the volume. */
const maxLoads = 6;

interface Waiting {
  readonly inSight: () => boolean;
  readonly start: () => void;
}

/** Queue of loads: those of visible elements start first, then the others in the order in which they came. */
export class LoadQueue {
  #running = 0;
  /** Number of running loads that have lent their place. */
  #lent = 0;
  #waiting: Waiting[] = [];

  constructor(readonly max: number) {}

  /**
   * Load something when it is its turn.
   * @param inSight - whether the element that shows it is in the visible part of the page at that time
   * @param signal - ends the waiting, with its reason
   * @param load - may lend its place while it waits for data. The number of lent places is limited, so that at most twice as many
   * loads run
   */
  async run<T>(inSight: () => boolean, signal: AbortSignal, load: (lend: () => void) => Promise<T>): Promise<T> {
    if (this.#running >= this.max) await this.#wait(inSight, signal);
    else this.#running++;
    let isLent = false;
    const lend = (): void => {
      if (isLent || this.#lent >= this.max) return;
      isLent = true;
      this.#lent++;
      this.#leave();
    };
    try {
      return await load(lend);
    } finally {
      if (isLent) this.#lent--;
      else this.#leave();
    }
  }

  #wait(inSight: () => boolean, signal: AbortSignal): Promise<void> {
    return new Promise((resolve, reject) => {
      const giveUp = (): void => {
        this.#waiting = this.#waiting.filter((other) => other !== waiting);
        reject(signal.reason as Error);
      };
      const start = (): void => {
        this.#running++;
        resolve();
      };
      const waiting: Waiting = { inSight, start };
      signal.addEventListener('abort', giveUp); // Later than start() it changes nothing.
      this.#waiting.push(waiting);
    });
  }

  #leave(): void {
    this.#running--;
    const next = this.#waiting.find(({ inSight }) => inSight()) ?? this.#waiting[0];
    if (!next) return;
    this.#waiting = this.#waiting.filter((other) => other !== next);
    next.start();
  }
}

/** The loads of this page. */
export const loads = new LoadQueue(maxLoads);
