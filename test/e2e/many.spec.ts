// Many elements in one page: what is far away costs nothing, few contexts serve all, and none of it is to be seen.
import type { Page } from '@playwright/test';
import { maxContexts } from '../../src/viewer/context-pool.ts';
import { ballUrl, compare, expect, expectSamePicture, fieldUrl, forgetEvents, open, seenEvents, setAttributes, settle, takePicture, takeScreenshot, test, waitForEvent, withElement } from './helpers/harness.ts';
import type { Picture } from './helpers/pictures.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { ball } from './helpers/volumes.ts';

const black = '<style>volume-view { background: black }</style>';
const onBlack = { background: [0, 0, 0] } as const;

/** One of a row of elements that differ. */
const element = (i: number, children = ''): string =>
  `<volume-view id="v${i}" src="${i % 2 ? ballUrl : fieldUrl}" ${attributesOf({ steps: String(20 + i) })}>${children}</volume-view>`;

const expected = (i: number): Picture => drawReference({ steps: 20 + i, ...(i % 2 ? { volume: ball } : {}), ...onBlack });

interface Count {
  /** WebGL contexts that are not lost. */
  now(): number;
  /** The most of them at any time. */
  most: number;
}

declare global {
  interface Window {
    __contexts: Count;
  }
}

/** Count the page's contexts from its very beginning, those that only ask what the device can do too. */
async function countContexts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const all = new Set<WebGLRenderingContext | WebGL2RenderingContext>();
    const count: Count = { now: () => [...all].filter((context) => !context.isContextLost()).length, most: 0 };
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
      const context = Reflect.apply(original, this, args) as RenderingContext | null;
      if (context instanceof WebGLRenderingContext || context instanceof WebGL2RenderingContext) all.add(context);
      count.most = Math.max(count.most, count.now());
      return context as never;
    };
    window.__contexts = count;
  });
}

const contexts = (page: Page): Promise<{ now: number; most: number }> =>
  page.evaluate(() => ({ now: window.__contexts.now(), most: window.__contexts.most }));

/** Whether an element has a scene of its own, and not only its last picture. */
const isLive = (page: Page, i: number): Promise<boolean> =>
  withElement(page, (view) => view.shadowRoot!.querySelector('x3d') !== null, { selector: `#v${i}` });

/** Wait until elements have drawn their final pictures, without asking them for it. */
async function waitUntilDrawn(page: Page, numbers: readonly number[]): Promise<void> {
  await page.waitForFunction((wanted) => wanted.every((i) => {
    const view = document.querySelector<HTMLElementTagNameMap['volume-view']>(`#v${i}`);
    return view?.renderStats?.converged;
  }), numbers);
}

/** The numbers of the elements of which something is in the visible part of the page. */
const inSight = (page: Page): Promise<number[]> => page.evaluate(() =>
  [...document.querySelectorAll('volume-view')].flatMap((view) => {
    const { top, bottom } = view.getBoundingClientRect();
    return bottom > 0 && top < innerHeight ? [Number(view.id.slice(1))] : [];
  }));

