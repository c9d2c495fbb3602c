/** Work that may wait where it yields, for the GPU or for the page. */
export type Waiting<T> = Generator<void, T>;

/** Do it at once. */
export function atOnce<T>(work: Waiting<T>): T {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}
