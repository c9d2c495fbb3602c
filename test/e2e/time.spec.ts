// Several scans: which one is shown, what is loaded when, and the timeline.
import type { Locator, Page } from '@playwright/test';
import { syntheticVolume } from '../helpers/synthetic.ts';
import { findFaults } from './helpers/axe.ts';
import { niftiBytes } from './helpers/data.ts';
import { expect, networkLines, open, seenEvents, settle, test, withElement } from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';


/** One colour a scan: red, green, blue, yellow, cyan, magenta, white, gray. */
const colors = ['#f00', '#0f0', '#00f', '#ff0', '#0ff', '#f0f', '#fff', '#888'];
const valueOf = (scan: number): number => (20 + 20 * scan) / 255;
const look = `transfer-function="${colors.map((color, i) => `${valueOf(i)} ${color} 100%`).join(', ')}" window="0 1" steps="16"`;

/** When scan i began. */
const timeOf = (scan: number): string => `2018-12-20T06:${String(6 * scan).padStart(2, '0')}:28Z`;
const urls = (count: number): string[] => Array.from({ length: count }, (_, i) => `/scans/${i}.nii`);
const several = (count: number): string => `src="${urls(count).join(' ')}" ${look} alt="Scans"`;
const timeline = '<volume-timeline style="width: 600px"></volume-timeline>';

interface Server {
  /** Numbers of the scans in the order in which they were asked for. */
  readonly asked: number[];
  /** Scans that do not come until they are let go. */
  readonly held: Set<number>;
}

interface ServerOptions {
  readonly missing?: readonly number[];
  readonly manifest?: object;
  /** Slices of a scan. */
  readonly height?: (scan: number) => number;
}

/** Serve scans of one value each, some of them missing, and manifests. */
async function serve(page: Page, { missing = [], manifest = {}, height = () => 8 }: ServerOptions = {}): Promise<Server> {
  const server: Server = { asked: [], held: new Set() };
  await page.route('**/scans/*.nii', async (route) => {
    const scan = Number(/(\d+)\.nii/.exec(route.request().url())![1]);
    server.asked.push(scan);
    if (missing.includes(scan)) return route.fulfill({ status: 404, body: 'no' });
    while (server.held.has(scan)) await new Promise((resolve) => setTimeout(resolve, 20));
    const volume = syntheticVolume({ dimensions: [8, 8, height(scan)], field: () => valueOf(scan) });
    await route.fulfill({ body: Buffer.from(niftiBytes(volume)), contentType: 'application/octet-stream' }).catch(() => {});
  });
  await page.route('**/scans/list.json', (route) => route.fulfill({ json: manifest }));
  return server;
}

const listed = (count: number): object => ({ scans: Array.from({ length: count }, (_, i) => ({ image: `${i}.nii`, time: timeOf(i) })) });

/** Open a page whose element's changes of time are kept. */
async function openScans(page: Page, body: string): Promise<void> {
  await page.addInitScript(() => {
    const told: unknown[] = ((window as unknown as { told: unknown[] }).told = []);
    document.addEventListener('time-change', (event) => told.push((event as CustomEvent).detail), true);
  });
  await open(page, body);
}

const told = (page: Page): Promise<{ index: number; time: string | null; count: number }[]> =>
  page.evaluate(() => (window as unknown as { told: { index: number; time: string | null; count: number }[] }).told);
const shown = (page: Page): Promise<number | undefined> => withElement(page, (element) => element.scan?.index);
const expectShown = (page: Page, index: number): Promise<void> => expect.poll(() => shown(page)).toBe(index);

/** The colour in the middle of the picture as it stands on the screen, each channel 0 to 15. */
async function middle(page: Page, x = 59, y = 44): Promise<string> {
  const { data } = decodePicture(await page.screenshot({ clip: { x, y, width: 2, height: 2 } }));
  return `#${[...data.subarray(0, 3)].map((x) => Math.round(x / 17).toString(16)).join('')}`;
}

async function expectMiddle(page: Page, scan: number): Promise<void> {
  await settle(page);
  await expect.poll(() => middle(page)).toBe(colors[scan]);
}

