// A built app in a browser, as a visitor opens it: served at the root of an address of its own.
import { decode } from 'fast-png';
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { startStaticServer } from '../../scripts/static-server.mjs';

/** What every app shows. */
const volume = readFileSync(join(projectRoot, 'demos/data/ct-phantom.nii.gz'));
export const made = { '/volume.nii.gz': () => volume };

// A remark of the GL driver on the cost of a readPixels.
const DRIVER_HINT = /GL Driver Message \(OpenGL, Performance/;

const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
export const closeBrowser = () => browser.close();

/**
 * @typedef {object} OpenApp
 * @property {import('@playwright/test').Page} page
 * @property {string[]} troubles - what reached the console, and answers that were errors
 * @property {string[]} paths - of what was asked for
 * @property {string[]} workers - URLs
 */

/**
 * Open a page, and close all after it.
 * @template T
 * @param {string} url
 * @param {(app: OpenApp) => Promise<T>} use
 * @param {(page: import('@playwright/test').Page) => Promise<void>} [prepare]
 */
export async function openUrl(url, use, prepare) {
  // Half a pixel a CSS pixel: a quarter of the rays.
  const page = await browser.newPage({ viewport: { width: 640, height: 480 }, deviceScaleFactor: 0.5 });
  /** @type {OpenApp} */
  const app = { page, troubles: [], paths: [], workers: [] };
  page.on('console', (message) => {
    if (!DRIVER_HINT.test(message.text()) && !/^(debug|info|log)$/.test(message.type()))
      app.troubles.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => app.troubles.push(`page error: ${error.message}`));
  page.on('response', (response) => {
    if (response.status() >= 400) app.troubles.push(`${response.status()}: ${response.url()}`);
  });
  page.on('request', (request) => app.paths.push(new URL(request.url()).pathname));
  page.on('worker', (worker) => app.workers.push(worker.url()));
  page.setDefaultTimeout(120_000);
  try {
    await prepare?.(page);
    await page.goto(url);
    return await use(app);
  } finally {
    await page.close();
  }
}

/**
 * @template T
 * @param {string} folder - what is served
 * @param {(app: OpenApp) => Promise<T>} use
 * @param {(page: import('@playwright/test').Page) => Promise<void>} [prepare]
 */
export async function openApp(folder, use, prepare) {
  const server = await startStaticServer({ root: folder, made });
  try {
    return await openUrl(`${server.url}/`, use, prepare);
  } finally {
    server.close();
  }
}

/**
 * The volume is in the picture, and nothing went wrong on the way.
 * @param {OpenApp} app
 * @returns {Promise<string>} how much of the picture it is
 */
export async function checkPicture({ page, troubles, workers }) {
  const view = page.locator('volume-view').first();
  await page.waitForFunction(() => customElements.get('volume-view'));
  await view.evaluate((/** @type {any} */ element) => element.whenRendered());
  // All parts of a page that are loaded when they are used.
  await page.waitForFunction(() =>
    document.querySelector('volume-view')?.shadowRoot?.querySelector('[part~="controls"], .controls, button'),
  );
  const { width, height, channels, data } = decode(await view.screenshot());
  // Bones are bright, and the ground is dark.
  let bright = 0;
  for (let at = 0; at < data.length; at += channels) if (data[at] > 100) bright += 1;
  const share = bright / (width * height);
  assert.ok(
    share > 0.03 && share < 0.5,
    `of a picture of ${width} x ${height} pixels ${(100 * share).toFixed(1)} % are bright`,
  );
  assert.deepEqual(troubles, []);
  assert.equal(workers.length, 1, `workers: ${workers.join() || 'none'}`);
  return `${(100 * share).toFixed(0)} % bright`;
}
