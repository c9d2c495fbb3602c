// Pages of lessons in a browser, and their pictures: for the tests of what the writers of lessons make.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { decode } from 'fast-png';

/** Milliseconds that something in a page may be late on a machine that has other work. */
export const longestWait = 120_000;

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} allowed - how the addresses begin that a page may ask for
 * @param {number} [deviceScaleFactor] - 0.5 has a quarter of the rays; a frame of another origin does not follow it
 * @returns {Promise<{ page: import('@playwright/test').Page, problems: string[] }>} with what the console says, requests elsewhere, and those that fail
 */
export async function openLessonPage(browser, allowed, deviceScaleFactor = 1) {
  const context = await browser.newContext({ viewport: { width: 480, height: 700 }, deviceScaleFactor });
  context.setDefaultTimeout(longestWait);
  const page = await context.newPage();
  /** @type {string[]} */
  const problems = [];
  page.on('console', (message) => {
    // A driver in software says that reading pixels takes long.
    if (['error', 'warning'].includes(message.type()) && !/GPU stall/.test(message.text()))
      problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(String(error)));
  // Of a worker's script that is missing the console says nothing.
  page.on('response', (response) => {
    if (response.status() >= 400) problems.push(`${response.status()} ${response.url()}`);
  });
  page.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(allowed)) problems.push(request.url());
  });
  return { page, problems };
}

/**
 * Waits until a view is drawn, also one whose script has still to come.
 * @param {import('@playwright/test').Page | import('@playwright/test').FrameLocator} place
 * @param {string} [selector]
 */
export async function atRest(place, selector = 'volume-view') {
  await place.locator(selector).evaluate(async (element) => {
    await customElements.whenDefined(element.localName);
    element.scrollIntoView();
    await /** @type {any} */ (element).whenRendered();
  });
}

/**
 * The picture, when it is at rest, as the element gives it.
 * @param {import('@playwright/test').Page | import('@playwright/test').FrameLocator} place
 * @param {string} [selector]
 */
export async function pictureOf(place, selector = 'volume-view') {
  await atRest(place, selector);
  const base64 = await place.locator(selector).evaluate(async (element) => {
    const view = /** @type {any} */ (element);
    return btoa(
      Array.from(new Uint8Array(await (await view.toBlob()).arrayBuffer()), (byte) => String.fromCharCode(byte)).join(
        '',
      ),
    );
  });
  return decode(Buffer.from(base64, 'base64'));
}

/** The largest difference of two pictures, of 255. @param {any} a @param {any} b */
export function difference(a, b) {
  assert.deepEqual([a.width, a.height, a.channels], [b.width, b.height, b.channels]);
  return a.data.reduce(
    (/** @type {number} */ max, /** @type {number} */ x, /** @type {number} */ i) =>
      Math.max(max, Math.abs(x - b.data[i])),
    0,
  );
}

/** @type {Record<string, string>} */
const types = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.webp': 'image/webp',
};

/**
 * A server of files on this machine.
 * @param {(path: string) => Uint8Array | string | undefined} find - gives the file of a path, which begins with `/`; undefined, or a throw, is a 404.
 * A text is HTML.
 * @returns {Promise<{ origin: string, close: () => void }>}
 */
export async function serveFiles(find) {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://x').pathname);
    let found;
    try {
      found = path === '/favicon.ico' ? Buffer.alloc(0) : find(path);
    } catch {
      found = undefined;
    }
    const type = typeof found === 'string' ? 'text/html' : (types[extname(path)] ?? 'application/octet-stream');
    response.writeHead(found === undefined ? 404 : 200, { 'content-type': type }).end(found);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(null)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return { origin: `http://127.0.0.1:${port}`, close: () => server.close() };
}
