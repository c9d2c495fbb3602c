// The page for frames in a sandbox without an origin, on a server with a strict Content-Security-Policy: what it shows, and with whom it talks.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';
import type { FrameLocator, Page } from '@playwright/test';
import { findFile, projectRoot } from '../../scripts/shared-data.mjs';
import { findFaults } from './helpers/axe.ts';
import { compare, expect, fieldUrl, open, takePicture, test } from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';

const lesson = `<!doctype html><html lang="de"><head><title>Two steps</title>
<meta name="author" content="Made by a program"><meta name="license" content="CC0 1.0"></head>
<body><h1>Two steps</h1><volume-view id="v" src="field.nii.gz" alt="A field" steps="40"></volume-view>
<volume-tour for="v" duration="0"><volume-step><h2>First</h2></volume-step>
<volume-step camera-orbit="90deg 90deg auto"><h2>Second</h2></volume-step></volume-tour></body></html>`;
const hostile = `<volume-view src="field.nii.gz"></volume-view><form><input name="childNodes"><input name="attributes"><img src="x" onerror="alert(1)"></form>`;

const types: Record<string, string> = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css' };
const made: Record<string, string> = { '/lessons/lesson.html': lesson, '/lessons/hostile.html': hostile };
/** Each answer has the strict policy; files may be read by all, as a page without an origin needs it. */
const site = createServer((request, response) => {
  const path = new URL(request.url ?? '/', 'http://x').pathname;
  const file = path === '/lessons/field.nii.gz' ? join(projectRoot, fieldUrl) : findFile(projectRoot, path);
  const body = made[path] ?? (file ? readFileSync(file) : undefined);
  const headers = {
    'content-type': types[extname(path)] ?? 'application/octet-stream',
    'content-security-policy': "default-src 'self'",
    'access-control-allow-origin': '*',
  };
  response.writeHead(path === '/favicon.ico' ? 204 : body === undefined ? 404 : 200, headers).end(body);
});
test.beforeAll(() => new Promise<void>((resolve) => site.listen(0, '127.0.0.1', resolve)));
test.afterAll(() => new Promise<void>((resolve) => void (site.closeAllConnections(), site.close(() => resolve()))));
const siteUrl = (): string => `http://127.0.0.1:${(site.address() as AddressInfo).port}`;

interface Frame extends EventTarget {
  get(): Promise<{ attributes: Record<string, string>; step: number | null; steps: number | null }>;
  set(attributes: Record<string, string | null>): Promise<unknown>;
  step(step: number | string): Promise<unknown>;
}
interface ParentPage extends Window {
  VolumeViewFrame: new (frame: Element) => Frame;
  one: Frame;
  heard: unknown[];
}

/** A page of another site with a frame, and the script for such pages. */
async function openParent(page: Page, query: string, attributes = 'sandbox="allow-scripts"'): Promise<FrameLocator> {
  await open(
    page,
    `<iframe data-volume-view ${attributes} style="width: 320px; height: 200px; border: 0" title="A field" src="${siteUrl()}/dist/embed.html?${query}"></iframe>`,
    { script: '<script src="/dist/embed-parent.js"></script>' },
  );
  await page.evaluate(() => {
    const own = window as unknown as ParentPage;
    own.one = new own.VolumeViewFrame(document.querySelector('iframe')!);
    own.heard = [];
    addEventListener('message', ({ data }) => own.heard.push(data));
  });
  return page.frameLocator('iframe');
}

const pictureOf = async (frame: FrameLocator): Promise<Picture> => {
  const bytes = await frame.locator('volume-view').evaluate(async (element) => {
    const view = element as HTMLElementTagNameMap['volume-view'];
    await view.whenRendered();
    return [...new Uint8Array(await (await view.toBlob()).arrayBuffer())];
  });
  return decodePicture(Uint8Array.from(bytes));
};

const lastOf = (page: Page, type: string): Promise<unknown> =>
  page.waitForFunction(
    (name) => (window as unknown as ParentPage).heard.find((one) => (one as { event?: string } | null)?.event === name),
    type,
  );

