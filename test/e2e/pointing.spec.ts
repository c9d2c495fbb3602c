// Pointing: what a script picks, what a click tells, and what it does not disturb.
import type { Page } from '@playwright/test';
import { interpolate } from '../../src/optics/rays/interpolate.ts';
import { projectPlace } from '../../src/viewer/camera/project-place.ts';
import type { VolumePick } from '../../src/index.ts';
import { unitToWorld } from '../../src/volume/grid.ts';
import { invertAffine, transformPoint } from '../../src/volume/matrix.ts';
import { files } from './helpers/data.ts';
import {
  expect,
  fieldUrl,
  open,
  setAttributes,
  settle,
  sharePage,
  takePicture,
  keptTest as test,
  test as newPageTest,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, plainCamera } from './helpers/reference.ts';
import { field } from './helpers/volumes.ts';
import { line, touch } from './helpers/touch.ts';

const plain = (more = ''): string =>
  `<volume-view src="${fieldUrl}" ${attributesOf()} ${more} alt="A field"></volume-view>`;
const size = { width: 120, height: 90 };
const places = [
  [60, 45],
  [48.5, 40],
  [70, 50],
  [66, 30.25],
  [40, 55],
] as const;

const pick = (page: Page, x: number, y: number, at?: 'jump' | 'surface' | 'max'): Promise<VolumePick | null> =>
  withElement(page, (element, [left, top, how]) => element.pick(left, top, how ? { at: how } : undefined), {
    argument: [x, y, at] as const,
  });

/** Keep the details of picks. */
async function watchPicks(page: Page): Promise<() => Promise<(VolumePick | null)[]>> {
  await page.evaluate(() => {
    const picks: unknown[] = ((window as unknown as { picks: unknown[] }).picks = []);
    document.querySelector('volume-view')!.addEventListener('volume-pick', ({ detail }) => picks.push(detail));
    document.addEventListener('volume-pick', () => picks.push('bubbled'));
  });
  return () => page.evaluate(() => (window as unknown as { picks: (VolumePick | null)[] }).picks);
}

function watchFiles(page: Page, paths: string[] = []): string[] {
  page.on('request', (request) => paths.push(new URL(request.url()).pathname));
  return paths;
}

const aWhile = (page: Page): Promise<void> => page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 300)));

