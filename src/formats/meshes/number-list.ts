/** A list of numbers whose count is not known in advance: its memory doubles each time that it is full. */
export class NumberList<T extends Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>> {
  length = 0;
  #room: T;

  constructor(readonly make: (length: number) => T) {
    this.#room = make(1024);
  }

  push(number: number): void {
    if (this.length === this.#room.length) {
      const room = this.make(2 * this.#room.length);
      room.set(this.#room);
      this.#room = room;
    }
    this.#room[this.length++] = number;
  }

  at(index: number): number {
    return this.#room[index];
  }

  /** All of them, in a buffer of exactly their length. */
  take(): T {
    return this.#room.slice(0, this.length) as T;
  }
}

export const floatList = (): NumberList<Float32Array<ArrayBuffer>> =>
  new NumberList((length) => new Float32Array(length));
export const wholeList = (): NumberList<Uint32Array<ArrayBuffer>> =>
  new NumberList((length) => new Uint32Array(length));
