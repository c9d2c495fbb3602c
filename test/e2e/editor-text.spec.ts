// <volume-transfer-function>, and what the page says: the transfer function to go back to, its text, bands.
import { drag, editor, handle, handles, openEditor, readStops, said, reported, view } from './helpers/companions.ts';
import { expect, keptTest as test, test as newPageTest, withElement } from './helpers/harness.ts';

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

  test('changed by the page, it is where the editor begins again', async ({ page }) => {
    await openEditor(page);
    await drag(page, handle(page, 2), { x: 30, y: 0 });
    await withElement(page, (element) => {
      element.transferFunction = '0 black 0, 255 white 5%';
    });
    await expect(handles(page)).toHaveCount(2);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
    expect((await reported(page)).at(-1)!.type).toBe('change');
  });

  test('a colour table of 65 stops is given few handles, and only an edit changes it', async ({ page }) => {
    await openEditor(page, view.replace(said, 'viridis') + editor);
    const count = await handles(page).count();
    expect(count).toBeGreaterThan(4);
    expect(count).toBeLessThanOrEqual(24);
    expect(await withElement(page, (element) => element.transferFunction)).toBe('viridis');
  });

  newPageTest('Copy gives attributes', async ({ page, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await openEditor(page);
    await page.getByRole('button', { name: 'Copy' }).click();
    await expect(page.locator('volume-transfer-function').getByRole('status')).toHaveText('Copied');
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(`transfer-function="${said}"`);
    await page.getByRole('slider', { name: 'Light', exact: true }).fill('1');
    await drag(page, handle(page, 2), { x: 30, y: 0 });
    await page.getByRole('button', { name: 'Copy' }).click();
    const text = await withElement(page, (element) => element.transferFunction);
    await expect
      .poll(() => page.evaluate(() => navigator.clipboard.readText()))
      .toBe(`transfer-function="${text}" light-factor="2"`);
  });

  newPageTest('where the clipboard is closed, the text is there to be copied by hand', async ({ page }) => {
    await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
    await openEditor(page);
    await page.getByRole('button', { name: 'Copy' }).click();
    await expect(page.getByLabel('Copy it from here')).toBeFocused();
    await expect(page.getByLabel('Copy it from here')).toHaveValue(`transfer-function="${said}"`);
    expect(
      await page.evaluate(
        () => document.querySelector('volume-transfer-function')!.shadowRoot!.querySelector('textarea')!.selectionEnd,
      ),
    ).toBeGreaterThan(20);
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
    await expect(page.getByRole('slider', { name: 'Opacity, 50 to 100' })).toHaveAttribute('aria-valuetext', '12.5%');
    expect((await reported(page)).some(({ type }) => type === 'change')).toBe(true);
  });

  test('15 by default; in stops again they are what was made of them', async ({ page }) => {
    await openEditor(page, view + editor.replace('for=', 'mode="bands" for='));
    await expect(page.getByRole('listitem')).toHaveCount(15);
    await page.locator('volume-transfer-function').evaluate((element) => element.setAttribute('bands', '4'));
    await expect(page.getByRole('listitem')).toHaveCount(4);
    await page
      .getByRole('slider', { name: /^Opacity, / })
      .nth(1)
      .fill('0.4');
    await page.locator('volume-transfer-function').evaluate((element) => element.removeAttribute('mode'));
    await expect(handles(page)).toHaveCount(9);
  });

  test('an attribute that cannot be read is named', async ({ page }) => {
    await openEditor(page, view + bands.replace('0 50 100', '100 50'));
    await expect(page.locator('volume-transfer-function').getByRole('alert')).toContainText(
      'band-edges got "100 50 150 200"; expected',
    );
    await page.locator('volume-transfer-function').evaluate((element) => element.setAttribute('mode', 'waves'));
    await expect(page.locator('volume-transfer-function').getByRole('alert')).toContainText(
      'mode got "waves"; expected stops, bands, or 2d',
    );
  });
});
