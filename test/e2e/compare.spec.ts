// <volume-compare>: two views, one camera
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { findSharedData, projectRoot } from '../../scripts/shared-data.mjs';
import { findFaults } from './helpers/axe.ts';
import { decodePicture } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';
import { attributesOf } from './helpers/reference.ts';
import { ballUrl, expect, fewPixels, fieldUrl, keptTest as test, open, settle } from './helpers/harness.ts';
import { serve, urls, look } from './helpers/scans.ts';

/** Red everywhere in the first view, blue in the second: the whole box is inside the volume. */
const flat = (color: string): Record<string, string> => ({
  'transfer-function': `0 ${color} 1, 1 ${color} 1`,
  'camera-orbit': '0deg 90deg 20',
});
const view = (id: string, changes: Record<string, string> = {}, src = fieldUrl): string =>
  `<volume-view id="${id}" src="${src}" ${attributesOf(changes)} alt="The ${id} field"></volume-view>`;
const box = '<style>volume-compare { inline-size: 320px } volume-view { inline-size: auto; block-size: 160px }</style>';
const compareOf = (more = '', one = flat('red'), two = flat('blue')): string =>
  `${box}<volume-compare ${more}>${view('first', one)}${view('second', two)}</volume-compare>`;

const ready = async (page: Page): Promise<void> => {
  await settle(page, '#first');
  await settle(page, '#second');
};
const divider = (page: Page) => page.getByRole('slider', { name: 'Divider between the two pictures' });
const cameras = (page: Page): Promise<number[][]> =>
  page.evaluate(() =>
    [...document.querySelectorAll('volume-view')].map(({ camera }) =>
      [...camera!.eye, ...camera!.target, ...camera!.up, camera!.fieldOfView].map((x) => Number(x.toFixed(4))),
    ),
  );
const shot = async (page: Page): Promise<Picture> =>
  decodePicture(await page.locator('volume-compare').screenshot({ animations: 'disabled' }));
/** Which view is at a share of the width, in a row above the divider's knob. */
function viewAt({ data, width, height }: Picture, share: number): 'first' | 'second' | 'none' {
  const at = 4 * (Math.round(height * 0.2) * width + Math.round(share * (width - 1)));
  const [red, , blue] = data.slice(at, at + 3);
  return red > blue + 60 ? 'first' : blue > red + 60 ? 'second' : 'none';
}

test.use(fewPixels);

test.describe('under a divider', () => {
  for (const dir of ['ltr', 'rtl'] as const) {
    test(`the first view is before it and the second one behind it, ${dir}`, async ({ page }) => {
      await open(page, `<div dir="${dir}">${compareOf('layout="slider" position="30"')}</div>`);
      await ready(page);
      const seen = (shares: readonly number[], picture: Picture): string[] =>
        shares.map((share) => viewAt(picture, dir === 'ltr' ? share : 1 - share));
      expect(seen([0.1, 0.25, 0.35, 0.9], await shot(page))).toEqual(['first', 'first', 'second', 'second']);
      const { x, y, width, height } = (await page.locator('volume-compare').boundingBox())!;
      const place = (share: number): number => x + width * (dir === 'ltr' ? share : 1 - share);
      await page.mouse.move(place(0.3), y + height / 2);
      await page.mouse.down();
      await page.mouse.move(place(0.8), y + height / 2, { steps: 4 });
      await page.mouse.up();
      await expect(divider(page)).toHaveAttribute('aria-valuenow', '80');
      expect(seen([0.1, 0.75, 0.85], await shot(page))).toEqual(['first', 'first', 'second']);
    });

    test(`keys move it, ${dir}`, async ({ page }) => {
      await open(page, `<div dir="${dir}">${compareOf('layout="slider"')}</div>`);
      await ready(page);
      await divider(page).focus();
      const right = dir === 'ltr' ? 1 : -1;
      for (const [key, now] of [
        ['ArrowRight', 50 + 2 * right],
        ['ArrowLeft', 50],
        ['PageUp', 60],
        ['PageDown', 50],
        ['Home', 0],
        ['ArrowDown', 0],
        ['End', 100],
      ] as const) {
        await page.keyboard.press(key);
        await expect(divider(page), key).toHaveAttribute('aria-valuenow', String(now));
      }
    });
  }

  test('a person can turn either view next to it', async ({ page }) => {
    await open(page, compareOf('layout="slider"'));
    await ready(page);
    const { x, y, width, height } = (await page.locator('volume-compare').boundingBox())!;
    for (const share of [0.2, 0.8]) {
      const [before] = await cameras(page);
      await page.mouse.move(x + width * share, y + height / 3);
      await page.mouse.down();
      await page.mouse.move(x + width * share + 30, y + height / 3, { steps: 3 });
      await page.mouse.up();
      await ready(page);
      const [first, second] = await cameras(page);
      expect(first).not.toEqual(before);
      expect(second).toEqual(first);
    }
  });

  test('axe finds nothing, also in the dark and on a phone', async ({ page }) => {
    await open(page, `<main><h1>Compared</h1>${compareOf('layout="slider"')}</main>`);
    await ready(page);
    expect(await findFaults(page)).toEqual([]);
  });

  test('on paper both are side by side', async ({ page }) => {
    await open(page, compareOf('layout="slider"'));
    await ready(page);
    await page.emulateMedia({ media: 'print' });
    const [one, two] = [await page.locator('#first').boundingBox(), await page.locator('#second').boundingBox()];
    await page.emulateMedia({ media: null });
    expect(two!.x).toBeGreaterThanOrEqual(one!.x + one!.width);
    expect(two!.y).toBe(one!.y);
  });
});