/** Without an origin no worker can be made from an address of the site; the page's own thread reads the file then. Handlers of a lesson never run. */
const blocked = /Creating a worker from 'blob:|Executing inline event handler violates/;
test.use({ viewport: { width: 640, height: 560 }, allowedLines: blocked });

test('without an origin and under a strict policy it is the picture of a page, and answers the page around it', async ({
  page,
}) => {
  const look = 'transfer-function=gray&steps=40';
  const frame = await openParent(page, `src=${fieldUrl}&alt=A+field&${look}&pickable#?secret=a1B2c3D4e5`);
  expect(await frame.locator('html').evaluate(() => self.origin)).toBe('null');

  // The height: our own message made the frame as high as a picture, and the one of WordPress has its secret.
  await expect(page.locator('iframe')).toHaveCSS('height', '240px');
  const heights = (): Promise<unknown[]> =>
    page.evaluate(() =>
      (window as unknown as ParentPage).heard.filter((one) => (one as { message?: string }).message === 'height'),
    );
  await page.evaluate(() => frames[0].postMessage({ message: 'ready', secret: 'a1B2c3D4e5' }, '*'));
  await expect.poll(heights).toContainEqual({ message: 'height', value: 240, secret: 'a1B2c3D4e5' });

  // Set, get, events.
  const got = await page.evaluate(async () => {
    const { one } = window as unknown as ParentPage;
    const loaded = new Promise<{ dimensions: number[] }>((resolve) =>
      one.addEventListener('load', (event) => resolve((event as CustomEvent<{ dimensions: number[] }>).detail)),
    );
    one.addEventListener('volume-pick', () => {});
    await one.set({ src: null }).catch(() => {});
    await one.set({ src: '/test/e2e/pages/data/field.nii.gz', 'camera-orbit': '40deg 60deg auto' });
    const { dimensions } = await loaded;
    const wrongs: Record<string, string>[] = [
      { onclick: 'x' },
      { src: 'javascript:alert(1)' },
      { crossorigin: 'use-credentials' },
    ];
    const refused = wrongs.map((wrong) =>
      one.set(wrong).then(
        () => 'taken',
        (error: Error) => error.message,
      ),
    );
    return { dimensions, refused: await Promise.all(refused), ...(await one.get()) };
  });
  expect(got.dimensions).toHaveLength(3);
  expect(got.refused).toEqual([
    '"onclick" is no attribute of <volume-view> that this page knows',
    expect.stringMatching(/^src got an address that this page does not fetch/),
    expect.stringMatching(/^crossorigin is not taken/),
  ]);
  expect(got.attributes).toMatchObject({ steps: '40', 'transfer-function': 'gray' });
  expect([got.step, got.steps]).toEqual([null, null]);
  const inFrame = await pictureOf(frame);
  await frame.locator('volume-view').click({ position: { x: 160, y: 120 } });
  await lastOf(page, 'volume-pick');

  // Another window's messages are ignored.
  await page.evaluate(() => {
    const other = document.createElement('iframe');
    other.setAttribute('sandbox', 'allow-scripts');
    other.srcdoc = `<script>parent.frames[0].postMessage({ volumeView: 1, set: { steps: '3' } }, '*'); parent.postMessage('sent', '*')</script>`;
    document.body.append(other);
  });
  await page.waitForFunction(() => (window as unknown as ParentPage).heard.includes('sent'));
  expect((await page.evaluate(() => (window as unknown as ParentPage).one.get())).attributes.steps).toBe('40');

  await open(
    page,
    `<volume-view style="width: 320px; height: 240px" src="${fieldUrl}" alt="A field" transfer-function="gray" steps="40" camera-orbit="40deg 60deg auto"></volume-view>`,
  );
  const inPage = await takePicture(page);
  expect(inPage.data.some((x) => x > 80)).toBe(true);
  expect(compare(inFrame, inPage).worst).toBe(0);
});

