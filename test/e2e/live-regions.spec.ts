// What screen readers are told by themselves: nothing while scans play, and nothing of what is edited elsewhere.
import type { Page } from '@playwright/test';
import { editor, view } from './helpers/companions.ts';
import { expect, open, settle, keptTest as test, withElement } from './helpers/harness.ts';
import { serve, several } from './helpers/scans.ts';

type Heard = typeof globalThis & { heard: string[] };

/** Note from now on what changes in live regions, in all elements' shadow roots. */
async function listen(page: Page): Promise<() => Promise<string[]>> {
  await page.evaluate(() => {
    const heard: string[] = ((globalThis as Heard).heard = []);
    for (const host of document.querySelectorAll('*')) {
      if (!host.shadowRoot) continue;
      new MutationObserver((records) => {
        for (const { target } of records) {
          const region = (target instanceof Element ? target : target.parentElement)?.closest(
            'output, [role=status], [role=alert], [aria-live]',
          );
          if (region && region.getAttribute('aria-live') !== 'off')
            heard.push(`${host.localName}: ${region.textContent}`);
        }
      }).observe(host.shadowRoot, { subtree: true, childList: true, characterData: true });
    }
  });
  return () => page.evaluate(() => (globalThis as Heard).heard);
}

test('nothing is announced while scans play, and again what a person asks for', async ({ page }) => {
  const server = await serve(page);
  server.held.add(1);
  await open(page, `<volume-view ${several(4)} play-speed="5"></volume-view><volume-timeline></volume-timeline>`);
  await settle(page);
  await expect(page.locator('volume-timeline .count')).toHaveText('1 / 4');
  await withElement(page, (element) => element.play());
  const heard = await listen(page);
  await expect(page.locator('volume-timeline .timeline')).toHaveAttribute('aria-busy', 'true');
  server.held.clear();
  for (const count of ['2 / 4', '4 / 4', '1 / 4'])
    await expect(page.locator('volume-timeline .count')).toHaveText(count);
  expect(await heard()).toEqual([]);
  await withElement(page, (element) => {
    element.pause();
    element.showScan(0);
  });
  await expect(page.locator('volume-timeline .count')).toHaveText('1 / 4');
  await page.getByRole('button', { name: 'Next scan' }).click();
  await expect
    .poll(async () => (await heard()).filter((text) => text.startsWith('volume-timeline')).length)
    .toBeGreaterThan(0);
});

test("nothing is announced while another one's editor changes the picture", async ({ page }) => {
  // So dense that something shows: a blank picture says so.
  await open(
    page,
    `${view.replace('steps=', 'opacity-factor="30" steps=')}<div id="mine">${editor}</div><div id="other">${editor}</div><volume-legend for="field"></volume-legend>`,
  );
  await expect(page.locator('#other .editor')).toBeVisible();
  await settle(page);
  const heard = await listen(page);
  await page
    .locator('#mine')
    .getByRole('slider', { name: /^Stop 2/ })
    .press('ArrowUp');
  await page.locator('#mine').getByLabel('Light').fill('0.5');
  await settle(page);
  await expect(page.locator('#other').getByRole('slider', { name: /^Stop 2/ })).not.toHaveAttribute(
    'aria-valuetext',
    /opacity 1%/,
  );
  expect(await heard()).toEqual([]);
});
