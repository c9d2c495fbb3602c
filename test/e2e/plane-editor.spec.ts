// <volume-transfer-function mode="2d">, by mouse, touch and keyboard.
import type { Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import { drag, openEditor } from './helpers/companions.ts';
import { compare, expect, fieldUrl, settle, takePicture, keptTest as test, withElement } from './helpers/harness.ts';
import { line, touch } from './helpers/touch.ts';

const page2d = `<main><h1>A field</h1><volume-view id="field" src="${fieldUrl}" transfer-function="0 blue 0, 255 red 30%" steps="20" alt="A field"></volume-view>
  <volume-transfer-function for="field" mode="2d" style="display: block; width: 400px"></volume-transfer-function></main>`;

const written = (page: Page): Promise<string | null> =>
  withElement(page, (element) => element.getAttribute('transfer-function-2d'));

test.use({ hasTouch: true });

test('boxes and Gaussians are drawn, moved, changed and deleted over the histogram, and the picture follows', async ({
  page,
}) => {
  await openEditor(page, page2d);
  const plane = page.locator('.plane');
  const painted = (): Promise<number> =>
    page.locator('.plane canvas').evaluate(
      (canvas: HTMLCanvasElement) =>
        canvas
          .getContext('2d')!
          .getImageData(0, 0, canvas.width, canvas.height)
          .data.filter((x, i) => i % 4 === 3 && x > 0).length,
    );
  await expect.poll(painted, 'a histogram').toBeGreaterThan(50);
  const before = await takePicture(page);
  const { x, y, width, height } = (await plane.boundingBox())!;

  // By mouse: beside everything a box is drawn; a click alone does nothing.
  await page.mouse.click(x + width / 2, y + height / 2);
  expect(await written(page)).toBe(null);
  await page.mouse.move(x + 0.3 * width, y + 0.9 * height);
  await page.mouse.down();
  await page.mouse.move(x + 0.5 * width, y + 0.5 * height, { steps: 3 });
  await page.mouse.move(x + 0.8 * width, y + 0.2 * height);
  await page.mouse.up();
  expect(await written(page)).toMatch(/^box [\d.]+ [\d.]+ [\d.]+ [\d.]+ #ff9933 30%$/);
  await settle(page);
  expect(compare(await takePicture(page), before).worst, 'another picture').toBeGreaterThan(10);
  const box = page.getByRole('slider', { name: 'Box, 1 of 1', exact: true });
  const from = Number(await page.getByLabel('Value from').inputValue());
  await drag(page, box, { x: -30, y: 0 });
  expect(Number(await page.getByLabel('Value from').inputValue())).toBeLessThan(from - 3);

  // By fields.
  await page.getByLabel('Value from').fill('60');
  await page.getByLabel('Value from').press('Enter');
  await page.getByLabel('Value to').fill('50');
  await page.getByLabel('Value to').press('Enter');
  await expect(page.getByLabel('Value to'), 'as it was').not.toHaveValue('50');
  await page.getByLabel('Colour of this part').fill('#00ff00');
  expect(await written(page)).toMatch(/^box 60 .* #00ff00 30%$/);

  // By keys.
  await page.getByRole('button', { name: 'Add a Gaussian' }).click();
  const bell = page.getByRole('slider', { name: 'Gaussian, 2 of 2', exact: true });
  await expect(bell).toBeFocused();
  await expect(bell).toHaveAttribute('aria-valuetext', /^values .* gradients .* opacity 30%, /);
  const middle = Number(await bell.getAttribute('aria-valuenow'));
  await page.keyboard.press('Shift+ArrowRight');
  expect(Number(await bell.getAttribute('aria-valuenow'))).toBeGreaterThan(middle + 3);
  expect(await findFaults(page)).toEqual([]);
  await page.keyboard.press('Delete');
  await expect(bell).toHaveCount(0);
  await page.keyboard.press('Control+z');
  await expect(bell).toHaveCount(1);

  // By finger: the corner changes the size.
  await bell.focus();
  const corner = (await page.getByRole('slider', { name: 'Size of Gaussian, 2 of 2' }).boundingBox())!;
  const wide = Number(await page.getByLabel('Width, values').inputValue());
  await touch(page, [line([corner.x + 7, corner.y + 7], [corner.x + 47, corner.y + 7])]);
  await expect.poll(async () => Number(await page.getByLabel('Width, values').inputValue())).toBeGreaterThan(wide + 5);

  // A grip at the edge is whole, and what is drawn of the part ends there.
  await drag(page, page.getByRole('slider', { name: 'Size of Gaussian, 2 of 2' }), { x: width, y: 0 });
  const atEdge = await plane.evaluate((chart) => {
    const grip = [...chart.querySelectorAll('.handle.size')].at(-1)!.getBoundingClientRect();
    const edge = chart.querySelector('.chart')!.getBoundingClientRect().right;
    const clips = ['.plane', '.plane .handles', '.plane .chart'].map(
      (name) => getComputedStyle((chart.getRootNode() as ShadowRoot).querySelector(name)!).overflow,
    );
    return { beyond: grip.right - edge, room: chart.getBoundingClientRect().right - grip.right, clips };
  });
  expect(atEdge.beyond).toBeGreaterThan(5);
  expect(atEdge.room).toBeGreaterThan(0);
  expect(atEdge.clips).toEqual(['visible', 'visible', 'hidden']);
});
