import type { Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import { files } from './helpers/data.ts';
import {
  compare,
  expect,
  fieldUrl,
  networkLines,
  open,
  settle,
  takeScreenshot,
  keptTest as test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';
import { serveSlowly } from './helpers/slow-server.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

/** A page around an element that has what axe wants of pages. */
const inPage = (element: string): string => `<main><h1>A volume</h1>${element}</main>`;

const status = (page: Page): Promise<string> =>
  withElement(page, (element) => element.shadowRoot!.querySelector('[role=status]')!.textContent.trim());

test('axe finds nothing while it loads, and the status is reported', async ({ page }) => {
  const server = await serveSlowly(files['field.nii'], 0.45);
  await open(page, inPage(`<volume-view src="${server.url}" alt="A field"></volume-view>`));
  await expect.poll(() => status(page)).toBe('Loading 40%');
  await expect(page.getByRole('progressbar')).toHaveAttribute('value', /^0\.4/);
  await expect(page.getByRole('progressbar')).toBeVisible();
  expect(await findFaults(page)).toEqual([]);
  server.release();
  await settle(page);
  await expect.poll(() => status(page)).toBe('Loaded');
  await expect(page.getByRole('progressbar')).toHaveCount(0);
  server.close();
});

test('axe finds nothing once it is loaded', async ({ page }) => {
  await open(page, inPage(plain));
  await settle(page);
  expect(await findFaults(page)).toEqual([]);
  await expect(page.getByRole('img', { name: 'A field' })).toBeVisible();
});

for (const attributes of ['', 'alt=""', 'interaction="none" alt="A field"', 'interaction="none" alt=""']) {
  test(`axe finds nothing with <volume-view ${attributes}>`, async ({ page }) => {
    await open(page, inPage(`<volume-view src="${fieldUrl}" ${attributes}></volume-view>`));
    await settle(page);
    expect(await findFaults(page)).toEqual([]);
  });
}

test.describe('in error', () => {
  test.use({ allowedLines: networkLines });

  test('axe finds nothing, and the error is reported once', async ({ page }) => {
    await open(page, inPage('<volume-view src="nowhere.nii" alt="A field"></volume-view>'));
    await waitForEvent(page, 'error');
    await expect(page.getByRole('alert')).toContainText('404');
    expect(await status(page)).toBe('');
    expect(await findFaults(page)).toEqual([]);
  });

  test('axe finds nothing where the old picture stands behind the words', async ({ page }) => {
    await open(page, inPage(plain));
    await settle(page);
    await page.locator('volume-view').evaluate((element) => element.setAttribute('steps', 'lots'));
    await waitForEvent(page, 'error');
    expect(await findFaults(page)).toEqual([]);
  });
});

test('the focus is visible by keyboard, and not by mouse', async ({ page }) => {
  await open(page, `${plain}<button>Next</button>`);
  await settle(page);
  const before = await takeScreenshot(page);
  await page.mouse.click(60, 45);
  expect(compare(await takeScreenshot(page), before).worst).toBe(0);
  await page.locator('button').focus();
  await page.keyboard.press('Shift+Tab');
  const focused = await withElement(page, (element) => document.activeElement === element);
  expect(focused).toBe(true);
  expect(compare(await takeScreenshot(page), before).worst).toBeGreaterThan(100);
  await page.keyboard.press('Tab');
  await expect(page.locator('button')).toBeFocused();
});

test('the title of a manifest names it where alt is absent, and the keys are described', async ({ page }) => {
  await open(page, '<volume-view src="/test/e2e/pages/data/field.json"></volume-view>');
  await settle(page);
  const picture = page.getByRole('img', { name: 'A smooth field' });
  await expect(picture).toBeVisible();
  await expect(picture).toHaveAccessibleDescription(/Arrow keys/);
});
