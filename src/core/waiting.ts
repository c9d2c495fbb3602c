/** Work that can pause where it yields, to wait for the GPU or for the page. */
export type Waiting<T> = Generator<void, T>;

/** Do the work without pauses. */
export function atOnce<T>(work: Waiting<T>): T {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}
