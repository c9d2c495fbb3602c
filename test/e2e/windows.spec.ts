// The windows of a DICOM file: by name in an attribute, and by choice in a pane.
import type { Page } from '@playwright/test';
import type { VolumeSliceView } from '../../components/volume-slice-view/volume-slice-view.ts';
import { ctSlice, dicomBytes } from '../helpers/dicom-bytes.ts';
import type { DicomFields } from '../helpers/dicom-bytes.ts';
import { findFaults } from './helpers/axe.ts';
import { expect, open, settle, takeScreenshot, keptTest as test, withElement } from './helpers/harness.ts';

const secret = 'Erna Geheim';

/** A CT of 8 x 8 x 4 voxels, all of 0 HU but some of the first slice, with the windows of its file. */
const urlOf = (fields: DicomFields): string => {
  const values = Uint16Array.from({ length: 256 }, (_, i) => (i < 4 ? 0 : i < 8 ? 3000 : 1024));
  const file = dicomBytes({
    ...ctSlice(0),
    Rows: [8],
    Columns: [8],
    PixelSpacing: [1, 1],
    NumberOfFrames: '4',
    PixelData: new Uint8Array(values.buffer),
    ...fields,
  });
  return `data:application/dicom;base64,${Buffer.from(file).toString('base64')}`;
};
const several = urlOf({
  WindowCenter: '40\\-600\\80',
  WindowWidth: '400\\1500\\80',
  WindowCenterWidthExplanation: `MEDIASTINUM\\LUNG\\${secret}`,
});
const one = urlOf({ WindowCenter: [40], WindowWidth: [400] });
const pane = (id: string, attributes: string): string =>
  `<volume-slice-view id="${id}" ${attributes} style="width: 240px"></volume-slice-view>`;
const view = (src: string, attributes = ''): string =>
  `<volume-view id="v" src="${src}" ${attributes} alt="A CT" style="width: 240px; height: 180px"></volume-view>`;

async function textOf(page: Page, id: string): Promise<string> {
  await page.locator(id).evaluate((element) => (element as unknown as VolumeSliceView).whenRendered());
  return (await page.locator(`${id} [part=window]`).textContent()) ?? '';
}

/** Grey in the middle of the left half of a pane, where nothing is written. */
async function grayOf(page: Page, id: string): Promise<number> {
  await textOf(page, id);
  const { width, data } = await takeScreenshot(page, id);
  return data[4 * (80 * width + 60)];
}

test.describe('the windows of a DICOM file', () => {
  test('are listed without the words of the file, and an attribute names one', async ({ page }) => {
    await open(
      page,
      `${view(several, 'value-window="Lung"')}${pane('a', 'for="v"')}${pane('b', 'for="v" value-window="3"')}`,
    );
    await settle(page);
    const { windows, optics } = await withElement(page, ({ volume, optics }) => ({
      windows: volume!.windows,
      optics: [...optics!.window],
    }));
    expect(windows!.map(({ name, from, to }) => [name, from, to])).toEqual([
      ['mediastinum', -160, 239],
      ['lung', -1350, 149],
      ['Window 3', 40, 119],
    ]);
    expect(optics).toEqual([-1350, 149]);
    expect(await textOf(page, '#a')).toBe('W 1500  L −600');
    expect(await textOf(page, '#b')).toBe('W 80  L 80');
    // 0 HU: 1350 / 1499 of white, and below black.
    expect([await grayOf(page, '#a'), await grayOf(page, '#b')]).toEqual([230, 0]);
    expect(await page.content()).not.toContain(secret);
  });

  test('that are not there are an error, which says which ones are', async ({ page }) => {
    const message = (): Promise<string | undefined> =>
      page.locator('#v').evaluate((element) => element.shadowRoot?.querySelector('[part=error]')?.textContent?.trim());
    await open(page, view(several, 'value-window="liver"'));
    await expect.poll(message).toContain('or a window of the file: 1 or mediastinum, 2 or lung, 3 or Window 3');
    await page.locator('#v').evaluate((element) => element.setAttribute('value-window', '2'));
    await settle(page);
    expect(await withElement(page, ({ optics }) => [...optics!.window])).toEqual([-1350, 149]);
  });

  test('are chosen by keyboard in a pane, for all panes of the volume', async ({ page }) => {
    await open(
      page,
      `<main><h1>Slices</h1>${view(several)}${pane('a', 'for="v"')}${pane('b', 'for="v" type="coronal"')}</main>`,
    );
    await settle(page);
    expect(await textOf(page, '#a')).toBe('W 400  L 40');
    const changes = await page.locator('#a').evaluateHandle((element) => {
      const all: unknown[] = [];
      element.addEventListener('window-change', (event) => all.push((event as CustomEvent<unknown>).detail));
      return all;
    });
    const choice = page.getByRole('combobox', { name: 'Window' }).first();
    expect(await choice.locator('option').allTextContents()).toEqual(['Mediastinum', 'Lung', 'Window 3']);
    expect(await choice.inputValue()).toBe('Mediastinum');
    await page.locator('#a').evaluate((element) => element.shadowRoot!.querySelector('select')!.focus());
    await page.keyboard.press('ArrowDown');
    await expect.poll(() => textOf(page, '#b')).toBe('W 1500  L −600');
    expect(await choice.locator('option').allTextContents()).toEqual(['Mediastinum', 'Lung', 'Window 3']);
    expect(await choice.inputValue()).toBe('Lung');
    expect(await grayOf(page, '#a')).toBe(230);
    expect(await changes.jsonValue()).toContainEqual({ window: [-1350, 149] });
    expect(await findFaults(page)).toEqual([]);
    // A window of one's own is none of them.
    const box = (await page.locator('#a').boundingBox())!;
    await page.mouse.move(box.x + 60, box.y + 150);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(box.x + 90, box.y + 150, { steps: 3 });
    await page.mouse.up({ button: 'right' });
    await expect.poll(() => choice.inputValue()).toBe('Other');
    await choice.selectOption('Window 3');
    await expect.poll(() => textOf(page, '#a')).toBe('W 80  L 80');
  });

  test('begin with the one that panes and slices show where nobody names one', async ({ page }) => {
    const lung = urlOf({ WindowCenter: '-600\\40', WindowWidth: '1500\\400' });
    await open(
      page,
      `${view(lung)}${pane('a', 'for="v"')}${pane('b', `src="${lung}"`)}${pane('c', `src="${urlOf({})}"`)}`,
    );
    await settle(page);
    for (const id of ['#a', '#b']) expect(await textOf(page, id)).toBe('W 1500  L −600');
    expect(await textOf(page, '#c'), 'a CT without windows').toBe('W 400  L 40');
  });

  test('are no choice where there is one, or where a pane has colours', async ({ page }) => {
    await open(page, `${pane('a', `src="${one}" value-window="1"`)}${pane('b', `src="${several}" colors="volume"`)}`, {
      script: '<script type="module" src="/dist/volume-slice-view.js"></script>',
    });
    expect(await textOf(page, '#a')).toBe('W 400  L 40');
    await page.locator('#b').evaluate((element) => (element as unknown as VolumeSliceView).whenRendered());
    expect(await page.locator('volume-slice-view select').count()).toBe(0);
  });
});
