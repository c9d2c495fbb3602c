// The sign in a picture's corner for what of a file is not in it, or not as it is there.
import type { Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import { ballUrl, expect, open, settle, keptTest as test, withElement } from './helpers/harness.ts';

const series = '/test/fixtures/nifti/v1-le-series.nii';
const view = (src: string, more = '', inside = ''): string =>
  `<main><h1>Scan</h1><volume-view src="${src}" style="width: 360px; height: 240px" ${more}>${inside}</volume-view><p tabindex="0">text</p></main>`;
const script = ['volume-view', 'volume-labels', 'volume-layer', 'volume-surface', 'volume-slice-view']
  .map((name) => `<script type="module" src="/dist/${name}.js"></script>`)
  .join('');

const reported = async (page: Page, within = 'volume-view'): Promise<string[]> =>
  page.locator(`${within} [part=notice-text] li`).allTextContents();
const sign = (page: Page, within = 'volume-view') => page.locator(`${within} [part=notice-sign]`);
const text = (page: Page, within = 'volume-view') => page.locator(`${within} [part=notice-text]`);

const twoVolumes = (keys: readonly string[]): string =>
  `data:application/octet-stream,${encodeURIComponent(
    [
      'NRRD0004',
      'type: uint8',
      'encoding: ascii',
      'dimension: 4',
      'sizes: 2 2 2 2',
      'kinds: domain domain domain list',
      'space: left-posterior-superior',
      'space directions: (5,0,0) (0,5,0) (0,0,5) none',
      'space origin: (0,0,0)',
      ...keys,
      '',
      '1 1 0 0 0 0 0 0 1 0 0 0 0 0 0 0',
      '',
    ].join('\n'),
  )}`;
/** A segmentation of 3D Slicer with two layers, of which one hides a voxel of the other. */
const segments = twoVolumes(['Segment0_Name:=A', 'Segment1_Name:=B']);
const overlap = '1 of the 2 voxels of the segment "A" are hidden by "B", which overlaps it';

test('there is none where all of the file is shown, and its part is not loaded', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await open(page, view(ballUrl), { script });
  await settle(page);
  await expect(sign(page)).toHaveCount(0);
  expect(await withElement(page, ({ volume }) => [volume!.left, volume!.notices])).toEqual(
    [null, null].map(() => undefined),
  );
  expect(asked.filter((url) => url.includes('view-notices'))).toEqual([]);
});

test('it opens when it is pointed at, has the focus of the keys, or is pressed; Escape closes it', async ({ page }) => {
  await open(page, view(series, 'controls'), { script });
  await settle(page);
  await expect(sign(page)).toBeVisible();
  // The file's second volume is a scan of its own.
  expect(await withElement(page, ({ volume }) => volume!.notices)).toEqual(['number 2 of each voxel']);
  await expect(text(page)).toBeHidden();
  await sign(page).hover();
  await expect(text(page)).toBeVisible();
  expect(await reported(page)).toEqual(['number 2 of each voxel']);
  await text(page).hover();
  await expect(text(page), 'the words can be pointed at').toBeVisible();
  await page.keyboard.press('Escape');
  await page.mouse.move(5, 5);
  await expect(text(page)).toBeHidden();
  await sign(page).click();
  await page.mouse.move(5, 5);
  await expect(text(page), 'it stays').toBeVisible();
  await page.locator('main > p').click();
  await expect(text(page)).toBeHidden();
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Tab');
  for (let i = 0; i < 12 && !(await sign(page).evaluate((button) => button.matches(':focus'))); i++)
    await page.keyboard.press('Shift+Tab');
  await expect(text(page), 'by keys').toBeVisible();
  await expect(sign(page)).toHaveAttribute('aria-expanded', 'true');
  expect(await findFaults(page)).toEqual([]);
  await page.keyboard.press('Escape');
  await expect(text(page)).toBeHidden();
  await expect(sign(page)).toHaveAttribute('aria-expanded', 'false');
  await expect(sign(page)).toHaveAccessibleName('Notes on the data: 1');
});

