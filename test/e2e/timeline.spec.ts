// The timeline: its buttons, its slider, and what it says.
import type { Locator, Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import { expect, keptTest as test, open, withElement } from './helpers/harness.ts';
import { expectShown, listed, look, serve, reported } from './helpers/scans.ts';

const timeline = '<volume-timeline style="width: 600px"></volume-timeline>';

test.describe('<volume-timeline>', () => {
  const slider = (page: Page): Locator => page.getByRole('slider', { name: 'Scan' });
  const button = (page: Page, name: string): Locator => page.getByRole('button', { name });

  /** A page as axe wants it. */
  const inPage = (element: string): string => `<main><h1>A storm</h1>${element}${timeline}</main>`;

  test('has buttons and a slider that name the scans; axe finds nothing', async ({ page }) => {
    await serve(page, { manifest: listed(6) });
    await open(page, inPage(`<volume-view src="/scans/list.json" ${look} time="1" alt="Scans"></volume-view>`));
    await expect(slider(page)).toHaveAttribute('aria-valuetext', '06:06 UTC, Dec 20, 2018, scan 2 of 6');
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
    await expect.poll(async () => (await reported(page)).map(({ index }) => index)).toContain(3);
    await button(page, 'Pause').click();
    await expect(button(page, 'Play')).toBeVisible();
    expect(await findFaults(page)).toEqual([]);
  });

  test('is operable by keyboard', async ({ page }) => {
    await serve(page, { manifest: listed(6) });
    await open(page, inPage(`<volume-view src="/scans/list.json" ${look} alt="Scans"></volume-view>`));
    await expect(slider(page)).toBeEnabled();
    await slider(page).focus();
    for (const [key, scan] of [
      ['ArrowRight', 1],
      ['End', 5],
      ['ArrowLeft', 4],
      ['Home', 0],
    ] as const) {
      await page.keyboard.press(key);
      await expectShown(page, scan);
      await expect(slider(page)).toHaveValue(String(scan));
    }
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Enter');
    await expectShown(page, 1);
  });

  test('writes times in the zone that the page asks for, and says so where nobody knows it', async ({ page }) => {
    await serve(page);
    const odim = '/test/fixtures/radar/odim-2.1.h5';
    await open(
      page,
      `<volume-view src="${odim} ${odim}?2" ${look} alt="Scans"></volume-view><volume-timeline time-zone="Asia/Kolkata"></volume-timeline>`,
    );
    const zone = page.locator('volume-timeline .day');
    await expect(zone).toContainText('GMT+5:30');
    const clock = async (): Promise<number> => {
      const [hours, minutes] = (await page.locator('volume-timeline .clock').textContent())!.split(':').map(Number);
      return 60 * hours + minutes;
    };
    const there = await clock();
    await page.locator('volume-timeline').evaluate((element) => element.removeAttribute('time-zone'));
    await expect(zone).toContainText('UTC');
    expect((there - (await clock()) + 1440) % 1440).toBe(330);
    await page.locator('volume-timeline').evaluate((element) => element.setAttribute('time-zone', 'Mars/Base'));
    await expect(page.locator('volume-timeline').getByRole('alert')).toContainText(
      'time-zone of <volume-timeline> got "Mars/Base"',
    );
    await expect(zone).toContainText('UTC');
  });

  test('says so where there is one scan, or none, and waits in words of its own', async ({ page }) => {
    const server = await serve(page);
    await open(page, inPage(`<volume-view ${look} alt="Scans"></volume-view>`));
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
