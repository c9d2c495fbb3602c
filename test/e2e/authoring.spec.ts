// `authoring`: the author of a page shows a place in the picture and copies the tag of a note there.
import type { Locator, Page } from '@playwright/test';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { atlas } from './helpers/atlas.ts';
import { findFaults } from './helpers/axe.ts';
import { expect, fieldUrl, open as openPage, settle, keptTest as test, test as freshTest } from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';
import { serveFiles } from './helpers/served-files.ts';

const box = { width: 320, height: 240 };
const look = attributesOf({ 'transfer-function': '0.15 #003 0, 0.4 #c63 0.3, 0.8 #ffc 0.8', steps: '20' });
const view = (inside = '', more = '', src = fieldUrl): string =>
  `<volume-view id="seen" src="${src}" ${look} style="width: ${box.width}px; height: ${box.height}px" alt="A field" authoring ${more}>${inside}</volume-view>`;

const panel = (page: Page): Locator => page.getByRole('group', { name: 'Place of a note' });
const button = (page: Page, name: string): Locator => panel(page).getByRole('button', { name, exact: true });
const tag = (page: Page): Locator => panel(page).getByRole('textbox', { name: 'Tag' });
const name = (page: Page): Locator => panel(page).getByRole('textbox', { name: 'Name' });
const status = (page: Page): Locator => panel(page).getByRole('status');
const preview = (page: Page, label: string): Locator =>
  page.locator('volume-view').getByRole('button', { name: label, exact: true });

async function open(page: Page, body: string): Promise<void> {
  await openPage(page, `<main><h1>A page</h1>${body}</main>`);
  await settle(page);
  await expect(panel(page)).toBeVisible();
}

/** CSS pixels from the middle of the picture, as places of the page: whole pixels, as browsers cut the fractions of a click off. */
async function placeAt(page: Page, x: number, y: number): Promise<[x: number, y: number]> {
  const { x: left, y: top } = (await page.locator('volume-view').boundingBox())!;
  return [Math.round(left + box.width / 2 + x), Math.round(top + box.height / 2 + y)];
}

const clickAt = async (page: Page, x: number, y: number): Promise<void> =>
  page.mouse.click(...(await placeAt(page, x, y)));

/** What a browser makes of the tag: the attributes of the only element in it. */
const parse = (page: Page): Promise<Record<string, string>> =>
  tag(page).evaluate((field) => {
    const { body } = new DOMParser().parseFromString((field as HTMLTextAreaElement).value, 'text/html');
    const [note, ...others] = body.querySelectorAll('*');
    if (note.localName !== 'volume-note' || others.length > 0) throw new Error(body.innerHTML);
    return Object.fromEntries([...note.attributes].map((one) => [one.name, one.value] as const));
  });