test('a hundred', async ({ page, lines }) => {
  test.setTimeout(300_000);
  const workers: string[] = [];
  const requests: string[] = [];
  page.on('worker', (worker) => workers.push(worker.url()));
  page.on('request', (request) => requests.push(new URL(request.url()).pathname));
  await countContexts(page);
  const cells = Array.from({ length: 100 }, (_, i) => element(i)).join('');
  await open(page, `<div style="display: grid; grid: auto-flow 200px / repeat(4, 200px)">${cells}</div>`, { head: black });

  // Three and a half rows are in sight, half as many are near: the others have cost nothing.
  await page.evaluate(() => customElements.whenDefined('volume-view').then(() => true));
  const first = await inSight(page);
  expect(first.length).toBeGreaterThan(maxContexts + 1);
  expect(first.length).toBeLessThanOrEqual(16);
  await waitUntilDrawn(page, first);
  await expect.poll(async () => (await seenEvents(page)).filter(({ type }) => type === 'load').length).toBeGreaterThanOrEqual(first.length);
  expect(workers.length, 'one for each of the two files').toBeLessThanOrEqual(2);
  expect((await contexts(page)).most).toBeLessThanOrEqual(maxContexts);
  for (const i of first) expectSamePicture(await takeScreenshot(page, `#v${i}`), expected(i));

  for (let top = 300; top < 4800; top += 500) {
    await page.evaluate((y) => scrollTo(0, y), top);
    const seen = await inSight(page);
    await waitUntilDrawn(page, seen);
    const one = seen[top / 100 % seen.length];
    expectSamePicture(await takeScreenshot(page, `#v${one}`), expected(one));
  }
  const { most } = await contexts(page);
  expect(most).toBeLessThanOrEqual(maxContexts);
  expect(requests.filter((path) => /x3dom/.test(path))).toHaveLength(1);
  expect(workers.length, 'each file was fetched and decoded once').toBe(2);

  // Back at the top the pictures are there, without another load.
  await forgetEvents(page);
  await page.evaluate(() => scrollTo(0, 0));
  for (const i of [first[0], first.at(-1)!]) expectSamePicture(await takeScreenshot(page, `#v${i}`), expected(i));
  expect(workers.length).toBe(2);
  expect((await seenEvents(page)).filter(({ type }) => type !== 'render')).toEqual([]);
  expect(lines.filter((line) => /context/i.test(line))).toEqual([]);

  await page.evaluate(() => document.querySelector('div')!.remove());
  expect((await contexts(page)).now).toBe(0);
});

/** More elements in sight than there are places, all drawn. */
async function openCrowd(page: Page, { children = '' } = {}): Promise<number[]> {
  const numbers = Array.from({ length: maxContexts + 2 }, (_, i) => i);
  const row = numbers.map((i) => element(i, children)).join('');
  await countContexts(page);
  await open(page, `<div style="display: grid; grid-template-columns: repeat(5, 130px)">${row}</div>`, { head: black });
  await waitUntilDrawn(page, numbers);
  return numbers;
}

async function findStill(page: Page, numbers: readonly number[]): Promise<number> {
  for (const i of numbers) if (!(await isLive(page, i))) return i;
  throw new Error('all are live');
}

/** Take an element's place away: the others are all asked to draw. */
async function takePlace(page: Page, from: number, numbers: readonly number[]): Promise<void> {
  await page.mouse.move(890, 690);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  for (const i of numbers) if (i !== from) await withElement(page, (view) => view.redraw(), { selector: `#v${i}` });
  await expect.poll(() => isLive(page, from)).toBe(false);
}

