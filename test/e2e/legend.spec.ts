// <volume-legend>
import { editor, handle, legend, middleOf, openEditor, view } from './helpers/companions.ts';
import { expect, open, keptTest as test, withElement } from './helpers/harness.ts';

test.describe('the legend', () => {
  test('has round numbers, the unit, and itself in words', async ({ page }) => {
    await open(
      page,
      `<volume-view src="/test/e2e/pages/data/field.json" transfer-function="0 blue 1%, 0.5 red 5%, 1 red 10%" alt="A"></volume-view><volume-legend></volume-legend>`,
    );
    const picture = page.getByRole('img', { name: /^A smooth field, 0 to 1 au: blue, .* red from 0\.\d+\.$/ });
    await expect(picture).toBeVisible();
    const ticks = page.locator('volume-legend [part=ticks] span');
    expect(await ticks.allTextContents()).toEqual(['0', '0.2', '0.4', '0.6', '0.8', '1']);
    const bar = (await page.locator('volume-legend .bar').boundingBox())!;
    const tick = await middleOf(ticks.nth(2));
    expect((tick.x - bar.x) / bar.width).toBeCloseTo(0.4, 2);
    await expect(page.locator('volume-legend [part=title]')).toContainText('au');
  });

  test('stands upright', async ({ page }) => {
    await open(page, view + legend.replace('label', 'orientation="vertical" label'));
    await expect(page.locator('volume-legend .legend')).toBeVisible();
    const ticks = page.locator('volume-legend [part=ticks] span');
    expect(await ticks.first().textContent()).toBe('0');
    const bar = (await page.locator('volume-legend .bar').boundingBox())!;
    expect(bar.height).toBeGreaterThan(bar.width * 4);
    const hundred = await middleOf(ticks.getByText('100', { exact: true }));
    expect((bar.y + bar.height - hundred.y) / bar.height).toBeCloseTo(0.5, 1);
  });

  test('follows the volume and the editor', async ({ page }) => {
    await openEditor(page, view + legend + editor);
    const picture = page.getByRole('img', { name: /^Strength/ });
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 200:/);
    await handle(page, 3).focus();
    await page.getByLabel('Value').fill('120');
    await page.getByLabel('Value').press('Enter');
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 120:/);
    await withElement(page, (element) => {
      element.transferFunction = '10 white 0, 20 white 5%';
    });
    await expect(picture).toHaveAccessibleName('Strength, 10 to 20: white.');
  });
});