test.describe('captions', () => {
  const named = (more = ''): string =>
    compareOf(more)
      .replace('id="first"', 'id="first" caption="Before"')
      .replace('id="second"', 'id="second" caption="&lt;b>After"');
  const boxes = (page: Page) =>
    Promise.all(
      [
        page.getByText('Before'),
        page.locator('[part=caption]').nth(1),
        page.locator('#first'),
        page.locator('#second'),
      ].map(async (one) => (await one.boundingBox())!),
    );

  for (const dir of ['ltr', 'rtl'] as const)
    test(`stand above the side that they name, ${dir}`, async ({ page }) => {
      await open(page, `<main dir="${dir}"><h1>Compared</h1>${named('layout="slider"')}</main>`);
      await ready(page);
      const [before, after, first, second] = await boxes(page);
      expect(first).toEqual(second);
      expect(before.y + before.height).toBeLessThanOrEqual(first.y);
      expect(after.y).toBe(before.y);
      const [left, right] = dir === 'ltr' ? [before, after] : [after, before];
      expect(left.x + left.width).toBeLessThan(right.x);
      // The divider is over the pictures, not over the captions.
      expect((await page.locator('[part=divider]').boundingBox())!.y).toBe(first.y);
      await page.locator('volume-compare').evaluate((one) => one.setAttribute('layout', 'side'));
      await expect.poll(async () => (await boxes(page))[3].y).toBeGreaterThan(first.y);
      const [a, b, one, two] = await boxes(page); // 320 pixels: one below the other
      const tops = [a, one, b, two].map(({ y }) => y);
      expect(tops.every((top, i) => i === 0 || top > tops[i - 1])).toBe(true);
      await page.locator('volume-compare').evaluate((one) => (one.style.inlineSize = '600px'));
      await expect.poll(async () => (await boxes(page))[3].y).toBe(one.y);
      const [c, d, three, four] = await boxes(page);
      expect([c.x, d.x, c.y]).toEqual([three.x, four.x, d.y]);
      expect(await findFaults(page)).toEqual([]);
    });

  test('are texts, follow the attribute, and leave no room where there are none', async ({ page }) => {
    await open(page, named());
    await ready(page);
    await expect(page.locator('[part=caption]')).toHaveText(['Before', '<b>After']);
    await page.locator('#second').evaluate((one) => one.setAttribute('caption', 'Later'));
    await expect(page.locator('[part=caption]')).toHaveText(['Before', 'Later']);
    await page.evaluate(() =>
      document.querySelectorAll('volume-view').forEach((one) => one.removeAttribute('caption')),
    );
    await expect(page.locator('[part=caption]')).toHaveCount(0);
    const [element, first] = [
      await page.locator('volume-compare').boundingBox(),
      await page.locator('#first').boundingBox(),
    ];
    expect(first!.y).toBe(element!.y);
    await page.locator('#first').evaluate((one) => one.setAttribute('caption', 'Again'));
    await expect(page.locator('[part=caption]')).toHaveText(['Again', '']);
  });

  test('are above their pictures on paper', async ({ page }) => {
    await open(page, named('layout="slider"'));
    await ready(page);
    await page.emulateMedia({ media: 'print' });
    const [before, after, first, second] = await boxes(page);
    await page.emulateMedia({ media: null });
    expect(second.x).toBeGreaterThanOrEqual(first.x + first.width);
    expect([first.y, before.x, after.x]).toEqual([second.y, first.x, second.x]);
    expect(before.y + before.height).toBeLessThanOrEqual(first.y);
  });
});

