// The start of every program that measures in a browser: a server, a browser, and a description of the machine.
// VOLUME_VIEW_GPU=1 uses the GPU instead of software GL.
import { realpathSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { startStaticServer } from '../../scripts/static-server.mjs';

/** The real folder of the packages: a working tree may share the packages of another one. */
const packages = realpathSync(join(projectRoot, 'node_modules'));

/**
 * @typedef {object} Tools
 * @property {import('@playwright/test').Browser} browser
 * @property {string} url - of the checkout, with a slash at its end
 * @property {Machine} machine
 * @property {(path: string, options?: PageOptions) => Promise<import('@playwright/test').Page>} openPage - relative to `url`, or any address;
 *   `sayProgress(text)` in the page writes to this program's standard error
 */

/** @typedef {{ width?: number, height?: number, before?: () => void }} PageOptions - before: runs in the page before anything else */

/** @typedef {{ browser: string, renderer: string, cores: string, software: boolean, busy: boolean }} Machine */

/**
 * Measure with the current source, served by vite. If other programs change files, the page does not reload.
 * @template T
 * @param {(tools: Tools & { vite: import('vite').ViteDevServer }) => Promise<T>} measure
 * @returns {Promise<T>}
 */
export async function measureSource(measure) {
  const vite = await createServer({
    root: projectRoot,
    logLevel: 'error',
    cacheDir: 'node_modules/.vite-measure',
    server: { port: 0, open: false, hmr: false, watch: null, fs: { allow: [projectRoot, packages] } },
  });
  try {
    await vite.listen();
    const url = vite.resolvedUrls?.local[0];
    if (!url) throw new Error('vite says no address');
    return await withBrowser(url, (tools) => measure({ ...tools, vite }));
  } finally {
    await vite.close();
  }
}

/**
 * Measure with the built package, served as plain files.
 * @template T
 * @param {(tools: Tools) => Promise<T>} measure
 * @param {Record<string, () => Uint8Array>} [made] - content that is served without a file, by path
 * @returns {Promise<T>}
 */
export async function measurePackage(measure, made = {}) {
  const server = await startStaticServer({ made });
  try {
    return await withBrowser(`${server.url}/`, measure);
  } finally {
    server.close();
  }
}

/**
 * @template T
 * @param {string} url
 * @param {(tools: Tools) => Promise<T>} measure
 * @returns {Promise<T>}
 */
async function withBrowser(url, measure) {
  const loadBefore = loadavg()[0];
  const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
  const began = performance.now();
  try {
    const machine = await describeMachine(browser, loadBefore);
    return await measure({
      browser,
      url,
      machine,
      openPage: (path, options) => openPage(browser, { url: new URL(path, url).href, began }, options),
    });
  } finally {
    process.stderr.write('\r\u001b[K');
    await browser.close();
  }
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {{ url: string, began: number }} where - began: when the program started, ms
 * @param {PageOptions} [options]
 */
async function openPage(browser, { url, began }, { width = 1000, height = 900, before } = {}) {
  const page = await browser.newPage({ viewport: { width, height } });
  page.on('pageerror', (error) => console.error(error));
  await page.exposeFunction('sayProgress', (/** @type {string} */ what) => {
    process.stderr.write(`\r\u001b[K${Math.round((performance.now() - began) / 1000)} s, ${what}`);
  });
  if (before) await page.addInitScript(before);
  await page.goto(url);
  return page;
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {number} loadBefore - load average before the browser was started
 * @returns {Promise<Machine>}
 * @throws if the GPU is requested and the browser has none
 */
async function describeMachine(browser, loadBefore) {
  const page = await browser.newPage();
  const renderer = await page.evaluate(() => {
    const canvas = document.createElement('canvas');
    const gl = canvas.getContext('webgl2') ?? canvas.getContext('webgl');
    if (!gl) return 'no WebGL';
    const info = gl.getExtension('WEBGL_debug_renderer_info');
    const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    return name;
  });
  await page.close();
  const software = /swiftshader|llvmpipe|lavapipe|software|no WebGL/i.test(renderer);
  if (process.env.VOLUME_VIEW_GPU === '1' && software) {
    throw new Error(`VOLUME_VIEW_GPU=1 asks for the GPU, but the browser took: ${renderer}`);
  }
  return {
    browser: `Chromium ${browser.version()}`,
    renderer,
    cores: `${cpus().length} cores (${cpus()[0].model.trim()})`,
    software,
    busy: loadBefore > 0.5 * cpus().length,
  };
}

/**
 * The line to print above every table.
 * @param {Machine} machine
 */
export function nameMachine({ browser, renderer, cores, busy }) {
  const warning = busy ? '; the machine was BUSY with other work before: these times are not to be reported' : '';
  return `${browser}, ${renderer}, ${cores}${warning}`;
}
