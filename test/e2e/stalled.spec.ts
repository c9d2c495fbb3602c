// Servers that are slow, busy or gone for a while.
import type { Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import { files } from './helpers/data.ts';
import {
  expect,
  expectSamePicture,
  fieldUrl,
  networkLines,
  open,
  seenEvents,
  settle,
  takePicture,
  test,
  waitForEvent,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { serveSlowly } from './helpers/slow-server.ts';

const viewOf = (src: string, id = 'view'): string =>
  `<volume-view id="${id}" src="${src}" ${attributesOf()} alt="A field" interaction="all"></volume-view>`;

/** Wait until bytes came, and let the page's clock go on. */
async function passSeconds(page: Page, seconds: number): Promise<void> {
  await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { loaded?: number } | null)?.loaded));
  await page.clock.runFor(seconds * 1000);
}

test('a load without progress says so, and is tried again by keys', async ({ page }) => {
  const server = await serveSlowly(files['field.nii'], 0.5);
  await page.clock.install();
  await open(page, `<main><h1>Field</h1>${viewOf(server.url)}</main>`);
  await passSeconds(page, 31);
  const { detail } = await waitForEvent(page, 'error');
  expect(detail).toMatchObject({ code: 'source/stalled' });
  await server.dropped;
  const alert = page.getByRole('alert');
  await expect(alert.getByRole('paragraph').first()).toHaveText('Loading has stopped.');
  const button = alert.getByRole('button', { name: 'Try again' });
  await button.scrollIntoViewIfNeeded();
  expect(Math.round((await button.boundingBox())!.height)).toBeGreaterThanOrEqual(44);
  expect(await findFaults(page)).toEqual([]);
  server.release();
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(alert).toHaveCount(0);
  await expect(page.locator('.picture')).toBeFocused();
  await settle(page);
  expectSamePicture(await takePicture(page), drawReference());
  expect(server.requests()).toBe(2);
  server.close();
});

test('six stalled servers do not keep another file waiting', async ({ page }) => {
  const server = await serveSlowly(files['field.nii'], 0.5);
  await page.clock.install();
  const stalled = Array.from({ length: 6 }, (_, i) => viewOf(`${server.url}?${i}`, `stalled${i}`)).join('');
  await open(page, `<div style="display: flex">${stalled}</div>`);
  await expect.poll(server.requests).toBe(6);
  await page.evaluate(
    (html) => document.querySelector('div')!.insertAdjacentHTML('beforeend', html),
    viewOf(fieldUrl, 'good'),
  );
  await passSeconds(page, 6);
  await waitForEvent(page, 'load', { id: 'good' });
  expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('error');
  server.close();
});

test.describe('a server that is busy', () => {
  test.use({ allowedLines: networkLines });

  test('for a moment is asked again, and nobody sees it', async ({ page }) => {
    let asked = 0;
    await page.route(`**${fieldUrl}`, (route) =>
      asked++ < 2 ? route.fulfill({ status: 503, headers: { 'retry-after': '0' } }) : route.continue(),
    );
    await open(page, viewOf(fieldUrl));
    expectSamePicture(await takePicture(page), drawReference());
    expect(asked).toBe(3);
    expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('error');
  });

  for (const [status, code, headline] of [
    [500, 'source/unavailable', 'The file is not available now.'],
    [404, 'source/not-found', 'The file could not be loaded.'],
  ] as const) {
    test(`${status} is ${code}; the reader's line shows no address, and one may try again`, async ({ page }) => {
      let isWell = false;
      await page.route(`**${fieldUrl}`, (route) => (isWell ? route.continue() : route.fulfill({ status })));
      await open(page, viewOf(fieldUrl));
      expect((await waitForEvent(page, 'error')).detail).toMatchObject({ code });
      await expect(page.getByRole('alert').getByRole('paragraph').first()).toHaveText(headline);
      isWell = true;
      await page.getByRole('button', { name: 'Try again' }).click();
      await settle(page);
      expectSamePicture(await takePicture(page), drawReference());
    });
  }
});

test('what another load does not mend is not offered to be tried again', async ({ page }) => {
  await open(page, viewOf(fieldUrl).replace('steps="30"', 'steps="lots"'));
  await waitForEvent(page, 'error');
  await expect(page.getByRole('alert')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Try again' })).toHaveCount(0);
});
