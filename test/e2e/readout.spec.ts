// <volume-readout>: by mouse, finger and keys, in words, in two languages and both directions.
import type { Locator, Page } from '@playwright/test';
import type * as Package from '../../src/index.ts';
import { findFaults } from './helpers/axe.ts';
import { expect, fieldUrl, open, settle, keptTest as test, withElement } from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';
import { line, touch } from './helpers/touch.ts';
import { serve, several } from './helpers/scans.ts';

const view = `<volume-view id="field" src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;
const readout = '<volume-readout for="field"></volume-readout>';
const wide = { head: '<style>volume-view { width: 240px; height: 180px }</style>' };

const rows = (page: Page): Locator => page.locator('volume-readout [part=row]');
const texts = (page: Page): Promise<string[]> => page.locator('volume-readout [part=text]').allInnerTexts();
const reported = (page: Page): Locator => page.locator('volume-readout [role=status]');
const marker = (page: Page): Locator => page.locator('volume-view [part=marker]');

/** Where the cross is, from the left and top edge of the picture; null where it is not. */
async function markerPlace(page: Page): Promise<readonly [x: number, y: number] | null> {
  if (!(await marker(page).isVisible())) return null;
  const [box, around] = [(await marker(page).boundingBox())!, (await page.locator('volume-view').boundingBox())!];
  return [box.x + box.width / 2 - around.x, box.y + box.height / 2 - around.y];
}

/** What the readout should say of a place. */
const expectedAt = (page: Page, x: number, y: number): Promise<string[]> =>
  withElement(
    page,
    async (element, [left, top]) => {
      const { value, world, voxel } = (await element.pick(left, top))!;
      const letters = ['LR', 'PA', 'IS'];
      const place = world
        .map((length, axis) => `${letters[axis][length < 0 ? 0 : 1]} ${Math.abs(length).toFixed(1)}`)
        .join(' ');
      return [`${Number(value.toPrecision(6))}`, `${place} mm`, voxel!.join(', ')];
    },
    { argument: [x, y] as const },
  );

async function openReadout(page: Page, body = view + readout, options: { head?: string } = wide): Promise<void> {
  await open(page, body, options);
  await settle(page);
  await expect(rows(page).first()).toBeVisible();
}

test('follows the mouse, keeps what is clicked, and the cross stays on it as the camera turns', async ({ page }) => {
  await openReadout(page);
  expect(await texts(page)).toEqual(['–', '–', '–']);
  expect(await markerPlace(page)).toBe(null);
  await page.mouse.move(120, 90);
  await expect.poll(() => texts(page)).toEqual(await expectedAt(page, 120, 90));
  expect(await markerPlace(page)).toEqual([120, 90]);
  await page.mouse.move(140, 80);
  await expect.poll(() => texts(page)).toEqual(await expectedAt(page, 140, 80));
  await page.mouse.move(3, 3);
  await expect.poll(() => texts(page)).toEqual(['–', '–', '–']);
  await expect(page.locator('volume-readout [part=hint]')).toHaveText('Nothing is shown there.');
  await page.mouse.move(400, 400);
  await expect.poll(() => markerPlace(page)).toBe(null);
  await page.mouse.click(120, 90);
  const kept = await expectedAt(page, 120, 90);
  await page.mouse.move(400, 400);
  await expect.poll(() => texts(page)).toEqual(kept);
  await expect.poll(async () => (await markerPlace(page))?.map(Math.round)).toEqual([120, 90]);
  await withElement(page, (element) => element.setAttribute('camera-orbit', '80deg 65deg 90'));
  await settle(page);
  await expect.poll(async () => (await markerPlace(page))?.map(Math.round)).not.toEqual([120, 90]);
  expect(await texts(page), 'the place is the same').toEqual(kept);
  // In a picture of another shape too.
  await withElement(page, (element) => {
    element.setAttribute('camera-orbit', '35deg 65deg 90');
    element.style.width = '300px';
  });
  await settle(page);
  await expect.poll(async () => (await markerPlace(page))?.map(Math.round)).toEqual([150, 90]);
  await page.mouse.click(3, 3);
  await page.mouse.move(400, 400);
  await expect.poll(() => texts(page)).toEqual(['–', '–', '–']);
});

test('turns nothing, and lets be turned', async ({ page }) => {
  await openReadout(page);
  const orbit = () => withElement(page, ({ camera }) => camera!.orbit);
  const before = await orbit();
  await page.mouse.move(120, 90);
  await page.mouse.click(120, 90);
  expect(await orbit()).toEqual(before);
  await page.mouse.down();
  await page.mouse.move(150, 90, { steps: 3 });
  await page.mouse.up();
  await settle(page);
  expect((await orbit()).theta).not.toBeCloseTo(before.theta, 3);
});

test('has a crosshair that keys move, which fires volume-pick and leaves the camera alone', async ({ page }) => {
  await openReadout(page);
  await page.evaluate(() => {
    const picks: unknown[] = ((window as unknown as { picks: unknown[] }).picks = []);
    document.querySelector('volume-view')!.addEventListener('volume-pick', ({ detail }) => picks.push(detail));
  });
  const orbit = () => withElement(page, ({ camera }) => camera!.orbit);
  const before = await orbit();
  const button = page.getByRole('button', { name: 'Crosshair' });
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(button).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByRole('application')).toBeFocused();
  await expect.poll(() => texts(page)).toEqual(await expectedAt(page, 120, 90));
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  await expect.poll(() => markerPlace(page)).toEqual([128, 86]);
  await expect.poll(() => texts(page)).toEqual(await expectedAt(page, 128, 86));
  await expect(reported(page)).toHaveText(
    /^Value [\d.]+, Place [RL] [\d.]+ [AP] [\d.]+ [SI] [\d.]+ mm, Voxel \d+, \d+, \d+$/,
  );
  await page.keyboard.press('Enter');
  await expect.poll(() => page.evaluate(() => (window as unknown as { picks: unknown[] }).picks.length)).toBe(1);
  await page.keyboard.press('Shift+ArrowLeft');
  await expect.poll(() => markerPlace(page)).toEqual([88, 86]);
  for (let i = 0; i < 9; i++) await page.keyboard.press('Shift+ArrowUp');
  await expect.poll(() => markerPlace(page), 'no farther than the edge').toEqual([88, 0]);
  expect(await orbit()).toEqual(before);
  await page.keyboard.press('Escape');
  await expect(button).toBeFocused();
  await expect(button).toHaveAttribute('aria-pressed', 'false');
  await expect.poll(async () => (await markerPlace(page))?.map(Math.round), 'what Enter kept').toEqual([128, 86]);
  await page.locator('.picture').press('ArrowLeft');
  await settle(page);
  expect(await orbit()).not.toEqual(before);
});

test('is reported once, when it is still', async ({ page }) => {
  await openReadout(page);
  await page.evaluate(() => {
    const heard: string[] = ((window as unknown as { heard: string[] }).heard = []);
    const region = document.querySelector('volume-readout')!.shadowRoot!.querySelector('[role=status]')!;
    new MutationObserver(() => heard.push(region.textContent)).observe(region, {
      subtree: true,
      childList: true,
      characterData: true,
    });
  });
  await page.mouse.move(110, 90);
  await page.mouse.move(130, 85, { steps: 12 });
  await expect(reported(page)).toHaveText(/^Value/);
  expect(await page.evaluate(() => (window as unknown as { heard: string[] }).heard.length)).toBe(1);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 700 }, hasTouch: true });

  test('reads what is tapped, and not what a finger turns; its button is large enough', async ({ page }) => {
    await openReadout(page);
    await page.touchscreen.tap(120, 90);
    await expect.poll(() => texts(page)).toEqual(await expectedAt(page, 120, 90));
    const kept = await texts(page);
    await touch(page, [line([80, 90], [150, 90])]);
    await settle(page);
    expect(await texts(page)).toEqual(kept);
    const { height } = (await page.getByRole('button', { name: 'Crosshair' }).boundingBox())!;
    expect(Math.round(height)).toBeGreaterThanOrEqual(44);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  });
});

test('axe finds nothing, with and without crosshair, pointed at or not', async ({ page }) => {
  await openReadout(page, `<main><h1>A field</h1>${view}${readout}</main>`);
  expect(await findFaults(page)).toEqual([]);
  await page.getByRole('button', { name: 'Crosshair' }).click();
  await expect(page.getByRole('application')).toBeFocused();
  expect(await findFaults(page)).toEqual([]);
});

test('says what is missing, and begins when it is there; goes on where it is put elsewhere', async ({ page }) => {
  await open(page, readout + readout.replace('field', 'nobody'));
  await expect(page.locator('volume-readout').nth(0)).toContainText(
    'There is no <volume-view id="field"> in this page.',
  );
  await page.evaluate((html) => document.body.insertAdjacentHTML('afterbegin', html), view);
  await settle(page);
  await page.mouse.move(60, 45);
  await expect.poll(async () => (await texts(page))[0]).not.toBe('–');
  await expect(page.locator('volume-readout').nth(1)).toContainText('id="nobody"');
  await page.evaluate(() => {
    const [first, second] = document.querySelectorAll('volume-readout');
    second.remove();
    document.body.append(first);
  });
  await page.mouse.move(62, 45);
  await expect.poll(async () => (await texts(page))[0]).not.toBe('–');
  await expect(marker(page)).toHaveCount(1);
  await page.evaluate(() => document.querySelector('volume-readout')!.remove());
  await expect(marker(page)).toHaveCount(0);
});

test('a kept place has the value of the scan that is shown', async ({ page }) => {
  await serve(page);
  await open(page, `<volume-view ${several(3)}></volume-view><volume-readout></volume-readout>`);
  await settle(page);
  await expect(rows(page).first()).toBeVisible();
  const box = (await page.locator('volume-view').boundingBox())!;
  const middle = [box.width / 2, box.height / 2] as const;
  await page.mouse.click(box.x + middle[0], box.y + middle[1]);
  await page.mouse.move(box.x + box.width + 40, box.y + box.height + 40);
  await expect.poll(async () => (await texts(page))[0]).not.toBe('–');
  const values = [await texts(page)];
  await withElement(page, (element) => void element.next());
  await settle(page);
  await expect.poll(() => withElement(page, (element) => element.scan!.index)).toBe(1);
  const expected = await withElement(
    page,
    async (element, [x, y]) => `${Number((await element.pick(x, y))!.value.toPrecision(6))}`,
    { argument: middle },
  );
  await expect.poll(async () => (await texts(page))[0].split(' ')[0]).toBe(expected);
  expect(values[0][0].split(' ')[0]).not.toBe('');
});

test('speaks another language, from right to left', async ({ page }) => {
  await openReadout(page, `<div dir="rtl" lang="ar">${view}${readout}</div>`);
  await page.evaluate(async () => {
    const address: string = '/dist/volume-view.js';
    const { registerTranslation }: Pick<typeof Package, 'registerTranslation'> = await import(address);
    registerTranslation('ar', {
      value: 'القيمة',
      place: 'الموضع',
      voxel: 'فوكسل',
      crosshair: 'مؤشر',
      patient: { right: 'ي', left: 'س', anterior: 'أ', posterior: 'خ', superior: 'ع', inferior: 'ف' },
      millimetres: (lengths) => `${lengths} مم`,
    });
  });
  const box = (await page.locator('volume-view').boundingBox())!;
  await page.mouse.move(box.x + 120, box.y + 90);
  await expect(page.locator('volume-readout dt').first()).toHaveText('القيمة');
  await expect.poll(async () => (await texts(page))[1]).toMatch(/^[يس] .* [أخ] .* [عف] .* مم$/);
  await expect(page.getByRole('button', { name: 'مؤشر' })).toBeVisible();
  await expect(page.locator('volume-readout [part=hint]'), 'what the page leaves out is the package’s').toHaveText(
    'أشر إلى الصورة أو انقرها.',
  );
  // The names stand right of what belongs to them; the cross is where the mouse is.
  const [name, text] = [
    (await page.locator('volume-readout dt').first().boundingBox())!,
    (await page.locator('volume-readout dd').first().boundingBox())!,
  ];
  expect(name.x).toBeGreaterThan(text.x);
  expect((await markerPlace(page))!.map(Math.round)).toEqual([120, 90]);
  // A crosshair goes where the arrow points.
  await page.getByRole('button', { name: 'مؤشر' }).click();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(async () => (await markerPlace(page))![0]).toBeLessThan(120);
});

test('stands as still as its numbers change', async ({ page }) => {
  await openReadout(page);
  const height = () => page.locator('volume-readout').evaluate((element) => element.getBoundingClientRect().height);
  const before = await height();
  await page.mouse.move(120, 90);
  await expect.poll(async () => (await texts(page))[0]).not.toBe('–');
  expect(await height()).toBe(before);
});

test('works alone from its own file, in the classic script, and under a strict policy', async ({ page }) => {
  const policy = `<meta http-equiv="Content-Security-Policy" content="default-src 'self'">`;
  await open(page, view + readout, { head: '<script type="module" src="/dist/volume-readout.js"></script>' });
  await settle(page);
  await page.mouse.move(60, 45);
  await expect.poll(async () => (await texts(page))[0]).not.toBe('–');
  // The readout's copy of the code and the view's make one event of a click.
  await withElement(page, (element) => {
    element.pickable = true;
    element.addEventListener(
      'volume-pick',
      () => (element.dataset.picks = `${Number(element.dataset.picks ?? 0) + 1}`),
    );
    return new Promise<void>((resolve) => setTimeout(resolve, 500));
  });
  await page.mouse.click(60, 45);
  await page.mouse.move(400, 400);
  await expect(reported(page)).toHaveText(/^Value/);
  await expect(page.locator('volume-view')).toHaveAttribute('data-picks', '1');
  await page.unrouteAll();
  await open(page, view + readout, {
    path: '/test/e2e/pages/classic.html',
    script: '<script defer src="/dist/volume-view.iife.js"></script>',
    head: policy,
  });
  await settle(page);
  await page.mouse.move(62, 45);
  await expect.poll(async () => (await texts(page))[0]).not.toBe('–');
});
