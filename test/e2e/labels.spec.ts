// <volume-labels>, <volume-label-list>: an atlas over a volume, in 3D and in a pane, by list, script and attributes.
import type { Page } from '@playwright/test';
import type { VolumeLabels } from '../../components/volume-labels/volume-labels.ts';
import type { CartesianGrid } from '../../src/volume/grid.ts';
import { transformPoint } from '../../src/volume/matrix.ts';
import { dicomBytes } from '../helpers/dicom-bytes.ts';
import { structureSetFields } from '../helpers/dicom-contours.ts';
import type { MadeRegion, Point } from '../helpers/dicom-contours.ts';
import { segment, segmentationFields } from '../helpers/dicom-segmentation.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { atlas } from './helpers/atlas.ts';
import { findFaults } from './helpers/axe.ts';
import {
  expect,
  fieldUrl,
  open,
  settle,
  takePicture,
  takeScreenshot,
  keptTest as test,
  withElement,
} from './helpers/harness.ts';
import type { Picture } from './helpers/pictures.ts';
import { serveFiles } from './helpers/served-files.ts';

const files: Record<string, Buffer> = {
  'atlas.nii': Buffer.from(niftiBytes(atlas)),
  'far.nii': Buffer.from(
    niftiBytes({
      ...atlas,
      grid: { ...atlas.grid, indexToWorld: atlas.grid.indexToWorld.map((entry, i) => (i === 3 ? entry + 1e4 : entry)) },
    }),
  ),
  'dseg.tsv': Buffer.from('index\tname\tcolor\n3\tRight side\t#ff0000\n7\tLeft side\t#0000ff\n7\tagain\t#00ff00\n'),
};
/** The same atlas as a segmentation of DICOM, whose world leads to the left and to the back. */
files['atlas.dcm'] = (() => {
  const {
    grid: {
      dimensions: [nx, ny, nz],
      indexToWorld: m,
    },
    samples,
  } = atlas as typeof atlas & { grid: CartesianGrid };
  const axes = [0, 1, 2, 3].map((axis) => [-m[axis], -m[axis + 4], m[axis + 8]]);
  const lengths = axes.map((axis) => Math.hypot(...axis));
  const [i, j] = axes.map((axis, n) => axis.map((x) => x / lengths[n]));
  const slices = Array.from({ length: nz }, (_, k) => [...samples.subarray(k * nx * ny, (k + 1) * nx * ny)]);
  const ids = [3, 7];
  return Buffer.from(
    dicomBytes(
      segmentationFields({
        type: 'BINARY',
        columns: nx,
        rows: ny,
        orientation: [...i, ...j],
        spacing: [lengths[1], lengths[0], lengths[2]],
        positionOf: (k) => axes[3].map((x, n) => x + k * axes[2][n]),
        frames: ids.flatMap((id) =>
          slices.map((pixels, slice) => ({ slice, segment: id, pixels: pixels.map((one) => Number(one === id)) })),
        ),
        // Red and blue of sRGB.
        segments: [segment(3, 'Right side', [34885, 53485, 50171]), segment(7, 'Left side', [21169, 53252, 5176])],
      }),
    ),
  );
})();
/** The same atlas by contours: around each side a rectangle in each of its planes. */
files['contours.dcm'] = (() => {
  const { dimensions, indexToWorld } = atlas.grid as CartesianGrid;
  const [nx, ny, nz] = dimensions;
  const at = (i: number, j: number, k: number): Point => {
    const [x, y, z] = transformPoint(indexToWorld, [i, j, k]);
    return [-x, -y, z];
  };
  const sides = [
    [0, nx / 2],
    [nx / 2, nx],
  ].map(([from, to]) => ({ id: atlas.samples[from], from: from - 0.5, to: to - 0.5 }));
  const regions = sides.map(({ id, from, to }): MadeRegion => ({
    number: id,
    name: id === 3 ? 'Right side' : 'Left side',
    color: id === 3 ? [255, 0, 0] : [0, 0, 255],
    contours: Array.from({ length: nz }, (_, k) => [
      at(from, -0.5, k),
      at(to, -0.5, k),
      at(to, ny - 0.5, k),
      at(from, ny - 0.5, k),
    ]),
  }));
  return Buffer.from(dicomBytes(structureSetFields(regions)));
})();
const folder = '/test/e2e/pages/data/labels';
/** Software GL takes half a second for a picture of labels of the specs' usual size: these have a quarter of its pixels. */
const small = 'style="width: 60px; height: 45px"';
const looks =
  'transfer-function="0 white 0, 60 white 40%" value-window="0 255" steps="40" interaction="none" camera-orbit="0deg 90deg auto" alt="A field"';
