/**
 * Resolves a millisecond later, so that the page can do other work first. Where timers follow each other, browsers make each wait for
 * 4 ms or more (HTML standard, timers), but not tasks. Older browsers have no such tasks.
 */
export function later(): Promise<void> {
  const page: { scheduler?: Scheduler } = globalThis;
  return page.scheduler?.postTask(() => {}, { delay: 1 }) ?? new Promise((resolve) => setTimeout(resolve, 1));
}
