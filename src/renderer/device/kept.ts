/** A value that is made again only when its key changes. */
export class Kept<T> {
  last: T | null = null;
  #key: readonly unknown[] = [];

  /** @param make - makes the value; it gets the previous value, whose texture it may fill again */
  get(key: readonly unknown[], make: (last: T | null) => T): T {
    const isSame = key.length === this.#key.length && key.every((part, i) => part === this.#key[i]);
    if (this.last === null || !isSame) this.last = make(this.last);
    this.#key = key;
    return this.last;
  }
}
