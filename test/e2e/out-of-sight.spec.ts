// Out of sight an element gives its context back; in sight again it is as it was.
import type { Page } from '@playwright/test';
import { black, contexts, countContexts, element, expected, isLive, onBlack, waitUntilDrawn } from './helpers/crowd.ts';
import {
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
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { shown, reported } from './helpers/scans.ts';

test.describe('out of sight and back', () => {
  const tall = '<div style="height: 6000px"></div>';
  const away = async (page: Page): Promise<void> => {
    await page.evaluate(() => scrollTo(0, 5000));
    await expect.poll(() => contexts(page)).toMatchObject({ now: 0 });
  };

  test('an element gives its context back, and its picture is there at once', async ({ page }) => {
    await countContexts(page);
    await open(page, element(0) + tall, { head: black });
    await waitUntilDrawn(page, [0]);
    await away(page);
    await forgetEvents(page);
    await page.evaluate(() => scrollTo(0, 0));
    expectSamePicture(await takeScreenshot(page, '#v0'), expected(0));
    await waitForEvent(page, 'render');
    expect(await isLive(page, 0)).toBe(true);
    expectSamePicture(await takeScreenshot(page, '#v0'), expected(0));
    expect((await seenEvents(page)).map(({ type }) => type)).toEqual(['render']);
  });

  test('what a scene held is free again, and no timer runs', async ({ page }) => {
    await page.addInitScript(() => {
      const running = new Set<unknown>();
      const { setInterval, clearInterval } = window;
      window.setInterval = ((...args: Parameters<typeof setInterval>) => {
        const id = setInterval(...args);
        running.add(id);
        return id;
      }) as typeof setInterval;
      window.clearInterval = (id) => {
        running.delete(id);
        clearInterval(id);
      };
      Object.assign(window, { countIntervals: () => running.size });
    });
    // Not with countContexts, which holds the contexts itself.
    await open(page, element(0, '<shape><appearance></appearance><box></box></shape>') + tall);
    await waitUntilDrawn(page, [0]);
    const session = await page.context().newCDPSession(page);
    const goAndComeBack = async (): Promise<number> => {
      await page.evaluate(() => scrollTo(0, 5000));
      await expect.poll(() => isLive(page, 0)).toBe(false);
      await forgetEvents(page);
      await page.evaluate(() => scrollTo(0, 0));
      await waitForEvent(page, 'render');
      await settle(page);
      await session.send('HeapProfiler.collectGarbage');
      return (await session.send('Memory.getDOMCounters')).jsEventListeners;
    };
    for (let time = 0; time < 2; time++) await goAndComeBack();
    const listeners = await goAndComeBack();
    for (let time = 0; time < 3; time++) await goAndComeBack();
    expect(await goAndComeBack()).toBeLessThanOrEqual(listeners);
    expect(await page.evaluate(() => (window as unknown as { countIntervals(): number }).countIntervals())).toBe(0);
  });

  test('what changed meanwhile is drawn then', async ({ page }) => {
    await countContexts(page);
    await open(page, element(0) + tall, { head: black });
    await waitUntilDrawn(page, [0]);
    await away(page);
    await withElement(page, (view) => view.setAttribute('steps', '30'));
    await forgetEvents(page);
    await page.waitForTimeout(200);
    expect(await seenEvents(page)).toEqual([]);
    await page.evaluate(() => scrollTo(0, 0));
    await waitForEvent(page, 'render');
    expectSamePicture(await takeScreenshot(page, '#v0'), drawReference(onBlack));
  });

  test("a person's way around the author's viewpoint stays", async ({ page }) => {
    const viewpoint = '<viewpoint position="0 -90 10" orientation="1 0 0 1.4" fieldofview="0.5"></viewpoint>';
    await countContexts(page);
    await open(page, element(0, viewpoint) + tall, { head: black });
    await waitUntilDrawn(page, [0]);
    const given = await takePicture(page);
    await page.locator('.picture').press('ArrowLeft');
    await waitForEvent(page, 'camera-change');
    await settle(page);
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    const turned = await takePicture(page);
    expect(compare(turned, given).worst).toBeGreaterThan(20);
    for (let time = 0; time < 2; time++) {
      await away(page);
      await forgetEvents(page);
      await page.evaluate(() => scrollTo(0, 0));
      await waitForEvent(page, 'render');
      expect(compare(await takePicture(page), turned).worst).toBe(0);
    }
    await page.locator('.picture').press('0');
    await settle(page);
    expect(compare(await takePicture(page), given).worst).toBe(0);
  });

  test('steps that were chosen are not chosen again', async ({ page }) => {
    await countContexts(page);
    await open(
      page,
      `<volume-view id="v0" src="${fieldUrl}" ${attributesOf({ steps: 'auto' })}></volume-view>${tall}`,
      { head: black },
    );
    await waitUntilDrawn(page, [0]);
    const before = await withElement(page, (view) => view.renderStats!);
    await away(page);
    await forgetEvents(page);
    await page.evaluate(() => scrollTo(0, 0));
    await waitForEvent(page, 'render');
    const { frameMs: _, ...rest } = await withElement(page, (view) => view.renderStats!);
    expect(before).toMatchObject(rest);
    expect((await seenEvents(page)).map(({ type }) => type)).toEqual(['render']);
  });

  test('several scans that play stand still, and go on', async ({ page }) => {
    await countContexts(page);
    const urls = [0, 1, 2].map((i) => `${fieldUrl}?${i}`).join(' ');
    await open(
      page,
      `<volume-view id="v0" src="${urls}" ${attributesOf()} autoplay play-speed="5"></volume-view>${tall}`,
    );
    // What was shown, and not what is: one who looks once a second may meet the same of three scans each time.
    const scansSince = async (since: number): Promise<number[]> =>
      (await reported(page)).slice(since).map(({ index }) => index);
    await expect.poll(() => scansSince(0)).toContain(1);
    await away(page);
    await page.waitForTimeout(300);
    const before = await scansSince(0);
    await forgetEvents(page);
    await page.waitForTimeout(700); // Three scans and more.
    expect(await scansSince(before.length)).toEqual([]);
    expect(await shown(page)).toBe(before.at(-1));
    expect(await seenEvents(page)).toEqual([]);
    await page.evaluate(() => scrollTo(0, 0));
    await expect.poll(async () => new Set((await scansSince(before.length)).slice(0, 3))).toEqual(new Set([0, 1, 2]));
  });
});
