/** What one of those that show bricks sees of the room that they share. */
export interface SharedRoom {
  /** Bytes that it may hold. */
  readonly share: number;
  /** @param changed - called when the share has changed */
  enter(changed: () => void): void;
  leave(changed: () => void): void;
}

/** Bricks in main memory, of a view that has no place on the GPU at the moment. */
export interface KeptBricks {
  /** 0 where there are none, and while they are on the GPU. */
  readonly keptBytes: number;
  dropKept(): void;
}

/** Bytes of bricks that a page may hold at once, shared in equal parts by all that show bricks on it. */
export class BrickRoom {
  /** Those that share it, and how many bytes each of them says that it has. */
  readonly #users = new Map<() => void, number>();
  #bytes = 0;
  /** In how many parts it is divided: the most users that there were a moment ago. */
  #parts = 1;
  /** The last one that was kept comes last. */
  #kept: WeakRef<KeptBricks>[] = [];

  /** @param graceMs - when users leave, others may come at once, as where views take turns: the parts of those that stay become larger after this time */
  constructor(readonly graceMs: number) {}

  /** The largest of the numbers that its users say; what it was before they left where there are none. */
  get bytes(): number {
    return this.#bytes;
  }

  /** What each of them may hold. */
  get share(): number {
    return Math.floor(this.#bytes / this.#parts);
  }

  /**
   * @param changed - called when the share has changed: who holds more has to give it back at once
   * @param bytes - of the whole room
   */
  enter(changed: () => void, bytes: number): void {
    this.#users.set(changed, bytes);
    this.#parts = Math.max(this.#parts, this.#users.size);
    this.#tell();
  }

  leave(changed: () => void): void {
    this.#users.delete(changed);
    const divide = (): void => {
      this.#parts = Math.max(1, this.#users.size);
      this.#tell();
    };
    if (this.graceMs > 0) setTimeout(divide, this.graceMs);
    else divide();
  }

  /**
   * A view had to give its place on the GPU to another one: its bricks stay in main memory until it is back. All that are kept may have as many bytes as the
   * room; the oldest ones go first. Who is gone from the page counts no longer.
   */
  keep(bricks: KeptBricks): void {
    const all = this.#kept.map((one) => one.deref()).filter((one) => one !== undefined && one !== bricks);
    const kept = [...(all as KeptBricks[]), bricks].filter(({ keptBytes }) => keptBytes > 0);
    let bytes = 0;
    for (let n = kept.length - 1; n >= 0; n--) {
      bytes += kept[n].keptBytes;
      if (bytes > this.#bytes) kept[n].dropKept();
    }
    this.#kept = kept.filter(({ keptBytes }) => keptBytes > 0).map((one) => new WeakRef(one));
  }

  #tell(): void {
    if (this.#users.size > 0) this.#bytes = Math.max(...this.#users.values());
    for (const changed of this.#users.keys()) changed();
  }
}
