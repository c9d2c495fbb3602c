/** What one of those that show bricks sees of the room that they share. */
export type SharedRoom = Pick<BrickRoom, 'share' | 'enter' | 'leave'>;

/** Bytes of bricks that a page may hold at once, shared in equal parts by all that show bricks on it. */
export class BrickRoom {
  readonly #users = new Set<() => void>();
  #bytes: number;

  /** @param bytes - of all of them */
  constructor(bytes: number) {
    this.#bytes = bytes;
  }

  get bytes(): number {
    return this.#bytes;
  }

  set bytes(bytes: number) {
    this.#bytes = bytes;
    this.#tell();
  }

  /** What each of them may hold. */
  get share(): number {
    return Math.floor(this.#bytes / Math.max(1, this.#users.size));
  }

  /** @param changed - called when the share has changed: who holds more has to give it back at once */
  enter(changed: () => void): void {
    this.#users.add(changed);
    this.#tell();
  }

  leave(changed: () => void): void {
    this.#users.delete(changed);
    this.#tell();
  }

  #tell(): void {
    for (const changed of this.#users) changed();
  }
}
