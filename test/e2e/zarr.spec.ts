// An OME-Zarr on a static server of another origin: with faults, with a strict policy, its channels, times, labels and regions.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { crc32 } from '../../src/formats/codecs/crc32.ts';
import { pyramidFiles } from '../helpers/zarr-bytes.ts';
import type { PyramidCase, ZarrFiles } from '../helpers/zarr-bytes.ts';
import { startZarr } from '../helpers/zarr-server.ts';
import type { ZarrFaults, ZarrServer } from '../helpers/zarr-server.ts';
import { zipBytes } from '../helpers/zip-bytes.ts';
import { expect, fewPixels, networkLines, open, settle, test, waitForEvent, withElement } from './helpers/harness.ts';

test.use(fewPixels);

// What is not there, and what failed, is a line of the browser's own.
test.use({ allowedLines: networkLines });

const running: ZarrServer[] = [];
const start = async (files: ZarrFiles, faults: ZarrFaults = {}, name?: string): Promise<ZarrServer> => {
  const server = await startZarr(files, faults, name);
  running.push(server);
  return server;
};
test.afterEach(async () => {
  await Promise.all(running.splice(0).map((server) => server.close()));
});

const view = (attributes: string, inside = ''): string =>
  `<main><h1>A brain</h1><volume-view id="v" ${attributes} style="width: 60px; height: 45px" alt="A brain" interaction="none">${inside}</volume-view></main>`;

const pyramid: PyramidCase = { shape: [24, 20, 28], levels: 3, unit: 'millimeter' };
const shards = { version: 3, chunk: [3, 5, 7], shard: [6, 10, 14] } as const;

for (const [name, made, faults] of [
  ['of Zarr 2, some chunks of which are missing', { ...pyramid, isMissing: ([z]: readonly number[]) => z === 1 }, {}],
  ['of Zarr 3 in shards', { ...pyramid, ...shards }, {}],
  ['in shards on a server that sends no parts', { ...pyramid, ...shards }, { ranges: false }],
  ['of which a tenth of all requests fails', pyramid, { failEvery: 10 }],
] as const)
  test(`an OME-Zarr ${name} is shown`, async ({ page }) => {
    const server = await start(pyramidFiles(made), faults);
    await open(page, view(`src="${server.url}"`));
    await settle(page);
    const volume = await withElement(page, (one) => one.volume);
    expect(volume!.dimensions).toEqual([28, 20, 24]);
    expect(volume!.reduced).toBeUndefined();
    expect(server.most()).toBeLessThanOrEqual(8);
    expect(server.running()).toBe(0);
  });

test('one scene is made while the chunks of an OME-Zarr come, and the coarse picture is first', async ({ page }) => {
  const server = await start(pyramidFiles({ ...pyramid, chunk: [3, 4, 4] }), { slowMs: 15 });
  await page.addInitScript(() => {
    const native = HTMLCanvasElement.prototype.getContext;
    const contexts = new Set<unknown>();
    Object.assign(globalThis, { contexts });
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
      const context: unknown = Reflect.apply(native, this, args);
      if (String(args[0]).startsWith('webgl')) contexts.add(context);
      return context;
    } as typeof native;
    document.addEventListener('render', () => performance.mark('picture'), { capture: true, once: true });
    document.addEventListener('load', () => performance.mark('whole'), { capture: true });
  });
  // With this, nothing is known of the volume before it has come.
  await open(page, view(`src="${server.url}" transfer-function="0 #000 0%, 255 #fff 50%"`));
  await settle(page);
  const contexts = await page.evaluate(() => (globalThis as unknown as { contexts: Set<unknown> }).contexts.size);
  // Two look at the device.
  expect(contexts).toBeLessThanOrEqual(3);
  const at = (name: string): Promise<number> =>
    page.evaluate((mark) => performance.getEntriesByName(mark).at(-1)!.startTime, name);
  expect(await at('picture')).toBeLessThan(await at('whole'));
});

test('an OME-Zarr in a ZIP archive is read by parts of it', async ({ page }) => {
  const parts = [...pyramidFiles({ ...pyramid, ...shards })].map(([path, packed]) => ({
    path,
    packed,
    crc: crc32(packed),
  }));
  const server = await start(new Map([['', zipBytes(parts)]]), {}, 'brain.ozx');
  await open(page, view(`src="${server.url}"`));
  await settle(page);
  expect(await withElement(page, ({ volume }) => [volume!.dimensions, volume!.source!.kind])).toEqual([
    [28, 20, 24],
    'archive',
  ]);
});

