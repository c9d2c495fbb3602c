import type { Budget } from './budget.ts';

/**
 * Joins the parts of one array, each from a file of its own. It allocates the array once the received files justify its
 * size. Until then it keeps the parts, so that one small file can't claim the memory of thousands.
 */
export class PartGatherer {
  #all: Uint8Array<ArrayBuffer> | null = null;
  #waiting: Uint8Array[] = [];
  #at = 0;
  readonly #size: number;
  readonly #what: string;
  readonly #budget: Budget;

  /**
   * @param size - bytes of all parts
   * @param what - for messages
   */
  constructor(size: number, what: string, budget: Budget) {
    this.#size = size;
    this.#what = what;
    this.#budget = budget;
  }

  /** Bytes received so far. */
  get length(): number {
    return this.#at + this.#waiting.reduce((sum, { length }) => sum + length, 0);
  }

  /** @param part - bytes that the caller took from the budget; they are given back when they are copied */
  add(part: Uint8Array): void {
    this.#waiting.push(part);
    if (this.#all || this.#size <= this.#budget.leftBytes) this.#move();
  }

  /** All parts, followed by zeros if some are missing. @throws {VolumeViewError} `format/too-large` */
  finish(): Uint8Array<ArrayBuffer> {
    return this.#move();
  }

  #move(): Uint8Array<ArrayBuffer> {
    if (!this.#all) {
      this.#budget.take(this.#size, this.#what);
      this.#all = new Uint8Array(this.#size);
    }
    for (const part of this.#waiting.splice(0)) {
      this.#all.set(part, this.#at);
      this.#at += part.length;
      this.#budget.giveBack(part.length);
    }
    return this.#all;
  }
}
