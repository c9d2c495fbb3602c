// What every spec needs: pages written in the spec, a guard on the console, the element's events, its pixels.
import { test as base, expect } from '@playwright/test';
import type { Page } from '@playwright/test';
import type { VolumeView } from '../../../src/index.ts';
import { KeptPages } from './kept-page.ts';
import { comparePictures, decodePicture } from './pictures.ts';
import type { Picture } from './pictures.ts';

export { expect };

export interface Seen {
  readonly id: string;
  readonly type: string;
  // The detail as JSON keeps it.
  readonly detail: unknown;
  readonly bubbles: boolean;
}

declare global {
  interface Window {
    __seen: Seen[];
    __bubbled: string[];
  }
}

/** A remark of the GL driver on the cost of a readPixels, which tests need and pages do not make. */
const driverHint = /GL Driver Message \(OpenGL, Performance/;

/** What a browser itself says of a request that failed; no page can prevent it. */
export const networkLines = /^error: (Failed to load resource|Access to \w+ at .* has been blocked by CORS policy)/;

interface Fixtures {
  /** Console lines that a test expects; any other one fails it. */
  allowedLines: RegExp;
  /** Lines so far, as `level: text`. */
  lines: string[];
}

export const test = base.extend<Fixtures>({
  allowedLines: [/^$/, { option: true }],
  lines: [
    async ({ allowedLines }, use) => {
      const lines: string[] = [];
      await use(lines);
      expectNoLines(lines, allowedLines);
    },
    { auto: true },
  ],
  page: async ({ page, lines }, use) => {
    keepLines(page, lines);
    await use(page);
  },
});

/**
 * For tests that look at an element, and not at how a page begins: those of a file follow each other in one page, in which `open` puts another body. What a page is opened
 * for takes twice as long as most of what is then looked at. What is loaded and defined stays, and so do the page's globals; all else is as in a new page.
 */
export const keptTest = test.extend<object, { kept: KeptPages }>({
  kept: [
    async ({ browser }, use) => {
      const kept = new KeptPages(browser, (page) => {
        keptPages.set(page, '');
        return page.addInitScript(watchEvents, eventNames);
      });
      await use(kept);
      await kept.close();
    },
    { scope: 'worker' },
  ],
  page: async ({ kept, lines, viewport, deviceScaleFactor, hasTouch, colorScheme }, use, { file }) => {
    const kind = { viewport, deviceScaleFactor, hasTouch, colorScheme };
    const page = await kept.take(kind, file);
    keepLines(page, lines);
    await use(page);
    if (!page.isClosed()) await fill(page, ''); // What elements do when they leave is the test's own.
    await kept.giveBack(page, kind);
  },
}) as unknown as typeof test;

function keepLines(page: Page, lines: string[]): void {
  page.on('console', (message) => lines.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => lines.push(`page error: ${error.message}`));
}

function expectNoLines(lines: readonly string[], allowedLines: RegExp): void {
  expect(
    lines.filter((line) => !driverHint.test(line) && !allowedLines.test(line)),
    'the console',
  ).toEqual([]);
}

const eventNames = ['load', 'progress', 'error', 'camera-change', 'render', 'time-change'];

/** Keep the events of all elements: none bubbles, but all pass the document on their way down. */
function watchEvents(names: string[]): void {
  window.__seen = [];
  window.__bubbled = [];
  const isOurs = (event: Event): event is CustomEvent => (event.target as Partial<Element>).localName === 'volume-view';
  for (const name of names) {
    document.addEventListener(
      name,
      (event) => {
        if (!isOurs(event)) return;
        const { type, detail, bubbles, target } = event;
        const plain = JSON.parse(JSON.stringify(detail ?? null)) as unknown;
        window.__seen.push({ id: (target as Element).id, type, detail: plain, bubbles });
      },
      true,
    );
    document.addEventListener(name, (event) => {
      if (isOurs(event)) window.__bubbled.push(name);
    });
  }
}

export interface PageOptions {
  readonly head?: string;
  readonly path?: string;
  readonly script?: string;
}

/** Options of files whose tests look at what a page does, and not at single pixels: half a pixel a CSS pixel has a quarter of the rays. */
export const fewPixels = { deviceScaleFactor: 0.5 };

/** Attributes of an element that shows the field at the size that the specs' pictures have. */
export const size = 'width: 120px; height: 90px;';
export const fieldUrl = '/test/e2e/pages/data/field.nii.gz';
export const ballUrl = '/test/e2e/pages/data/ball.nii';

/** How the documents of kept pages were opened. */
const keptPages = new WeakMap<Page, string>();

const keyOf = (page: Page, { head, path, script }: PageOptions): string =>
  JSON.stringify([page.url(), head, path, script]);

/** Put a body in the place of that of a kept page, if it was opened in the same way. Scripts in a body run in a document of their own. */
async function openAgain(page: Page, body: string, options: PageOptions): Promise<boolean> {
  if (keptPages.get(page) !== keyOf(page, options) || /<script/.test(body)) return false;
  await fill(page, body);
  return true;
}

/** Throw where a tag has an attribute twice: the browser takes the first one, without a word, and a test would look at something else. */
function expectNoAttributeTwice(html: string): void {
  for (const [tag, inside] of html.matchAll(
    /<[a-z][a-z0-9-]*((?:\s+[^\s"'=<>/]+(?:=(?:"[^"]*"|'[^']*'|[^\s"'<>]+))?)*)\s*\/?>/gi,
  )) {
    const names = [...inside.matchAll(/\s+([^\s"'=<>/]+)(?:=(?:"[^"]*"|'[^']*'|[^\s"'<>]+))?/g)].map(
      ([, name]) => name,
    );
    const twice = names.find((name, i) => names.indexOf(name) < i);
    if (twice) throw new Error(`The attribute ${twice} is there twice: ${tag}`);
  }
}

