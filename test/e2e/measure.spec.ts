// <volume-measure>: handles over the picture by mouse, finger and keys, points by clicks, lines in the scene, and words.
import type { Locator, Page } from '@playwright/test';
import { moveByKey, placeInPlane } from '../../src/viewer/camera/drag-place.ts';
import type { SeenPicture } from '../../src/viewer/camera/drag-place.ts';
import type { MeasureResult } from '../../src/viewer/tools/measuring.ts';
import { projectPlace } from '../../src/viewer/camera/project-place.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { findFaults } from './helpers/axe.ts';
import {
  expect,
  fieldUrl,
  open,
  settle,
  takePicture,
  keptTest as test,
  test as newPageTest,
  withElement,
} from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';
import { line, touch } from './helpers/touch.ts';

type Measure = HTMLElement & { points: readonly Vector3[] | null; readonly result: MeasureResult | null };

const view = `<volume-view id="field" src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;
const wide = { head: '<style>volume-view { width: 240px; height: 180px }</style>' };
const rows = (page: Page): Locator => page.locator('volume-measure [part=row]');
const handles = (page: Page): Locator => page.locator('volume-view .handle');
const pointsOf = (page: Page): Promise<readonly Vector3[] | null> =>
  page.locator('volume-measure').evaluate((element: Measure) => element.points);

async function openMeasure(page: Page, attributes: string): Promise<void> {
  await open(
    page,
    `<main>${view}<volume-measure for="field" ${attributes}></volume-measure><h1>Test</h1></main>`,
    wide,
  );
  await settle(page);
  await expect(page.locator('volume-measure [part=measure]')).toBeVisible();
  await page
    .locator('volume-measure')
    .evaluate((element: Measure) =>
      element.addEventListener(
        'measure-change',
        (event) => ((window as { last?: unknown }).last = (event as CustomEvent<unknown>).detail),
      ),
    );
}

const picture = async (page: Page): Promise<SeenPicture> => ({
  camera: (await withElement(page, (element) => element.camera))!,
  width: 240,
  height: 180,
});

async function middleOf(handle: Locator): Promise<[x: number, y: number]> {
  const box = (await handle.boundingBox())!;
  return [box.x + box.width / 2, box.y + box.height / 2];
}

function expectNear(got: readonly number[] | undefined, expected: readonly number[], tolerance: number): void {
  expected.forEach((x, axis) =>
    expect(Math.abs(got![axis] - x), `${String(got)} is not ${String(expected)}`).toBeLessThan(tolerance),
  );
}

test('a distance has lines in the scene, and handles that mouse, finger and keys move while the picture stands still', async ({
  page,
}) => {
  await openMeasure(page, 'points="-16 0 0, 8 0 0" color="#00ff00"');
  await expect(rows(page)).toHaveText(/^Distance\s*24\.00 ± 0\.82 mm$/);
  // In the scene itself, and not only over it.
  const countGreen = async (): Promise<number> => {
    const { data } = await takePicture(page);
    return data.reduce(
      (count, green, i) =>
        count + (i % 4 === 1 && green > 1.3 * data[i - 1] && green > 1.3 * data[i + 1] && green > 40 ? 1 : 0),
      0,
    );
  };
  await expect.poll(countGreen).toBeGreaterThan(5);
  const seen = await picture(page);
  const [x, y] = await middleOf(handles(page).nth(1));
  await page.mouse.move(x + 3, y - 4);
  await page.mouse.down();
  await page.mouse.move(x + 13, y - 14);
  await page.mouse.move(x + 23, y - 24);
  await page.mouse.up();
  const moved = placeInPlane(seen, [8, 0, 0], [x + 20, y - 20]);
  await expect.poll(async () => (await pointsOf(page))![1][0]).toBeLessThan(7.5);
  expectNear((await pointsOf(page))![1], moved, 0.1);
  await handles(page).first().focus();
  await page.keyboard.press('Shift+PageUp');
  await page.keyboard.press('ArrowRight');
  const away = moveByKey(seen, [-16, 0, 0], { key: 'PageUp', shiftKey: true })!;
  expectNear((await pointsOf(page))![0], moveByKey(seen, away, { key: 'ArrowRight', shiftKey: false })!, 1e-6);
  const before = (await pointsOf(page))![1];
  const at = await middleOf(handles(page).nth(1));
  await touch(page, [line(at, [at[0], at[1] + 30])]);
  await expect.poll(async () => (await pointsOf(page))![1][2]).toBeLessThan(before[2] - 1);
  expect((await picture(page)).camera, 'the picture has not turned').toEqual(seen.camera);
  const result = (await page.evaluate(() => (window as { last?: unknown }).last)) as MeasureResult;
  const [from, to] = (await pointsOf(page))!;
  expect(result.value).toBeCloseTo(Math.hypot(...from.map((one, axis) => one - to[axis])), 9);
  await expect(rows(page)).toContainText(result.value.toFixed(2));
  expect(await page.locator('volume-measure').getAttribute('points'), 'it writes no attribute').toBe('-16 0 0, 8 0 0');
  await expect(page.locator('volume-measure [role=status]')).toContainText(`Distance ${result.value.toFixed(2)}`);
  expect(await findFaults(page)).toEqual([]);
  await page.locator('volume-measure').evaluate((element) => ((element as HTMLElement).hidden = true));
  await expect(handles(page), 'hidden hides what is in the picture too').toHaveCount(0);
  await expect.poll(countGreen).toBe(0);
  await expect(page.locator('volume-view [part=measure] text')).toBeEmpty();
  await page.locator('volume-measure').evaluate((element) => ((element as HTMLElement).hidden = false));
  await expect(handles(page)).toHaveCount(2);
  await page.locator('volume-measure').evaluate((element) => element.remove());
  await expect(handles(page)).toHaveCount(0);
  await expect.poll(countGreen).toBe(0);
});

test('points are placed by clicks, cancelled by Escape, and placed in the middle for keys', async ({ page }) => {
  await openMeasure(page, 'type="angle"');
  const [begin, middle] = [
    page.locator('volume-measure button').first(),
    page.getByRole('button', { name: 'Place in the middle' }),
  ];
  await begin.click();
  await page.mouse.click(100, 90);
  await expect(page.locator('volume-measure [part=hint]')).toContainText('point 2 of 3');
  await page.mouse.click(3, 3);
  await expect(page.locator('volume-measure [role=status]')).toHaveText('Nothing is shown there.');
  await page.keyboard.press('Escape');
  await expect(handles(page)).toHaveCount(0);
  await begin.click();
  for (const [x, y] of [
    [100, 90],
    [130, 100],
    [125, 70],
  ] as const) {
    await page.mouse.click(x, y);
    await page.waitForTimeout(50);
  }
  await expect(rows(page)).toHaveText(/^Angle\s*[\d.]+° ± [\d.]+°$/);
  const picked = await withElement(page, async (element) => (await element.pick(130, 100))!.world);
  expectNear((await pointsOf(page))![1], picked, 1e-9);
  await begin.click();
  await page.keyboard.press('Escape');
  expectNear((await pointsOf(page))![1], picked, 1e-9);
  await begin.click();
  await middle.click();
  await expect(handles(page).first()).toBeFocused();
  expect((await pointsOf(page))!.length).toBe(3);
});

test('what is inside a sphere is added up; what cannot be read is said, and the last good measure stays', async ({
  page,
}) => {
  await openMeasure(page, 'type="sphere" points="0 0 0, 5 0 0"');
  await expect(rows(page)).toHaveText([
    /^Radius\s*5 mm$/,
    /^Volume\s*524 ± \d+ mm³$/,
    /^Mean/,
    /^Standard deviation/,
    /^Minimum to maximum/,
    /^Voxels\s*\d+, \d+ of them at the edge$/,
  ]);
  const result = (await page.locator('volume-measure').evaluate((element: Measure) => element.result))!;
  expect(result.statistics!.count, '524 mm³ of 3 mm³ each').toBeGreaterThan(150);
  const error = page.locator('volume-measure [part=error]');
  await page.locator('volume-measure').evaluate((element) => element.setAttribute('points', '0 0 NaN, 1 1 1'));
  await expect(error).toHaveText(
    'points of <volume-measure type="sphere"> got "0 0 NaN, 1 1 1"; expected 2 places, three numbers each, like "10 0 5, 10 12 5".',
  );
  await expect(rows(page).first()).toContainText('5 mm');
  await page.locator('volume-measure').evaluate(
    (element: Measure) =>
      (element.points = [
        [900, 0, 0],
        [901, 0, 0],
      ]),
  );
  await expect(error).toHaveCount(0);
  await expect(rows(page).last()).toHaveText(/none inside/);
  expect(await handles(page).first().isVisible(), 'outside of the picture').toBe(false);
});

newPageTest('a page that measures, cuts and names nothing loads nothing of it', async ({ page }) => {
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(request.url()));
  await open(page, view);
  await settle(page);
  expect(loaded.some((url) => url.includes('volume-view.js'))).toBe(true);
  // Rays on the main processor, which self-checks and picks cast, know of intervals and of labels.
  const others = loaded.filter((url) => !/\/labels-.{8}\.js$/.test(url));
  expect(others.filter((url) => /measure|handle|companion|clip(?!-intervals)|cuts|label/.test(url))).toEqual([]);
  await page.evaluate(() => document.body.append(document.createElement('volume-measure')));
  await expect.poll(() => loaded.filter((url) => url.includes('measure')).length).toBeGreaterThan(0);
});

test('the crosshair of panes stands in the picture of their view, which moves it by its cursor and by a click', async ({
  page,
}) => {
  await open(
    page,
    `<main>${view}<volume-slice-view for="field" type="coronal" cursor="1 2 3"></volume-slice-view></main>`,
    {
      head: '<style>volume-view { width: 240px; height: 180px } volume-slice-view { width: 120px; --volume-slice-crosshair-color: #12fe34 }</style>',
    },
  );
  await settle(page);
  const lines = page.locator('volume-view [part=crosshair] path').last();
  await expect(lines).toHaveAttribute('stroke', '#12fe34');
  const seen = await picture(page);
  // Each axis of the world once: two pixels each, and the place is between them.
  const ends = async (): Promise<number[][]> =>
    [...((await lines.getAttribute('d')) ?? '').matchAll(/M([\d.-]+) ([\d.-]+)L([\d.-]+) ([\d.-]+)/g)].map((found) =>
      found.slice(1).map(Number),
    );
  const aside = async (place: Vector3): Promise<number> => {
    const [x, y] = projectPlace(seen.camera, place, seen)!;
    const found = await ends();
    return found.length === 3
      ? Math.max(
          ...found.map(
            ([x0, y0, x1, y1]) => Math.abs((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)) / Math.hypot(x1 - x0, y1 - y0),
          ),
        )
      : Infinity;
  };
  await expect.poll(() => aside([1, 2, 3])).toBeLessThan(0.2);
  const pane = page.locator('volume-slice-view');
  const paneCursor = (): Promise<readonly number[] | null> =>
    pane.evaluate((element) => (element as HTMLElement & { cursor: Vector3 | null }).cursor);
  await withElement(page, (element) => (element.cursor = [-4, 5, 6]));
  await expect.poll(paneCursor).toEqual([-4, 5, 6]);
  await expect.poll(() => aside([-4, 5, 6])).toBeLessThan(0.2);
  await page.mouse.click(125, 80);
  const world = await withElement(page, async (element) => (await element.pick(125, 80))!.world);
  await expect.poll(paneCursor).toEqual(world);
  expect(await withElement(page, (element) => element.cursor)).toEqual(world);
  await withElement(page, (element) => (element.crosshair = 'none'));
  await expect.poll(ends).toEqual([]);
  await withElement(page, (element) => element.setAttribute('crosshair', 'nothing'));
  await expect(pane.locator('[part=error]')).toContainText(
    'crosshair of <volume-view> got "nothing"; expected auto or none',
  );
  expect(await ends(), 'it stays as it was').toEqual([]);
  await withElement(page, (element) => element.removeAttribute('crosshair'));
  await expect(pane.locator('[part=error]')).toHaveCount(0);
  await withElement(page, (element) => element.setAttribute('cursor', 'here'));
  await expect(pane.locator('[part=error]')).toContainText('cursor of <volume-view> got "here"; expected 3 numbers');
  await pane.evaluate((element) => element.remove());
  await expect(page.locator('volume-view [part=crosshair]')).toHaveCount(0);
});
