/** Runs in the page before all else: notes the longest task of its main thread. */
export function watchTasks() {
  const noted = /** @type {any} */ (window);
  noted.longestTask = 0;
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) noted.longestTask = Math.max(noted.longestTask, duration);
  }).observe({ type: 'longtask' });
}
