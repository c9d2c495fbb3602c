// Pages with strict headers, and pages around the element in which somebody else may write.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { findBrowser, listTestArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import {
  expect,
  expectSamePicture,
  fieldUrl,
  networkLines,
  open,
  setAttributes,
  settle,
  takePicture,
  test,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;
const classic = '<script src="/dist/volume-view.iife.js"></script>';

const policies = {
  "default-src 'self'": "default-src 'self'",
  'Trusted Types': "default-src 'self'; require-trusted-types-for 'script'; trusted-types volume-view lit-html",
};

/** Show one of the strict pages with another policy. */
async function openStrict(page: Page, name: string, policy: string): Promise<void> {
  await page.route(`**/csp/${name}.html`, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': policy } });
  });
  await page.goto(`/test/e2e/pages/csp/${name}.html`);
}

for (const [title, policy] of Object.entries(policies)) {
  for (const name of ['strict', 'classic']) {
    test(`${title}, ${name}.html: the picture, in a worker, and not a line on the console`, async ({ page }) => {
      const workers: string[] = [];
      page.on('worker', (worker) => workers.push(new URL(worker.url()).pathname));
      await openStrict(page, name, policy);
      expectSamePicture(await takePicture(page), drawReference());
      expect(workers).toHaveLength(1);
      expect(workers[0]).toMatch(name === 'strict' ? /^\/dist\/decode-worker\.js$/ : /^\/dist\/classic\//);
    });
  }
}

test.describe('a page in which somebody else names elements', () => {
  // The image asks for its picture, which is not there.
  test.use({ allowedLines: networkLines });

  test('an image called "currentScript" does not choose what is run', async ({ page }) => {
    const asked: string[] = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname));
    await open(page, `<img name="currentScript" src="/strange/a.js" alt="">${classic}${plain}`, { script: '' });
    expectSamePicture(await takePicture(page), drawReference());
    expect(asked).toContain('/dist/x3dom.js');
    expect(asked.filter((path) => path.startsWith('/strange/'))).toEqual(['/strange/a.js']);
  });

  for (const strange of [
    '<p id="x3dom"></p>',
    '<img name="x3dom" alt="">',
    '<iframe name="x3dom" title="x"></iframe>',
    '<form name="head"></form>',
    '<img name="baseURI" alt="">',
  ]) {
    test(`${strange} is not what it is called`, async ({ page }) => {
      await open(page, strange + plain);
      expectSamePicture(await takePicture(page), drawReference());
    });
  }
});

test('x3dom does not listen to unload, and every other listener stays', async ({ page }) => {
  await page.addInitScript(() => {
    const reported: string[] = ((window as unknown as { reported: string[] }).reported = []);
    const native = EventTarget.prototype.addEventListener;
    EventTarget.prototype.addEventListener = function (this: EventTarget, ...args: Parameters<typeof native>) {
      if (this === window) reported.push(args[0]);
      Reflect.apply(native, this, args);
    };
  });
  await open(page, plain);
  await settle(page);
  await page.evaluate(() => window.addEventListener('unload', () => {}));
  const reported = await page.evaluate(() => (window as unknown as { reported: string[] }).reported);
  expect(reported).toContain('reload'); // x3dom's own event.
  expect(
    reported.filter((type) => type === 'unload'),
    "the page's own one",
  ).toHaveLength(1);
});

test('the back-forward cache keeps a page with a picture', async ({ playwright }) => {
  // Playwright switches that cache off where nobody asks for it, and can not follow a page into it: so the page tells.
  const browser = await playwright.chromium.launch({
    executablePath: await findBrowser(),
    args: listTestArgs(),
    ignoreDefaultArgs: ['--disable-back-forward-cache'],
  });
  try {
    const page = await browser.newPage({ baseURL: process.env.VOLUME_VIEW_URL, viewport: { width: 900, height: 700 } });
    const shown: string[] = [];
    await page.context().route('**/shown?*', (route) => {
      shown.push(new URL(route.request().url()).search);
      return route.fulfill({ status: 204 });
    });
    await page.context().route('**/other.html', (route) =>
      route.fulfill({
        contentType: 'text/html',
        body: '<title>Other</title><script>addEventListener("pageshow", () => setTimeout(() => history.back(), 100))</script>',
      }),
    );
    await page.addInitScript(() =>
      addEventListener(
        'pageshow',
        ({ persisted }) => void fetch(`/shown?${location.pathname.split('/').at(-1)}=${persisted}`),
      ),
    );
    await open(page, plain);
    await settle(page);
    await page.evaluate(() => void setTimeout(() => (location.href = 'other.html')));
    await expect.poll(() => shown).toEqual(['?open.html=false', '?other.html=false', '?open.html=true']);
  } finally {
    await browser.close();
  }
});

test('the classic script has a worker with what the file needs, and loads no other part', async ({ page }) => {
  const workers: string[] = [];
  const parts: string[] = [];
  const partOf = (url: string): string => readFileSync(join(projectRoot, new URL(url).pathname), 'utf8');
  page.on('request', (request) => {
    if (request.url().includes('/dist/classic/')) parts.push(partOf(request.url()));
  });
  page.on('worker', (worker) => workers.push(partOf(worker.url())));
  await open(page, plain, { script: classic });
  expectSamePicture(await takePicture(page), drawReference());
  const asked = (words: string): boolean => [...parts, ...workers].some((text) => text.includes(words));
  expect(asked('left out of this worker'), 'the worker for usual NIfTI files').toBe(true);
  expect(asked('SNOD'), 'a reader of radar files').toBe(false);
  await setAttributes(page, { src: '/test/fixtures/radar/odim-2.3.h5' });
  await settle(page);
  expect(asked('SNOD'), 'the worker with all readers').toBe(true);
});
