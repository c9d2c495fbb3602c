// The long tasks of a page's thread, with what they waited for: a trace of the browser says what an observer of long tasks does not.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** Tasks that are named take so many milliseconds. */
const longMs = 50;

/** Calls in which the page waits for the GPU's process. */
const waits = /^(GLES2::|GLES2Implementation::Get|GLES2Implementation::Check|GpuChannelHost::CreateViewCommandBuffer)/;

/**
 * Traces what a page does. Its mark `begin` is the time 0.
 * @param {import('@playwright/test').Browser} browser
 * @param {import('@playwright/test').Page} page
 * @param {() => Promise<unknown>} act
 * @returns {Promise<{ at: number, ms: number, ownMs: number, waitMs: number, waits: string }[]>} ownMs: of a processor
 */
export async function traceTasks(browser, page, act) {
  const folder = mkdtempSync(join(tmpdir(), 'volume-view-trace-'));
  try {
    const path = join(folder, 'trace.json');
    const categories = ['devtools.timeline', 'blink.user_timing', 'toplevel', 'gpu'];
    await browser.startTracing(page, { path, categories });
    await act();
    await browser.stopTracing();
    return findTasks(JSON.parse(readFileSync(path, 'utf8')).traceEvents);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** @param {any[]} events */
function findTasks(events) {
  const begin = events.find(({ name, cat }) => name === 'begin' && cat.includes('user_timing'));
  const isMain = (/** @type {any} */ { pid, tid }) => pid === begin.pid && tid === begin.tid;
  const own = events.filter((event) => event.ph === 'X' && isMain(event));
  const tasks = own.filter(({ name, dur }) => name.endsWith('RunTask') && dur > 1000 * longMs);
  // The scheduler's tasks contain those of other names.
  tasks.sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  let end = begin.ts;
  const found = [];
  for (const task of tasks) {
    if (task.ts < end) continue;
    end = task.ts + task.dur;
    const inside = own.filter(({ ts, dur, name }) => ts >= task.ts && ts + dur <= end && waits.test(name));
    inside.sort((a, b) => b.dur - a.dur);
    found.push({
      at: (task.ts - begin.ts) / 1000,
      ms: task.dur / 1000,
      ownMs: (task.tdur ?? 0) / 1000,
      waitMs: inside.reduce((sum, { dur }) => sum + dur, 0) / 1000,
      waits: [...new Set(inside.slice(0, 4).map(({ name }) => name.split('::').at(-1)))].join(', '),
    });
  }
  return found;
}