test.describe('the cameras', () => {
  test('are equal from the first picture on, and after a turn of either view', async ({ page }) => {
    await open(page, compareOf('', {}, { 'camera-orbit': '100deg 30deg 50' }));
    await ready(page);
    let [first, second] = await cameras(page);
    expect(second).toEqual(first);
    for (const id of ['second', 'first']) {
      const before = first;
      await page.locator(`#${id} .picture`).press('ArrowRight');
      await page.locator(`#${id} .picture`).press('Shift+ArrowUp');
      await page.locator(`#${id} .picture`).press('+');
      await ready(page);
      [first, second] = await cameras(page);
      expect(first).not.toEqual(before);
      expect(second).toEqual(first);
    }
    // Nothing is echoed: both come to rest.
    const frames = await page.evaluate(async () => {
      let count = 0;
      const add = (): void => void count++;
      const views = [...document.querySelectorAll('volume-view')];
      for (const one of views) one.addEventListener('render', add);
      await new Promise((resolve) => setTimeout(resolve, 300));
      for (const one of views) one.removeEventListener('render', add);
      return count;
    });
    expect(frames).toBe(0);
  });

  test('are at the same place of the world, where the grids differ', async ({ page }) => {
    await open(
      page,
      `${box}<volume-compare>${view('first')}${view('second', { 'camera-orbit': '' }, ballUrl)}</volume-compare>`,
    );
    await ready(page);
    const [first, second] = await cameras(page);
    expect(second).toEqual(first);
  });

  test('leave one with an error as it is', async ({ page }) => {
    await open(page, `${box}<volume-compare>${view('first', {}, '/nothing.nii')}${view('second')}</volume-compare>`);
    await settle(page, '#second');
    await expect(page.locator('#first').getByRole('alert')).toBeVisible();
    await page.locator('#second .picture').press('ArrowRight');
    await settle(page, '#second');
    await page.locator('#first').evaluate((element, src) => element.setAttribute('src', src), fieldUrl);
    await ready(page);
    const [first, second] = await cameras(page);
    expect(first).toEqual(second);
  });

  test('are together again after the element was moved, and apart once a view is elsewhere', async ({ page }) => {
    await open(page, `${compareOf('', {}, {})}<div id="other"></div>`);
    await ready(page);
    await page.evaluate(() => document.querySelector('#other')!.append(document.querySelector('volume-compare')!));
    await ready(page);
    await page.locator('#first .picture').press('ArrowRight');
    await ready(page);
    let [first, second] = await cameras(page);
    expect(second).toEqual(first);
    await page.evaluate(() => document.body.append(document.querySelector('#second')!));
    await expect(page.locator('volume-compare [part=error]')).toContainText(
      '<volume-compare> got 1 <volume-view>; expected two',
    );
    await ready(page);
    await page.locator('#first .picture').press('ArrowRight');
    await ready(page);
    [first, second] = await cameras(page);
    expect(second).not.toEqual(first);
  });
});

test('three views are too many', async ({ page }) => {
  await open(page, `${box}<volume-compare>${view('first')}${view('second')}${view('third')}</volume-compare>`);
  await expect(page.locator('volume-compare [part=error]')).toContainText('got 3 <volume-view>s; expected two');
});

test('an attribute that can not be read is reported, and the last good one stays', async ({ page }) => {
  await open(page, compareOf('layout="slider" position="30"'));
  await ready(page);
  const error = page.locator('volume-compare [part=error]');
  await page.locator('volume-compare').evaluate((element) => element.setAttribute('position', '300'));
  await expect(error).toContainText('position of <volume-compare> got "300"; expected per cent');
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '30');
  await page.locator('volume-compare').evaluate((element) => element.setAttribute('position', '40'));
  await expect(error).toHaveCount(0);
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '40');
});