test('no packing needs WebAssembly, which the policy of the page forbids', async ({ page }) => {
  const { cases } = JSON.parse(readFileSync('test/fixtures/zarr-fixtures.json', 'utf8')) as {
    cases: Record<string, { files: Record<string, string> }>;
  };
  await open(page, view(''), {
    head: `<meta http-equiv="Content-Security-Policy" content="default-src 'self'; connect-src *; style-src 'self' 'unsafe-inline'">`,
  });
  for (const name of ['v2 blosc lz4 bytes', 'v2 blosc zstd bits', 'v3 zstd', 'v3 shards blosc']) {
    const files = new Map(
      Object.entries(cases[name].files).map(([path, text]) => [path, new Uint8Array(Buffer.from(text, 'base64'))]),
    );
    const { url } = await start(files);
    const range = await withElement(
      page,
      async (one, src) => {
        one.src = src;
        await one.whenRendered();
        return one.volume!.range;
      },
      { argument: url },
    );
    expect(range[1] - range[0], name).toBeGreaterThan(10);
  }
});

test('a view that leaves the page asks for nothing any more', async ({ page }) => {
  const server = await start(pyramidFiles({ shape: [40, 40, 40] }), { slowMs: 100 });
  await open(page, view(`src="${server.url}"`));
  await expect.poll(() => server.asked.length).toBeGreaterThan(10);
  await withElement(page, (one) => one.remove());
  const { length } = server.asked;
  await expect.poll(() => server.running()).toBe(0);
  await page.waitForTimeout(300);
  // What was on its way may have come.
  expect(server.asked.length).toBeLessThanOrEqual(length + 8);
  expect(length).toBeLessThan(900);
});