const view = (inside: string, src = fieldUrl): string =>
  `<main><h1>Labels</h1><volume-view id="v" src="${src}" ${small} ${looks}>${inside}</volume-view>`;
const labels = (attributes = `src="${folder}/atlas.nii" table="${folder}/dseg.tsv"`, inside = ''): string =>
  `<volume-labels ${attributes}>${inside}</volume-labels>`;
const twice = /^warning: <volume-labels>: of the BIDS table .*\nline 4: label 7 is there already/;

const serve = (page: Page): Promise<readonly string[]> => serveFiles(page, folder, files);

const withLabels = <R>(page: Page, act: (element: VolumeLabels) => R): Promise<R> =>
  page.locator('volume-labels').evaluate(act as never);

/** What picks right and left of the middle tell: id and name; null for nothing. */
const pickNames = (page: Page): Promise<unknown> =>
  withElement(page, async (one) => {
    const picks = await Promise.all([0.4, 0.6].map((x) => one.pick(x * one.clientWidth, one.clientHeight / 2)));
    return picks.map((pick) => pick && [pick.label, pick.labelName]);
  });

/** How red, less how blue, what is left and what is right of the middle is. */
function tintOf({ width, height, data }: Picture): [left: number, right: number] {
  const sums: [number, number] = [0, 0];
  for (let at = 0; at < width * height; at++) {
    const x = (at % width) / width;
    if (Math.abs(x - 0.5) > 0.05) sums[x < 0.5 ? 0 : 1] += data[4 * at] - data[4 * at + 2];
  }
  return sums;
}

for (const [what, name] of [
  ['a segmentation', 'atlas.dcm'],
  ['a structure set', 'contours.dcm'],
])
  test(`${what} of DICOM colours and names what it covers, at its own places`, async ({ page }) => {
    await serve(page);
    await open(page, `${view(labels(`src="${folder}/${name}"`))}</main>`);
    await settle(page);
    const [left, right] = tintOf(await takePicture(page));
    expect(left).toBeGreaterThan(1000);
    expect(right).toBeLessThan(-1000);
    expect(await pickNames(page)).toEqual([
      ['3', 'Right side'],
      ['7', 'Left side'],
    ]);
  });

test.describe('behind a token', () => {
  test.use({ allowedLines: /401|404|Failed to load resource|<volume-labels>: of the/ });

  test('labels and their table are fetched as the page fetches the volume', async ({ page }) => {
    await serve(page);
    await page.route(`**${folder}/*`, async (route) => {
      const { authorization } = await route.request().allHeaders();
      return authorization === 'Bearer 1234' ? route.fallback() : route.fulfill({ status: 401 });
    });
    await open(page, view('', '/demos/data/none'));
    await withElement(
      page,
      (one, [src, inside]) => {
        one.fetch = (address, options) =>
          fetch(address, {
            ...options,
            headers: { ...Object.fromEntries(new Headers(options?.headers)), Authorization: 'Bearer 1234' },
          });
        one.innerHTML = inside;
        one.src = src;
      },
      { argument: [fieldUrl, labels()] as const },
    );
    await expect
      .poll(() => pickNames(page))
      .toEqual([
        ['3', 'Right side'],
        ['7', 'Left side'],
      ]);
  });
});

