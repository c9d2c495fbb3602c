import {
  ballUrl,
  compare,
  expect,
  fieldUrl,
  open,
  setAttributes,
  settle,
  sharePage,
  takePicture,
  takeScreenshot,
  keptTest as test,
  withElement,
} from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';
import { attributesOf, plainAttributes } from './helpers/reference.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

// What each attribute does to the mean of [red, green, blue, alpha].
type Mean = readonly [number, number, number, number];
const changes: Record<string, { set: Record<string, string>; expected: (now: Mean, before: Mean) => boolean }> = {
  'transfer-function, stops': {
    set: { 'transfer-function': '0.15 #000 0, 0.8 #00f 10%' },
    expected: ([red, green, blue]) => red === 0 && green === 0 && blue > 10,
  },
  'transfer-function, a preset': {
    set: { 'transfer-function': 'viridis', 'value-window': '0.1 0.9' },
    expected: ([red, green]) => green > red,
  },
  'transfer-function, a part of the window': {
    set: { 'transfer-function': '0% #000 0, 100% #0f0 10%', 'value-window': '0.5 0.9' },
    expected: ([red, green, blue]) => red === 0 && blue === 0 && green > 1,
  },
  'opacity-factor': {
    set: { 'opacity-factor': '0.2' },
    expected: (now, before) => now[3] < before[3] * 0.7 && now[3] > before[3] * 0.1,
  },
  'light-factor': {
    set: { 'light-factor': '0.5' },
    expected: (now, before) => Math.abs(now[0] - before[0] / 2) < 1 && Math.abs(now[3] - before[3]) < 0.1,
  },
  'reference-length': { set: { 'reference-length': '4' }, expected: (now, before) => now[3] < before[3] * 0.8 },
  steps: { set: { steps: '1' }, expected: (now, before) => Math.abs(now[3] - before[3]) < 12 },
  spacing: { set: { spacing: '1 1.5 1' }, expected: (now, before) => now[3] < before[3] },
  'a negative spacing': { set: { spacing: '1 1.5 -2' }, expected: (now, before) => Math.abs(now[3] - before[3]) < 12 },
  src: { set: { src: ballUrl }, expected: (now, before) => now[3] < before[3] * 0.6 && now[3] > 0.5 },
};

test.describe('each alone', () => {
  const sharedPage = sharePage(plain);

  for (const [name, { set, expected }] of Object.entries(changes))
    test(`${name} changes the picture, and back`, async () => {
      const page = sharedPage();
      const before = await takePicture(page);
      const old = await page
        .locator('volume-view')
        .evaluate(
          (element, names) => Object.fromEntries(names.map((n) => [n, element.getAttribute(n)])),
          Object.keys(set),
        );
      await setAttributes(page, set);
      const now = await takePicture(page);
      expect(compare(now, before).worst).toBeGreaterThan(5);
      expect(expected(meanOf(now), meanOf(before)), `${meanOf(now).join(' ')} after ${meanOf(before).join(' ')}`).toBe(
        true,
      );
      await setAttributes(page, old);
      expect(compare(await takePicture(page), before).worst).toBe(0);
    });
});

test('a projection shows the smallest, the mean or the largest value of each ray, and none is as before', async ({
  page,
}) => {
  await open(page, plain);
  const before = await takePicture(page);
  const opacities: number[] = [];
  for (const projection of ['min', 'average', 'max']) {
    await setAttributes(page, { projection });
    const now = await takePicture(page);
    expect(compare(now, before).worst, projection).toBeGreaterThan(5);
    opacities.push(meanOf(now)[3]);
    expect(await withElement(page, (element) => element.optics!.projection)).toBe(projection);
  }
  // Opacity rises with the value here.
  expect(opacities[0]).toBeLessThan(opacities[1]);
  expect(opacities[1]).toBeLessThan(opacities[2]);
  await setAttributes(page, { projection: null });
  expect(compare(await takePicture(page), before).worst).toBe(0);
});

test('properties are the attributes, in camel case', async ({ page }) => {
  await open(page, plain);
  const before = await takePicture(page);
  const after = await withElement(page, async (element) => {
    element.transferFunction = 'inferno';
    element.valueWindow = [0.1, 0.9];
    element.steps = 31;
    await element.whenRendered();
    return element.renderStats!.steps;
  });
  expect(after).toBe(31);
  expect(compare(await takePicture(page), before).worst).toBeGreaterThan(5);
});

