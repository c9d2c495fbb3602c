/** Something that is made again only when what it depends on changes. */
export class Kept<T> {
  last: T | null = null;
  #key: readonly unknown[] = [];

  /** @param make - from what there was before, whose texture it may fill again */
  get(key: readonly unknown[], make: (last: T | null) => T): T {
    const isSame = key.length === this.#key.length && key.every((part, i) => part === this.#key[i]);
    if (this.last === null || !isSame) this.last = make(this.last);
    this.#key = key;
    return this.last;
  }
}