test.describe('a list of URLs', () => {
  test('shows the first, goes to the next and back, and says where it ends', async ({ page }) => {
    await serve(page);
    await openScans(page, `<volume-view ${several(3)}></volume-view>`);
    await expectMiddle(page, 0);
    expect(await withElement(page, (element) => element.previous())).toBe(false);
    expect(await withElement(page, (element) => element.next())).toBe(true);
    await expectShown(page, 1);
    await expectMiddle(page, 1);
    // Two at once are two steps, or as many as there are.
    expect(await withElement(page, (element) => [element.next(), element.next()])).toEqual([true, false]);
    await expectShown(page, 2);
    expect(await withElement(page, (element) => element.previous())).toBe(true);
    await expectShown(page, 1);
    expect(await told(page)).toEqual([0, 1, 2, 1].map((index) => ({ index, time: null, count: 3 })));
    expect(await withElement(page, (element) => element.time)).toBe('1');
    expect(await withElement(page, (element) => [...element.times])).toEqual([null, null, null]);
  });

  test('loads the neighbours ahead, the next one first, and each once', async ({ page }) => {
    const { asked } = await serve(page);
    await openScans(page, `<volume-view ${several(4)} time="1"></volume-view>`);
    await expect.poll(() => asked).toEqual([1, 2, 0]);
    await withElement(page, (element) => element.next());
    await expectShown(page, 2);
    await expect.poll(() => asked).toEqual([1, 2, 0, 3]);
    for (const time of ['0', '3', '1']) {
      await withElement(page, (element, wanted) => (element.time = wanted), { argument: time });
      await expectShown(page, Number(time));
    }
    expect(asked).toEqual([1, 2, 0, 3]);
  });

  test('keeps five at most', async ({ page }) => {
    const { asked } = await serve(page);
    await openScans(page, `<volume-view ${several(8)}></volume-view>`);
    for (let i = 1; i < 8; i++) {
      await expectShown(page, i - 1);
      await withElement(page, (element) => element.next());
    }
    await expectShown(page, 7);
    expect(asked).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    for (const time of ['4', '3']) {
      await withElement(page, (element, wanted) => (element.time = wanted), { argument: time });
      await expectShown(page, Number(time));
    }
    expect(asked.slice(0, 8)).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    await withElement(page, (element) => (element.time = '0'));
    await expectShown(page, 0);
    expect(asked.filter((scan) => scan === 0), 'the first had made room').toHaveLength(2);
  });

  test('gives up what is no longer wanted', async ({ page }) => {
    const server = await serve(page);
    [1, 2, 3].forEach((scan) => server.held.add(scan));
    await openScans(page, `<volume-view ${several(6)}></volume-view>`);
    await expectShown(page, 0);
    await withElement(page, (element) => (element.time = '2'));
    await expect.poll(() => server.asked).toContain(2);
    expect(await withElement(page, (element) => element.waiting)).toBe(true);
    await withElement(page, (element) => (element.time = '4'));
    await expectShown(page, 4);
    server.held.clear();
    await expectMiddle(page, 4);
    expect((await told(page)).map(({ index }) => index)).toEqual([0, 4]);
    expect(await withElement(page, (element) => element.waiting)).toBe(false);
  });

  test('has no blank picture between two', async ({ page }) => {
    await serve(page);
    await openScans(page, `<volume-view ${several(3)}></volume-view>`);
    await expectMiddle(page, 0);
    const seen: string[] = [];
    await withElement(page, (element) => Object.assign(element, { playSpeed: '5', play: true }));
    for (let i = 0; i < 40; i++) seen.push(await middle(page));
    await withElement(page, (element) => (element.play = false));
    expect(new Set(seen)).toEqual(new Set(colors.slice(0, 3)));
  });

  test('leaves camera, window and looks as they are', async ({ page }) => {
    await serve(page, { height: (scan) => 8 + 3 * scan });
    const plain = `src="${urls(3).join(' ')}" steps="16" alt="Scans"`;
    await openScans(page, `<volume-view ${plain}></volume-view>`);
    await settle(page);
    await page.locator('volume-view').press('ArrowLeft');
    await settle(page);
    const read = () => withElement(page, (element) => JSON.stringify([element.optics, window.__seen.filter(({ type }) => type === 'camera-change').at(-1)?.detail]));
    const before = await read();
    await withElement(page, (element) => element.next());
    await expectShown(page, 1);
    await settle(page);
    expect(await read()).toBe(before);
    expect(await withElement(page, (element) => element.volume!.dimensions[2])).toBe(11);
    // An attribute holds for all scans from then on.
    await withElement(page, (element) => (element.window = '0 0.5'));
    await withElement(page, (element) => element.next());
    await expectShown(page, 2);
    await settle(page);
    expect(await withElement(page, (element) => element.optics!.window)).toEqual([0, 0.5]);
  });

  test('begins anew with another source, and goes on where the element is put elsewhere', async ({ page }) => {
    await serve(page);
    await openScans(page, `<volume-view ${several(3)} time="2"></volume-view><div></div>`);
    await expectMiddle(page, 2);
    await page.evaluate(() => {
      const view = document.querySelector('volume-view')!;
      view.remove();
      setTimeout(() => document.querySelector('div')!.append(view), 50);
    });
    await page.waitForTimeout(100);
    await expectMiddle(page, 2);
    await withElement(page, (element) => element.previous());
    await expectMiddle(page, 1);
    await withElement(page, (element) => Object.assign(element, { src: '/scans/3.nii', time: null }));
    await expectMiddle(page, 3);
    expect(await withElement(page, (element) => [element.next(), element.times.length, element.scan])).toEqual([false, 1, { index: 0, time: null, count: 1 }]);
  });
});