test.describe('of several changes in a row the last one holds', () => {
  // A table of colours has to be fetched before it can be used; stops are read at once.
  const slow = 'magma';
  const { 'transfer-function': quick } = plainAttributes;

  for (const [name, first, second] of [
    ['quick after slow', slow, quick],
    ['quick after wrong', 'rainbow', quick],
    ['quick, slow, quick', `${quick}, 1 red 1`, slow],
  ]) {
    test(name, async ({ page }) => {
      await open(page, plain);
      const before = await takePicture(page);
      await withElement(
        page,
        async (element, values) => {
          for (const value of values) {
            element.transferFunction = value;
            await element.updateComplete;
          }
          await element.whenRendered();
        },
        { argument: [first, second, quick] },
      );
      expect(compare(await takePicture(page), before).worst).toBe(0);
      await expect(page.getByRole('alert')).toHaveCount(0);
    });
  }

  for (const src of [ballUrl, '/nowhere.nii']) {
    test(`also while ${src} loads`, async ({ page }) => {
      await page.route('**/nowhere.nii', (route) => route.fulfill({ contentType: 'text/plain', body: 'no' }));
      // Two dozen pictures, of which only the colour is looked at.
      await open(page, plain.replace('<volume-view', '<volume-view style="width: 40px; height: 30px"'));
      await page.addStyleTag({
        content: 'volume-view { background: black } volume-view::part(error) { display: none }',
      });
      await settle(page);
      // At every moment of a load in turn: so many steps of the event loop after its start.
      for (let ticks = 0; ticks < 12; ticks++) {
        const width = await withElement(
          page,
          async (element, [url, count]) => {
            element.transferFunction = '0.15 #000 0, 0.8 #00f 10%';
            element.src = '/test/e2e/pages/data/field.nii';
            await element.whenRendered();
            element.src = url;
            await element.updateComplete;
            for (let i = 0; i < count; i++) await new Promise((resolve) => setTimeout(resolve));
            element.transferFunction = '0.15 #000 0, 0.8 #0f0 10%';
            await element.whenRendered().catch(() => {});
            return element.volume!.dimensions[0];
          },
          { argument: [src, ticks] as const },
        );
        expect(width).toBe(src === ballUrl ? 12 : 24);
        const [, g, b] = meanOf(await takeScreenshot(page));
        expect(g, `green after ${ticks} ticks`).toBeGreaterThan(0.4);
        expect(b, `blue after ${ticks} ticks`).toBe(0);
      }
    });
  }
});

test('properties take numbers, and undefined for nothing', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  const seen = await withElement(page, async (element) => {
    const list: unknown[] = [];
    for (const steps of [70, undefined]) {
      (element as { steps: unknown }).steps = steps;
      await element.updateComplete;
      await element.whenRendered();
      list.push(element.steps, element.renderStats!.steps, element.hasAttribute('error'));
    }
    return list;
  });
  expect(seen.slice(0, 3)).toEqual([70, 70, false]);
  expect(seen[3]).toBe(null);
  expect(seen[4]).not.toBe(70);
});

test('without src there is no picture, as with an image, and with it again there is', async ({ page }) => {
  await open(page, plain);
  const before = await takePicture(page);
  const emptied = await withElement(page, async (element) => {
    element.removeAttribute('src');
    await element.whenRendered();
    return [element.volume, element.renderStats, element.shadowRoot!.querySelectorAll('canvas').length];
  });
  expect(emptied).toEqual([null, null, 0]);
  await setAttributes(page, { src: fieldUrl });
  expect(compare(await takePicture(page), before).worst).toBe(0);
});

test('max-error is kept by as coarse a picture as will do, and the picture states its error', async ({ page }) => {
  // Narrow peaks: of smooth functions a few steps show as much as 8 bits hold.
  const peaks = '0.3 #c63 0, 0.31 #c63 60%, 0.32 #c63 0, 0.6 #ffc 0, 0.61 #ffc 60%, 0.62 #ffc 0';
  await open(page, plain.replace('steps="30"', 'max-error="40"').replace(plainAttributes['transfer-function'], peaks));
  await settle(page);
  const read = () =>
    withElement(page, async (element) => {
      await element.whenRendered();
      return element.renderStats!;
    });
  const loose = await read();
  expect(loose.error!.rms).toBeLessThanOrEqual(40);
  expect(loose.keepsMaxError).toBe(true);
  expect(loose.error!.p99).toBeGreaterThanOrEqual(loose.error!.rms);
  await setAttributes(page, { 'max-error': '0.5' });
  const strict = await read();
  expect(strict.error!.rms).toBeLessThan(loose.error!.rms);
  // Rounding alone leaves 0.29.
  expect(strict.error!.rms).toBeLessThanOrEqual(0.5);
  expect(strict.keepsMaxError).toBe(true);
});

test('steps="auto" keeps an error of 1 at rest, with a step for every voxel', async ({ page }) => {
  await open(page, plain.replace('steps="30"', 'steps="auto"'));
  await settle(page);
  // The finest voxel edge is 1; the diagonal is the longest ray.
  const oneAVoxel = Math.hypot(24, 30, 32);
  const { steps, error, converged } = (await withElement(page, (element) => element.renderStats))!;
  expect(converged).toBe(true);
  expect(error!.rms).toBeLessThanOrEqual(1);
  expect(steps).toBe(Math.ceil(oneAVoxel));
});

test('every preset draws', async ({ page }) => {
  await open(page, plain.replace(/transfer-function="[^"]*"/, 'value-window="0.1 0.9"'));
  await settle(page);
  const names = ['gray', 'viridis', 'inferno', 'mri', 'magma', 'plasma', 'cividis', 'turbo'];
  const seen = new Set<string>();
  for (const name of names) {
    await setAttributes(page, { 'transfer-function': name });
    const mean = meanOf(await takePicture(page));
    expect(mean[3], name).toBeGreaterThan(2);
    seen.add(mean.map((m) => m.toFixed(2)).join(' '));
  }
  expect(seen.size, 'no two are the same').toBe(names.length);
});

test('with no attribute at all the subject is seen and the air is not', async ({ page }) => {
  await open(page, `<volume-view src="${ballUrl}"></volume-view>`);
  const picture = await takePicture(page);
  const alphaAt = (x: number, y: number): number => picture.data[(y * picture.width + x) * 4 + 3];
  expect(alphaAt(60, 45)).toBeGreaterThan(60);
  for (const [x, y] of [
    [5, 5],
    [114, 5],
    [5, 84],
    [114, 84],
  ])
    expect(alphaAt(x, y)).toBe(0);
});