/** Put this in the place of a page's body. */
async function fill(page: Page, body: string): Promise<void> {
  await page.evaluate((html) => {
    for (const element of [document.documentElement, document.body])
      for (const name of element.getAttributeNames()) if (name !== 'lang') element.removeAttribute(name);
    document.body.innerHTML = html;
    scrollTo(0, 0);
    window.__seen = [];
    window.__bubbled = [];
  }, body);
}

/**
 * Show a page of this body with the built package. The server of the checkout sends it: where Playwright answers in its place, the browser keeps nothing, and
 * reads and compiles the package anew for each page.
 */
export async function open(page: Page, body: string, options: PageOptions = {}): Promise<void> {
  const {
    head = '',
    path = '/test/e2e/pages/open.html',
    script = '<script type="module" src="/dist/volume-view.js"></script>',
  } = options;
  expectNoAttributeTwice(body);
  if (await openAgain(page, body, options)) return;
  if (!keptPages.has(page)) await page.addInitScript(watchEvents, eventNames);
  const html = `<!doctype html><html lang="en"><head><title>Test</title>${script}
      <style>body { margin: 0 } volume-view { ${size} }</style>${head}</head><body>${body}</body></html>`;
  // Of each worker its own.
  const address = `${process.env.VOLUME_VIEW_URL}${path}?${process.env.TEST_PARALLEL_INDEX}`;
  await fetch(address, { method: 'PUT', body: html });
  await page.goto(address);
  if (keptPages.has(page)) keptPages.set(page, keyOf(page, options));
}

/**
 * One page for all tests of a file, or of the `describe` it is called in: opening one takes most of a short test's time. A
 * test finds in it what the one before left, and no events.
 */
export function sharePage(
  body: string,
  { prepare, ...options }: PageOptions & { readonly prepare?: (page: Page) => Promise<void> } = {},
): () => Page {
  let page: Page;
  const lines: string[] = [];
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    keepLines(page, lines);
    await prepare?.(page);
    await open(page, body, options);
    await settle(page);
  });
  test.beforeEach(() => forgetEvents(page));
  test.afterEach(({ allowedLines }) => expectNoLines(lines.splice(0), allowedLines));
  test.afterAll(() => page.close());
  return () => page;
}

/** What a page says in the place of an answer where it has not exactly one element of a selector. */
const notOne = 'not one element';

