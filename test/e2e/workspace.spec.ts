// <volume-workspace>: a volume, its panes and companions, laid out by the room that there is; and companions as wide as their view.
import type { Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import { ballUrl, expect, fieldUrl, keptTest as test, open, seenEvents, settle } from './helpers/harness.ts';

const radar = '/test/fixtures/radar/odim-2.1.h5';
const workspace = (inside: string, attributes = ''): string =>
  `<volume-workspace ${attributes}>${inside}</volume-workspace>`;
const view = (src = fieldUrl, inside = ''): string =>
  `<volume-view src="${src}" steps="20" alt="A field">${inside}</volume-view>`;

/** What a workspace has made of itself: names of elements in the order of the page, with their boxes. */
const partsOf = (page: Page): Promise<Record<string, [x: number, y: number, width: number, height: number][]>> =>
  page.locator('volume-workspace').evaluate((element) => {
    const found: Record<string, [number, number, number, number][]> = {};
    for (const one of [...element.querySelectorAll('volume-view'), ...element.shadowRoot!.querySelectorAll('*')]) {
      if (!one.localName.startsWith('volume-')) continue;
      const { x, y, width, height } = one.getBoundingClientRect();
      (found[one.localName] ??= []).push([x, y, width, height].map(Math.round) as [number, number, number, number]);
    }
    return found;
  });

const openWorkspace = async (page: Page, body: string, width: number): Promise<void> => {
  await page.setViewportSize({ width, height: 700 });
  await open(page, body, {
    head: '<style>body { margin: 0 } volume-view { width: auto !important; height: auto !important }</style>',
  });
  if (!body.includes('<volume-labels>')) await settle(page); // Labels without a file are an error, as they should be.
};

test('on a desk two by two, no higher than the screen, and nothing is written twice', async ({ page }) => {
  await openWorkspace(page, `<main><h1>Field</h1>${workspace(view())}</main>`, 900);
  const parts = await partsOf(page);
  expect(new Set(Object.keys(parts))).toEqual(
    new Set(['volume-legend', 'volume-readout', 'volume-slice-view', 'volume-view']),
  );
  const cells = [...parts['volume-view'], ...parts['volume-slice-view']];
  expect(cells).toHaveLength(4);
  expect(new Set(cells.map(([x]) => x)).size).toBe(2);
  expect(new Set(cells.map(([, y]) => y)).size).toBe(2);
  for (const [, , width, height] of cells) {
    expect(Math.abs(width - 446)).toBeLessThanOrEqual(1);
    expect(Math.abs(height - cells[0][3])).toBeLessThanOrEqual(1);
  }
  expect(2 * cells[0][3]).toBeLessThanOrEqual(700);
  for (const pane of await page.locator('volume-workspace').locator('volume-slice-view').all())
    await expect(pane.locator('[part=place]')).not.toHaveText('');
  await expect(page.locator('volume-readout').getByRole('button')).toBeVisible();
  expect(await findFaults(page)).toEqual([]);
});

test('on a phone one below the other, in a wider column the panes in a row', async ({ page }) => {
  await openWorkspace(page, workspace(view()), 390);
  const phone = await partsOf(page);
  const column = [
    ...phone['volume-view'],
    ...phone['volume-slice-view'],
    ...phone['volume-legend'],
    ...phone['volume-readout'],
  ];
  expect(column.every(([x, , width]) => x === 0 && width === 390)).toBe(true);
  expect(column.every(([, y], i) => i === 0 || y >= column[i - 1][1] + column[i - 1][3])).toBe(true);
  await page.setViewportSize({ width: 600, height: 700 });
  const tablet = await partsOf(page);
  expect(new Set(tablet['volume-slice-view'].map(([, y]) => y)).size).toBe(1);
  expect(tablet['volume-view'][0][2]).toBe(600);
});

test('shows what suits the volume, and what the author says instead', async ({ page }) => {
  await openWorkspace(
    page,
    workspace(view(`${fieldUrl} ${ballUrl}`, `<volume-labels></volume-labels>`), 'panes="coronal"'),
    900,
  );
  await expect(page.locator('volume-timeline')).toBeVisible();
  await expect(page.locator('volume-label-list')).toBeVisible();
  await expect(page.locator('volume-slice-view')).toHaveCount(1);
  await expect(page.locator('volume-slice-view')).toHaveAttribute('type', 'coronal');
  await page.locator('volume-workspace').evaluate((element) => {
    element.setAttribute('companions', 'legend');
    element.insertAdjacentHTML('beforeend', '<volume-legend slot="side" label="Mine"></volume-legend>');
  });
  await expect(page.locator('volume-timeline')).toHaveCount(0);
  await expect(page.locator('volume-legend')).toHaveCount(1);
  await expect(page.locator('volume-legend')).toContainText('Mine');
  await page.locator('volume-workspace').evaluate((element) => element.setAttribute('panes', 'none'));
  await expect(page.locator('volume-slice-view')).toHaveCount(0);
});

test('labels that the page hides have no list until they are shown', async ({ page }) => {
  await openWorkspace(page, workspace(view(ballUrl, `<volume-labels hidden src="${ballUrl}"></volume-labels>`)), 900);
  await expect(page.locator('volume-legend')).toBeVisible();
  await expect(page.locator('volume-label-list')).toHaveCount(0);
  await page.evaluate(() => document.querySelector('volume-labels')!.removeAttribute('hidden'));
  await expect(page.locator('volume-label-list')).toBeVisible();
  await page.evaluate(() => document.querySelector('volume-labels')!.setAttribute('hidden', ''));
  await expect(page.locator('volume-label-list')).toHaveCount(0);
});

test('a radar has no panes', async ({ page }) => {
  await openWorkspace(page, workspace(`<volume-view src="${radar}" steps="20" alt="Rain"></volume-view>`), 900);
  await expect(page.locator('volume-slice-view')).toHaveCount(0);
  await expect(page.locator('volume-legend')).toBeVisible();
  expect((await partsOf(page))['volume-view'][0][2]).toBe(900);
});

test('a wrong word is left out, and said', async ({ page }) => {
  await openWorkspace(page, workspace(view(), 'panes="axial top"'), 900);
  await expect(page.locator('volume-workspace').getByRole('alert')).toHaveText(
    'panes of <volume-workspace> got "axial top"; expected none, or some of axial, sagittal, coronal.',
  );
  await expect(page.locator('volume-slice-view')).toHaveCount(3);
  expect((await seenEvents(page)).filter(({ type }) => type === 'error').length).toBeLessThanOrEqual(1);
  await page.locator('volume-workspace').evaluate((element) => element.setAttribute('panes', 'axial'));
  await expect(page.locator('volume-workspace').getByRole('alert')).toHaveCount(0);
});

test('a view that is taken out and another one put in is followed', async ({ page }) => {
  await openWorkspace(page, workspace(view(radar)), 900);
  await expect(page.locator('volume-slice-view')).toHaveCount(0);
  await page.locator('volume-workspace').evaluate((element, html) => {
    element.innerHTML = html;
  }, view());
  await expect(page.locator('volume-slice-view')).toHaveCount(3);
  await page.locator('volume-workspace').evaluate((element) => element.replaceChildren());
  await expect(page.locator('volume-slice-view')).toHaveCount(0);
});

test('companions end where their view ends, with a gap above; other layouts are left alone', async ({ page }) => {
  const tags = '<volume-legend></volume-legend><volume-readout></volume-readout>';
  await open(
    page,
    `<section style="width: 800px"><volume-view id="v" src="${fieldUrl}" steps="20" alt="A field"></volume-view>${tags}</section>
    <div style="display: flex; width: 800px"><volume-legend for="v" style="flex: 1"></volume-legend></div>`,
    { head: '<style>volume-view { width: 320px !important; height: 240px !important }</style>' },
  );
  await settle(page);
  const boxes = await page
    .locator('volume-view, volume-legend, volume-readout')
    .evaluateAll((all) =>
      all.map((one) => one.getBoundingClientRect()).map(({ top, bottom, width }) => [top, bottom, width]),
    );
  const [[, bottom, width], legend, readout, other] = boxes;
  expect(width).toBe(320);
  expect([legend[2], readout[2], other[2]]).toEqual([320, 320, 800]);
  expect([legend[0] - bottom, readout[0] - legend[1]]).toEqual([8, 8]);
});
