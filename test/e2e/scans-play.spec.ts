// Scans that play, times that are wrong, and scans that fail.
import { expect, networkLines, open, seenEvents, settle, keptTest as test, withElement } from './helpers/harness.ts';
import {
  colors,
  expectMiddle,
  expectShown,
  listed,
  look,
  middle,
  serve,
  several,
  shown,
  reported,
} from './helpers/scans.ts';

test.describe('play', () => {
  test('goes round and round, and stops where it is asked to', async ({ page }) => {
    await serve(page);
    await open(page, `<volume-view ${several(3)} autoplay play-speed="10"></volume-view>`);
    await expect.poll(async () => (await reported(page)).length).toBeGreaterThan(6);
    expect(await withElement(page, (element) => element.paused)).toBe(false);
    await withElement(page, (element) => element.pause());
    await settle(page);
    const seen = (await reported(page)).map(({ index }) => index);
    expect(seen).toEqual(seen.map((_, i) => i % 3));
    await page.waitForTimeout(400);
    expect(await reported(page)).toHaveLength(seen.length);
    // What a person or a script does is no attribute.
    expect(await withElement(page, (element) => [element.paused, element.autoplay, element.time])).toEqual([
      true,
      true,
      null,
    ]);
  });

  test('by itself waits while less motion is asked for, also when that is asked for later, until somebody says so', async ({
    page,
  }) => {
    await serve(page);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await open(page, `<volume-view ${several(3)} autoplay play-speed="10"></volume-view>`);
    await settle(page);
    await page.waitForTimeout(400);
    expect(await withElement(page, (element) => [element.paused, element.scan?.index])).toEqual([true, 0]);
    const paused = (): Promise<boolean> => withElement(page, (element) => element.paused);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await expect.poll(paused, 'no longer').toBe(false);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await expect.poll(paused, 'while it plays by itself').toBe(true);
    await withElement(page, (element) => element.play());
    await expect.poll(async () => (await reported(page)).length, 'a person or a script says so').toBeGreaterThan(3);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.waitForTimeout(100);
    expect(await paused(), 'and goes on').toBe(false);
    await withElement(page, (element) => element.pause());
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await page.waitForTimeout(100);
    expect(await paused(), 'somebody wants it to stand').toBe(true);
  });

  test('begins and ends by methods, with events; play() waits for the source, and pause() refuses it', async ({
    page,
  }) => {
    await serve(page);
    await open(page, `<volume-view alt="Scans" ${look}></volume-view>`);
    const [events, refused, before, after] = await withElement(
      page,
      async (element, src) => {
        const events: string[] = [];
        for (const name of ['play', 'pause'] as const) element.addEventListener(name, () => events.push(name));
        element.src = src;
        const before = element.paused;
        const refused = element.play().catch((error: DOMException) => error.name);
        element.pause();
        await element.play();
        return [events, await refused, before, element.paused];
      },
      { argument: several(2).split('"')[1] },
    );
    expect(events).toEqual(['play', 'pause', 'play']);
    expect([refused, before, after]).toEqual(['AbortError', true, false]);
    await expect.poll(async () => (await reported(page)).length).toBeGreaterThan(2);
  });

  test('is refused where there is one scan, none, or an error', async ({ page }) => {
    await serve(page);
    await open(page, `<volume-view alt="Scans" ${look}></volume-view>`);
    for (const src of [null, '/scans/0.nii']) {
      const result = await withElement(
        page,
        async (element, src) => {
          element.src = src;
          const name = await element.play().catch((error: DOMException) => error.name);
          return [name, element.paused];
        },
        { argument: src },
      );
      expect(result, `${src}`).toEqual(['NotSupportedError', true]);
    }
  });

  test.describe('in its old spelling', () => {
    test.use({
      allowedLines:
        /^warning: <volume-view>: the (attribute play|property renderComplete) is an old name; write (autoplay|whenRendered\(\))\.$/,
    });

    test('is a switch still, and the console says once what to write', async ({ page, lines }) => {
      await serve(page);
      await open(page, `<volume-view ${several(3)} play play-speed="10"></volume-view>`);
      await expect.poll(async () => (await reported(page)).length).toBeGreaterThan(3);
      await withElement(page, (element) => element.removeAttribute('play'));
      expect(await withElement(page, (element) => element.paused)).toBe(true);
      await withElement(page, async (element) => {
        element.setAttribute('play', '');
        await element.updateComplete;
      });
      expect(await withElement(page, (element) => element.paused)).toBe(false);
      await withElement(page, async (element) => {
        const { renderComplete } = element as unknown as { renderComplete: Promise<void> };
        element.pause();
        await renderComplete;
      });
      expect(lines.filter((line) => line.includes('old name'))).toHaveLength(2);
    });
  });

  test.describe('with errors', () => {
    test.use({ allowedLines: networkLines });

    test('passes over a scan that fails; the last good picture stays, and the error is reported', async ({ page }) => {
      await serve(page, { missing: [1] });
      await open(page, `<volume-view ${several(3)} style="width: 400px; height: 300px"></volume-view>`);
      await settle(page);
      await withElement(page, (element) => element.next());
      await expect(page.getByRole('alert')).toContainText('404');
      expect(await middle(page, 200, 120)).toBe(colors[0]);
      expect(await shown(page)).toBe(0);
      await withElement(page, (element) => Object.assign(element, { playSpeed: '10' }).play());
      await expect.poll(async () => (await reported(page)).map(({ index }) => index).join('')).toContain('0202');
      expect((await seenEvents(page)).filter(({ type }) => type === 'error').length).toBeGreaterThan(1);
      expect(await withElement(page, (element) => element.paused)).toBe(false);
    });

    test("of a manifest's first scan leaves the others; where all fail, it stops", async ({ page }) => {
      await serve(page, { missing: [0], manifest: listed(2) });
      await open(page, `<volume-view src="/scans/list.json" ${look} alt="Scans"></volume-view>`);
      await expect(page.getByRole('alert')).toContainText('404');
      expect(await withElement(page, (element) => element.next())).toBe(true);
      await expectMiddle(page, 1);
      await withElement(page, (element) =>
        Object.assign(element, { src: '/scans/0.nii /scans/0.nii?2', time: null, playSpeed: '20' })
          .play()
          .catch(() => {}),
      );
      await expect.poll(() => withElement(page, (element) => element.paused)).toBe(true);
    });
  });

  test('says what is wrong with a time, and shows what it can', async ({ page }) => {
    await serve(page);
    await open(page, `<volume-view ${several(3)} time="noon"></volume-view>`);
    await expect(page.getByRole('alert')).toContainText(
      'time got "noon"; expected a scan\'s number from 0, or a time in UTC',
    );
    await expectShown(page, 0);
    await withElement(page, (element) => (element.time = '3'));
    await expect(page.getByRole('alert')).toContainText('time got "3"; expected the number of a scan, from 0 to 2');
    await withElement(page, (element) => (element.time = '2'));
    await expectShown(page, 2);
    await expect(page.getByRole('alert')).toHaveCount(0);
  });
});