test('it is no part of the picture, lies within it, and an author can hide it', async ({ page }) => {
  await open(page, view(series), { script, head: '<style>.plain::part(notice-sign) { display: none }</style>' });
  await settle(page);
  const [around, small] = [(await page.locator('volume-view').boundingBox())!, (await sign(page).boundingBox())!];
  expect(small.width).toBeGreaterThanOrEqual(24);
  expect([small.x >= around.x, small.y >= around.y, small.x + small.width <= around.x + around.width]).toEqual([
    true,
    true,
    true,
  ]);
  expect((small.width * small.height) / (around.width * around.height), 'of the picture').toBeLessThan(0.02);
  await page.locator('volume-view').evaluate((element) => element.classList.add('plain'));
  await expect(sign(page)).toBeHidden();
});

test.describe('next to the volume', () => {
  // Who makes the page reads it in the console, too.
  test.use({ allowedLines: /^warning: <volume-(labels|surface)>: (not all of|its materials|of the BIDS table)/ });

  test('it names labels, layers and surfaces by their files, as long as they are there', async ({ page }) => {
    const obj = `data:text/plain,${encodeURIComponent('v 0 0 0\nv 9 0 0\nv 0 9 0\nusemtl red\nf 1 2 3\n')}`;
    await page.route('**/labels.tsv', (route) =>
      route.fulfill({ contentType: 'text/tab-separated-values', body: 'index\tname\nx\tA\n1\tA\n' }),
    );
    await open(
      page,
      view(
        ballUrl,
        '',
        `<volume-labels src="${segments}" table="/labels.tsv"></volume-labels><volume-layer src="${twoVolumes([])}"></volume-layer><volume-surface src="${obj}"></volume-surface>`,
      ),
      { script },
    );
    await settle(page);
    await expect(sign(page)).toBeVisible();
    await expect.poll(() => reported(page)).toHaveLength(4);
    expect(new Set(await reported(page))).toEqual(
      new Set([
        overlap,
        'its materials are not shown',
        'volume 2 of the file',
        'labels.tsv: line 2 got the index "x"; expected a whole number. It is left out',
      ]),
    );
    await page.evaluate(() => document.querySelector('volume-layer')!.setAttribute('hidden', ''));
    await expect.poll(() => reported(page)).toHaveLength(3);
    const labels = (act: 'hide' | 'show' | 'remove'): Promise<void> =>
      page.evaluate((what) => {
        const element = document.querySelector('volume-labels')!;
        if (what === 'remove') element.remove();
        else element.toggleAttribute('hidden', what === 'hide');
      }, act);
    await labels('hide');
    await expect.poll(() => reported(page)).toEqual(['its materials are not shown']);
    await labels('show');
    await expect.poll(() => reported(page)).toHaveLength(3);
    await page.evaluate(() => document.querySelector('volume-surface')!.remove());
    await expect.poll(() => reported(page)).toHaveLength(2);
    // Without the labels nothing is left to say: the sign goes too.
    await labels('remove');
    await expect(sign(page)).toHaveCount(0);
  });
});

test.describe('elsewhere', () => {
  test('a pane with a file of its own has it, below its window', async ({ page }) => {
    await open(
      page,
      `<main><h1>Slices</h1><volume-slice-view src="${segments}" style="width: 240px"></volume-slice-view></main>`,
      { script },
    );
    await page
      .locator('volume-slice-view')
      .evaluate((pane) => (pane as unknown as { whenRendered(): Promise<void> }).whenRendered());
    await expect(sign(page, 'volume-slice-view')).toBeVisible();
    expect(await reported(page, 'volume-slice-view')).toEqual([overlap]);
    await sign(page, 'volume-slice-view').click();
    await expect(text(page, 'volume-slice-view')).toBeVisible();
    expect(await findFaults(page)).toEqual([]);
  });

  test('in the language of the page', async ({ page }) => {
    await open(page, `<div lang="de">${view(series)}</div>`, { script });
    await settle(page);
    await expect(sign(page)).toHaveAccessibleName('Hinweise zu den Daten: 1');
    await expect(text(page).locator('li').first()).toHaveAttribute('lang', 'en');
  });
});
