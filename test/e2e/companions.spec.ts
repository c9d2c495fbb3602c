import { createRequire } from 'node:module';
import type { Locator, Page } from '@playwright/test';
import type { AxeResults } from 'axe-core';
import { parseTransferFunction } from '../../src/optics/parse-transfer-function.ts';
import { compare, expect, fieldUrl, open, settle, takePicture, test, withElement } from './helpers/harness.ts';

const axePath = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** What the page says of the field, whose values go from 0 to 255. */
const said = '0 blue 0, 100 red 1%, 200 #ffff00 30%';
const view = `<volume-view id="field" src="${fieldUrl}" transfer-function="${said}" steps="20" alt="A field"></volume-view>`;
const editor = '<volume-transfer-function for="field" style="display: block; width: 400px"></volume-transfer-function>';
const legend = '<volume-legend for="field" label="Strength"></volume-legend>';

const handles = (page: Page): Locator => page.getByRole('slider', { name: /^Stop/ });
const handle = (page: Page, number: number): Locator => page.getByRole('slider', { name: new RegExp(`^Stop ${number} of`) });

interface Told {
  type: string;
  transferFunction: string;
  bubbles: boolean;
}

/** Open a page with an editor and wait until it shows the volume; what it tells is kept. */
async function openEditor(page: Page, body = view + editor): Promise<void> {
  await open(page, body);
  await page.evaluate(() => {
    const told: Told[] = ((window as unknown as { told: Told[] }).told = []);
    const keep = (event: Event): void => {
      const { type, detail, bubbles } = event as CustomEvent<{ transferFunction: string }>;
      if ((event.target as Element).localName === 'volume-transfer-function') told.push({ type, transferFunction: detail?.transferFunction, bubbles });
    };
    for (const type of ['input', 'change']) document.addEventListener(type, keep, true);
  });
  await expect(page.locator('volume-transfer-function .editor')).toBeVisible();
  await settle(page);
}

const told = (page: Page): Promise<Told[]> => page.evaluate(() => (window as unknown as { told: Told[] }).told);

/** The stops that the volume has. */
async function readStops(page: Page): Promise<{ value: number; opacity: number; color: readonly number[] }[]> {
  const text = await withElement(page, (element) => element.transferFunction ?? '');
  return [...parseTransferFunction(text, [0, 255])];
}

async function readValues(page: Page): Promise<number[]> {
  return (await readStops(page)).map(({ value }) => value);
}