test.describe('an atlas', () => {
  test.use({ allowedLines: twice });

  test('colours and names what it covers, in 3D and in a pane; the list hides one, and nothing else changes', async ({
    page,
  }) => {
    await serve(page);
    await open(
      page,
      `${view(labels())}<volume-slice-view for="v" type="coronal" style="width: 160px" value-window="0 255"></volume-slice-view>
      <volume-readout for="v"></volume-readout><volume-label-list for="v"></volume-label-list></main>`,
    );
    await settle(page);
    const rows = page.locator('volume-label-list li');
    await expect(rows).toHaveCount(3);
    await expect(page.getByRole('checkbox')).toHaveText(['', '', '']);
    expect(await page.locator('volume-label-list bdi').allTextContents()).toEqual([
      'Everything else',
      'Right side',
      'Left side',
    ]);
    const before = await takePicture(page);
    const [left, right] = tintOf(before);
    // From the front the patient's right is on the left, as in the coronal pane.
    expect(left).toBeGreaterThan(1000);
    expect(right).toBeLessThan(-1000);
    const pane = tintOf(await takeScreenshot(page, 'volume-slice-view'));
    expect(pane[0]).toBeGreaterThan(1000);
    expect(pane[1]).toBeLessThan(-1000);
    await expect(page.locator('volume-slice-view [part=value]')).toHaveText(/^(Right|Left) side · \d+/);
    const named = await page.locator('volume-slice-view').evaluate(
      (pane) =>
        new Promise((resolve) => {
          pane.addEventListener(
            'cursor-change',
            (event) => resolve((event as CustomEvent<{ label: string }>).detail.label),
            { once: true },
          );
          pane.setAttribute('cursor', '5 0 0');
        }),
    );
    expect(named).toBe('Right side');
    expect(await pickNames(page)).toEqual([
      ['3', 'Right side'],
      ['7', 'Left side'],
    ]);
    await page.locator('#v').hover({ position: { x: 36, y: 22 } });
    await expect(page.locator('volume-readout dd').first()).toHaveText('Left side');
    expect(await findFaults(page)).toEqual([]);

    await page.getByRole('checkbox', { name: 'Left side' }).uncheck();
    await settle(page);
    const after = await takePicture(page);
    const change = [0, 0];
    for (let at = 0; at < after.width * after.height; at++) {
      const x = (at % after.width) / after.width;
      const by = Math.abs(after.data[4 * at + 3] - before.data[4 * at + 3]);
      if (Math.abs(x - 0.5) > 0.1) change[x < 0.5 ? 0 : 1] = Math.max(change[x < 0.5 ? 0 : 1], by);
    }
    expect(change[0], 'the other side stays').toBeLessThanOrEqual(2);
    expect(change[1]).toBeGreaterThan(40);
    expect(await pickNames(page), "what is hidden can't be pointed at").toEqual([['3', 'Right side'], null]);
    await expect
      .poll(async () => tintOf(await takeScreenshot(page, 'volume-slice-view'))[1], 'the pane follows')
      .toBeGreaterThan(-10);
  });

  test('follows keys, the search, scripts and children, and loads nothing twice', async ({ page }) => {
    const asked = await serve(page);
    await open(page, `${view(labels())}<volume-label-list for="v"></volume-label-list></main>`);
    await settle(page);
    const hidden = (): Promise<readonly number[]> => withLabels(page, (element) => element.hiddenLabels);
    await page.getByRole('searchbox', { name: 'Find a label' }).focus();
    await page.keyboard.type('SIDE left');
    await expect(page.locator('volume-label-list li')).toHaveCount(1);
    await page.keyboard.press('Tab'); // Over "Show all", which has nothing to do.
    await expect(page.getByRole('checkbox', { name: 'Left side' })).toBeFocused();
    await page.keyboard.press('Space');
    expect(await hidden()).toEqual([7]);
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    expect(await hidden(), 'only this').toEqual([0, 3]);
    await expect(page.locator('volume-label-list [role=status]')).toHaveText('1 of 2 shown');
    const places = await page.locator('volume-label-list [role=status] span').evaluate((span) => {
      document.documentElement.dir = 'rtl';
      const text = document.createTreeWalker(span, NodeFilter.SHOW_TEXT).nextNode()!;
      const places = [0, 11].map((at) => {
        const range = document.createRange();
        range.setStart(text, at);
        range.setEnd(text, at + 1);
        return range.getBoundingClientRect().left;
      });
      document.documentElement.dir = '';
      return places;
    });
    expect(places[0], 'English words in a page that runs to the left begin with their first').toBeLessThan(places[1]);
    await page.getByRole('searchbox').fill('');
    await page.getByRole('button', { name: 'Show all' }).click();
    expect(await hidden()).toEqual([]);
    await withLabels(page, (element) => {
      element.innerHTML = '<volume-label value="3" name="<b>R</b>" color="lime" hidden></volume-label>';
    });
    await expect(page.locator('volume-label-list bdi').nth(1)).toHaveText('<b>R</b>');
    expect(await withLabels(page, (element) => element.labels.map(({ color }) => color))).toEqual([
      '#ffffff',
      '#00ff00',
      '#0000ff',
    ]);
    await withLabels(page, (element) => element.firstElementChild!.toggleAttribute('hidden'));
    await withLabels(page, (element) => element.firstElementChild!.toggleAttribute('hidden'));
    await expect.poll(hidden, 'an attribute that changes counts again').toEqual([3]);
    for (const name of ['atlas.nii', 'dseg.tsv']) expect(asked.filter((path) => path.endsWith(name))).toHaveLength(1);
    await withLabels(
      page,
      (element) =>
        (element.innerHTML = '<volume-label value="3" transfer-function="0% lime 0, 25% lime 40%"></volume-label>'),
    );
    await settle(page);
    const tints = tintOf(await takePicture(page));
    expect(Math.abs(tints[0]), 'a label with a transfer function of its own has the colours of that').toBeLessThan(25);
    expect(tints[1]).toBeLessThan(-1000);
    const pickAppearance = (): Promise<[string, number] | null> =>
      withElement(page, async (one) => {
        const pick = await one.pick(0.4 * one.clientWidth, one.clientHeight / 2);
        return pick && [pick.color, pick.opacity];
      });
    const [color, opacity] = (await pickAppearance())!;
    expect(color).toBe('#00ff00');
    await withElement(page, (one) => one.setAttribute('value-window', '0 12000'));
    await expect.poll(async () => (await pickAppearance())?.[1], 'which spans the window').toBeLessThan(0.5 * opacity);
    await withElement(page, (one) => one.setAttribute('value-window', '0 255'));
    await withLabels(page, (element) => (element.hidden = true));
    await expect(page.locator('volume-label-list')).toContainText('The labels are hidden.');
    await withLabels(page, (element) => (element.hidden = false));
    await expect(page.locator('volume-label-list li')).toHaveCount(3);
    await withLabels(page, (element) => element.remove());
    await settle(page);
    const [left, right] = tintOf(await takePicture(page));
    expect(Math.abs(left) + Math.abs(right), 'without its labels the volume is as it was').toBe(0);
    await expect(page.locator('volume-label-list')).toContainText('This volume has no labels.');
  });
});

