// The same pages in three engines: `npm run test:engines [-- --page /test/engines/other.html --only Firefox]`; by default the
// smoke test, and then a short walk (see walk.js).
// The page sets `window.__smoke = { done, passed: [name], failed: [name] }`; errors.js, its first script, collects
// what reaches the console in `window.__messages`, for engines whose protocol does not tell.
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { parseArgs } from 'node:util';
import { build } from 'vite';
import { canInstallPackages, installPackages } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { startStaticServer } from '../../scripts/static-server.mjs';
import { engine as chromium } from './chromium.mjs';
import { engine as firefox } from './firefox.mjs';
import { engine as webkit } from './webkit.mjs';

/**
 * A page that is open in an engine.
 * @typedef {object} OpenPage
 * @property {string} version
 * @property {string[]} messages - console messages so far, where the protocol allows
 * @property {(expression: string) => Promise<any>} evaluate - the JSON value of an expression in the page
 * @property {() => Promise<void>} close
 */
/**
 * @typedef {object} Engine
 * @property {string} name
 * @property {string[]} packages - of Debian, where `find` finds nothing
 * @property {() => string | null | Promise<string | null>} find - path of the browser
 * @property {(url: string, executablePath: string) => Promise<OpenPage>} open
 */

const SHORT_WALK = '/test/engines/walk.html?steps=60&seed=14';

const { values: options } = parseArgs({
  options: { page: { type: 'string' }, only: { type: 'string' }, minutes: { type: 'string', default: '8' } },
});
const pages = options.page ? [options.page] : ['/test/engines/smoke.html', SHORT_WALK];
const PAGE_LIMIT_MS = Number(options.minutes) * 60_000;

/** @param {Engine} engine */
async function findOrInstall(engine) {
  const found = await engine.find();
  if (found) return found;
  const command = `apt-get install -y ${engine.packages.join(' ')}`;
  if (!canInstallPackages()) throw new Error(`it is not installed (on Debian: ${command})`);
  if (!installPackages(engine.packages)) throw new Error(`"${command}" failed`);
  const installed = await engine.find();
  if (!installed) throw new Error(`"${command}" brought no browser`);
  return installed;
}

/**
 * @param {OpenPage} page
 * @returns {Promise<{ passed: string[], failed: string[] }>}
 */
async function readResults(page) {
  const end = Date.now() + PAGE_LIMIT_MS;
  for (;;) {
    const text = await page.evaluate('JSON.stringify([window.__smoke ?? null, window.__messages ?? []])');
    const [smoke, own] = JSON.parse(text);
    if (smoke?.done || Date.now() > end) {
      const passed = smoke?.passed ?? [];
      const failed = smoke?.failed ?? [];
      if (!smoke?.done) failed.push(`the page finishes within ${PAGE_LIMIT_MS / 1000} s`);
      const messages = [...new Set([...page.messages, ...own])];
      if (messages.length === 0) passed.push('the console stays empty');
      else failed.push(`the console stays empty: ${messages.join(' | ')}`);
      return { passed, failed };
    }
    await sleep(250);
  }
}

/** The CPU reference as a module that pages can load, where smoke.js looks for it. */
async function bundleReference() {
  await build({
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'warn',
    build: {
      outDir: join(projectRoot, 'node_modules/.cache/volume-view/engines'),
      target: 'es2022',
      lib: { entry: join(projectRoot, 'test/engines/reference.ts'), formats: ['es'], fileName: 'reference' },
    },
  });
}

let passedCount = 0;
let failedCount = 0;

/** @param {Engine} engine @param {string} path - of the browser @param {string} url */
async function testEngine(engine, path, url) {
  let page;
  try {
    page = await engine.open(url, path);
    const { passed, failed } = await readResults(page);
    for (const name of passed) console.log(`${engine.name} (${page.version}): ok: ${name}`);
    for (const name of failed) console.log(`${engine.name} (${page.version}): FAILED: ${name}`);
    passedCount += passed.length;
    failedCount += failed.length;
  } catch (error) {
    failedCount += 1;
    console.log(`${engine.name}: FAILED: ${error instanceof Error ? error.message : String(error)}`);
  } finally {
    await page?.close();
  }
}

/** @param {Engine} engine @param {string} path - of the browser */
async function testPages(engine, path) {
  for (const page of pages) await testEngine(engine, path, server.url + page);
}

await bundleReference();
const server = await startStaticServer();
/** @type {Promise<void>[]} */
const tests = [];
for (const engine of [chromium, firefox, webkit]) {
  if (options.only && options.only.toLowerCase() !== engine.name.toLowerCase()) continue;
  try {
    // One after the other, as apt-get wants it; the pages then run side by side.
    tests.push(testPages(engine, await findOrInstall(engine)));
  } catch (error) {
    console.log(`${engine.name}: not available: ${error instanceof Error ? error.message : String(error)}`);
  }
}
await Promise.all(tests);
server.close();
console.log(`${passedCount} passed, ${failedCount} failed`);
process.exit(failedCount > 0 ? 1 : 0);
