import { existsSync, readFileSync } from 'node:fs';

/** Time between two readings, ms. */
const interval = 20;

/**
 * Follow the memory of a page's processes that is theirs alone: heap, array buffers, the workers' too. Shared memory and
 * the GPU's process are not in it. Linux tells it in /proc; elsewhere it is not known. The browser also keeps there what it has loaded, for the program that
 * follows it: over a long time browser-alone.mjs measures a page without it.
 * @param {import('@playwright/test').Browser} browser
 * @returns {Promise<{ now: () => number | null, stop: () => number | null }>} now: bytes at the moment; stop: returns the maximum of bytes beyond those at the start
 */
export async function watchMemory(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const ids = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => id);
  const before = sumPrivateBytes(ids);
  let max = before;
  const timer = setInterval(() => (max = Math.max(max ?? 0, sumPrivateBytes(ids) ?? 0)), interval);
  return {
    now: () => sumPrivateBytes(ids),
    stop() {
      clearInterval(timer);
      return max === null || before === null ? null : max - before;
    },
  };
}

/** @param {readonly number[]} ids - of processes */
function sumPrivateBytes(ids) {
  if (process.platform !== 'linux') return null;
  // A process that waits for a page may end before it gets one.
  const running = ids.filter((id) => existsSync(`/proc/${id}/status`));
  return running.reduce((sum, id) => sum + privateBytes(id), 0);
}

/** What a process has for itself alone; Linux only. @param {number | string} id @throws where it has ended */
export function privateBytes(id) {
  const [, kilobytes] = /^RssAnon:\s+(\d+) kB$/m.exec(readFileSync(`/proc/${id}/status`, 'utf8')) ?? [];
  return 1024 * Number(kilobytes ?? 0);
}