test.describe('a manifest', () => {
  test('knows the times before the scans are loaded', async ({ page }) => {
    const { asked } = await serve(page, { manifest: listed(6) });
    await openScans(page, `<volume-view src="/scans/list.json" ${look} time="${timeOf(3).replace('28Z', '40Z')}" alt="Scans"></volume-view>`);
    await expectMiddle(page, 3);
    expect(asked[0]).toBe(3);
    expect(await told(page)).toEqual([{ index: 3, time: timeOf(3), count: 6 }]);
    expect(await withElement(page, (element) => [...element.times])).toEqual([0, 1, 2, 3, 4, 5].map(timeOf));
    await withElement(page, (element) => (element.time = '2018-12-20T01:00:00Z'));
    await expectShown(page, 0);
    await withElement(page, (element) => (element.time = '2018-12-20T07:12:28+01:00'));
    await expectShown(page, 2);
  });

  test('shows the radar\'s own times of a list of files', async ({ page }) => {
    const storm = ['1500', '1510', '1520'].map((clock) => `/demos/data/storm-radar-${clock}.json`);
    await openScans(page, `<volume-view src="${storm.join(' ')}" time="2011-06-20T15:19:00Z" steps="16" alt="Storm"></volume-view>`);
    await expectShown(page, 1);
    expect(await told(page)).toEqual([{ index: 1, time: '2011-06-20T15:10:00Z', count: 3 }]);
    await expect.poll(() => withElement(page, (element) => [...element.times])).toEqual(['2011-06-20T15:00:00Z', '2011-06-20T15:10:00Z', '2011-06-20T15:20:00Z']);
  });
});

test.describe('play', () => {
  test('goes round and round, and holds where it is told to', async ({ page }) => {
    await serve(page);
    await openScans(page, `<volume-view ${several(3)} play play-speed="10"></volume-view>`);
    await expect.poll(async () => (await told(page)).length).toBeGreaterThan(6);
    await withElement(page, (element) => (element.play = false));
    await settle(page);
    const seen = (await told(page)).map(({ index }) => index);
    expect(seen).toEqual(seen.map((_, i) => i % 3));
    await page.waitForTimeout(400);
    expect(await told(page)).toHaveLength(seen.length);
    expect(await page.locator('volume-view').getAttribute('play')).toBe(null);
  });

  test.describe('with errors', () => {
    test.use({ allowedLines: networkLines });

    test('passes over a scan that fails; the last good picture stays, and the error is told', async ({ page }) => {
      await serve(page, { missing: [1] });
      await openScans(page, `<volume-view ${several(3)} style="width: 400px; height: 300px"></volume-view>`);
      await settle(page);
      await withElement(page, (element) => element.next());
      await expect(page.getByRole('alert')).toContainText('404');
      expect(await middle(page, 200, 120)).toBe(colors[0]);
      expect(await shown(page)).toBe(0);
      await withElement(page, (element) => Object.assign(element, { playSpeed: '10', play: true }));
      await expect.poll(async () => (await told(page)).map(({ index }) => index).join('')).toContain('0202');
      expect((await seenEvents(page)).filter(({ type }) => type === 'error').length).toBeGreaterThan(1);
      expect(await page.locator('volume-view').getAttribute('play')).toBe('');
    });

    test('of a manifest\'s first scan leaves the others; where all fail, it stops', async ({ page }) => {
      await serve(page, { missing: [0], manifest: listed(2) });
      await openScans(page, `<volume-view src="/scans/list.json" ${look} alt="Scans"></volume-view>`);
      await expect(page.getByRole('alert')).toContainText('404');
      expect(await withElement(page, (element) => element.next())).toBe(true);
      await expectMiddle(page, 1);
      await withElement(page, (element) => Object.assign(element, { src: '/scans/0.nii /scans/0.nii?2', time: null, playSpeed: '20', play: true }));
      await expect.poll(() => withElement(page, (element) => element.play)).toBe(false);
    });
  });

  test('says what is wrong with a time, and shows what it can', async ({ page }) => {
    await serve(page);
    await openScans(page, `<volume-view ${several(3)} time="noon"></volume-view>`);
    await expect(page.getByRole('alert')).toContainText('time got "noon"; expected a scan\'s number from 0, or a time in UTC');
    await expectShown(page, 0);
    await withElement(page, (element) => (element.time = '3'));
    await expect(page.getByRole('alert')).toContainText('time got "3"; expected the number of a scan, from 0 to 2');
    await withElement(page, (element) => (element.time = '2'));
    await expectShown(page, 2);
    await expect(page.getByRole('alert')).toHaveCount(0);
  });
});