test('both show one time', async ({ page }) => {
  await serve(page);
  const scans = (id: string): string =>
    `<volume-view id="${id}" src="${urls(3).join(' ')}" ${look} alt="Scans"></volume-view>`;
  await open(page, `${box}<volume-compare>${scans('first')}${scans('second')}</volume-compare>`);
  await ready(page);
  const shown = (): Promise<(number | undefined)[]> =>
    page.evaluate(() => [...document.querySelectorAll('volume-view')].map(({ scan }) => scan?.index));
  await page.evaluate(() => document.querySelector<HTMLElementTagNameMap['volume-view']>('#second')!.showScan(2));
  await expect.poll(shown).toEqual([2, 2]);
  await page.evaluate(() => document.querySelector<HTMLElementTagNameMap['volume-view']>('#first')!.previous());
  await expect.poll(shown).toEqual([1, 1]);
});

test('the panes of both have one crosshair', async ({ page }) => {
  await open(
    page,
    `${compareOf('', {}, {})}<volume-slice-view for="first"></volume-slice-view><volume-slice-view for="second"></volume-slice-view>`,
  );
  await ready(page);
  await page.evaluate(async () => {
    await customElements.whenDefined('volume-slice-view');
    const [one, two] = document.querySelectorAll('volume-slice-view');
    await one.whenRendered();
    await two.whenRendered();
    two.cursor = [1, 2, 3];
  });
  await expect.poll(() => page.evaluate(() => document.querySelector('volume-slice-view')!.cursor)).toEqual([1, 2, 3]);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, colorScheme: 'dark' });

  test('two views are one below the other, as wide as the page', async ({ page }) => {
    const body = compareOf().replace('inline-size: 320px', 'inline-size: auto');
    await open(page, `<main><h1>Compared</h1>${body}</main>`);
    await ready(page);
    const [one, two] = [await page.locator('#first').boundingBox(), await page.locator('#second').boundingBox()];
    expect([one!.width, two!.width]).toEqual([390, 390]);
    expect(two!.y).toBeGreaterThanOrEqual(one!.y + one!.height);
    expect(await findFaults(page)).toEqual([]);
  });
});

/** Two radars that see the same rain. */
const radars = ['behel', 'bewid'].map((name) => `/shared-data/radar/odim_belgium_20190606/${name}.pvol.hdf`);
const areRadars = radars.every((file) => existsSync(findSharedData(file) ?? ''));
if (!areRadars) console.log(`left out: two real radars compared (needs ${radars.join(' and ')} in ../shared/data)`);

if (areRadars)
  test('two real radars are seen from one place over the earth', async ({ page }) => {
    const radar = (id: string, src: string, name: string): string =>
      `<volume-view id="${id}" src="${src}" caption="${name}" vertical-exaggeration="4" steps="24" alt="Rain around ${name}"></volume-view>`;
    await open(
      page,
      `${box}<volume-compare>${radar('first', radars[0], 'Helchteren')}${radar('second', radars[1], 'Wideumont')}</volume-compare>`,
    );
    await ready(page);
    await expect(page.locator('[part=caption]')).toHaveText(['Helchteren', 'Wideumont']);
    await page.locator('#first').evaluate((one) => one.setAttribute('camera-orbit', '200deg 40deg 300000'));
    await settle(page, '#first');
    // pyproj 3.7, aeqd around 51.069072 N 5.4064 E on a sphere of 6371 km: Wideumont (49.9143 N 5.5056 E) is 7103.4 m east, 128400.0 m south.
    const shift = await page.evaluate(() => {
      const [one, two] = [...document.querySelectorAll('volume-view')].map(({ camera }) => camera!.target);
      return [one[0] - two[0], one[1] - two[1]];
    });
    expect(Math.abs(shift[0] - 7103.4)).toBeLessThan(1);
    expect(Math.abs(shift[1] + 128400)).toBeLessThan(1);
  });

test('works as the guide writes it', async ({ page }) => {
  const guide = readFileSync(join(projectRoot, 'docs/guide/compare.md'), 'utf8');
  const [, html] = /^```html\n([^]*?)^```$/m.exec(guide)!;
  await open(page, box + html.replace('before.nii.gz', fieldUrl).replace('after.nii.gz', ballUrl));
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '50');
  await expect(page.locator('volume-compare [part=error]')).toHaveCount(0);
});
