// The radar's page among the demos, with the built package in the place of its sources.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { findFaults } from './helpers/axe.ts';
import { openDemo } from './helpers/demo.ts';
import { compare, expect, fewPixels, settle, takePicture, test, withElement } from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';

test.use({ ...fewPixels, viewport: { width: 420, height: 900 } });

/** With small pictures of few steps: what they show is told elsewhere. */
async function openRadar(page: Page): Promise<void> {
  await openDemo(page, 'radar.html', '.radar volume-view { inline-size: 5rem }');
  await page.locator('volume-view').evaluate((element) => element.setAttribute('steps', '40'));
  await settle(page);
}

/** Let files of the fixtures fall onto the page. */
async function drop(page: Page, ...names: string[]): Promise<void> {
  const files = names.map((name) => ({
    name: name.split('/').at(-1)!,
    base64: readFileSync(join(projectRoot, 'test/fixtures', name)).toString('base64'),
  }));
  const transfer = await page.evaluateHandle((all) => {
    const data = new DataTransfer();
    for (const { name, base64 } of all)
      data.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    return data;
  }, files);
  await page.dispatchEvent('main', 'dragover', { dataTransfer: transfer });
  await expect(page.locator('body')).toHaveClass(/dropping/);
  await page.dispatchEvent('main', 'drop', { dataTransfer: transfer });
  await expect(page.locator('body')).not.toHaveClass(/dropping/);
}

const formatOf = (page: Page): Promise<string | undefined> => withElement(page, (element) => element.volume?.format);

test('the storm, its timeline, legend and editor are there, and axe finds nothing', async ({ page }) => {
  await openRadar(page);
  expect(meanOf(await takePicture(page))[3]).toBeGreaterThan(5);
  await expect(page.locator('volume-legend')).toContainText('dBZ');
  await page.getByText('Colours and opacities, by bands').click();
  await expect(page.locator('volume-transfer-function').getByRole('slider').first()).toBeVisible();
  expect(await page.locator('volume-transfer-function').getByRole('slider').count()).toBeGreaterThanOrEqual(15);
  expect(await findFaults(page)).toEqual([]);
});

test('the next scan is one of its own', async ({ page }) => {
  await openRadar(page);
  const before = await takePicture(page);
  await page.locator('volume-timeline').getByRole('button', { name: /next/i }).click();
  await expect(page.locator('volume-timeline')).toContainText('2 / 3');
  await settle(page);
  expect(compare(await takePicture(page), before).worst).toBeGreaterThan(30);
});

test('each cut comes with its box and goes with it; the section runs between the points that are given', async ({
  page,
}) => {
  await openRadar(page);
  await page.getByLabel('Range rings').uncheck();
  await page.getByLabel('Volume', { exact: true }).uncheck();
  await settle(page);
  for (const cut of ['PPI, one sweep', 'CAPPI, horizontal', 'RHI, vertical', 'Section']) {
    expect(meanOf(await takePicture(page))[3], 'nothing is left').toBeLessThan(0.01);
    await page.getByLabel(cut, { exact: true }).check();
    await settle(page);
    expect(meanOf(await takePicture(page))[3], cut).toBeGreaterThan(0.5);
    if (cut !== 'Section') await page.getByLabel(cut, { exact: true }).uncheck();
    await settle(page);
  }
  const before = await takePicture(page);
  await page.getByLabel('To, km north').fill('60');
  await page.getByLabel('To, km north').blur();
  await settle(page);
  await expect(page.locator('volume-slice[type=section]')).toHaveAttribute('to', '70000 60000');
  expect(compare(await takePicture(page), before).worst).toBeGreaterThan(30);
});

test('a file that is dropped is shown, its moments can be chosen, and the storm comes back', async ({ page }) => {
  await openRadar(page);
  await drop(page, 'radar/cfradial1-classic.nc');
  await expect.poll(() => formatOf(page)).toMatch(/^CfRadial 1/);
  await settle(page);
  await expect(page.locator('#what')).toContainText('Testfeld, 2024-05-17 12:00:03 UTC');
  expect(meanOf(await takePicture(page))[3]).toBeGreaterThan(0.1);
  await expect(page.locator('#moments')).toHaveText(/DBZ\s*VEL\s*WIDTH/);
  await page.locator('#moments').getByText('VEL').click();
  await expect.poll(() => withElement(page, (element) => element.volume?.unit)).toBe('m/s');
  await page.getByRole('button', { name: 'Back to the synthetic storm' }).click();
  await page.locator('volume-view').scrollIntoViewIfNeeded(); // On a phone it is far above the button, and loads when seen.
  await expect.poll(() => formatOf(page)).toMatch(/polar mosaic/);
  await settle(page);
  await expect(page.getByRole('radio', { name: 'Reflectivity' })).toBeChecked();
});

test('several files that are dropped are scans in time', async ({ page }) => {
  await openRadar(page);
  await drop(page, 'radar/odim-2.2.h5', 'radar/odim-2.1.h5');
  await expect.poll(() => formatOf(page)).toBe('ODIM_H5 2.1');
  await settle(page);
  await expect(page.locator('volume-timeline')).toContainText('1 / 2');
  await page.locator('volume-timeline').getByRole('button', { name: /next/i }).click();
  await expect.poll(() => formatOf(page)).toBe('ODIM_H5 2.2');
});

test("a file that is no radar's is an error on the picture, and nothing else breaks", async ({ page }) => {
  await openRadar(page);
  await drop(page, 'make-fixtures.py');
  await expect(page.locator('volume-view').getByRole('alert')).toContainText(
    'make-fixtures.py is of no known type; expected',
  );
  await drop(page, 'radar/odim-2.0.h5');
  await expect.poll(() => formatOf(page)).toBe('ODIM_H5 2.0');
});