test('its channels are shown in their colours, or one of them, or some, as the address says', async ({ page }) => {
  const channels = ['0000FF', 'FF0000', '00FF00'].map((color, c) => ({
    color,
    active: c < 2,
    label: ['<b>DNA</b>', 'actin', 'off'][c],
    window: { start: 0, end: 100, min: 0, max: 65_535 },
  }));
  // Blue light where x of the file is small, red where it is large; x of the file runs to the left, seen from behind here.
  const valueAt = ({ x, c }: { x: number; c: number }): number => (c === 2 || x < 4 === (c === 0) ? 100 : 0);
  const server = await start(
    pyramidFiles({
      axes: 'czyx',
      shape: [3, 8, 8, 8],
      valueAt,
      unit: 'millimeter',
      attributes: { omero: { channels } },
    }),
  );
  await open(
    page,
    view(`src="${server.url}" camera-orbit="180deg 90deg auto"`) +
      '<volume-legend for="v"></volume-legend><volume-readout for="v"></volume-readout><volume-slice-view id="s" for="v" style="width: 60px"></volume-slice-view>',
  );
  await settle(page);
  const look = (): Promise<unknown> =>
    withElement(page, ({ volume }) => [
      volume!.channels?.map(({ number }) => number) ?? null,
      volume!.left,
      volume!.range,
    ]);
  expect(await look()).toMatchObject([[1, 2], [expect.stringContaining('1 of 3 channels')], [1, 1]]);
  const picked = await withElement(page, async (one) => [await one.pick(15, 22), await one.pick(45, 22)]);
  expect(picked.map((one) => one!.layers)).toEqual(
    [100, 0].map((red) => [
      { name: '<b>DNA</b>', value: 100 - red, unit: '', channel: 1 },
      { name: 'actin', value: red, unit: '', channel: 2 },
    ]),
  );
  expect(picked.map((one) => one!.color)).toEqual(['#ff0000', '#0000ff']);
  await expect(page.locator('volume-legend')).toContainText('<b>DNA</b>');
  await expect(page.locator('volume-readout')).toContainText('actin');
  await expect(page.locator('volume-slice-view')).toContainText('actin');
  for (const [hash, numbers] of [
    ['#channels=3,1', [3, 1]],
    ['#channel=2', null],
  ] as const) {
    await withElement(
      page,
      async (one, wanted) => {
        one.src = one.src!.replace(/#.*|$/, wanted);
        await one.whenRendered();
      },
      { argument: hash },
    );
    expect(await look()).toMatchObject([numbers, expect.anything(), expect.anything()]);
  }
});

test('its times are scans', async ({ page }) => {
  const server = await start(
    pyramidFiles({ axes: 'tzyx', shape: [3, 8, 8, 8], timeUnit: 'second', scale: [2, 1, 1, 1] }),
  );
  await open(page, view(`src="${server.url}" time="2 s"`));
  await settle(page);
  expect(await withElement(page, (one) => [one.times, one.scan])).toEqual([
    ['0 s', '2 s', '4 s'],
    { index: 1, time: '2 s', count: 3 },
  ]);
  await withElement(page, async (one) => {
    one.next();
    await one.whenRendered();
  });
  expect(await withElement(page, (one) => one.scan!.index)).toBe(2);
});

test('a region is read finer than the whole', async ({ page }) => {
  // A device that holds little.
  await page.addInitScript(() => Object.defineProperty(navigator, 'deviceMemory', { value: 8 / 2 ** 20 }));
  const server = await start(pyramidFiles({ ...pyramid, shape: [32, 32, 32] }));
  await open(page, view(`src="${server.url}"`));
  await settle(page);
  const shown = (): Promise<unknown> => withElement(page, ({ volume }) => [volume!.dimensions, volume!.reduced?.from]);
  const [all] = (await shown()) as [number[]];
  expect(Math.max(...all)).toBeLessThan(32);
  await withElement(page, async (one) => {
    one.region = [-15, -15, 8, -8, -8, 15];
    await one.whenRendered();
  });
  expect(await shown()).toEqual([[8, 8, 8], undefined]);
});

for (const kind of ['folder', '.ozx'])
  test(`a region of a chosen ${kind} is read finer than the whole`, async ({ page }, info) => {
    const files = pyramidFiles({ ...pyramid, shape: [32, 32, 32] });
    const stored = [...files].map(([path, packed]) => ({ path, packed, crc: crc32(packed) }));
    const written: ZarrFiles = kind === 'folder' ? files : new Map([['cells.ozx', zipBytes(stored)]]);
    for (const [path, bytes] of written) {
      const target = info.outputPath('cells', path);
      mkdirSync(dirname(target), { recursive: true });
      writeFileSync(target, bytes);
    }
    const input = `<label>Cells <input type="file" ${kind === 'folder' ? 'webkitdirectory' : ''}></label>`;
    await open(page, view('max-bytes="9000"') + input);
    await page.setInputFiles('input', info.outputPath('cells', kind === 'folder' ? '' : 'cells.ozx'));
    const show = (region: readonly [number, number, number, number, number, number] | null): Promise<unknown> =>
      withElement(
        page,
        async (one, argument) => {
          one.files ??= document.querySelector('input')!.files!;
          one.region = argument;
          await one.whenRendered();
          return [one.volume!.dimensions, one.volume!.reduced?.from];
        },
        { argument: region },
      );
    expect(await show(null)).toEqual([
      [16, 16, 16],
      [32, 32, 32],
    ]);
    expect(await show([-15, -15, 8, -8, -8, 15])).toEqual([[8, 8, 8], undefined]);
    expect(await show([-31, -31, 0, -24, -24, 7])).toEqual([[8, 8, 8], undefined]);
  });

test('its labels are those of <volume-labels>, with their colours', async ({ page }) => {
  const files = pyramidFiles(pyramid);
  const labels = pyramidFiles({
    ...pyramid,
    type: 'uint8',
    valueAt: ({ x }) => (x > 14 ? 7 : 2),
    attributes: {
      'image-label': {
        colors: [{ 'label-value': 7, rgba: [255, 0, 0, 255] }],
        properties: [{ 'label-value': 7, name: 'cortex' }],
      },
    },
  });
  for (const [path, bytes] of labels) files.set(`labels/cells/${path}`, bytes);
  const server = await start(files);
  await open(
    page,
    view(`src="${server.url}"`, `<volume-labels id="l" src="${server.url}/labels/cells"></volume-labels>`),
  );
  await settle(page);
  const found = await page.evaluate(
    () => (document.querySelector('volume-labels') as unknown as { labels: readonly unknown[] }).labels,
  );
  expect(found).toMatchObject(expect.arrayContaining([expect.objectContaining({ id: 7, name: 'cortex' })]));
  // Of a region only its chunks are read, of the labels as of the volume, and the labels are at their place.
  const chunks = (): number => server.asked.filter((path) => /labels\/cells\/\d\/\d/.test(path)).length;
  const before = chunks();
  await withElement(page, async (one) => {
    one.region = [-13, -15, 8, -6, -8, 15];
    await one.whenRendered();
  });
  expect(chunks() - before).toBeGreaterThan(0);
  expect(chunks() - before).toBeLessThanOrEqual(64); // Of 210.
  // The cortex begins at x = 15 of the file.
  const seen = await page.evaluate(() =>
    (document.querySelector('volume-labels') as unknown as { labels: readonly { id: number }[] }).labels.map(
      ({ id }) => id,
    ),
  );
  expect(seen).toEqual([0, 2]);
});

test('what is no Zarr is refused in words', async ({ page }) => {
  const server = await start(new Map());
  await open(page, view(`src="${server.url}"`));
  const { detail } = await waitForEvent(page, 'error');
  expect(detail).toMatchObject({
    code: 'format/unsupported',
    message: expect.stringContaining('is no Zarr') as unknown as string,
  });
});
