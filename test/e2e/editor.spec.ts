// <volume-transfer-function>, by mouse, touch and keyboard.
import {
  drag,
  editor,
  handle,
  handles,
  middleOf,
  openEditor,
  readStops,
  readValues,
  said,
  reported,
  view,
} from './helpers/companions.ts';
import { compare, expect, settle, takePicture, keptTest as test, withElement } from './helpers/harness.ts';

test.describe('the editor by mouse', () => {
  test('drags a stop, and the picture follows while it is dragged', async ({ page }) => {
    await openEditor(page);
    const before = await takePicture(page);
    const { x, y } = await middleOf(handle(page, 2));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y - 60);
    await expect.poll(async () => (await reported(page)).map(({ type }) => type)).toContain('input');
    expect((await reported(page)).some(({ type }) => type === 'change')).toBe(false);
    const [, during] = await readStops(page);
    expect(during.value).toBeGreaterThan(110);
    expect(during.opacity).toBeGreaterThan(0.05);
    await page.mouse.up();
    const events = await reported(page);
    expect(events.at(-1)).toMatchObject({ type: 'change', bubbles: false });
    expect(events.at(-1)!.transferFunction).toBe(await withElement(page, (element) => element.transferFunction));
    await settle(page);
    expect(compare(await takePicture(page), before).worst).toBeGreaterThan(10);
  });

  test('goes no further than the neighbours: two stops of one value are a jump', async ({ page }) => {
    await openEditor(page);
    await drag(page, handle(page, 2), { x: 300, y: 0 });
    expect(await readValues(page)).toEqual([0, 200, 200]);
    const jump = await readStops(page);
    expect(jump[1].opacity).toBeLessThan(jump[2].opacity);
    await drag(page, handle(page, 2), { x: -80, y: 0 });
    expect((await readValues(page))[1]).toBeLessThan(190);
  });

  test('a click alone chooses a stop and changes nothing', async ({ page }) => {
    await openEditor(page);
    const { x, y } = await middleOf(handle(page, 3));
    await page.mouse.click(x, y);
    await expect(handle(page, 3)).toBeFocused();
    await expect(page.getByLabel('Value')).toHaveValue('200');
    expect(await reported(page)).toEqual([]);
    expect(await withElement(page, (element) => element.transferFunction)).toBe(said);
  });

  test('a double click adds a stop where it is', async ({ page }) => {
    await openEditor(page);
    const plot = (await page.locator('.plot').boundingBox())!;
    await page.mouse.dblclick(plot.x + plot.width * 0.6, plot.y + plot.height * 0.2);
    await expect(handles(page)).toHaveCount(4);
    await expect(handle(page, 3)).toBeFocused();
    const added = (await readStops(page))[2];
    expect(added.value).toBeGreaterThan(100);
    expect(added.value).toBeLessThan(200);
    expect(Math.abs(Math.cbrt(added.opacity) - 0.8)).toBeLessThan(0.05);
    expect((await reported(page)).map(({ type }) => type)).toEqual(['change']);
  });

  test('changes the colour of a stop, and its value and opacity by numbers', async ({ page }) => {
    await openEditor(page);
    await handle(page, 2).focus();
    await page.getByLabel('Colour of the stop').fill('#00ff00');
    expect((await readStops(page))[1].color).toEqual([0, 1, 0]);
    await page.getByLabel('Value').fill('150.5');
    await page.getByLabel('Value').press('Enter');
    await page.getByLabel('Opacity (%)').fill('12.5');
    await page.getByLabel('Opacity (%)').press('Enter');
    expect((await readStops(page))[1]).toMatchObject({ value: 150.5, opacity: 0.125 });
    await page.getByLabel('Value').fill('999');
    await page.getByLabel('Value').press('Enter');
    await expect(page.getByLabel('Value'), 'no further than the next stop').toHaveValue('200');
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(page.getByLabel('Value')).toHaveValue('150.5');
  });

  test('a number that is being typed stays when the volume answers; what is no number shows what holds', async ({
    page,
  }) => {
    await openEditor(page);
    await handle(page, 2).focus();
    const field = page.getByLabel('Value');
    const shown = await field.inputValue();
    await field.fill('120');
    await withElement(page, (element) => void element.dispatchEvent(new Event('optics-change')));
    await page.evaluate(
      () =>
        (document.querySelector('volume-transfer-function') as unknown as { updateComplete: Promise<unknown> })
          .updateComplete,
    );
    await expect(field).toHaveValue('120');
    await field.fill('');
    await field.press('Tab');
    await expect(field).toHaveValue(shown);
    for (const round of [1, 2]) {
      await field.fill('999');
      await field.press('Enter');
      await expect(field, `no further than the next stop, time ${round}`).toHaveValue('200');
    }
  });

  test('sets the factors', async ({ page }) => {
    await openEditor(page);
    await page.getByRole('slider', { name: 'Opacity', exact: true }).fill('1');
    await page.getByRole('slider', { name: 'Light', exact: true }).fill('-1');
    await expect
      .poll(() =>
        withElement(page, (element) => [element.opacityFactor, element.lightFactor, element.transferFunction]),
      )
      .toEqual([2, 0.5, said]);
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByRole('button', { name: 'Undo' }).click();
    expect(await withElement(page, (element) => [element.opacityFactor, element.lightFactor])).toEqual([null, null]);
  });
});

