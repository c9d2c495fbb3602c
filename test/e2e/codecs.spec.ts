// Large libraries that read few files: where they are loaded from, and what a page does that does not allow WebAssembly.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { ctSlice, dicomBytes } from '../helpers/dicom-bytes.ts';
import { j2kStreams } from '../helpers/j2k-streams.ts';
import { expect, open, settle, test, withElement } from './helpers/harness.ts';

const ht = j2kStreams.find(({ name }) => name === 'HTJ2K of 16 bits, lossless')!;
const packed = Uint8Array.from(Buffer.from(ht.stream, 'base64'));
const file = Buffer.from(
  dicomBytes(
    {
      ...ctSlice(0),
      Modality: 'MR',
      RescaleSlope: undefined,
      RescaleIntercept: undefined,
      Rows: [9],
      Columns: [10],
      BitsStored: [16],
      HighBit: [15],
      NumberOfFrames: '4',
    },
    { syntax: '1.2.840.10008.1.2.4.201', fragments: [packed, packed, packed, packed] },
  ),
);
const url = `data:application/dicom;base64,${file.toString('base64')}`;
const tag = (src: string): string =>
  `<volume-view src="${src}" alt="Packed" style="width:120px;height:90px"></volume-view>`;

/** The workers of a page, and the scripts that it or they have requested, by the ends of their names. */
function watch(page: Page): { readonly workers: string[]; readonly scripts: string[] } {
  const [workers, scripts]: [string[], string[]] = [[], []];
  page.on('worker', (worker) => workers.push(worker.url()));
  page.context().on('request', (request) => scripts.push(request.url()));
  return { workers, scripts };
}

async function expectValues(page: Page): Promise<void> {
  await settle(page);
  const { range, format, dimensions } = await withElement(page, ({ volume }) => ({
    range: [...volume!.range],
    format: volume!.format,
    dimensions: [...volume!.dimensions],
  }));
  expect(dimensions).toEqual([10, 9, 4]);
  expect(format).toBe('DICOM, MR');
  expect(range).toEqual([Math.min(...ht.values), Math.max(...ht.values)]);
}

test.describe('JPEG 2000 in DICOM', () => {
  test('is read in a worker, which loads the library', async ({ page }) => {
    const { scripts, workers } = watch(page);
    await open(page, tag(url), { script: '<script type="module" src="/dist/volume-view.js"></script>' });
    await expectValues(page);
    expect(workers.filter((one) => one.endsWith('/decode-worker.js'))).toHaveLength(1);
    const libraries = scripts.filter((one) => one.includes('openjpeg'));
    expect(libraries.some((one) => one.includes('worker-openjpeg-wasm'))).toBe(true);
    expect(libraries.filter((one) => one.includes('openjpeg-js') || !one.includes('worker-'))).toEqual([]);
  });

  test('is read in a worker by the classic script', async ({ page }) => {
    const { workers } = watch(page);
    await open(page, tag(url), { script: '<script src="/dist/volume-view.iife.js"></script>' });
    await expectValues(page);
    expect(workers.length).toBeGreaterThan(0);
  });

  test('is read where the policy allows no WebAssembly', async ({ page }) => {
    const { scripts } = watch(page);
    const policy = "default-src 'self'; style-src 'self' 'unsafe-inline'";
    await page.route('**/decode-worker.js', async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': policy } });
    });
    await page.route('**/packed.dcm', (route) => route.fulfill({ body: file, contentType: 'application/dicom' }));
    await open(page, tag('/packed.dcm'), { script: '<script type="module" src="/dist/volume-view.js"></script>' });
    await expectValues(page);
    expect(scripts.filter((one) => /openjpeg-(wasm|js)/.test(one)).map((one) => /openjpeg-\w+/.exec(one)![0])).toEqual([
      'openjpeg-js',
    ]);
  });
});

test.describe('from disk', () => {
  test.use({ allowedLines: /^error: (Access to fetch at 'file:|Failed to load resource)/ });

  test('JPEG 2000 is read in a worker', async ({ page }, testInfo) => {
    const { workers } = watch(page);
    const script = pathToFileURL(join(projectRoot, 'dist/volume-view.iife.js')).href;
    const path = testInfo.outputPath('page.html');
    writeFileSync(path, `<!doctype html><title>From disk</title><script src="${script}"></script>${tag(url)}`);
    await page.goto(pathToFileURL(path).href);
    await expectValues(page);
    // Each worker's text has more readers than the one before; the last one has the library.
    expect(workers.every((one) => one.startsWith('blob:'))).toBe(true);
    expect(workers).toHaveLength(3);
  });
});
