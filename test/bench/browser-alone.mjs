import { spawn } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';
import { privateBytes } from './watch-memory.mjs';

/**
 * @typedef {object} Alone
 * @property {() => number} readMemory - bytes that the processes of pages have for themselves alone, with their workers; Linux only
 * @property {() => string} readConsole - all that the browser has written, with the consoles of its pages
 * @property {Promise<void>} ended - when the page has called `report({ isOver: true })`; rejects with what it threw, or when the browser ends
 */

/**
 * Opens a page in a browser that no program follows. Playwright follows what a page loads, and so does whoever has the developer tools open: the browser then
 * keeps the body of each answer, up to 100 MB or more, in the process of the page, where it looks like a leak of the page.
 * @param {string} url - of a page; in it `gc()` collects garbage, and after `?` it gets the address for reports, to which it sends JSON
 * @param {{ take: (report: any) => void, setReports?: (address: string) => void }} reporting - take: gets each report; setReports: gets the address before the page is opened
 * @param {(alone: Alone) => Promise<void>} follow - the browser is closed after it
 */
export async function openAlone(url, { take, setReports }, follow) {
  const profile = mkdtempSync(join(tmpdir(), 'volume-view-alone-'));
  let end = () => {};
  /** @type {(reason: Error) => void} */
  let fail = () => {};
  /** @type {Promise<void>} */
  const ended = new Promise((resolve, reject) => ([end, fail] = [resolve, reject]));
  ended.catch(() => {});
  const reports = createServer((request, response) => {
    let text = '';
    request.on('data', (part) => (text += part));
    request.on('end', () => {
      response.setHeader('access-control-allow-origin', '*').end();
      const said = JSON.parse(text);
      if (said.isOver) end();
      else if (said.thrown) fail(new Error(said.thrown));
      else take(said);
    });
  });
  await new Promise((resolve) => reports.listen(0, '127.0.0.1', () => resolve(null)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (reports.address());
  const address = `http://127.0.0.1:${port}/`;
  setReports?.(address);
  const child = spawn(
    await findBrowser(),
    [
      ...listLaunchArgs(),
      ...['--headless=new', '--no-sandbox', '--no-first-run', '--enable-logging=stderr', '--js-flags=--expose-gc'],
      ...['--enable-precise-memory-info', `--user-data-dir=${profile}`, `${url}?${address}`],
    ],
    { stdio: ['ignore', 'ignore', 'pipe'] },
  );
  let lines = '';
  child.stderr.on('data', (part) => (lines += part));
  child.on('exit', (code) => fail(new Error(`the browser ended with ${code}:\n${lines.slice(-2000)}`)));
  try {
    await follow({ readMemory: () => sumPrivateBytes(profile), readConsole: () => lines, ended });
  } finally {
    const gone = new Promise((resolve) => child.on('exit', resolve));
    child.kill();
    await gone;
    reports.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** @param {string} profile - of the browser @returns bytes */
function sumPrivateBytes(profile) {
  let sum = 0;
  for (const id of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    try {
      const command = readFileSync(`/proc/${id}/cmdline`, 'utf8');
      if (command.includes(profile) && command.includes('--type=renderer')) sum += privateBytes(id);
    } catch {
      continue; // It has ended meanwhile.
    }
  }
  return sum;
}
