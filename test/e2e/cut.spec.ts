// Volumes that are cut open: by attributes, by ClipPlanes, and by what a person drags.
import type { Page } from '@playwright/test';
import {
  compare,
  expect,
  fieldUrl,
  open,
  setAttributes,
  settle,
  sharePage,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';

const view = `<volume-view src="${fieldUrl}" ${attributesOf({ 'transfer-function': '0 #003 0.999, 0.4 #c63 0.999, 1 #ffc 0.999', 'camera-orbit': '90deg 90deg 90' })} alt="A field"></volume-view>`;
const style = { head: '<style>volume-view { width: 240px; height: 180px }</style>' };

const clipsReady = (page: Page): Promise<unknown> =>
  page.evaluate(() =>
    customElements.whenDefined('volume-clip').then(() => document.querySelector('volume-clip')!.updateComplete),
  );
const place = (page: Page): Promise<number> => page.evaluate(() => document.querySelector('volume-clip')!.at!);

test.describe('a volume that is cut', () => {
  const sharedPage = sharePage(view, style);

  // First, as the first of them has its code loaded.
  test('by what can not be read says so, and stays as it was', async () => {
    const page = sharedPage();
    const whole = await takePicture(page);
    await withElement(page, (element) => element.setAttribute('cutout', '1 2 3'));
    const error = (await waitForEvent(page, 'error')).detail as { code: string; message: string };
    expect(error).toMatchObject({ code: 'attribute/invalid' });
    expect(error.message).toContain('cutout got "1 2 3"');
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))); // What loads the code is done with it.
    await expect(page.getByRole('alert')).toContainText('cutout got "1 2 3"');
    await setAttributes(page, { cutout: null });
    expect(compare(await takePicture(page), whole).worst).toBe(0);
    await setAttributes(page, { cutout: '-99 -99 -99 99 99 99' });
    expect(
      (await takePicture(page)).data.some((x) => x > 0),
      'all is cut away',
    ).toBe(false);
    expect(await withElement(page, (element) => element.pick(120, 90))).toBe(null);
    await setAttributes(page, { cutout: null });
  });

  test('by a box or a plane is the same whoever says so, whole again without, and is picked as it is seen', async () => {
    const page = sharedPage();
    const whole = await takePicture(page);
    await setAttributes(page, { cutout: '-20 -3 -20 2 20 20' });
    const cut = await takePicture(page);
    expect(compare(cut, whole).worst).toBeGreaterThan(30);
    const picked = await withElement(page, (element) => element.pick(120, 90));
    expect(picked!.world[0]).toBeCloseTo(2.1, 1);
    await setAttributes(page, { cutout: null });
    expect(compare(await takePicture(page), whole).worst).toBe(0);

    await page.evaluate(() =>
      document.body.insertAdjacentHTML(
        'beforeend',
        '<volume-clip type="box" keep="outside" box="-20 -3 -20 2 20 20"></volume-clip>',
      ),
    );
    await clipsReady(page);
    expect(compare(await takePicture(page), cut).worst).toBe(0);
    await page.evaluate(() => (document.querySelector('volume-clip')!.hidden = true));
    await clipsReady(page);
    expect(compare(await takePicture(page), whole).worst).toBe(0);

    await page.evaluate(() =>
      Object.assign(document.querySelector('volume-clip')!, { hidden: false, type: 'plane', normal: [1, 0, 0], at: 2 }),
    );
    await clipsReady(page);
    const half = await takePicture(page);
    expect(compare(half, whole).worst).toBeGreaterThan(30);
    expect((await withElement(page, (element) => element.pick(120, 90)))!.world[0]).toBeCloseTo(2.1, 1);
    await page.evaluate(() => document.querySelector('volume-clip')!.remove());
    await withElement(page, (element) =>
      element.insertAdjacentHTML('beforeend', '<ClipPlane plane="2 0 0 -4"></ClipPlane>'),
    );
    expect(compare(await takePicture(page), half).worst).toBe(0);
    await withElement(page, (element) => element.querySelector('clipplane')!.setAttribute('enabled', 'false'));
    expect(compare(await takePicture(page), whole).worst).toBe(0);
    await withElement(page, (element) => element.replaceChildren());
  });
});

test('a plane is dragged by its handle and moved by keys; an attribute brings it back', async ({ page }) => {
  await open(page, `${view}<volume-clip normal="0 0 1" at="-4"></volume-clip>`, style);
  await settle(page);
  await clipsReady(page);
  await page.evaluate(() => {
    const seen: unknown[] = ((window as unknown as { seen: unknown[] }).seen = []);
    document
      .querySelector('volume-clip')!
      .addEventListener('clip-change', (event) => seen.push((event as CustomEvent).detail));
  });
  await settle(page);
  const before = await takePicture(page);
  const handle = page.locator('volume-view').getByRole('button', { name: /^Cutting plane, −4$/ });
  const { x, y, width, height } = (await handle.boundingBox())!;
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 9, y + height / 2 - 30, { steps: 3 });
  await page.mouse.up();
  // 90 away, 32 degrees over 180 pixels.
  expect(await place(page)).toBeCloseTo(-4 + (30 * 2 * 90 * Math.tan((16 * Math.PI) / 180)) / 180, 1);
  await settle(page);
  const dragged = await takePicture(page);
  expect(compare(dragged, before).worst).toBeGreaterThan(30);
  expect(
    await page.evaluate(() => (window as unknown as { seen: { kind: string; at: number }[] }).seen.at(-1)),
  ).toMatchObject({ kind: 'plane', at: await place(page) });
  const moved = await place(page);
  await page.keyboard.press('ArrowDown');
  expect(await place(page)).toBeLessThan(moved);
  await page.keyboard.press('PageUp');
  expect(await place(page)).toBeCloseTo(moved, 6);
  await settle(page);
  expect(compare(await takePicture(page), dragged).worst).toBeLessThanOrEqual(1);
  await page.evaluate(() => document.querySelector('volume-clip')!.setAttribute('at', '-4'));
  await clipsReady(page);
  expect(compare(await takePicture(page), before).worst).toBe(0);
  await setAttributes(page, { src: null });
  await expect(page.locator('volume-view .handle'), 'without a volume there is nothing to cut').toHaveCount(0);
});