test.describe('more in sight than there are contexts', () => {
  test('all show their pictures, and at rest nothing is drawn', async ({ page }) => {
    const numbers = await openCrowd(page);
    for (const i of numbers) expectSamePicture(await takeScreenshot(page, `#v${i}`), expected(i));
    expect(await contexts(page)).toEqual({ now: maxContexts, most: maxContexts });
    await forgetEvents(page);
    await page.waitForTimeout(500);
    expect(await seenEvents(page)).toEqual([]);
  });

  test('the mouse over it gives an element a context, without a jump', async ({ page }) => {
    const numbers = await openCrowd(page);
    const still = await findStill(page, numbers);
    const before = await takeScreenshot(page, `#v${still}`);
    await page.locator(`#v${still}`).hover();
    await expect.poll(() => isLive(page, still)).toBe(true);
    await page.waitForFunction((id) => document.querySelector(`#${id}`)!.shadowRoot!.querySelectorAll('canvas').length === 1, `v${still}`);
    expect(compare(await takeScreenshot(page, `#v${still}`), before).worst).toBe(0);
    expect((await contexts(page)).most).toBe(maxContexts);
  });

  test('keys turn one that had none, and what a person chose stays when it has none again', async ({ page }) => {
    const numbers = await openCrowd(page);
    const still = await findStill(page, numbers);
    const id = `v${still}`;
    await forgetEvents(page);
    await page.locator(`#${id} .picture`).press('ArrowLeft');
    await waitForEvent(page, 'camera-change', { id });
    await settle(page, `#${id}`);
    const turned = await takeScreenshot(page, `#${id}`);
    expect(compare(turned, expected(still)).worst).toBeGreaterThan(20);
    // The ring of the focus is no part of the picture.
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    const stats = await withElement(page, (view) => JSON.stringify(view.renderStats), { selector: `#${id}` });
    const blob = await takePicture(page, { selector: `#${id}` });
    const shown = await takeScreenshot(page, `#${id}`);
    await takePlace(page, still, numbers);
    expect(compare(await takeScreenshot(page, `#${id}`), shown).worst).toBe(0);
    expect(JSON.parse(await withElement(page, (view) => JSON.stringify(view.renderStats), { selector: `#${id}` }))).toMatchObject({ width: 120, steps: JSON.parse(stats).steps });
    expect(compare(await takePicture(page, { selector: `#${id}` }), blob).worst).toBe(0);
  });

  test('an attribute that changes is shown', async ({ page }) => {
    const numbers = await openCrowd(page);
    const still = await findStill(page, numbers);
    await withElement(page, (view) => view.setAttribute('steps', '60'), { selector: `#v${still}` });
    await settle(page, `#v${still}`);
    const reference = drawReference({ ...(still % 2 ? { volume: ball } : {}), ...onBlack });
    expectSamePicture(await takeScreenshot(page, `#v${still}`), reference);
    await setAttributes(page, { src: still % 2 ? fieldUrl : ballUrl }, `#v${still}`);
    expectSamePicture(await takeScreenshot(page, `#v${still}`), drawReference({ ...(still % 2 ? {} : { volume: ball }), ...onBlack }));
  });

  test('so is an author\'s shape, one that was there and one that is new', async ({ page }) => {
    const shape = (color: string): string =>
      `<shape><appearance><material diffusecolor="0 0 0" emissivecolor="${color}"></material></appearance><box size="8 8 60"></box></shape>`;
    const numbers = await openCrowd(page, { children: shape('0 1 0') });
    const still = await findStill(page, numbers);
    const green = await takeScreenshot(page, `#v${still}`);
    await forgetEvents(page);
    await withElement(page, (view) => view.querySelector('material')!.setAttribute('emissivecolor', '0 0 1'), { selector: `#v${still}` });
    await waitForEvent(page, 'render', { id: `v${still}` });
    await settle(page, `#v${still}`);
    const blue = await takeScreenshot(page, `#v${still}`);
    expect(compare(blue, green).worst).toBeGreaterThan(200);
    await takePlace(page, still, numbers);
    await withElement(page, (view) => view.querySelector('shape')!.remove(), { selector: `#v${still}` });
    await expect.poll(async () => compare(await takeScreenshot(page, `#v${still}`), expected(still)).worst).toBeLessThanOrEqual(2);
  });

  test('an error stays where it was, and the last picture under it', async ({ page }) => {
    const numbers = await openCrowd(page);
    const wrong = await findStill(page, numbers);
    await page.addStyleTag({ content: 'volume-view::part(error) { visibility: hidden }' });
    await withElement(page, (view) => view.setAttribute('transfer-function', 'nonsense'), { selector: `#v${wrong}` });
    await waitForEvent(page, 'error', { id: `v${wrong}` });
    expectSamePicture(await takeScreenshot(page, `#v${wrong}`), expected(wrong));
    await page.locator(`#v${wrong}`).hover();
    await expect.poll(() => isLive(page, wrong)).toBe(true);
    await takePlace(page, wrong, numbers);
    await expect(page.locator(`#v${wrong} .error`)).toContainText('nonsense');
    expectSamePicture(await takeScreenshot(page, `#v${wrong}`), expected(wrong));
  });

  test('where all of them move without end, each gets its turns', async ({ page }) => {
    const clock = '<timesensor def="clock" cycleinterval="3" loop="true"></timesensor>';
    const numbers = await openCrowd(page, { children: clock });
    // Beside those that draw all the time, one that was never drawn comes to be drawn.
    await page.evaluate((html) => document.body.insertAdjacentHTML('beforeend', html), element(90));
    await waitUntilDrawn(page, [90]);
    expectSamePicture(await takeScreenshot(page, '#v90'), expected(90));
    await forgetEvents(page);
    await expect.poll(async () => new Set((await seenEvents(page)).map(({ id }) => id)).size).toBe(numbers.length);
    expect((await contexts(page)).most).toBe(maxContexts);
  });
});

