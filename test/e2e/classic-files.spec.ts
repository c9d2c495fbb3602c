// The classic script with only the files that the guide names (docs/guide/browsers.md): it asks for no other, in each way that the guide has.
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { ctSlice, dicomBytes } from '../helpers/dicom-bytes.ts';
import { jpegStreams } from '../helpers/jpeg-streams.ts';
import { ballUrl, expect, fewPixels, open, settle, test, withElement } from './helpers/harness.ts';

test.use(fewPixels);

const dist = join(projectRoot, 'dist');
const isDocumented = (path: string): boolean =>
  /\/dist\/(?:page\.html|volume-view\.iife\.js|volume-view\.css|x3dom\.js|classic\/[^/]+)$/.test(path);

/** Files of which the usual worker, the one with all readers, and the one with libraries read one each. */
const packed = Uint8Array.from(
  Buffer.from(jpegStreams.find(({ name }) => name === 'JPEG-LS of 16 bits')!.stream, 'base64'),
);
const ball = readFileSync(join(projectRoot, ballUrl));
/** Its first slices alone: the worker for NIfTI does not have what suggests the looks of a single slice. */
const slice = Buffer.from(ball);
slice.writeInt16LE(1, 46); // dim[3]
const data = {
  'ball.nii': ball,
  'slice.nii': slice,
  'scan.h5': readFileSync(join(projectRoot, 'test/fixtures/radar/odim-2.3.h5')),
  'packed.dcm': Buffer.from(
    dicomBytes(
      {
        ...ctSlice(0),
        Modality: 'MR',
        RescaleSlope: undefined,
        RescaleIntercept: undefined,
        PixelRepresentation: [0],
        Rows: [9],
        Columns: [10],
        BitsAllocated: [16],
        BitsStored: [16],
        HighBit: [15],
        NumberOfFrames: '4',
      },
      { syntax: '1.2.840.10008.1.2.4.80', fragments: [packed, packed, packed, packed] },
    ),
  ),
};
const names = Object.keys(data) as (keyof typeof data)[];
const urlOf = (name: keyof typeof data): string =>
  `data:application/octet-stream;base64,${data[name].toString('base64')}`;

interface Watched {
  readonly workers: string[];
  /** Requests that got no good answer. */
  readonly failed: string[];
}

/** Serve the documented files of the package alone, and watch what is asked for. */
async function watch(page: Page): Promise<Watched> {
  const watched: Watched = { workers: [], failed: [] };
  page.on('worker', (worker) => watched.workers.push(worker.url()));
  page.on('requestfailed', (request) => watched.failed.push(request.url()));
  page.on('response', (response) => {
    if (response.status() >= 400) watched.failed.push(response.url());
  });
  await page.route(/^http.*\/dist\//, (route) =>
    isDocumented(new URL(route.request().url()).pathname) ? route.continue() : route.fulfill({ status: 404 }),
  );
  await page.route('**/files/*', (route) =>
    route.fulfill({ body: data[new URL(route.request().url()).pathname.split('/').at(-1) as keyof typeof data] }),
  );
  return watched;
}

const tag = (src: string): string =>
  `<volume-view src="${src}" alt="A file" style="width:120px;height:90px"></volume-view>`;

/** Show all files, one after another. */
async function showAll(page: Page, urls: readonly string[]): Promise<void> {
  for (const url of urls) {
    await withElement(page, (element, src) => void (element.src = src), { argument: url });
    await settle(page);
    expect(await withElement(page, ({ volume }) => volume !== null)).toBe(true);
    await expect(page.getByRole('alert')).toHaveCount(0);
  }
}

test('from a server: workers from its files', async ({ page }) => {
  const { workers, failed } = await watch(page);
  await open(page, tag('/files/ball.nii'), { script: '<script src="/dist/volume-view.iife.js"></script>' });
  await showAll(
    page,
    names.map((name) => `/files/${name}`),
  );
  expect(failed).toEqual([]);
  expect(workers.length).toBeGreaterThanOrEqual(3);
  for (const url of workers) expect(new URL(url).pathname).toMatch(/^\/dist\/classic\/\d+-[0-9a-f]{8}\.js$/);
});

test('written into a page, with the other files next to the page', async ({ page }) => {
  const { workers, failed } = await watch(page);
  const text = readFileSync(join(dist, 'volume-view.iife.js'), 'utf8');
  await open(page, tag('/files/ball.nii'), { script: `<script>${text}</script>`, path: '/dist/page.html' });
  await showAll(
    page,
    names.map((name) => `/files/${name}`),
  );
  expect(failed).toEqual([]);
  for (const url of workers) expect(new URL(url).pathname).toMatch(/^\/dist\/classic\//);
});

test('from another server: workers from texts', async ({ page }) => {
  const { workers, failed } = await watch(page);
  const script = `<script src="${process.env.VOLUME_VIEW_CROSS_URL}/cors/dist/volume-view.iife.js"></script>`;
  await open(page, tag('/files/ball.nii'), { script });
  await showAll(
    page,
    names.map((name) => `/files/${name}`),
  );
  expect(failed).toEqual([]);
  for (const url of workers) expect(url).toMatch(/^blob:/);
});

test('from disk, and in a frame without an origin', async ({ page }, testInfo) => {
  const { workers, failed } = await watch(page);
  const folder = testInfo.outputPath('site');
  for (const name of ['volume-view.iife.js', 'x3dom.js', 'classic'])
    cpSync(join(dist, name), join(folder, 'dist', name), { recursive: true });
  writeFileSync(
    join(folder, 'page.html'),
    `<!doctype html><title>From disk</title><script src="dist/volume-view.iife.js"></script>${tag(urlOf('ball.nii'))}`,
  );
  await page.goto(pathToFileURL(join(folder, 'page.html')).href);
  await showAll(page, names.map(urlOf));
  expect(failed).toEqual([]);
  expect(workers.length).toBeGreaterThanOrEqual(3);
  for (const url of workers.splice(0)) expect(url).toMatch(/^blob:/);

  const inner = `<!doctype html><title>Inner</title><script src="${process.env.VOLUME_VIEW_URL}/dist/volume-view.iife.js"></script>${tag(urlOf('scan.h5'))}`;
  await open(page, `<iframe sandbox="allow-scripts" title="x" srcdoc="${inner.replaceAll('"', '&quot;')}"></iframe>`, {
    script: '',
  });
  const view = page.frameLocator('iframe').locator('volume-view');
  await view.evaluate((element) => (element as HTMLElementTagNameMap['volume-view']).whenRendered());
  expect(await view.evaluate((element) => (element as HTMLElementTagNameMap['volume-view']).volume?.format)).toMatch(
    /ODIM/,
  );
  expect(failed).toEqual([]);
});
