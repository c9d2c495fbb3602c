// <volume-layer> and color-moment: a second volume in the picture, in panes, under the pointer and in a legend; what is told of bad ones.
import type { Page } from '@playwright/test';
import type { VolumeLayer } from '../../components/volume-layer/volume-layer.ts';
import type { VolumeView } from '../../src/index.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import { findFaults } from './helpers/axe.ts';
import {
  expect,
  fieldUrl,
  open,
  setAttributes,
  settle,
  takePicture,
  takeScreenshot,
  keptTest as test,
} from './helpers/harness.ts';
import { comparePictures } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';
import { serveFiles } from './helpers/served-files.ts';
import { field } from './helpers/volumes.ts';

/** Of both signs, coarser than the field: to its right (in the file) 6, to its left -6. */
const map: Volume = (() => {
  const made = syntheticVolume({
    dimensions: [12, 10, 8],
    kind: 'float32',
    field: (x) => (x < 0.35 ? 6 : x > 0.65 ? -6 : 0),
  });
  const { indexToWorld } = field.grid;
  const half = indexToWorld.map((entry, i) =>
    i < 12 && i % 4 < 3
      ? 2 * entry
      : i < 12
        ? entry + 0.5 * (indexToWorld[i - 1] + indexToWorld[i - 2] + indexToWorld[i - 3])
        : entry,
  );
  return { ...made, grid: { ...made.grid, indexToWorld: half } };
})();
const moved = (by: number): Volume => ({
  ...map,
  grid: { ...map.grid, indexToWorld: map.grid.indexToWorld.map((entry, i) => (i === 3 ? entry + by : entry)) },
});
const files: Record<string, Buffer> = {
  'map.nii': Buffer.from(niftiBytes(map)),
  'far.nii': Buffer.from(niftiBytes(moved(1e3))),
};
const folder = '/test/e2e/pages/data/layers';

const serve = (page: Page): Promise<readonly string[]> => serveFiles(page, folder, files);

/** How much redder than blue the left and the right half are. */
function tintOf({ data, width, height }: Picture): [number, number] {
  const sums: [number, number] = [0, 0];
  for (let at = 0; at < width * height; at++)
    sums[at % width < width / 2 ? 0 : 1] += (data[4 * at] - data[4 * at + 2]) / (width * height);
  return sums;
}

test('a map of both signs is seen in 3D, in a pane, under the pointer and in a legend; hidden it is gone, and a bad one leaves it', async ({
  page,
}) => {
  const asked = await serve(page);
  await open(
    page,
    `<main><h1>Layers</h1><volume-view id="v" src="${fieldUrl}" transfer-function="0 white 0, 60 white 10%" value-window="0 255" steps="40" interaction="none" camera-orbit="0deg 90deg auto" alt="A field"></volume-view>
    <volume-slice-view for="v" type="coronal" style="width: 160px" value-window="0 255"></volume-slice-view><volume-readout for="v"></volume-readout><volume-legend for="v" layer></volume-legend></main>`,
  );
  await settle(page);
  const plain = await takePicture(page);
  const isPart = (path: string): boolean => /[/](overlay|volume-layer|beside)-/.test(path);
  expect(asked.filter(isPart), 'a page without a layer loads nothing of it').toEqual([]);
  await page.evaluate(
    (src) =>
      document
        .querySelector('#v')!
        .insertAdjacentHTML('beforeend', `<volume-layer src="${src}" label="z value"></volume-layer>`),
    `${folder}/map.nii`,
  );
  const layer = page.locator('volume-layer');
  await layer.evaluate(
    (element) => new Promise((resolve) => element.addEventListener('layer-change', resolve, { once: true })),
  );
  await settle(page);
  const got = await takePicture(page);
  const [left, right] = tintOf(got);
  expect(Math.abs(left - right)).toBeGreaterThan(6);
  expect(left * right, 'warm on one side, cold on the other').toBeLessThan(0);
  const pane = tintOf(await takeScreenshot(page, 'volume-slice-view'));
  expect(Math.sign(pane[0]), 'as in the pane').toBe(Math.sign(left));
  expect(Math.sign(pane[1])).toBe(Math.sign(right));
  const picked = await page
    .locator('#v')
    .evaluate((view: VolumeView) =>
      Promise.all(
        Array.from({ length: 15 }, (_, i) => view.pick(((i + 1) / 16) * view.clientWidth, view.clientHeight / 2)),
      ),
    );
  const values = picked.flatMap((pick) => pick?.layers?.map(({ name, value }) => `${name} ${value}`) ?? []);
  expect(values).toEqual(expect.arrayContaining(['z value 6', 'z value -6']));
  await page.locator('#v').hover({ position: { x: 60, y: 50 } });
  await expect(page.locator('volume-readout [part=row]', { hasText: 'z value' }).locator('dd')).toHaveText(/^-?\d/);
  await expect(page.locator('volume-legend [part=title]')).toHaveText('z value');
  expect(await layer.evaluate((element: VolumeLayer) => [element.volume!.dimensions, element.look!.window])).toEqual([
    [12, 10, 8],
    [-6, 6],
  ]);
  expect(await findFaults(page)).toEqual([]);

  const reported = await layer.evaluate(
    (element: VolumeLayer, src) =>
      new Promise((resolve) => {
        element.addEventListener(
          'error',
          (event) => resolve((event as unknown as CustomEvent<{ message: string }>).detail.message),
          { once: true },
        );
        element.src = src;
      }),
    `${folder}/far.nii`,
  );
  expect(reported).toMatch(/far\.nii and the volume have no place in common; expected files of the same body/);
  const kept = await page
    .locator('#v')
    .evaluate(async (view: VolumeView) => (await view.pick(0.5 * view.clientWidth, 0.5 * view.clientHeight))?.layers);
  expect(kept, 'the last good one stays').toEqual([{ name: 'z value', value: expect.any(Number), unit: '' }]);
  await layer.evaluate(
    (element: VolumeLayer, src) => ((element.src = src), (element.hidden = true)),
    `${folder}/map.nii`,
  );
  await settle(page);
  expect(comparePictures(await takePicture(page), plain).worst).toBeLessThanOrEqual(1);
  await layer.evaluate((element: VolumeLayer) => (element.hidden = false));
  await expect(page.locator('volume-legend [part=title]')).toHaveText('z value');
  const back = await page.locator('#v').evaluate(async (view: VolumeView) => {
    const frame = document.body.appendChild(document.createElement('iframe'));
    frame.contentDocument!.body.append(view);
    document.querySelector('main')!.prepend(view);
    await view.whenRendered();
    return (await view.pick(0.5 * view.clientWidth, 0.5 * view.clientHeight))?.layers?.length;
  });
  expect(back, 'through another document').toBe(1);
  await layer.evaluate((element) => document.body.appendChild(document.createElement('volume-view')).append(element));
  await expect(page.locator('volume-legend [part=title]'), 'it is in another view now').toHaveCount(0);
});

