// A file of several volumes: its scans, its times, and which bytes of it are fetched.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { gzipSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { expect, fieldUrl, keptTest as test, open, withElement } from './helpers/harness.ts';
import { ctSlice, dicomBytes } from '../helpers/dicom-bytes.ts';
import { expectShown } from './helpers/scans.ts';

const functional = readFileSync(new URL('../../demos/data/functional.nii', import.meta.url));
const look = 'value-window="3000 5000" style="width: 200px; height: 150px"';

/** The same volumes again and again: 2,000 times, 4 MB. */
const long = Buffer.concat([
  functional.subarray(0, 352),
  ...Array.from({ length: 100 }, () => functional.subarray(352)),
]);
long.writeInt16LE(2000, 48);

/** Serves the file as a whole, packed or not; returns how often it was asked for. */
async function serve(page: Page, name: string): Promise<string[]> {
  const asked: string[] = [];
  const body = name.endsWith('.gz') ? gzipSync(functional) : functional;
  await page.route(`**/${name}`, async (route) => {
    asked.push(route.request().headers().range ?? '');
    await route.fulfill({ body, contentType: 'application/octet-stream' });
  });
  return asked;
}

/** A server of another origin that sends parts, and says so. */
async function startServer(): Promise<{ readonly url: string; readonly asked: string[]; close: () => void }> {
  const asked: string[] = [];
  const server = createServer(({ headers: { range = '' } }, response) => {
    asked.push(range);
    const [, start, end] = /bytes=(\d+)-(\d+)/.exec(range)?.map(Number) ?? [0, 0, long.length - 1];
    const part = long.subarray(start, end + 1);
    response.writeHead(range ? 206 : 200, {
      'content-length': part.length,
      'accept-ranges': 'bytes',
      'access-control-allow-origin': '*',
      'access-control-expose-headers': 'accept-ranges',
      ...(range && { 'content-range': `bytes ${start}-${end}/${long.length}` }),
    });
    response.end(part);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return { url: `http://127.0.0.1:${port}/ranges.nii`, asked, close: () => server.close() };
}

const formatOf = (page: Page): Promise<string | undefined> => withElement(page, (element) => element.volume?.format);

test.describe('a NIfTI file of several times', () => {
  for (const name of ['packed.nii.gz', 'plain.nii']) {
    test(`${name} is fetched once; its volumes are scans`, async ({ page }) => {
      const asked = await serve(page, name);
      await open(
        page,
        `<volume-view src="/${name}" ${look} time="8 s" alt="Scans"></volume-view><volume-timeline></volume-timeline>`,
      );
      await expectShown(page, 4);
      expect(await withElement(page, (element) => element.times.slice(0, 3))).toEqual(['0 s', '2 s', '4 s']);
      expect(await formatOf(page)).toBe('NIfTI-1, volume 5 of 20');
      await expect(page.locator('volume-timeline').locator('.clock')).toHaveText('8 s');
      await expect(page.getByRole('slider', { name: 'Scan' })).toHaveAttribute('aria-valuetext', '8 s, scan 5 of 20');
      for (const index of [19, 0, 5]) {
        await withElement(page, (element, at) => element.showScan(at), { argument: index });
        await expectShown(page, index);
        expect(await formatOf(page)).toBe(`NIfTI-1, volume ${index + 1} of 20`);
      }
      expect(asked).toEqual(['']);
    });
  }

  test('is fetched in ranges from a server that has them', async ({ page }) => {
    const { url, asked, close } = await startServer();
    try {
      await open(page, `<volume-view src="${url}" ${look} alt="Scans"></volume-view>`);
      await expectShown(page, 0);
      await withElement(page, (element) => element.showScan(1999));
      await expectShown(page, 1999);
      expect(await formatOf(page)).toBe('NIfTI-1, volume 2000 of 2000');
      expect(asked.filter((range) => range === '').length).toBe(1);
      expect(asked).toContain(`bytes=${352 + 1999 * 2142}-${352 + 2000 * 2142 - 1}`);
    } finally {
      close();
    }
  });

  test('has a time that is none of its own refused in words', async ({ page }) => {
    await serve(page, 'plain.nii');
    await open(page, `<volume-view src="/plain.nii" ${look} time="12 Hz" alt="Scans"></volume-view>`);
    await expect(page.getByText('time got "12 Hz"')).toBeVisible();
  });
});

test('a DICOM series of three times, chosen by a reader, is three scans with a curve', async ({ page }) => {
  const mr = { Modality: 'MR', RescaleIntercept: undefined, RescaleSlope: undefined };
  // More than are sent to a worker at once.
  const files = Array.from({ length: 18 }, (_, k) => k).flatMap((k) =>
    [0, 1, 2].map((t) =>
      dicomBytes(ctSlice(5 * k, { ...mr, TriggerTime: String(50 * t) }, 100 + 100 * t + 10 * k)).toString(),
    ),
  );
  await open(
    page,
    `<volume-view src="${fieldUrl}" ${look} alt="Scans"></volume-view><volume-timeline></volume-timeline><volume-readout curve></volume-readout>`,
  );
  await withElement(
    page,
    (element, given) => {
      const all = given.map((text, i) => new File([Uint8Array.from(text.split(','), Number)], `${i}.dcm`));
      element.files = all as never;
    },
    { argument: files },
  );
  await expect.poll(() => formatOf(page)).toBe('DICOM, MR, volume 1 of 3');
  await expect(page.locator('volume-timeline')).toContainText('1 / 3');
  expect(await withElement(page, (element) => element.volume!.range)).toEqual([100, 281]);
  await withElement(page, (element) => element.setAttribute('time', '0.1 s'));
  await expect.poll(() => formatOf(page)).toBe('DICOM, MR, volume 3 of 3');
  await expect(page.locator('volume-timeline')).toContainText('3 / 3');
  expect(await withElement(page, (element) => element.volume!.range)).toEqual([300, 481]);
});