test.describe('a volume that is labels', () => {
  test.use({ allowedLines: twice });

  test('takes names and colours of a table', async ({ page }) => {
    await serve(page);
    await open(
      page,
      `<main><h1>Labels</h1><volume-view id="v" src="${folder}/atlas.nii" ${small} steps="40" interaction="none" camera-orbit="0deg 90deg auto" alt="Two sides">${labels(`table="${folder}/dseg.tsv"`)}</volume-view>
      <volume-slice-view for="v" type="coronal" style="width: 160px"></volume-slice-view></main>`,
    );
    await settle(page);
    const [left, right] = tintOf(await takePicture(page));
    expect(left).toBeGreaterThan(1000);
    expect(right).toBeLessThan(-1000);
    await expect(page.locator('volume-slice-view [part=value]')).toHaveText(/^(Right|Left) side$/);
    await withLabels(page, (element) => element.showOnly([3]));
    await settle(page);
    const after = tintOf(await takePicture(page));
    expect(after[0]).toBeGreaterThan(1000);
    expect(Math.abs(after[1])).toBeLessThan(2.5);
  });
});

test.describe('a pane that stands alone', () => {
  test.use({ allowedLines: twice });

  test("has labels in addition to its file, or is labels itself, and reports what it can't show", async ({ page }) => {
    await serve(page);
    const pane = (id: string, src: string, inside: string): string =>
      `<volume-slice-view id="${id}" src="${src}" type="coronal" style="width: 160px">${inside}</volume-slice-view>`;
    await open(
      page,
      `<main><h1>Panes</h1>${pane('beside', fieldUrl, labels())}${pane('own', `${folder}/atlas.nii`, labels(`table="${folder}/dseg.tsv"`))}</main>`,
    );
    for (const [id, value] of [
      ['beside', /^(Right|Left) side · \d+/],
      ['own', /^(Right|Left) side$/],
    ] as const) {
      await expect(page.locator(`#${id} [part=value]`)).toHaveText(value);
      const [left, right] = tintOf(await takeScreenshot(page, `#${id}`));
      expect(left, id).toBeGreaterThan(1000);
      expect(right, id).toBeLessThan(-1000);
    }
    await page
      .locator('#beside volume-labels')
      .evaluate((element, src) => element.setAttribute('src', src), `${folder}/far.nii`);
    await expect(page.locator('#beside [part=error]')).toContainText('no place in common');
    await page.locator('#beside volume-labels').evaluate((element) => element.remove());
    await expect(page.locator('#beside [part=error]')).toHaveCount(0);
    await expect
      .poll(async () => tintOf(await takeScreenshot(page, '#beside .picture'))[1], 'grey but for the crosshair')
      .toBeGreaterThan(-10);
  });
});

