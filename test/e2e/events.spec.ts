import { files } from './helpers/data.ts';
import {
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  forgetEvents,
  open,
  seenEvents,
  settle,
  takePicture,
  takeScreenshot,
  keptTest as test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { serveSlowly } from './helpers/slow-server.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

const isRising = (numbers: number[]): boolean => numbers.every((n, i) => i === 0 || n >= numbers[i - 1]);

test('load says what the volume is', async ({ page }) => {
  await open(page, `<volume-view src="/test/e2e/pages/data/field.json"></volume-view>`);
  const { detail } = await waitForEvent(page, 'load');
  expect(detail).toMatchObject({
    dimensions: [24, 20, 16],
    unit: 'au',
    format: 'PNG mosaic',
    title: 'A smooth field',
    credit: 'made by test/e2e/helpers/data.ts',
    indexToWorld: [-1, 0, 0, 11.5, 0, -1.5, 0, 14.25, 0, 0, 2, -15, 0, 0, 0, 1],
  });
  const { spacing, range } = detail as { spacing: number[]; range: number[] };
  [1, 1.5, 2].forEach((length, axis) => expect(spacing[axis]).toBeCloseTo(length, 6));
  const values = [...new Uint8Array(files['field.nii'].slice(352))];
  expect(range[0]).toBeCloseTo(Math.min(...values) / 255, 6);
  expect(range[1]).toBeCloseTo(Math.max(...values) / 255, 6);
  expect(JSON.parse(JSON.stringify(await withElement(page, (element) => element.volume)))).toEqual(detail);
});

test('volume and renderStats are null before there is one', async ({ page }) => {
  await open(page, '<volume-view></volume-view>');
  expect(await withElement(page, (element) => [element.volume, element.renderStats])).toEqual([null, null]);
  await settle(page);
  expect(await withElement(page, (element) => element.redraw().catch((error: Error) => error.message))).toMatch(
    /no volume/,
  );
  expect(await seenEvents(page)).toEqual([]);
});

test('progress counts bytes up to the whole, then decoding', async ({ page }) => {
  const bytes = files['field.nii'];
  const server = await serveSlowly(bytes, 0.4);
  await open(page, `<volume-view src="${server.url}"></volume-view>`);
  await page.waitForFunction(() =>
    window.__seen.some(({ type, detail }) => type === 'progress' && (detail as { loaded: number }).loaded > 0),
  );
  expect(await withElement(page, (element) => element.volume)).toBeNull();
  server.release();
  await waitForEvent(page, 'load');
  const details = (await seenEvents(page))
    .filter(({ type }) => type === 'progress')
    .map(({ detail }) => detail as { loaded: number; total: number; phase: string });
  const fetched = details.filter(({ phase }) => phase === 'fetch');
  expect(fetched.every(({ total }) => total === bytes.length)).toBe(true);
  expect(isRising(fetched.map(({ loaded }) => loaded))).toBe(true);
  expect(fetched.map(({ loaded }) => loaded)).toContain(Math.round(bytes.length * 0.4));
  expect(fetched.at(-1)!.loaded).toBe(bytes.length);
  expect(details.at(-1)!.phase).toBe('decode');
  server.close();
});

test('events come in order and do not bubble', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  await page.locator('.picture').press('ArrowLeft');
  await waitForEvent(page, 'camera-change');
  await withElement(page, (element) => {
    element.setAttribute('steps', 'many');
  });
  await waitForEvent(page, 'error');
  const seen = await seenEvents(page);
  const firsts = ['progress', 'load', 'render', 'camera-change', 'error'].map((name) =>
    seen.findIndex(({ type }) => type === name),
  );
  expect(
    firsts.every((at) => at >= 0),
    'all were seen',
  ).toBe(true);
  expect(isRising(firsts)).toBe(true);
  expect(seen.filter(({ bubbles }) => bubbles)).toEqual([]);
  expect(await page.evaluate(() => window.__bubbled)).toEqual([]);
});

test('render describes the frame that was drawn', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  const stats = await withElement(page, (element) => element.renderStats!);
  expect(stats).toMatchObject({ steps: 30, width: 120, height: 90, converged: true });
  expect(stats.frameMs).toBeGreaterThan(0);
  expect(stats.stepLength).toBeCloseTo(Math.hypot(24, 30, 32) / 30, 6);
  // No ray takes more than all steps, and the volume fills a good part of the picture.
  expect(stats.samples).toBeGreaterThan(120 * 90 * 30 * 0.05);
  expect(stats.samples).toBeLessThan(120 * 90 * 30);
  expect(Object.keys(stats)).toEqual(
    expect.arrayContaining(['frameMs', 'steps', 'stepLength', 'samples', 'width', 'height', 'converged']),
  );
  expect((await seenEvents(page)).filter(({ type }) => type === 'render').at(-1)!.detail).toEqual(stats);
});

test('setting a property fires nothing but what it leads to', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  await forgetEvents(page);
  await withElement(page, async (element) => {
    Object.assign(element, { alt: 'Another', poster: '/favicon.ico', loading: 'eager', cameraControls: 'off' });
    await element.whenRendered();
    element.interaction = null;
    await element.whenRendered();
  });
  expect(await seenEvents(page)).toEqual([]);
  await withElement(page, async (element) => {
    element.steps = 30;
    element.transferFunction = 'viridis';
    element.cameraOrbit = '10deg 50deg 80';
    await element.whenRendered();
  });
  expect(new Set((await seenEvents(page)).map(({ type }) => type))).toEqual(new Set(['render']));
});

test('whenRendered waits for the picture of the present attributes', async ({ page }) => {
  await open(page, plain.replace('steps="30"', 'steps="9"').replace('35deg 65deg 90', '0deg 10deg 200'));
  const stats = await withElement(page, async (element) => {
    await element.whenRendered();
    element.steps = 30;
    element.cameraOrbit = '35deg 65deg 90';
    await element.whenRendered();
    return element.renderStats;
  });
  expect(stats).toMatchObject({ steps: 30, converged: true });
  await page.addStyleTag({ content: 'volume-view { background: white }' });
  expectSamePicture(await takeScreenshot(page), drawReference({ background: [255, 255, 255] }));
});

test('whenRendered asked for before the source is set does not wait for ever, nor fail', async ({ page }) => {
  await open(page, '<volume-view></volume-view>');
  const dimensions = await withElement(
    page,
    async (element, src) => {
      await element.whenRendered();
      element.src = src;
      await element.whenRendered();
      return element.volume!.dimensions;
    },
    { argument: fieldUrl },
  );
  expect(dimensions).toEqual([24, 20, 16]);
});

test('redraw draws one frame and resolves with its numbers', async ({ page }) => {
  await open(page, plain);
  const before = await takePicture(page);
  await forgetEvents(page);
  const [given, kept] = await withElement(page, async (element) => [await element.redraw(), element.renderStats]);
  expect(given).toEqual(kept);
  expect(given).toMatchObject({ steps: 30, width: 120, height: 90, converged: true });
  expect((await seenEvents(page)).map(({ type }) => type)).toEqual(['render']);
  expect(compare(await takePicture(page), before).worst).toBe(0);
});

test('at rest it draws nothing', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  await forgetEvents(page);
  // Sixty of the browser's own frames: a loop of the element's would draw in each.
  await page.evaluate(async () => {
    for (let i = 0; i < 60; i++) await new Promise(requestAnimationFrame);
  });
  expect(await seenEvents(page)).toEqual([]);
});
