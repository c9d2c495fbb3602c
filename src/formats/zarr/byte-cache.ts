/** What a key that stands for nothing takes: the key and its place in the list. */
const emptyBytes = 256;

/** Keeps what was used last, up to so many bytes. */
export class ByteCache<T extends ArrayBufferView> {
  readonly #kept = new Map<string, T | null>();
  #bytes = 0;

  constructor(readonly maxBytes: number) {}

  /** Bytes that are kept. */
  get bytes(): number {
    return this.#bytes;
  }

  /** Null for what is known to be nothing; undefined for what is not kept. */
  get(key: string): T | null | undefined {
    const value = this.#kept.get(key);
    if (value === undefined) return undefined;
    this.#kept.delete(key);
    this.#kept.set(key, value);
    return value;
  }

  /** What is too large is not kept. */
  set(key: string, value: T | null): void {
    this.#drop(key);
    if (costOf(value) > this.maxBytes) return;
    this.#kept.set(key, value);
    this.#bytes += costOf(value);
    for (const oldest of this.#kept.keys()) {
      if (this.#bytes <= this.maxBytes) break;
      this.#drop(oldest);
    }
  }

  #drop(key: string): void {
    const value = this.#kept.get(key);
    if (value === undefined) return;
    this.#kept.delete(key);
    this.#bytes -= costOf(value);
  }
}

const costOf = (value: ArrayBufferView | null): number => emptyBytes + (value?.byteLength ?? 0);