test('where a file has no such moment its picture comes to rest, and that is reported', async ({ page }) => {
  const renders = (): Promise<number> =>
    page.locator('volume-view').evaluate((view: VolumeView & { renders?: number }) => view.renders ?? 0);
  for (const [src, reported] of [
    ['/demos/data/storm-radar-1510.json', /color-moment got "VRADH"; expected one that the file holds: DBZH/],
    ['/demos/data/mni152-t1.nii.gz', /color-moment got "VRADH" and a volume that is no radar scan/],
  ] as const) {
    await open(
      page,
      `<volume-view src="${src}" color-moment="VRADH" style="width: 160px; height: 120px" alt="A volume"></volume-view>`,
    );
    await expect(page.locator('volume-view [part=error]')).toContainText(reported);
    await page
      .locator('volume-view')
      .evaluate((view: VolumeView & { renders?: number }) =>
        view.addEventListener('render', () => (view.renders = (view.renders ?? 0) + 1)),
      );
    await expect
      .poll(() => page.locator('volume-view').evaluate((view: VolumeView) => view.renderStats?.converged))
      .toBe(true);
    const before = await renders();
    await page.waitForTimeout(500);
    expect(await renders(), 'pictures of a view at rest').toBe(before);
  }
});

test('a radar is coloured by another moment of its file; one that is not there is reported with the list of those that are', async ({
  page,
}) => {
  const asked = await serve(page);
  await open(
    page,
    '<volume-view src="/test/fixtures/radar/cfradial1-classic.nc" transfer-function="-40 #08f 8%, 90 #f80 30%" camera-orbit="200deg 50deg 100%" steps="60" interaction="none" alt="A storm"></volume-view>',
  );
  await settle(page);
  const plain = await takePicture(page);
  expect(asked.filter((path) => path.includes('color-moment'))).toEqual([]);
  const { moments, moment } = await page.locator('volume-view').evaluate((view: VolumeView) => view.volume!);
  const other = moments!.find((one) => one !== moment)!;
  await setAttributes(page, { 'color-moment': other });
  const colored = await takePicture(page);
  expect(comparePictures(colored, plain).worst).toBeGreaterThan(20);
  const reported = page.locator('volume-view [part=error]');
  await setAttributes(page, { 'color-moment': 'NOPE' }).catch(() => {});
  await expect(reported).toContainText('NOPE');
  await expect(reported).toContainText(other);
  await setAttributes(page, { 'color-moment': null });
  expect(comparePictures(await takePicture(page), plain).worst).toBeLessThanOrEqual(1);
  await setAttributes(page, { src: '/test/fixtures/radar/odim-2.2.h5', 'color-moment': 'VRADH' }).catch(() => {});
  await expect(reported).toContainText('VRADH has 1 sweeps of up to 66 gates, and DBZH has 2 sweeps of up to 33 gates');
});
