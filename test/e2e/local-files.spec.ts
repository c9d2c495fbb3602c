// Files of the reader's disk, and archives: what a page shows of them, and what it says where it can't.
import { zipSync } from 'fflate';
import type { Page } from '@playwright/test';
import { files } from './helpers/data.ts';
import { plain } from './helpers/green-shape.ts';
import {
  expect,
  expectSamePicture,
  fieldUrl,
  forgetEvents,
  open,
  seenEvents,
  settle,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { ball } from './helpers/volumes.ts';

const field = new Uint8Array(files['field.nii']);
const readme = new TextEncoder().encode('Measured on a Monday.\n');
const archive = Buffer.from(zipSync({ 'study/field.nii': field, 'study/README.txt': readme }));
const asUrl = (bytes: Buffer): string => `data:application/zip;base64,${bytes.toString('base64')}`;
const fileOf = (name: string, buffer: Buffer): { name: string; mimeType: string; buffer: Buffer } => ({
  name,
  mimeType: 'application/octet-stream',
  buffer,
});

const empty = `<input type="file" multiple>${plain.replace(/src="[^"]*"/, '')}`;

/** Choose files by hand, as far as a test can, and give them to the element. */
async function choose(page: Page, chosen: readonly ReturnType<typeof fileOf>[]): Promise<void> {
  await page.setInputFiles('input', [...chosen]);
  await withElement(page, (element) => {
    const input = document.querySelector('input')!;
    element.files = input.files;
    input.value = ''; // The element does not depend on what the input holds later.
  });
}

test.describe('src with an archive', () => {
  for (const [what, script] of [
    ['', undefined],
    [', with the classic script', '<script src="/dist/volume-view.iife.js"></script>'],
  ] as const) {
    test(`shows the volume that it holds${what}`, async ({ page }) => {
      await open(page, plain.replace(fieldUrl, asUrl(archive)), { script });
      expectSamePicture(await takePicture(page), drawReference());
      const [{ detail }] = (await seenEvents(page)).filter(({ type }) => type === 'load');
      expect(detail).toMatchObject({ dimensions: [24, 20, 16], format: 'NIfTI-1' });
    });
  }

  test('that holds two shows the larger one, lists both, and shows the other one on demand', async ({ page }) => {
    await open(page, `${plain.replace(fieldUrl, '/test/fixtures/zip/two.zip')}<volume-series></volume-series>`);
    await settle(page);
    const rows = page.getByRole('radio');
    await expect(rows).toHaveCount(2);
    await expect(rows.nth(0)).toBeChecked();
    await expect(page.locator('volume-series [part=row]').nth(1)).toContainText(/NIfTI.*0\.195 kB/s);
    await rows.nth(1).check();
    await expect
      .poll(() =>
        withElement(page, (element) => [element.series, element.volume?.series?.find(({ shown }) => shown)?.number]),
      )
      .toEqual([2, 2]);
    expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('error');
  });

  test('of an encrypted volume says so', async ({ page }) => {
    await open(page, plain.replace(fieldUrl, '/test/fixtures/zip/encrypted.zip'));
    const { detail } = await waitForEvent(page, 'error');
    expect(detail).toMatchObject({ code: 'format/unsupported' });
    expect((detail as Error).message).toContain('is encrypted');
  });
});

test.describe('view.files', () => {
  test('shows a file of the disk, without src, and lets src come back', async ({ page }) => {
    await open(page, empty);
    await choose(page, [fileOf('Häuser 1.nii', Buffer.from(field))]);
    expectSamePicture(await takePicture(page), drawReference());
    expect(
      await withElement(page, (element) => [
        element.files?.length,
        element.files?.[0].name,
        element.src,
        element.getAttribute('src'),
      ]),
    ).toEqual([1, 'Häuser 1.nii', null, null]);
    await withElement(page, (element) => {
      element.files = null;
      element.src = '/test/e2e/pages/data/ball.nii';
    });
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('error');
  });

  test('goes before src, and each choice is loaded', async ({ page }) => {
    await open(page, `<input type="file" multiple>${plain}`);
    await settle(page);
    await forgetEvents(page);
    await choose(page, [fileOf('a.nii', Buffer.from(files['ball.nii']))]);
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    await choose(page, [fileOf('a.nii', Buffer.from(field))]);
    expectSamePicture(await takePicture(page), drawReference());
    expect((await seenEvents(page)).filter(({ type }) => type === 'load')).toHaveLength(2);
    await withElement(page, (element) => element.reload());
    await expect.poll(async () => (await seenEvents(page)).filter(({ type }) => type === 'load').length).toBe(3);
  });

  test('takes an archive, and a header with its data', async ({ page }) => {
    await open(page, empty);
    await choose(page, [fileOf('study.zip', archive)]);
    expectSamePicture(await takePicture(page), drawReference());
    const header = Buffer.from(
      'ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = cube.raw\n',
    );
    await forgetEvents(page);
    await choose(page, [fileOf('cube.mhd', header), fileOf('cube.raw', Buffer.from([0, 1, 2, 3, 4, 5, 6, 7]))]);
    const { detail } = await waitForEvent(page, 'load');
    expect(detail).toMatchObject({ dimensions: [2, 2, 2], range: [0, 7] });
  });

  test('that is set before the element is defined is shown when it is', async ({ page }) => {
    await open(page, `<volume-view ${attributesOf()}></volume-view>`, { script: '' });
    await page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      document.querySelector('volume-view')!.files = [new File([bytes], 'field.nii')];
      const script: string = '/dist/volume-view.js';
      await import(script);
    }, Buffer.from(field).toString('base64'));
    expectSamePicture(await takePicture(page), drawReference());
  });

  test('needs no permission of a strict policy', async ({ page }) => {
    await open(page, empty, {
      head: "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'self'; style-src 'self' 'unsafe-inline'\">",
    });
    await choose(page, [fileOf('field.nii', Buffer.from(field))]);
    expectSamePicture(await takePicture(page), drawReference());
  });

  for (const [what, value, code, words] of [
    ['is no list', 5, 'attribute/invalid', 'FileList'],
    ['holds something else', ['field.nii'], 'attribute/invalid', 'FileList'],
  ] as const) {
    test(`that ${what} is an error in words`, async ({ page }) => {
      await open(page, empty);
      await withElement(
        page,
        (element, given) => {
          element.files = given as never;
        },
        { argument: value },
      );
      const { detail } = await waitForEvent(page, 'error');
      expect(detail).toMatchObject({ code });
      expect((detail as Error).message).toContain(words);
    });
  }

  test('of no known type says what was chosen', async ({ page }) => {
    await open(page, empty);
    await choose(page, [fileOf('letter.txt', Buffer.from('Dear Sir'))]);
    const { detail } = await waitForEvent(page, 'error');
    expect(detail).toMatchObject({ code: 'format/unknown' });
    expect((detail as Error).message).toContain('file-1.txt');
    expect((detail as Error).message).not.toContain('letter');
  });

  test('of no files is as if it were not set', async ({ page }) => {
    await open(page, `<input type="file" multiple>${plain}`);
    await choose(page, []);
    expectSamePicture(await takePicture(page), drawReference());
    expect(await withElement(page, (element) => element.files)).toBe(null);
  });
});
