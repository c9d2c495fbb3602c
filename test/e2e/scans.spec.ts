// Several scans: which one is shown, and what is loaded when.
import { expect, open, settle, keptTest as test, withElement } from './helpers/harness.ts';
import {
  colors,
  expectMiddle,
  expectShown,
  listed,
  look,
  middle,
  serve,
  several,
  timeOf,
  reported,
  urls,
} from './helpers/scans.ts';

test.describe('a list of URLs', () => {
  test('shows the first, goes to the next and back, and says where it ends', async ({ page }) => {
    await serve(page);
    await open(page, `<volume-view ${several(3)}></volume-view>`);
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
    expect(await reported(page)).toEqual([0, 1, 2, 1].map((index) => ({ index, time: null, count: 3 })));
    // Where the person is, is no attribute; to set one shows its scan, though it says what it said before.
    expect(await withElement(page, (element) => element.time)).toBe(null);
    for (let i = 0; i < 2; i++) {
      await withElement(page, (element) => (element.time = 0));
      await expectShown(page, 0);
      await withElement(page, (element) => element.showScan(1));
      await expectShown(page, 1);
      expect(await withElement(page, (element) => element.time)).toBe(0);
    }
    expect(await withElement(page, (element) => [...element.times])).toEqual([null, null, null]);
  });

  test('loads the neighbours ahead, the next one first, and each once', async ({ page }) => {
    const { asked } = await serve(page);
    await open(page, `<volume-view ${several(4)} time="1"></volume-view>`);
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
    await open(page, `<volume-view ${several(8)}></volume-view>`);
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
    expect(
      asked.filter((scan) => scan === 0),
      'the first had made room',
    ).toHaveLength(2);
  });

  test('gives up what is no longer wanted', async ({ page }) => {
    const server = await serve(page);
    [1, 2, 3].forEach((scan) => server.held.add(scan));
    await open(page, `<volume-view ${several(6)}></volume-view>`);
    await expectShown(page, 0);
    await withElement(page, (element) => (element.time = '2'));
    await expect.poll(() => server.asked).toContain(2);
    expect(await withElement(page, (element) => element.waiting)).toBe(true);
    await withElement(page, (element) => (element.time = '4'));
    await expectShown(page, 4);
    server.held.clear();
    await expectMiddle(page, 4);
    expect((await reported(page)).map(({ index }) => index)).toEqual([0, 4]);
    expect(await withElement(page, (element) => element.waiting)).toBe(false);
  });

  test('has no blank picture between two', async ({ page }) => {
    await serve(page);
    await open(page, `<volume-view ${several(3)}></volume-view>`);
    await expectMiddle(page, 0);
    const seen: string[] = [];
    await withElement(page, (element) => Object.assign(element, { playSpeed: '5' }).play());
    for (let i = 0; i < 40; i++) seen.push(await middle(page));
    await withElement(page, (element) => element.pause());
    expect(new Set(seen)).toEqual(new Set(colors.slice(0, 3)));
  });

  test('leaves camera, window and looks as they are', async ({ page }) => {
    await serve(page, { height: (scan) => 8 + 3 * scan });
    const plain = `src="${urls(3).join(' ')}" steps="16" alt="Scans"`;
    await open(page, `<volume-view ${plain}></volume-view>`);
    await settle(page);
    await page.locator('volume-view').press('ArrowLeft');
    await settle(page);
    const read = () =>
      withElement(page, (element) =>
        JSON.stringify([element.optics, window.__seen.filter(({ type }) => type === 'camera-change').at(-1)?.detail]),
      );
    const before = await read();
    await withElement(page, (element) => element.next());
    await expectShown(page, 1);
    await settle(page);
    expect(await read()).toBe(before);
    expect(await withElement(page, (element) => element.volume!.dimensions[2])).toBe(11);
    // An attribute holds for all scans from then on.
    await withElement(page, (element) => (element.valueWindow = [0, 0.5]));
    await withElement(page, (element) => element.next());
    await expectShown(page, 2);
    await settle(page);
    expect(await withElement(page, (element) => element.optics!.window)).toEqual([0, 0.5]);
  });

  test('begins again with another source, and goes on where the element is put elsewhere', async ({ page }) => {
    await serve(page);
    await open(page, `<volume-view ${several(3)} time="2"></volume-view><div></div>`);
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
    expect(await withElement(page, (element) => [element.next(), element.times.length, element.scan])).toEqual([
      false,
      1,
      { index: 0, time: null, count: 1 },
    ]);
  });
});

test.describe('a manifest', () => {
  test('knows the times before the scans are loaded', async ({ page }) => {
    const { asked } = await serve(page, { manifest: listed(6) });
    await open(
      page,
      `<volume-view src="/scans/list.json" ${look} time="${timeOf(3).replace('28Z', '40Z')}" alt="Scans"></volume-view>`,
    );
    await expectMiddle(page, 3);
    expect(asked[0]).toBe(3);
    expect(await reported(page)).toEqual([{ index: 3, time: timeOf(3), count: 6 }]);
    expect(await withElement(page, (element) => [...element.times])).toEqual([0, 1, 2, 3, 4, 5].map(timeOf));
    await withElement(page, (element) => (element.time = '2018-12-20T01:00:00Z'));
    await expectShown(page, 0);
    await withElement(page, (element) => (element.time = '2018-12-20T07:12:28+01:00'));
    await expectShown(page, 2);
  });

  test("shows the radar's own times of a list of files", async ({ page }) => {
    const storm = ['1500', '1510', '1520'].map((clock) => `/demos/data/storm-radar-${clock}.json`);
    await open(
      page,
      `<volume-view src="${storm.join(' ')}" time="2011-06-20T15:19:00Z" steps="16" alt="Storm"></volume-view>`,
    );
    await expectShown(page, 1);
    expect(await reported(page)).toEqual([{ index: 1, time: '2011-06-20T15:10:00Z', count: 3 }]);
    await expect
      .poll(() => withElement(page, (element) => [...element.times]))
      .toEqual(['2011-06-20T15:00:00Z', '2011-06-20T15:10:00Z', '2011-06-20T15:20:00Z']);
  });
});