/** Run a function with the element, once it is defined. */
export async function withElement<R, A = undefined>(
  page: Page,
  act: (element: VolumeView, argument: A) => R | Promise<R>,
  { argument, selector = 'volume-view' }: { argument?: A; selector?: string } = {},
): Promise<R> {
  // A locator asks the page four times, and sends it all that finds elements first. One question does where there is nothing to wait for.
  // Playwright sends the text that `toString` gives: so that of `act` can be part of it, and no page's policy has a say in it.
  const ask = {
    toString: () => `async ([selector, argument]) => {
    await customElements.whenDefined('volume-view');
    const found = document.querySelectorAll(selector);
    return found.length === 1 ? { answer: await (${String(act)})(found[0], argument) } : ${JSON.stringify(notOne)};
  }`,
  };
  const reported = (await page.evaluate(Object.assign(() => notOne, ask) as never, [selector, argument] as never)) as
    | { answer: R }
    | typeof notOne;
  // Playwright's own types for what it sends to the page are deeper than the compiler wants to go.
  return reported === notOne ? page.locator(selector).evaluate(act as never, argument as never) : reported.answer;
}

/** Wait until the picture is final. */
export async function settle(page: Page, selector = 'volume-view'): Promise<void> {
  await withElement(page, (element) => element.whenRendered(), { selector });
}

/** Wait for an event that happens from now on (or happened after `since`). */
export async function waitForEvent(page: Page, type: string, { since = 0, id = '' } = {}): Promise<Seen> {
  const handle = await page.waitForFunction(
    ([name, from, of]) => window.__seen.slice(from).find((seen) => seen.type === name && (!of || seen.id === of)),
    [type, since, id] as const,
  );
  return (await handle.jsonValue())!;
}

export function seenEvents(page: Page): Promise<Seen[]> {
  return page.evaluate(() => window.__seen);
}

export async function forgetEvents(page: Page): Promise<void> {
  await page.evaluate(() => {
    window.__seen.length = 0;
  });
}

/** Change attributes (null removes one) and wait for the picture. */
export async function setAttributes(
  page: Page,
  attributes: Record<string, string | null>,
  selector = 'volume-view',
): Promise<void> {
  await withElement(
    page,
    async (element, changes) => {
      for (const [name, value] of Object.entries(changes)) {
        if (value === null) element.removeAttribute(name);
        else element.setAttribute(name, value);
      }
      await element.whenRendered();
    },
    { argument: attributes, selector },
  );
}

/** What the element's toBlob gives. */
export async function takePicture(
  page: Page,
  { selector = 'volume-view', ...options }: { selector?: string; type?: string; width?: number; height?: number } = {},
): Promise<Picture> {
  const base64 = await withElement(
    page,
    async (element, wanted) => {
      const bytes = new Uint8Array(await (await element.toBlob(wanted)).arrayBuffer());
      let text = '';
      for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
      return btoa(text);
    },
    { selector, argument: options },
  );
  return decodePicture(Buffer.from(base64, 'base64'));
}

/** The element as it stands in the page, with what is behind it. */
export async function takeScreenshot(page: Page, selector = 'volume-view'): Promise<Picture> {
  return decodePicture(await page.locator(selector).screenshot());
}

/** Two pictures of one size that differ by so much, in 1/255. */
export function compare(a: Picture, b: Picture): { worst: number; rmse: number } {
  expect([a.width, a.height], 'size').toEqual([b.width, b.height]);
  return comparePictures(a, b);
}

/** The issue's own bounds: 2/255 at any pixel, 0.5/255 RMSE. */
export function expectSamePicture(got: Picture, expected: Picture): void {
  const strongest = expected.data.reduce((max, x, i) => (i % 4 < 3 ? Math.max(max, x) : max), 0);
  expect(strongest, 'the reference shows something').toBeGreaterThan(80);
  const { worst, rmse } = compare(got, expected);
  expect(worst, 'worst pixel').toBeLessThanOrEqual(2);
  expect(rmse, 'RMSE').toBeLessThanOrEqual(0.5);
}
