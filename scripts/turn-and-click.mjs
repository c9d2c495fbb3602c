/**
 * Turn the volume that a page shows by dragging, then click on its middle.
 * @param {import('@playwright/test').Page} page - with one view, which may still be loading
 */
export async function turnAndClick(page) {
  const view = page.locator('volume-view');
  await view.waitFor({ timeout: 60_000 });
  await view.evaluate((/** @type {any} */ one) => one.whenRendered());
  await page.waitForTimeout(1500);
  await view.scrollIntoViewIfNeeded();
  const box = await view.boundingBox();
  if (!box) throw new Error('the view has no place in the page');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 20, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(800);
  await page.mouse.click(x, y);
  await page.waitForTimeout(1500);
}