test('a frame with the origin of its server says nothing to another site, whatever its address says', async ({
  page,
}) => {
  const frame = await openParent(
    page,
    `src=${fieldUrl}&alt=A+field&steps=40&parent=${encodeURIComponent(process.env.VOLUME_VIEW_URL!)}#?secret=abc`,
    '',
  );
  await expect(frame.locator('volume-view')).toBeVisible();
  await page.evaluate(() => {
    for (const request of [{ get: true }, { set: { steps: '3' } }, { events: ['load'] }])
      frames[0].postMessage({ volumeView: 1, id: 7, ...request }, '*');
    frames[0].postMessage({ message: 'ready' }, '*');
  });
  await page.waitForFunction(() =>
    (window as unknown as ParentPage).heard.some((one) => (one as { message?: string }).message === 'height'),
  );
  await frame.locator('volume-view').evaluate((view) => (view as HTMLElementTagNameMap['volume-view']).whenRendered());
  const heard = (await page.evaluate(() => (window as unknown as ParentPage).heard)) as Record<string, unknown>[];
  expect(heard.filter(({ volumeView, event }) => volumeView !== undefined && event !== 'ready')).toEqual([]);
  await expect(frame.locator('volume-view')).toHaveAttribute('steps', '40');
});

test.describe('a poster', () => {
  test.use({ bypassCSP: true }); // For axe, which is put into the page.

  test('loads no script of the element until it is asked for, also with keys', async ({ page }) => {
    const asked: string[] = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname));
    await page.goto(
      `${siteUrl()}/dist/embed.html?src=${fieldUrl}&alt=A+field&steps=40&lang=de&poster=${encodeURIComponent('/demos/images/one-tag.webp')}`,
    );
    const button = page.getByRole('button', { name: 'In 3D zeigen' });
    await expect(page.getByRole('img', { name: 'A field' })).toBeVisible();
    expect(await findFaults(page)).toEqual([]);
    expect(asked.filter((path) => /iife|field/.test(path))).toEqual([]);
    await page.keyboard.press('Tab');
    await expect(button).toBeFocused();
    await page.keyboard.press('Enter');
    await expect(button).toHaveCount(0);
    await page.locator('volume-view').evaluate(async (view) => {
      await customElements.whenDefined('volume-view'); // Its script comes after the press.
      return (view as HTMLElementTagNameMap['volume-view']).whenRendered();
    });
  });
});

test('a lesson file is shown with its credits, and its steps open by messages; a hostile one is refused in words', async ({
  page,
}) => {
  const frame = await openParent(page, 'lesson=../lessons/lesson.html');
  await expect(frame.getByRole('heading', { name: 'First' })).toBeVisible();
  await expect(frame.getByText('CC0 1.0')).toBeVisible();
  expect(
    await frame
      .locator('html')
      .evaluate((html) => [html.getAttribute('lang'), html.getAttribute('dir'), document.title]),
  ).toEqual(['de', 'ltr', 'Two steps']);
  await expect(frame.locator('volume-view')).toHaveAttribute('src', `${siteUrl()}/lessons/field.nii.gz`);
  const [before, after] = await page.evaluate(async () => {
    const { one } = window as unknown as ParentPage;
    const changed = new Promise((resolve) => one.addEventListener('step-change', resolve));
    const { step, steps } = await one.get();
    await one.step('next');
    await changed;
    const wrong = await one.step(9).catch((error: Error) => error.message);
    return [
      [step, steps],
      [(await one.get()).step, wrong],
    ];
  });
  expect(before).toEqual([1, 2]);
  expect(after).toEqual([2, 'got step 9; expected at most 2']);
  await expect(frame.getByRole('heading', { name: 'Second' })).toBeVisible();

  await page.goto(`${siteUrl()}/dist/embed.html?lesson=../lessons/hostile.html`);
  await expect(page.getByText('got <form>; expected text')).toBeVisible();
  await expect(page.locator('volume-view, form, img')).toHaveCount(0);
});