test.describe('the editor by touch', () => {
  test.use({ hasTouch: true });

  test('drags a stop; a double tap adds one; the page stays where it is', async ({ page }) => {
    await openEditor(page, `${view}${editor}<div style="height: 3000px"></div>`);
    const { x, y } = await middleOf(handle(page, 2));
    const client = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', at?: [number, number]): Promise<unknown> =>
      client.send('Input.dispatchTouchEvent', { type, touchPoints: at ? [{ x: at[0], y: at[1] }] : [] });
    await touch('touchStart', [x + 12, y - 12]); // a fingertip is not exact
    for (const part of [0.3, 0.6, 1]) await touch('touchMove', [x + 12 + 50 * part, y - 12 - 40 * part]);
    await touch('touchEnd');
    await expect.poll(async () => (await reported(page)).at(-1)?.type).toBe('change');
    const moved = (await readStops(page))[1];
    expect(moved.value).toBeGreaterThan(115);
    expect(moved.value, 'not by the whole 62 pixels: it was taken by its edge').toBeLessThan(145);
    expect(moved.opacity).toBeGreaterThan(0.03);
    expect(await page.evaluate(() => scrollY)).toBe(0);
    const plot = (await page.locator('.plot').boundingBox())!;
    for (let i = 0; i < 2; i++) await page.touchscreen.tap(plot.x + plot.width * 0.3, plot.y + plot.height * 0.3);
    await expect(handles(page)).toHaveCount(4);
  });
});

test.describe('the editor by keyboard', () => {
  test('Tab goes through the stops, arrows move them, with Shift ten times as far', async ({ page }) => {
    await openEditor(page);
    await handle(page, 1).focus();
    await page.keyboard.press('Tab');
    await expect(handle(page, 2)).toBeFocused();
    await expect(handle(page, 2)).toHaveAttribute('aria-valuetext', '100, opacity 1%, red');
    const [, start] = await readStops(page);
    await page.keyboard.press('ArrowRight');
    const [, right] = await readStops(page);
    const step = right.value - start.value;
    expect(step).toBeGreaterThan(1);
    await page.keyboard.press('Shift+ArrowRight');
    const [, far] = await readStops(page);
    expect((far.value - right.value) / step).toBeCloseTo(10, 0);
    await page.keyboard.press('ArrowLeft');
    expect((await readStops(page))[1].value).toBeLessThan(far.value);
    await page.keyboard.press('ArrowUp');
    const [, up] = await readStops(page);
    expect(up.opacity).toBeGreaterThan(start.opacity);
    await page.keyboard.press('Shift+ArrowUp');
    expect((await readStops(page))[1].opacity).toBeGreaterThan(up.opacity * 2);
    await page.keyboard.press('Home');
    expect(await readValues(page)).toEqual([0, 0, 200]);
    await page.keyboard.press('End');
    expect(await readValues(page)).toEqual([0, 200, 200]);
    await expect(handle(page, 2)).toHaveAttribute('aria-valuenow', '200');
  });

  test('a held key is one step of undo; Ctrl+Z and Ctrl+Shift+Z go back and forth', async ({ page }) => {
    await openEditor(page);
    await handle(page, 2).focus();
    for (let i = 0; i < 5; i++) await page.keyboard.down('ArrowRight');
    await page.keyboard.up('ArrowRight');
    const moved = await readValues(page);
    expect(moved[1]).toBeGreaterThan(108);
    await page.keyboard.press('Control+z');
    expect(await withElement(page, (element) => element.transferFunction)).toBe(said);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
    await page.keyboard.press('Control+Shift+z');
    expect(await readValues(page)).toEqual(moved);
  });

  test('Insert and + add a stop, Delete removes it, and the last one stays', async ({ page }) => {
    await openEditor(page);
    await handle(page, 1).focus();
    await page.keyboard.press('Insert');
    await expect(handle(page, 2)).toBeFocused();
    expect(await readValues(page)).toEqual([0, 50, 100, 200]);
    await page.keyboard.press('+');
    expect(await readValues(page)).toEqual([0, 50, 75, 100, 200]);
    for (let left = 4; left >= 1; left--) {
      await page.keyboard.press('Delete');
      await expect(handles(page)).toHaveCount(left);
      await expect(page.locator('.handle:focus')).toHaveCount(1);
    }
    await page.keyboard.press('Delete');
    await expect(handles(page)).toHaveCount(1);
    await expect(page.getByRole('button', { name: 'Delete' })).toBeDisabled();
  });
});