test.describe('pick()', () => {
  const sharedPage = sharePage(plain());

  test('is on the pixel, and has the value of the file there', async () => {
    const page = sharedPage();
    const toUnit = invertAffine(unitToWorld(field.grid))!;
    const picture = await takePicture(page);
    for (const [x, y] of places) {
      for (const at of ['jump', 'max'] as const) {
        const found = (await pick(page, x, y, at))!;
        const seen = projectPlace(plainCamera, found.world, size)!;
        expect(Math.hypot(seen[0] - x, seen[1] - y), `${x} ${y}`).toBeLessThan(1e-3);
        const place = transformPoint(toUnit, found.world);
        const { dimensions } = field.grid;
        expect(found.interpolated).toBeCloseTo(field.slope * interpolate(field.samples, dimensions, place), 5);
        const [i, j, k] = found.voxel!;
        expect([i, j, k]).toEqual(place.map((p, axis) => Math.floor(p * dimensions[axis])));
        expect(found.value).toBeCloseTo(field.slope * field.samples[i + dimensions[0] * (j + dimensions[1] * k)], 6);
        expect(found).toMatchObject({ unit: '', radar: null });
        expect(found.color).toMatch(/^#[0-9a-f]{6}$/);
      }
    }
    // Pixel centres: opacities are those of the picture.
    for (const [x, y] of [
      [60.5, 45.5],
      [70.5, 50.5],
    ]) {
      const alpha = picture.data[4 * (Math.floor(y) * picture.width + Math.floor(x)) + 3] / 255;
      expect((await pick(page, x, y))!.opacity).toBeCloseTo(alpha, 1);
    }
  });

  test('finds more of what is in front at the surface than at the maximum', async () => {
    const page = sharedPage();
    const depth = async (at: 'surface' | 'max'): Promise<number> => {
      const { world } = (await pick(page, 60, 45, at))!;
      return Math.hypot(...world.map((x, axis) => x - plainCamera.eye[axis]));
    };
    expect(await depth('surface')).toBeLessThan(await depth('max'));
  });

  test('is null outside, next to the volume and at no place, and never an error', async () => {
    const page = sharedPage();
    for (const [x, y] of [
      [-1, 45],
      [121, 45],
      [60, -0.01],
      [60, 90.5],
      [1, 1],
      [NaN, 45],
      [60, Infinity],
    ])
      expect(await pick(page, x, y), `${x} ${y}`).toBe(null);
    expect(await withElement(page, (element) => (element.pick as (...all: unknown[]) => Promise<unknown>)())).toBe(
      null,
    );
    expect(
      await withElement(page, (element) =>
        (element.pick as (...all: unknown[]) => Promise<unknown>)('60', '45', { at: 'elsewhere' }),
      ),
    ).not.toBe(null);
    expect(
      await withElement(page, (element) => (element.pick as (...all: unknown[]) => Promise<unknown>)(60, 45, null)),
    ).not.toBe(null);
  });

  test('follows the camera, the colours, the region and the projection', async () => {
    const page = sharedPage();
    const before = (await pick(page, 60, 45))!;
    await setAttributes(page, { 'camera-orbit': '215deg 115deg 90' });
    const behind = (await pick(page, 60, 45))!;
    expect(Math.hypot(...behind.world.map((x, axis) => x - before.world[axis])), 'from the other side').toBeGreaterThan(
      1,
    );
    await setAttributes(page, { 'camera-orbit': '35deg 65deg 90', region: '-2 -2 -2 2 2 2' });
    const inside = (await pick(page, 60, 45))!;
    for (const x of inside.world) expect(Math.abs(x)).toBeLessThan(2.001);
    await setAttributes(page, { region: null, projection: 'max' });
    const largest = (await pick(page, 60, 45))!;
    expect(largest.interpolated).toBeGreaterThan(before.interpolated - 1e-6);
    await setAttributes(page, { projection: null, 'transfer-function': '0 red 0, 1 red 0' });
    expect(await pick(page, 60, 45)).toBe(null);
    await setAttributes(page, { 'transfer-function': '0.15 #003 0, 0.4 #c63 4%, 0.8 #ffc 0.3' });
    expect(await pick(page, 60, 45)).toEqual(before);
  });
});

test("pick() is null before there is a volume, and where the element is gone; of another volume it is the new one's", async ({
  page,
}) => {
  await open(page, plain());
  expect(await withElement(page, async (element) => (element.volume ? null : element.pick(60, 45)))).toBe(null);
  await settle(page);
  const before = (await pick(page, 60, 45))!;
  const meanwhile = await withElement(page, async (element) => {
    const first = element.pick(60, 45);
    element.src = '/test/e2e/pages/data/ball.nii';
    return [await first, await element.whenRendered().then(() => element.pick(60, 45))];
  });
  expect(meanwhile[0]).toEqual(before);
  expect(meanwhile[1]!.voxel!.every((index) => index < 12)).toBe(true);
  const gone = await withElement(page, async (element) => {
    const first = element.pick(60, 45);
    element.remove();
    const [during, after] = [await first, await element.pick(60, 45)];
    return [during === null || typeof during.value === 'number', after];
  });
  expect(gone).toEqual([true, null]);
});

test("pick() sees through the author's viewpoint", async ({ page }) => {
  await open(
    page,
    plain().replace(
      '</volume-view>',
      '<viewpoint position="0 -90 0" orientation="1 0 0 1.5708" fieldofview="0.5"></viewpoint></volume-view>',
    ),
  );
  await settle(page);
  const found = (await pick(page, 60, 45))!;
  expect(Math.abs(found.world[0])).toBeLessThan(0.1);
  expect(Math.abs(found.world[2])).toBeLessThan(0.1);
  const right = (await pick(page, 75, 45))!;
  expect(right.world[0]).toBeGreaterThan(2);
});

test('finds a slice of a patient in the picture', async ({ page }) => {
  await open(
    page,
    plain('opacity-factor="0.0001"').replace(
      '</volume-view>',
      '<volume-slice type="axial" at="2"></volume-slice></volume-view>',
    ),
  );
  await settle(page);
  const found = (await pick(page, 60, 45))!;
  expect(found.world[2]).toBeCloseTo(2, 6);
  expect(found.opacity).toBeGreaterThan(0.99);
});

test('labels are whole numbers that are in the file', async ({ page }) => {
  const bytes = Uint8Array.from(files['field.nii']);
  const view = new DataView(bytes.buffer);
  view.setInt16(68, 1002, true); // the intent: labels
  view.setFloat32(112, 1, true);
  for (let i = 352; i < bytes.length; i++) bytes[i] = bytes[i] > 128 ? 17 : bytes[i] > 64 ? 4 : 0;
  await page.route('**/labels.nii', (route) => route.fulfill({ body: Buffer.from(bytes) }));
  await open(page, '<volume-view src="/labels.nii" alt="Labels"></volume-view><volume-readout></volume-readout>');
  await settle(page);
  const seen = new Set<string>();
  for (let x = 30; x <= 90; x += 5) {
    const found = await pick(page, x, 45);
    if (!found) continue;
    expect(found.interpolated).toBe(found.value);
    expect(found.label).toBe(String(found.value));
    seen.add(found.label!);
  }
  expect([...seen].every((label) => label === '4' || label === '17')).toBe(true);
  expect(seen.size).toBeGreaterThan(0);
  await page.mouse.move(60, 45);
  await expect(page.locator('volume-readout [part=row]').first()).toHaveText(/^Label\s*(4|17)$/);
});

test('of a radar it knows range, azimuth, elevation and heights, on a slice too', async ({ page }) => {
  const attributes =
    'src="/demos/data/storm-radar-1510.json" vertical-exaggeration="4" camera-target="-5000 0 9000" camera-orbit="200deg 60deg 56%" steps="60" alt="A storm"';
  await open(page, `<volume-view ${attributes}></volume-view><volume-readout></volume-readout>`, {
    head: '<style>volume-view { width: 300px; height: 225px }</style>',
  });
  await settle(page);
  const check = async (found: VolumePick, x: number, y: number): Promise<void> => {
    const camera = (await withElement(page, (element) => element.camera))!;
    const seen = projectPlace(camera, found.world, { width: 300, height: 225 })!;
    expect(Math.hypot(seen[0] - x, seen[1] - y)).toBeLessThan(0.01);
    const { range, azimuth, elevation, heightAboveAntenna, heightAboveSea, latitude, longitude, gate } = found.radar!;
    const [east, north, up] = found.world;
    expect(up).toBeCloseTo(4 * heightAboveAntenna, 6);
    expect(((Math.atan2(east, north) * 180) / Math.PI + 360) % 360).toBeCloseTo(azimuth, 6);
    expect(Math.hypot(east, north)).toBeLessThan(range);
    expect(Math.abs(gate.range - range)).toBeLessThanOrEqual(250);
    expect(Math.abs(gate.azimuth - azimuth)).toBeLessThanOrEqual(0.5);
    expect(elevation).toBeGreaterThan(0);
    expect([heightAboveSea, latitude, longitude, found.voxel]).toEqual([null, null, null, null]);
    expect(found.unit).toBe('dBZ');
  };
  const tower = (await pick(page, 105, 130))!;
  await check(tower, 105, 130);
  await page.mouse.move(105, 130);
  const texts = page.locator('volume-readout [part=text]');
  await expect(texts.first()).toHaveText(`${tower.value} dBZ`);
  expect(await texts.allInnerTexts()).toEqual([
    `${tower.value} dBZ`,
    `${(tower.radar!.range / 1000).toFixed(2)} km`,
    `${tower.radar!.azimuth.toFixed(1)}°`,
    `${tower.radar!.elevation.toFixed(2)}°`,
    `${tower.radar!.heightAboveAntenna.toFixed(0)} m`,
  ]);
  await withElement(page, (element) => {
    element.transferFunction = '0 white 0.01%, 80 red 0.01%';
    element.innerHTML = '<volume-slice type="ppi" elevation="1.3"></volume-slice>';
    return element.whenRendered();
  });
  const slice = (await pick(page, 105, 140))!;
  await check(slice, 105, 140);
  expect(slice.radar!.elevation).toBeCloseTo(1.3, 3);
  expect(slice.radar!.gate.elevation).toBe(1.3);
  expect(slice.opacity).toBe(1);
});

test.describe('volume-pick', () => {
  test('is fired by a click, and not by a drag, another button or a control', async ({ page }) => {
    await open(page, plain('pickable controls controlslist="nohint"'), {
      head: '<style>volume-view { width: 300px; height: 225px }</style>',
    });
    await settle(page);
    const picks = await watchPicks(page);
    await page.mouse.click(150, 110);
    await expect.poll(picks).toHaveLength(1);
    expect((await picks())[0]).toEqual(await pick(page, 150, 110));
    await page.mouse.click(1, 1);
    await expect.poll(picks).toHaveLength(2);
    expect((await picks())[1]).toBe(null);
    const camera = await withElement(page, (element) => element.camera);
    await page.mouse.move(150, 110);
    await page.mouse.down();
    await page.mouse.move(170, 110, { steps: 4 });
    await page.mouse.move(150, 110, { steps: 4 }); // back where it began, and a drag all the same
    await page.mouse.up();
    await page.mouse.click(150, 110, { button: 'right' });
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Views' }).click();
    await aWhile(page);
    expect(await picks()).toHaveLength(2);
    expect((await withElement(page, (element) => element.camera))!.orbit.radius).toBeCloseTo(camera!.orbit.radius, 6);
  });

  test('knows the place in an element with a border, scaled by the page', async ({ page }) => {
    await open(page, plain('pickable'), {
      head: '<style>volume-view { margin: 40px; border: 10px solid; box-sizing: content-box; transform: scale(2); transform-origin: 0 0 }</style>',
    });
    await settle(page);
    const picks = await watchPicks(page);
    await page.mouse.click(40 + 2 * (10 + 60), 40 + 2 * (10 + 45));
    await expect.poll(picks).toHaveLength(1);
    expect((await picks())[0]!.world).toEqual((await pick(page, 60, 45))!.world);
  });

  test('is fired where nothing turns the picture, and no longer where the attribute is gone', async ({ page }) => {
    await open(page, plain('interaction="none"'));
    await settle(page);
    const paths = watchFiles(page);
    const picks = await watchPicks(page);
    await page.mouse.click(60, 45);
    await aWhile(page);
    expect(await picks()).toEqual([]);
    expect(paths, 'nothing is loaded for those who do not ask').toEqual([]);
    await withElement(page, (element) => void (element.pickable = true));
    await expect.poll(() => paths.filter((path) => path.includes('pick-clicks')).length).toBe(1);
    await aWhile(page);
    await page.mouse.click(60, 45);
    await expect.poll(picks).toHaveLength(1);
    await withElement(page, (element) => void (element.pickable = false));
    await page.mouse.click(60, 45);
    await aWhile(page);
    expect(await picks()).toHaveLength(1);
  });

  test.describe('on a phone', () => {
    test.use({ hasTouch: true });

    test('is fired by a tap, and not by a finger that turns, two that pinch, or one that scrolls', async ({ page }) => {
      await open(page, `${plain('pickable')}<div style="height: 3000px"></div>`);
      await settle(page);
      const picks = await watchPicks(page);
      await page.touchscreen.tap(60, 45);
      await expect.poll(picks).toHaveLength(1);
      expect((await picks())[0]!.voxel).toHaveLength(3);
      await touch(page, [line([30, 45], [90, 45])]);
      await touch(page, [line([50, 45], [40, 45]), line([70, 45], [80, 45])]);
      await touch(page, [line([60, 80], [60, 20])]);
      await aWhile(page);
      expect(await picks()).toHaveLength(1);
    });
  });
});

newPageTest('a page that points at nothing loads nothing of it', async ({ page }) => {
  const paths = watchFiles(page);
  await open(page, plain());
  await settle(page);
  await page.mouse.click(60, 45);
  await aWhile(page);
  expect(paths.filter((path) => /pick|readout|twin|ray-|reference|cast/.test(path))).toEqual([]);
  await pick(page, 60, 45);
  expect(paths.some((path) => path.includes('pick'))).toBe(true);
});

test.describe('without its part', () => {
  test.use({
    allowedLines: /^(error: Failed to load resource|warning: VolumeViewError: the part of volume-view that picks)/,
  });

  newPageTest('pick() says which one is missing, and the picture stays', async ({ page }) => {
    await page.route('**/chunks/pick-*.js', (route) =>
      /pick-clicks/.test(route.request().url()) ? route.continue() : route.fulfill({ status: 404 }),
    );
    await open(page, plain('pickable'));
    await settle(page);
    expect(
      await withElement(page, (element) =>
        element.pick(60, 45).then(
          () => '',
          (error: { code: string }) => error.code,
        ),
      ),
    ).toBe('format/unsupported');
    await page.mouse.click(60, 45);
    await aWhile(page);
    await settle(page);
  });
});