test('what is in sight keeps its context when a script asks for what is not', async ({ page }) => {
  const numbers = Array.from({ length: maxContexts }, (_, i) => i);
  const far = [30, 31];
  const row = numbers.map((i) => element(i)).join('');
  await countContexts(page);
  await open(page, `<div style="display: grid; grid-template-columns: repeat(5, 130px)">${row}</div><div style="height: 6000px"></div>${far.map((i) => element(i)).join('')}`, { head: black });
  await waitUntilDrawn(page, numbers);
  await page.evaluate(() => Object.assign(window, { kept: [...document.querySelectorAll('volume-view')].map((view) => view.shadowRoot!.querySelector('x3d')) }));
  const pictures = await Promise.all(far.map((i) => takePicture(page, { selector: `#v${i}` })));
  for (const [n, i] of far.entries()) expectSamePicture(pictures[n], drawReference({ steps: 20 + i, ...(i % 2 ? { volume: ball } : {}) }));
  const same = await page.evaluate(() => {
    const { kept } = window as unknown as { kept: (Element | null)[] };
    return [...document.querySelectorAll('volume-view')].map((view, n) => kept[n] !== null && kept[n] === view.shadowRoot!.querySelector('x3d'));
  });
  expect(same).toEqual([...numbers.map(() => true), ...far.map(() => false)]);
  await expect.poll(() => contexts(page)).toEqual({ now: maxContexts, most: maxContexts + 1 });
});

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
    await withElement(page, (view) => view.setAttribute('steps', '60'));
    await forgetEvents(page);
    await page.waitForTimeout(200);
    expect(await seenEvents(page)).toEqual([]);
    await page.evaluate(() => scrollTo(0, 0));
    await waitForEvent(page, 'render');
    expectSamePicture(await takeScreenshot(page, '#v0'), drawReference(onBlack));
  });

  test('a person\'s way around the author\'s viewpoint stays', async ({ page }) => {
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

  test('steps that were chosen are not chosen anew', async ({ page }) => {
    await countContexts(page);
    await open(page, `<volume-view id="v0" src="${fieldUrl}" ${attributesOf({ steps: 'auto' })}></volume-view>${tall}`, { head: black });
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
    await open(page, `<volume-view id="v0" src="${urls}" ${attributesOf()} play play-speed="5"></volume-view>${tall}`, { head: black });
    const index = (): Promise<number> => withElement(page, (view) => view.scan?.index ?? -1);
    await expect.poll(index).toBe(1);
    await away(page);
    await page.waitForTimeout(500);
    const stands = await index();
    await forgetEvents(page);
    await page.waitForTimeout(1000);
    expect(await index()).toBe(stands);
    expect(await seenEvents(page)).toEqual([]);
    await page.evaluate(() => scrollTo(0, 0));
    await expect.poll(index).not.toBe(stands);
    await expect.poll(index).toBe(stands);
  });
});