test.describe('authoring', () => {
  test('a click gives the tag of a note, which stands where the click was', async ({ page }) => {
    await open(page, view('<volume-note position="0 0 0"></volume-note>'));
    await expect(panel(page)).toMatchAriaSnapshot(`
      - group "Place of a note":
        - paragraph: Click the place of a note in the picture
        - button "Crosshair"
        - status
    `);
    expect(await findFaults(page)).toEqual([]);
    await clickAt(page, -158, 100);
    await expect(status(page)).toHaveText('Nothing is seen there');
    await expect(tag(page)).toHaveCount(0);
    await clickAt(page, 20, 30);
    await expect(name(page)).toBeFocused();
    await expect(status(page)).toHaveText(/^Place: -?[\d.]+ -?[\d.]+ -?[\d.]+$/);
    await expect(panel(page)).toMatchAriaSnapshot(`
      - group "Place of a note":
        - textbox "Name"
        - button "Copy"
        - button "Crosshair"
        - button "Remove the place"
        - textbox "Tag"
        - status
    `);
    // The author's own note keeps its number.
    await expect(preview(page, 'Note 1')).toHaveCount(1);
    await expect(preview(page, 'Note 2')).toBeVisible();
    await page.keyboard.type('Left lobe');
    await expect(preview(page, 'Left lobe')).toBeVisible();
    expect(await findFaults(page)).toEqual([]);
    expect(await parse(page)).toEqual({ position: expect.any(String), label: 'Left lobe' });
    const written = await tag(page).inputValue();
    const camera = await page.evaluate(() => document.querySelector('volume-view')!.getView()['camera-orbit']);
    expect(camera, 'what is typed turns nothing').toBeUndefined();
    await page.evaluate((written) => {
      const view = document.querySelector('volume-view')!;
      view.authoring = false;
      view.insertAdjacentHTML('beforeend', written.replace('>', ' hide="never">'));
    }, written);
    await expect(panel(page)).toHaveCount(0);
    await expect(preview(page, 'Left lobe')).toHaveCount(1);
    const pin = page.locator('volume-view .pin').nth(1);
    const [x, y] = await placeAt(page, 20, 30);
    await expect(async () => {
      const at = (await pin.boundingBox())!;
      expect(Math.hypot(at.x + at.width / 2 - x, at.y + at.height / 2 - y)).toBeLessThan(1);
    }).toPass();
    await expect(page.locator('volume-view .aim')).toHaveCount(0);
  });

  test('keys alone: a crosshair, a name, a copy, and the next note', async ({ page }) => {
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await open(page, view());
    await button(page, 'Crosshair').focus();
    await page.keyboard.press('Enter');
    const crosshair = page.getByRole('application', { name: 'Crosshair' });
    await expect(crosshair).toBeFocused();
    await page.keyboard.press('Shift+ArrowLeft');
    await expect(page.locator('volume-view .aim [role=status]')).toHaveText(
      /^Place -?[\d.]+ -?[\d.]+ -?[\d.]+, value [\d.]+$/,
    );
    await page.keyboard.press('Enter');
    await expect(name(page)).toBeFocused();
    await expect(crosshair).toHaveCount(0);
    await page.keyboard.type('LAD');
    await page.keyboard.press('Enter');
    await expect(status(page)).toHaveText('Copied. Its text goes between the tags.');
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    expect(copied).toMatch(/^<volume-note position="-?[\d.]+ -?[\d.]+ -?[\d.]+" label="LAD"><\/volume-note>$/);
    expect(copied).toBe(await tag(page).inputValue());
    await page.keyboard.press('Escape');
    await expect(tag(page)).toHaveCount(0);
    await expect(preview(page, 'LAD')).toHaveCount(0);
    await expect(page.locator('volume-view .picture')).toBeFocused();
    // The next note has no name yet; Escape leaves a crosshair without a place.
    await button(page, 'Crosshair').press('Enter');
    await page.keyboard.press('Escape');
    await expect(button(page, 'Crosshair')).toBeFocused();
    await clickAt(page, 0, 0);
    await expect(name(page)).toHaveValue('');
  });

  test('names are texts, and a click that corrects the place keeps them', async ({ page }) => {
    await open(page, view());
    await clickAt(page, 0, 20);
    const evil = '"><img src=x onerror="window.hit=1"> & \'</volume-note>';
    await name(page).fill(evil);
    expect((await parse(page)).label).toBe(evil);
    const { position } = await parse(page);
    await clickAt(page, 20, 60); // Below the panel, which is high with a long name.
    await expect(async () => expect((await parse(page)).position).not.toBe(position)).toPass();
    expect((await parse(page)).label).toBe(evil);
    await expect(preview(page, evil)).toHaveCount(1);
    expect(await page.evaluate(() => 'hit' in window)).toBe(false);
    await expect(page.locator('volume-view img')).toHaveCount(0);
  });

  test('a label may be named in place of a position', async ({ page }) => {
    const folder = '/test/e2e/pages/data/authoring';
    await serveFiles(page, folder, {
      'atlas.nii': Buffer.from(niftiBytes(atlas)),
      'dseg.tsv': Buffer.from('index\tname\n3\tRight side\n7\tLeft side\n'),
    });
    await open(page, view(`<volume-labels src="${folder}/atlas.nii" table="${folder}/dseg.tsv"></volume-labels>`));
    await expect(async () => {
      await clickAt(page, 30, 10);
      await expect(panel(page).getByRole('checkbox')).toHaveCount(1, { timeout: 10_000 });
    }).toPass();
    const [id, label] = (await name(page).inputValue()) === 'Right side' ? ['3', 'Right side'] : ['7', 'Left side'];
    expect(await parse(page)).toEqual({ position: expect.any(String), label });
    await panel(page)
      .getByRole('checkbox', { name: `In the middle of label ${id}, ${label}` })
      .check();
    expect(await parse(page)).toEqual({ of: id, label });
    await expect(preview(page, label)).toBeVisible();
  });

  test('a radar that says where it is has latitude, longitude and height', async ({ page }) => {
    await page.route('**/over-land.json', async (route) => {
      const manifest = (await (
        await route.fetch({ url: new URL('/demos/data/storm-radar-1500.json', page.url()).href })
      ).json()) as object;
      await route.fulfill({ json: { ...manifest, site: { latitude: 10.5, longitude: 20.5, height: 800 } } });
    });
    const src = '/demos/data/over-land.json';
    await openPage(
      page,
      `<volume-view src="${src}" steps="20" alt="A storm" authoring style="width: ${box.width}px; height: ${box.height}px"></volume-view>`,
    );
    await settle(page);
    await expect(panel(page)).toBeVisible();
    // Somewhere is a cloud.
    await expect(async () => {
      for (const [x, y] of [0, 20, -20, 40, -40].flatMap((x) => [10, 30, 50].map((y) => [x, y]))) {
        await clickAt(page, x, y);
        await expect(status(page)).not.toHaveText('');
        if ((await tag(page).count()) > 0) return;
      }
      throw new Error('nothing is seen');
    }).toPass();
    const written = await parse(page);
    expect(Object.keys(written)).toEqual(['latitude', 'longitude', 'height']);
    expect(Math.hypot(Number(written.latitude) - 10.5, Number(written.longitude) - 20.5)).toBeLessThan(4);
    expect(written.height).toMatch(/^-?\d+$/);
    await expect(preview(page, 'Note 1')).toHaveCount(1);
  });

  test('the crosshair of slices gives a place too', async ({ page }) => {
    await open(page, `${view()}<volume-slice-view for="seen" orientation="axial" cursor="1 2 3"></volume-slice-view>`);
    await button(page, 'Crosshair of the slices').click();
    expect(await parse(page)).toEqual({ position: '1 2 3' });
    await expect(page.locator('volume-slice-view').getByRole('button', { name: 'Note 1' })).toBeVisible();
  });
});