async function middleOf(locator: Locator): Promise<{ x: number; y: number }> {
  const box = (await locator.boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

async function drag(page: Page, locator: Locator, by: { x: number; y: number }): Promise<void> {
  const { x, y } = await middleOf(locator);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const part of [0.3, 0.7, 1]) await page.mouse.move(x + by.x * part, y + by.y * part);
  await page.mouse.up();
}

async function findFaults(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: axePath });
  const results = await page.evaluate(() => (window as unknown as { axe: { run(): Promise<AxeResults> } }).axe.run());
  expect(results.passes.length, 'axe looked').toBeGreaterThan(5);
  return results.violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html}`));
}

test.describe('the loader', () => {
  const watch = (page: Page): string[] => {
    const paths: string[] = [];
    page.on('request', (request) => paths.push(new URL(request.url()).pathname));
    return paths;
  };

  test('loads nothing of the companions on a page without them', async ({ page }) => {
    const paths = watch(page);
    await open(page, view);
    await settle(page);
    expect(paths).toContain('/dist/volume-view.js');
    expect(paths.filter((path) => /legend|transfer-function|ticks|link/.test(path))).toEqual([]);
    expect(await page.evaluate(() => Boolean(customElements.get('volume-legend') ?? customElements.get('volume-transfer-function')))).toBe(false);
  });

  test('loads one alone, once, for any number of them', async ({ page }) => {
    const paths = watch(page);
    await open(page, view + legend + legend);
    await expect(page.getByRole('img', { name: /^Strength/ })).toHaveCount(2);
    expect(paths.filter((path) => path.includes('volume-legend')).length).toBe(1);
    expect(paths.filter((path) => path.includes('volume-transfer-function'))).toEqual([]);
  });

  test('sees those that come later, deep in something, and within a volume', async ({ page }) => {
    await open(page, view);
    await settle(page);
    await page.evaluate(() => {
      const section = document.createElement('section');
      section.append(document.createElement('p'));
      section.firstChild!.appendChild(document.createElement('volume-legend'));
      document.body.append(section);
      document.querySelector('volume-view')!.append(document.createElement('volume-transfer-function'));
    });
    await expect(page.locator('volume-legend .legend')).toBeVisible();
    await expect.poll(() => page.evaluate(() => Boolean(customElements.get('volume-transfer-function')))).toBe(true);
  });

  test('works in the classic script too', async ({ page }) => {
    await open(page, view + legend + editor, { script: '<script defer src="/dist/volume-view.iife.js"></script>' });
    await expect(page.getByRole('img', { name: /^Strength/ })).toBeVisible();
    await expect(handles(page)).toHaveCount(3);
  });

  test('and under a strict Content-Security-Policy', async ({ page }) => {
    await open(page, view + editor.replace(/ style="[^"]*"/, '') + legend, {
      head: `<meta http-equiv="Content-Security-Policy" content="default-src 'self'">`,
    });
    await expect(handles(page)).toHaveCount(3);
    const [first, last] = [await middleOf(handle(page, 1)), await middleOf(handle(page, 3))];
    expect(last.x - first.x, 'handles are placed').toBeGreaterThan(200);
    expect(first.y - last.y).toBeGreaterThan(50);
  });
});

test.describe('the editor by mouse', () => {
  test('drags a stop, and the picture follows while it is dragged', async ({ page }) => {
    await openEditor(page);
    const before = await takePicture(page);
    const { x, y } = await middleOf(handle(page, 2));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y - 60);
    await expect.poll(async () => (await told(page)).map(({ type }) => type)).toContain('input');
    expect((await told(page)).some(({ type }) => type === 'change')).toBe(false);
    const [, during] = await readStops(page);
    expect(during.value).toBeGreaterThan(110);
    expect(during.opacity).toBeGreaterThan(0.05);
    await page.mouse.up();
    const events = await told(page);
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
    expect(await told(page)).toEqual([]);
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
    expect((await told(page)).map(({ type }) => type)).toEqual(['change']);
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

  test('sets the factors', async ({ page }) => {
    await openEditor(page);
    await page.getByRole('slider', { name: 'Opacity', exact: true }).fill('1');
    await page.getByRole('slider', { name: 'Light', exact: true }).fill('-1');
    await expect.poll(() => withElement(page, (element) => [element.opacityFactor, element.lightFactor, element.transferFunction])).toEqual(['2', '0.5', said]);
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
    await expect.poll(async () => (await told(page)).at(-1)?.type).toBe('change');
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
    await expect(handle(page, 2)).toHaveAttribute('aria-valuetext', '100, opacity 1 %, red');
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

test.describe('what the page says', () => {
  test('Reset goes back to it, and can be undone', async ({ page }) => {
    await openEditor(page);
    const reset = page.getByRole('button', { name: 'Reset' });
    await expect(reset).toBeDisabled();
    await drag(page, handle(page, 3), { x: 0, y: -30 });
    await drag(page, handle(page, 2), { x: 30, y: 0 });
    const edited = await withElement(page, (element) => element.transferFunction);
    await reset.click();
    expect(await withElement(page, (element) => element.transferFunction)).toBe(said);
    await expect(reset).toBeDisabled();
    await page.getByRole('button', { name: 'Undo' }).click();
    expect(await withElement(page, (element) => element.transferFunction)).toBe(edited);
  });

  test('where it says nothing, Reset takes the attribute away', async ({ page }) => {
    await openEditor(page, view.replace(` transfer-function="${said}"`, '') + editor);
    await expect(handles(page)).toHaveCount(7); // the default preset's
    await drag(page, handle(page, 4), { x: 0, y: -50 });
    expect(await withElement(page, (element) => element.transferFunction)).not.toBeNull();
    await page.getByRole('button', { name: 'Reset' }).click();
    expect(await withElement(page, (element) => element.transferFunction)).toBeNull();
  });

  test('changed by the page, it is where the editor begins anew', async ({ page }) => {
    await openEditor(page);
    await drag(page, handle(page, 2), { x: 30, y: 0 });
    await withElement(page, (element) => {
      element.transferFunction = '0 black 0, 255 white 5%';
    });
    await expect(handles(page)).toHaveCount(2);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
    expect((await told(page)).at(-1)!.type).toBe('change');
  });

  test('a colour table of 65 stops is given few handles, and only an edit changes it', async ({ page }) => {
    await openEditor(page, view.replace(said, 'viridis') + editor);
    const count = await handles(page).count();
    expect(count).toBeGreaterThan(4);
    expect(count).toBeLessThanOrEqual(24);
    expect(await withElement(page, (element) => element.transferFunction)).toBe('viridis');
  });

  test('Copy gives attributes', async ({ page, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await openEditor(page);
    await page.getByRole('button', { name: 'Copy' }).click();
    await expect(page.locator('volume-transfer-function').getByRole('status')).toHaveText('Copied');
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(`transfer-function="${said}"`);
    await page.getByRole('slider', { name: 'Light', exact: true }).fill('1');
    await drag(page, handle(page, 2), { x: 30, y: 0 });
    await page.getByRole('button', { name: 'Copy' }).click();
    const text = await withElement(page, (element) => element.transferFunction);
    await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe(`transfer-function="${text}" light-factor="2"`);
  });

  test('where the clipboard is closed, the text is there to be copied by hand', async ({ page }) => {
    await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
    await openEditor(page);
    await page.getByRole('button', { name: 'Copy' }).click();
    await expect(page.getByLabel('Copy it from here')).toBeFocused();
    await expect(page.getByLabel('Copy it from here')).toHaveValue(`transfer-function="${said}"`);
    expect(await page.evaluate(() => document.querySelector('volume-transfer-function')!.shadowRoot!.querySelector('textarea')!.selectionEnd)).toBeGreaterThan(20);
  });
});

test.describe('bands', () => {
  const bands = editor.replace('for=', 'mode="bands" band-edges="0 50 100 150 200" for=');

  test('one colour and one opacity each, with jumps at their edges', async ({ page }) => {
    await openEditor(page, view + bands);
    await expect(page.getByRole('listitem')).toHaveCount(4);
    expect(await withElement(page, (element) => element.transferFunction), 'nothing is written yet').toBe(said);
    await page.getByRole('slider', { name: 'Opacity, 50 to 100' }).fill('0.5');
    await page.getByLabel('Colour, 100 to 150').fill('#00ff00');
    const stops = await readStops(page);
    expect(stops.map(({ value }) => value)).toEqual([0, 0, 50, 50, 100, 100, 150, 150, 200]);
    expect(stops[3]).toMatchObject({ opacity: 0.125 });
    expect(stops[4]).toEqual({ ...stops[3], value: 100 });
    expect(stops[5].color).toEqual([0, 1, 0]);
    await expect(page.getByRole('slider', { name: 'Opacity, 50 to 100' })).toHaveAttribute('aria-valuetext', '12.5 %');
    expect((await told(page)).some(({ type }) => type === 'change')).toBe(true);
  });

  test('15 by default; in stops again they are what was made of them', async ({ page }) => {
    await openEditor(page, view + editor.replace('for=', 'mode="bands" for='));
    await expect(page.getByRole('listitem')).toHaveCount(15);
    await page.locator('volume-transfer-function').evaluate((element) => element.setAttribute('bands', '4'));
    await expect(page.getByRole('listitem')).toHaveCount(4);
    await page.getByRole('slider', { name: /^Opacity, / }).nth(1).fill('0.4');
    await page.locator('volume-transfer-function').evaluate((element) => element.removeAttribute('mode'));
    await expect(handles(page)).toHaveCount(9);
  });

  test('an attribute that cannot be read is named', async ({ page }) => {
    await openEditor(page, view + bands.replace('0 50 100', '100 50'));
    await expect(page.locator('volume-transfer-function').getByRole('alert')).toContainText('band-edges got "100 50 150 200"; expected');
    await page.locator('volume-transfer-function').evaluate((element) => element.setAttribute('mode', 'waves'));
    await expect(page.locator('volume-transfer-function').getByRole('alert')).toContainText('mode got "waves"; expected stops, or bands');
  });
});

test.describe('the legend', () => {
  test('has round numbers, the unit, and itself in words', async ({ page }) => {
    await open(page, `<volume-view src="/test/e2e/pages/data/field.json" transfer-function="0 blue 1%, 0.5 red 5%, 1 red 10%" alt="A"></volume-view><volume-legend></volume-legend>`);
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

test.describe('finding the volume', () => {
  const words = (page: Page): Promise<string> => page.locator('volume-legend').evaluate((element) => (element.shadowRoot?.textContent ?? '').replace(/\s+/g, ' ').trim());

  test('whatever comes first, and whatever goes', async ({ page }) => {
    await open(page, '<volume-legend for="late" label="Late"></volume-legend>');
    await expect.poll(() => words(page)).toBe('There is no <volume-view id="late"> in this page.');
    await page.evaluate((src) => {
      const later = document.createElement('volume-view');
      document.body.append(later);
      later.id = 'late';
      setTimeout(() => (later.src = src));
    }, fieldUrl);
    await expect.poll(() => words(page)).toBe('No volume is loaded yet.');
    await expect(page.getByRole('img', { name: /^Late/ })).toBeVisible();
    await withElement(page, (element) => {
      element.src = null;
    });
    await expect.poll(() => words(page)).toBe('No volume is loaded yet.');
    await page.locator('volume-view').evaluate((element) => element.remove());
    await expect.poll(() => words(page)).toMatch(/^There is no/);
  });

  test('another one when `for` changes; without it, the nearest', async ({ page }) => {
    const other = view.replace('id="field"', 'id="other"').replace(said, '0 white 0, 77 white 5%');
    await open(page, `<section>${view}</section><section>${other}<p>${legend.replace(' for="field"', '')}</p></section>`);
    const picture = page.getByRole('img', { name: /^Strength/ });
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 77/);
    const setFor = (id: string | null): Promise<void> => page.locator('volume-legend').evaluate((element, name) => {
      if (name === null) element.removeAttribute('for');
      else element.setAttribute('for', name);
    }, id);
    await setFor('field');
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 200/);
    await setFor('nobody');
    await expect.poll(() => words(page)).toBe('There is no <volume-view id="nobody"> in this page.');
    await setFor(null);
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 77/);
  });

  test('taken out of the page it lets go of the volume; put back it holds it again', async ({ page }) => {
    await openEditor(page, view + legend + editor);
    await page.evaluate(() => {
      const counted = window as unknown as { listeners: number };
      counted.listeners = 0;
      const element = document.querySelector('volume-view')!;
      const [add, remove] = [element.addEventListener.bind(element), element.removeEventListener.bind(element)];
      Object.assign(element, {
        addEventListener: (...args: Parameters<typeof add>) => (counted.listeners++, add(...args)),
        removeEventListener: (...args: Parameters<typeof remove>) => (counted.listeners--, remove(...args)),
      });
    });
    const listeners = (): Promise<number> => page.evaluate(() => (window as unknown as { listeners: number }).listeners);
    await page.evaluate(() => {
      const kept = [...document.querySelectorAll('volume-legend, volume-transfer-function')];
      kept.forEach((element) => element.remove());
      Object.assign(window, { kept });
    });
    expect(await listeners()).toBe(-4); // two events each
    await page.evaluate(() => document.body.append(...(window as unknown as { kept: Element[] }).kept));
    expect(await listeners()).toBe(0);
    await expect(handles(page)).toHaveCount(3);
    await drag(page, handle(page, 2), { x: 30, y: 0 });
    await expect.poll(() => readValues(page).then(([, value]) => value)).toBeGreaterThan(105);
  });
});

for (const scheme of ['light', 'dark'] as const) {
  test.describe(`axe, ${scheme}`, () => {
    test.use({ colorScheme: scheme, viewport: { width: 320, height: 700 } });
    const head = '<meta name="viewport" content="width=device-width"><style>:root { color-scheme: light dark }</style>';

    for (const [what, body] of Object.entries({
      stops: view + editor.replace('400px', '100%') + legend,
      bands: view + editor.replace('400px"', '100%" mode="bands"') + legend.replace('label', 'orientation="vertical" label'),
      nothing: '<volume-transfer-function></volume-transfer-function><volume-legend></volume-legend>',
    })) {
      test(`finds nothing: ${what}; nothing is wider than a phone`, async ({ page }) => {
        await open(page, `<main><h1>A volume</h1>${body}</main>`, { head });
        await expect(page.locator('volume-transfer-function').locator(what === 'nothing' ? '.hint' : '.editor')).toBeVisible();
        await expect(page.locator('volume-legend').locator(what === 'nothing' ? '.hint' : '.legend')).toBeVisible();
        if (what !== 'nothing') await settle(page);
        expect(await findFaults(page)).toEqual([]);
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
      });
    }
  });
}
