// Many elements in one page: what is far away costs nothing, few contexts serve all, and none of it is to be seen.
import type { Page } from '@playwright/test';
import { maxContexts } from '../../src/viewer/scenes/context-pool.ts';
import { black, contexts, countContexts, element, expected, sized, waitUntilDrawn } from './helpers/crowd.ts';
import {
  ballUrl,
  expect,
  expectSamePicture,
  fieldUrl,
  forgetEvents,
  open,
  seenEvents,
  takePicture,
  takeScreenshot,
  test,
} from './helpers/harness.ts';
import { drawReference } from './helpers/reference.ts';
import { ball } from './helpers/volumes.ts';

/** The numbers of the elements of which something is in the visible part of the page. */
const inSight = (page: Page): Promise<number[]> =>
  page.evaluate(() =>
    [...document.querySelectorAll('volume-view')].flatMap((view) => {
      const { top, bottom } = view.getBoundingClientRect();
      return bottom > 0 && top < innerHeight ? [Number(view.id.slice(1))] : [];
    }),
  );

test('more than sixty', async ({ page, lines }) => {
  test.setTimeout(300_000);
  const workers: string[] = [];
  const requests: string[] = [];
  const readFiles = (): string[] => requests.filter((path) => path === fieldUrl || path === ballUrl);
  page.on('worker', (worker) => workers.push(worker.url()));
  page.on('request', (request) => requests.push(new URL(request.url()).pathname));
  await countContexts(page);
  const cells = Array.from({ length: 64 }, (_, i) => element(i)).join('');
  await open(page, `<div style="display: grid; grid: auto-flow 200px / repeat(4, 200px)">${cells}</div>`, {
    head: black,
  });

  // Three and a half rows are in sight, half as many are near: the others have cost nothing.
  await page.evaluate(() => customElements.whenDefined('volume-view').then(() => true));
  const first = await inSight(page);
  expect(first.length).toBeGreaterThan(maxContexts + 1);
  expect(first.length).toBeLessThanOrEqual(16);
  await waitUntilDrawn(page, first);
  await expect
    .poll(async () => (await seenEvents(page)).filter(({ type }) => type === 'load').length)
    .toBeGreaterThanOrEqual(first.length);
  expect(workers.length, 'one for each of the two files').toBeLessThanOrEqual(2);
  expect((await contexts(page)).max).toBeLessThanOrEqual(maxContexts);
  for (const i of first) expectSamePicture(await takeScreenshot(page, `#v${i}`), expected(i));

  for (let top = 300; top < 3000; top += 1000) {
    await page.evaluate((y) => scrollTo(0, y), top);
    const seen = await inSight(page);
    await waitUntilDrawn(page, seen);
    const one = seen[(top / 100) % seen.length];
    expectSamePicture(await takeScreenshot(page, `#v${one}`), expected(one));
  }
  const { max } = await contexts(page);
  expect(max).toBeLessThanOrEqual(maxContexts);
  expect(requests.filter((path) => /x3dom/.test(path))).toHaveLength(1);
  expect(readFiles(), 'each file was fetched and decoded once').toHaveLength(2);

  // Back at the top the pictures are there, without another load.
  await forgetEvents(page);
  await page.evaluate(() => scrollTo(0, 0));
  for (const i of [first[0], first.at(-1)!]) expectSamePicture(await takeScreenshot(page, `#v${i}`), expected(i));
  expect(readFiles()).toHaveLength(2);
  expect(workers.length).toBeLessThanOrEqual(2);
  expect((await seenEvents(page)).filter(({ type }) => type !== 'render')).toEqual([]);
  expect(lines.filter((line) => /context/i.test(line))).toEqual([]);

  await page.evaluate(() => document.querySelector('div')!.remove());
  expect((await contexts(page)).now).toBe(0);
});

test('what is in sight keeps its context when a script asks for what is not', async ({ page }) => {
  const numbers = Array.from({ length: maxContexts }, (_, i) => i);
  const far = [30, 31];
  const row = numbers.map((i) => element(i)).join('');
  await countContexts(page);
  await open(
    page,
    `<div style="display: grid; grid-template-columns: repeat(5, 130px)">${row}</div><div style="height: 6000px"></div>${far.map((i) => element(i)).join('')}`,
    { head: black },
  );
  await waitUntilDrawn(page, numbers);
  await page.evaluate(() =>
    Object.assign(window, {
      kept: [...document.querySelectorAll('volume-view')].map((view) => view.shadowRoot!.querySelector('x3d')),
    }),
  );
  const pictures = await Promise.all(far.map((i) => takePicture(page, { selector: `#v${i}` })));
  for (const [n, i] of far.entries())
    expectSamePicture(pictures[n], drawReference({ steps: 20 + i, ...(i % 2 ? { volume: ball } : {}), ...sized }));
  const same = await page.evaluate(() => {
    const { kept } = window as unknown as { kept: (Element | null)[] };
    return [...document.querySelectorAll('volume-view')].map(
      (view, n) => kept[n] !== null && kept[n] === view.shadowRoot!.querySelector('x3d'),
    );
  });
  expect(same).toEqual([...numbers.map(() => true), ...far.map(() => false)]);
  await expect.poll(() => contexts(page)).toEqual({ now: maxContexts, max: maxContexts + 1 });
});
