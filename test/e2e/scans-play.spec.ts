// Scans that play, times that are wrong, and scans that fail.
import { expect, networkLines, seenEvents, settle, test, withElement } from './helpers/harness.ts';
import { colors, expectMiddle, expectShown, listed, look, middle, openScans, serve, several, shown, told } from './helpers/scans.ts';

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
