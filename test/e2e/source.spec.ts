// Another src: what is fetched, what is shown meanwhile, what ends.
import type { Page } from '@playwright/test';
import { files } from './helpers/data.ts';
import { plain } from './helpers/green-shape.ts';
import {
  ballUrl,
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  forgetEvents,
  open,
  seenEvents,
  settle,
  takePicture,
  takeScreenshot,
  keptTest as test,
  test as newPageTest,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { serveSlowly } from './helpers/slow-server.ts';
import { ball } from './helpers/volumes.ts';

test.describe('another src', () => {
  test('of many in a row only the last one is shown', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await forgetEvents(page);
    await withElement(
      page,
      async (element, urls) => {
        for (const url of urls) {
          element.src = url;
          await Promise.resolve();
        }
        await element.whenRendered();
      },
      { argument: [ballUrl, fieldUrl, '/nowhere.nii', ballUrl, fieldUrl, ballUrl] },
    );
    const seen = await seenEvents(page);
    expect(
      seen.filter(({ type }) => type === 'load').map(({ detail }) => (detail as { dimensions: number[] }).dimensions),
    ).toEqual([[12, 12, 12]]);
    expect(seen.filter(({ type }) => type === 'error')).toEqual([]);
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
  });

  test('ends the fetch of the one before', async ({ page }) => {
    const server = await serveSlowly(files['field.nii'], 0.5);
    await open(page, `<volume-view src="${server.url}" ${attributesOf()}></volume-view>`);
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { loaded: number }).loaded > 0));
    await withElement(
      page,
      (element, src) => {
        element.src = src;
      },
      { argument: ballUrl },
    );
    await server.dropped;
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    expect((await seenEvents(page)).filter(({ type }) => type === 'load')).toHaveLength(1);
    server.close();
  });

  test('so does taking the element out, and back in it loads again', async ({ page }) => {
    const server = await serveSlowly(files['field.nii'], 0.5);
    await open(page, `<volume-view src="${server.url}" ${attributesOf()}></volume-view>`);
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { loaded: number }).loaded > 0));
    await withElement(page, (element) => {
      (window as unknown as { kept: Element }).kept = element;
      element.remove();
    });
    await server.dropped;
    server.release();
    await page.evaluate(() => document.body.append((window as unknown as { kept: Element }).kept));
    expectSamePicture(await takePicture(page), drawReference());
    expect(server.requests()).toBe(2);
    expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('error');
    server.close();
  });

  test('set while it is out of the page is what it shows when it is back', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await forgetEvents(page);
    await withElement(
      page,
      async (element, src) => {
        element.remove();
        await new Promise(requestAnimationFrame);
        element.src = src;
        await element.updateComplete;
        document.body.append(element);
      },
      { argument: ballUrl },
    );
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    expect((await seenEvents(page)).filter(({ type }) => type === 'load')).toHaveLength(1);
  });

  newPageTest('asks for its file once', async ({ page }) => {
    const requests: string[] = [];
    page.on('request', (request) => requests.push(new URL(request.url()).pathname));
    await open(page, plain);
    await settle(page);
    expect(requests.filter((path) => path === fieldUrl)).toHaveLength(1);
    expect(requests.filter((path) => path.includes('decode-worker'))).toHaveLength(1);
    await withElement(
      page,
      async (element, src) => {
        element.src = src;
        await element.whenRendered();
      },
      { argument: ballUrl },
    );
    expect(requests.filter((path) => path === ballUrl)).toHaveLength(1);
  });

  test('in the same place keeps the view that a person chose', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await page.locator('.picture').press('ArrowLeft');
    await waitForEvent(page, 'camera-change');
    const before = await takePicture(page);
    await withElement(page, async (element) => {
      element.src = '/test/e2e/pages/data/field.nii';
      await element.whenRendered();
    });
    expect(compare(await takePicture(page), before).worst).toBe(0);
  });

  test('keeps the old picture until the new one is there', async ({ page }) => {
    await open(page, plain);
    const before = await takePicture(page);
    const server = await serveSlowly(files['ball.nii'], 0.5);
    await withElement(
      page,
      (element, src) => {
        element.src = src;
      },
      { argument: server.url },
    );
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { total?: number }).total === 7264));
    const kept = await withElement(page, (element) => element.volume!.dimensions);
    expect(kept).toEqual([24, 20, 16]);
    await page.addStyleTag({
      content: 'volume-view { background: black } volume-view::part(progress) { display: none }',
    });
    const onBlack = { ...before, data: before.data.map((x, i) => (i % 4 === 3 ? 255 : x)) };
    expect(compare(await takeScreenshot(page), onBlack).worst).toBeLessThanOrEqual(1);
    server.release();
    await settle(page);
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    server.close();
  });
});

test.describe('while the file is on its way', () => {
  /** Open a view whose file never comes whole, and list the requests for the code of light. */
  const requestsOf = async (page: Page, attributes: string): Promise<string[]> => {
    const server = await serveSlowly(files['field.nii'], 0.5);
    const urls: string[] = [];
    page.on('request', (request) => urls.push(new URL(request.url()).pathname));
    await open(page, `<volume-view src="${server.url}" ${attributes} alt="A field"></volume-view>`);
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { loaded: number }).loaded > 0));
    await expect.poll(() => urls.some((url) => url.includes('/x3dom'))).toBe(true);
    server.close();
    return urls.filter((url) => /\/chunks\/(styles|light)-/.test(url));
  };

  newPageTest('the code for light loads too, where the scan may be lit', async ({ page }) => {
    expect(await requestsOf(page, '')).toHaveLength(2);
  });

  newPageTest('it does not where the author wants another picture', async ({ page }) => {
    expect(await requestsOf(page, 'projection="max"')).toEqual([]);
  });
});