freshTest('where the browser does not allow copying, the tag is selected', async ({ page }) => {
  await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
  await open(page, view());
  await clickAt(page, 0, 20);
  await button(page, 'Copy').click();
  await expect(status(page)).toHaveText('The browser does not allow copying. The tag is selected: copy it.');
  await expect(tag(page)).toBeFocused();
  const length = (await tag(page).inputValue()).length;
  expect(await tag(page).evaluate((one: HTMLTextAreaElement) => [one.selectionStart, one.selectionEnd])).toEqual([
    0,
    length,
  ]);
});

freshTest.describe('on a phone', () => {
  freshTest.use({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });

  freshTest('a tap gives the tag, without a keyboard over the picture', async ({ page }) => {
    await open(page, view());
    await page.touchscreen.tap(...(await placeAt(page, 0, 30)));
    await expect(tag(page)).toHaveValue(/^<volume-note position="[-\d. ]+"><\/volume-note>$/);
    await expect(name(page)).not.toBeFocused();
    const [{ y, height }, pin] = [
      (await panel(page).boundingBox())!,
      (await page.locator('volume-view .pin').boundingBox())!,
    ];
    expect(y + height, 'the panel does not cover the place').toBeLessThan(pin.y);
    for (const one of await panel(page).getByRole('button').all())
      expect(Math.round((await one.boundingBox())!.height)).toBeGreaterThanOrEqual(44);
    expect(await findFaults(page)).toEqual([]);
  });
});

freshTest('the code for authors is not loaded without the attribute', async ({ page }) => {
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(new URL(request.url()).pathname));
  const countScripts = (): number => loaded.filter((path) => path.endsWith('.js')).length;
  await openPage(page, view().replace(' authoring', ' controls'));
  await settle(page);
  await expect(page.locator('volume-view .controls')).toBeVisible();
  const before = countScripts();
  await page.evaluate(() => (document.querySelector('volume-view')!.authoring = true));
  await expect(panel(page)).toBeVisible();
  expect(countScripts()).toBeGreaterThan(before);
});