test.describe("what can't be shown", () => {
  test.use({
    allowedLines: new RegExp(`${twice.source}|^warning: <volume-labels> (got no volume around it|is the second one)`),
  });

  test('is reported, and the last good labels stay; elements without a volume of their own say so', async ({
    page,
    lines,
  }) => {
    await serve(page);
    await open(page, `${view(labels())}</main>`);
    await settle(page);
    const before = tintOf(await takePicture(page));
    const others = labels(`src="${folder}/far.nii"`);
    await page.evaluate((html) => {
      document.querySelector('volume-view')!.insertAdjacentHTML('beforeend', html);
      document.body.insertAdjacentHTML('beforeend', html);
    }, others);
    await expect.poll(() => lines.filter((line) => /no volume around it|the second one/.test(line)).length).toBe(2);
    await page.evaluate(() =>
      document
        .querySelectorAll('volume-labels:not(:first-child), body > volume-labels')
        .forEach((element) => element.remove()),
    );
    const errors: [Record<string, string>, string, RegExp][] = [
      [{ src: `${folder}/far.nii` }, 'format/unsupported', /no place in common/],
      [{ src: `${folder}/atlas.nii`, table: `${folder}/atlas.nii` }, 'format/unknown', /BIDS/],
    ];
    for (const [attributes, code, message] of errors) {
      const reported = await page.locator('volume-labels').evaluate(
        (element, changes) =>
          new Promise<{ code: string; message: string }>((resolve) => {
            element.addEventListener(
              'error',
              (event) => resolve((event as unknown as CustomEvent<{ code: string; message: string }>).detail),
              { once: true },
            );
            for (const [name, value] of Object.entries(changes)) element.setAttribute(name, value);
          }),
        attributes,
      );
      expect(reported.code).toBe(code);
      expect(reported.message).toMatch(message);
      await expect(page.getByRole('alert')).toContainText('The labels cannot be shown.');
      await expect(page.getByRole('alert')).toContainText(message);
    }
    await page.locator('volume-labels').evaluate(
      (element, [src, table]) => {
        element.setAttribute('src', src);
        element.setAttribute('table', table);
      },
      [`${folder}/atlas.nii`, `${folder}/dseg.tsv`],
    );
    await settle(page);
    await expect(page.getByRole('alert')).toHaveCount(0);
    expect(tintOf(await takePicture(page))).toEqual(before);
  });
});