test.describe('<volume-timeline>', () => {
  const slider = (page: Page): Locator => page.getByRole('slider', { name: 'Scan' });
  const button = (page: Page, name: string): Locator => page.getByRole('button', { name });

  /** A page as axe wants it. */
  const inPage = (element: string): string => `<main><h1>A storm</h1>${element}${timeline}</main>`;

  test('has buttons and a slider that name the scans; axe finds nothing', async ({ page }) => {
    await serve(page, { manifest: listed(6) });
    await openScans(page, inPage(`<volume-view src="/scans/list.json" ${look} time="1" alt="Scans"></volume-view>`));
    await expect(slider(page)).toHaveAttribute('aria-valuetext', '06:06 UTC, 20 Dec 2018, scan 2 of 6');
    await expect(slider(page)).toHaveValue('1');
    await expect(page.locator('volume-timeline').locator('.clock')).toHaveText('06:06');
    await expect(page.locator('volume-timeline').locator('.tick')).toHaveCount(6);
    expect(await findFaults(page)).toEqual([]);
    await button(page, 'Previous scan').click();
    await expectShown(page, 0);
    await expect(button(page, 'Previous scan')).toBeDisabled();
    await button(page, 'Next scan').click();
    await expectShown(page, 1);
    await button(page, 'Play').click();
    await expect(button(page, 'Pause')).toBeVisible();
    await expect.poll(async () => (await told(page)).map(({ index }) => index)).toContain(3);
    await button(page, 'Pause').click();
    await expect(button(page, 'Play')).toBeVisible();
    expect(await findFaults(page)).toEqual([]);
  });

  test('is operable by keyboard', async ({ page }) => {
    await serve(page, { manifest: listed(6) });
    await openScans(page, inPage(`<volume-view src="/scans/list.json" ${look} alt="Scans"></volume-view>`));
    await expect(slider(page)).toBeEnabled();
    await slider(page).focus();
    for (const [key, scan] of [['ArrowRight', 1], ['End', 5], ['ArrowLeft', 4], ['Home', 0]] as const) {
      await page.keyboard.press(key);
      await expectShown(page, scan);
      await expect(slider(page)).toHaveValue(String(scan));
    }
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Enter');
    await expectShown(page, 1);
  });

  test('says so where there is one scan, or none, and waits in words of its own', async ({ page }) => {
    const server = await serve(page);
    await openScans(page, inPage(`<volume-view ${look} alt="Scans"></volume-view>`));
    await expect(page.locator('volume-timeline')).toContainText('No volume is loaded yet.');
    for (const name of ['Previous scan', 'Play', 'Next scan']) await expect(button(page, name)).toBeDisabled();
    await expect(slider(page)).toBeDisabled();
    await withElement(page, (element) => (element.src = '/scans/0.nii'));
    await expect(page.locator('volume-timeline')).toContainText('There is one scan.');
    expect(await findFaults(page)).toEqual([]);
    server.held.add(2);
    await withElement(page, (element) => (element.src = '/scans/0.nii /scans/1.nii /scans/2.nii /scans/3.nii'));
    await expect(slider(page)).toBeEnabled();
    await withElement(page, (element) => (element.time = '2'));
    await expect(page.getByRole('group', { name: 'Time' })).toHaveAttribute('aria-busy', 'true');
    server.held.clear();
    await expect(page.getByRole('group', { name: 'Time' })).toHaveAttribute('aria-busy', 'false');
  });
});
