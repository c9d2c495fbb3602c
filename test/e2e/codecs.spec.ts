// Large libraries that read few files: where they are loaded from, and what a page does that does not allow WebAssembly.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { ctSlice, dicomBytes } from '../helpers/dicom-bytes.ts';
import type { DicomFields } from '../helpers/dicom-bytes.ts';
import { j2kStreams } from '../helpers/j2k-streams.ts';
import { jpegStreams } from '../helpers/jpeg-streams.ts';
import { expect, open, settle, test, withElement } from './helpers/harness.ts';

/** A file of four frames that a library unpacks. */
interface PackedFile {
  readonly name: string;
  /** As the names of its scripts begin. */
  readonly library: string;
  /** The scripts of the library that are loaded where the policy allows no WebAssembly. */
  readonly withoutWasm: readonly string[];
  readonly body: Buffer;
  readonly range: readonly [number, number];
}

function pack(
  { stream, values }: { readonly stream: string; readonly values: readonly number[] },
  syntax: string,
  size: DicomFields,
): Pick<PackedFile, 'body' | 'range'> {
  const packed = Uint8Array.from(Buffer.from(stream, 'base64'));
  const body = dicomBytes(
    {
      ...ctSlice(0),
      Modality: 'MR',
      RescaleSlope: undefined,
      RescaleIntercept: undefined,
      PixelRepresentation: [0],
      ...size,
      NumberOfFrames: '4',
    },
    { syntax, fragments: [packed, packed, packed, packed] },
  );
  return { body: Buffer.from(body), range: [Math.min(...values), Math.max(...values)] };
}

const deep = { Rows: [9], Columns: [10], BitsAllocated: [16], BitsStored: [16], HighBit: [15] };
const files: readonly PackedFile[] = [
  {
    name: 'JPEG 2000',
    library: 'openjpeg',
    withoutWasm: ['openjpeg-js'],
    ...pack(
      j2kStreams.find(({ name }) => name === 'HTJ2K of 16 bits, lossless')!,
      '1.2.840.10008.1.2.4.201',
      deep,
    ),
  },
  {
    name: 'JPEG-LS',
    library: 'charls',
    withoutWasm: [],
    ...pack(
      jpegStreams.find(({ name }) => name === 'JPEG-LS of 16 bits')!,
      '1.2.840.10008.1.2.4.80',
      deep,
    ),
  },
];
const urlOf = ({ body }: PackedFile): string => `data:application/dicom;base64,${body.toString('base64')}`;
const tag = (src: string): string =>
  `<volume-view src="${src}" alt="Packed" style="width:120px;height:90px"></volume-view>`;

/** The workers of a page, and the scripts that it or they have requested, by the ends of their names. */
function watch(page: Page): { readonly workers: string[]; readonly scripts: string[] } {
  const [workers, scripts]: [string[], string[]] = [[], []];
  page.on('worker', (worker) => workers.push(worker.url()));
  page.context().on('request', (request) => scripts.push(request.url()));
  return { workers, scripts };
}

async function expectValues(page: Page, { range: expected }: PackedFile): Promise<void> {
  await settle(page);
  const { range, format, dimensions } = await withElement(page, ({ volume }) => ({
    range: [...volume!.range],
    format: volume!.format,
    dimensions: [...volume!.dimensions],
  }));
  expect(dimensions).toEqual([10, 9, 4]);
  expect(format).toBe('DICOM, MR');
  expect(range).toEqual(expected);
}

for (const file of files) {
  const { name, library, body } = file;
  test.describe(`${name} in DICOM`, () => {
    test('is read in a worker, which loads the library', async ({ page }) => {
      const { scripts, workers } = watch(page);
      await open(page, tag(urlOf(file)), { script: '<script type="module" src="/dist/volume-view.js"></script>' });
      await expectValues(page, file);
      expect(workers.filter((one) => one.endsWith('/decode-worker.js'))).toHaveLength(1);
      const libraries = scripts.filter((one) => one.includes(library));
      expect(libraries.some((one) => one.includes(`worker-${library}-wasm`))).toBe(true);
      expect(libraries.filter((one) => one.includes('-js-') || !one.includes('worker-'))).toEqual([]);
    });

    test('is read in a worker by the classic script', async ({ page }) => {
      const { workers } = watch(page);
      await open(page, tag(urlOf(file)), { script: '<script src="/dist/volume-view.iife.js"></script>' });
      await expectValues(page, file);
      expect(workers.length).toBeGreaterThan(0);
    });

    test('is read where the policy allows no WebAssembly', async ({ page }) => {
      const { scripts } = watch(page);
      const policy = "default-src 'self'; style-src 'self' 'unsafe-inline'";
      await page.route('**/decode-worker.js', async (route) => {
        const response = await route.fetch();
        await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': policy } });
      });
      await page.route('**/packed.dcm', (route) => route.fulfill({ body, contentType: 'application/dicom' }));
      await open(page, tag('/packed.dcm'), { script: '<script type="module" src="/dist/volume-view.js"></script>' });
      await expectValues(page, file);
      const loaded = scripts.map((one) => /(openjpeg|charls)-(wasm|js)/.exec(one)?.[0]).filter(Boolean);
      expect(loaded).toEqual(file.withoutWasm);
    });
  });
}

test.describe('from disk', () => {
  test.use({ allowedLines: /^error: (Access to fetch at 'file:|Failed to load resource)/ });

  for (const file of files) {
    test(`${file.name} is read in a worker`, async ({ page }, testInfo) => {
      const { workers } = watch(page);
      const script = pathToFileURL(join(projectRoot, 'dist/volume-view.iife.js')).href;
      const path = testInfo.outputPath('page.html');
      writeFileSync(
        path,
        `<!doctype html><title>From disk</title><script src="${script}"></script>${tag(urlOf(file))}`,
      );
      await page.goto(pathToFileURL(path).href);
      await expectValues(page, file);
      // Each worker's text has more readers than the one before; the last one has the library.
      expect(workers.every((one) => one.startsWith('blob:'))).toBe(true);
      expect(workers).toHaveLength(3);
    });
  }
});
