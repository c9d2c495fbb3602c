// On paper: the picture as it was on the screen, at its place, with its ground.
import { inflateSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import {
  compare,
  expect,
  fieldUrl,
  open,
  settle,
  takePicture,
  takeScreenshot,
  test,
  withElement,
} from './helpers/harness.ts';
import type { Picture } from './helpers/pictures.ts';
import { attributesOf } from './helpers/reference.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

/** The pictures of a PDF file as Chromium writes it: colours, and their alpha as a picture that follows. */
function readPictures(pdf: Buffer): Picture[] {
  const text = pdf.toString('latin1');
  const planes = [
    ...text.matchAll(
      /<<[^>]*\/Subtype \/Image\s[^>]*?\/Width (\d+)\s*\/Height (\d+)[^>]*?\/Length (\d+)>>\s*stream\r?\n/g,
    ),
  ].map(({ 0: head, 1: width, 2: height, 3: size, index }) => {
    const from = index + head.length;
    return {
      width: Number(width),
      height: Number(height),
      bytes: inflateSync(pdf.subarray(from, from + Number(size))),
    };
  });
  return planes.flatMap(({ width, height, bytes }, i) => {
    if (bytes.length !== width * height * 3) return [];
    const data = new Float64Array(width * height * 4).map((_, at) => {
      const [pixel, channel] = [Math.floor(at / 4), at % 4];
      const alpha = planes[i + 1].bytes[pixel];
      return channel === 3 ? alpha : (bytes[pixel * 3 + channel] * alpha) / 255;
    });
    return [{ width, height, data }];
  });
}

/** What stands on paper. A canvas of a scene that is not in use yet is transparent. */
const print = async (page: Page): Promise<Picture[]> =>
  readPictures(await page.pdf({ format: 'A4' })).filter(({ data }) => data.some((x) => x > 0));

test('the picture is printed', async ({ page }) => {
  await open(page, `<h1>A page</h1>${plain}`);
  await settle(page);
  const seen = await takePicture(page);
  const [printed, ...more] = await print(page);
  expect(more).toEqual([]);
  expect(compare(printed, seen).worst).toBeLessThanOrEqual(2);
});

test('so is the snapshot of an element that has given its context back', async ({ page }) => {
  const many = Array.from({ length: 10 }, (_, i) => plain.replace('<volume-view', `<volume-view id="one-${i}"`)).join(
    '',
  );
  await open(page, `<div style="display: grid; grid-template-columns: repeat(4, 120px)">${many}</div>`);
  for (let i = 0; i < 10; i++) await settle(page, `#one-${i}`);
  const seen = await takePicture(page, { selector: '#one-0' });
  const printed = await print(page);
  expect(printed.length).toBe(10);
  for (const picture of printed) expect(compare(picture, seen).worst).toBeLessThanOrEqual(2);
});

test('it stands at its place, on its ground, without the frame of the focus', async ({ page }) => {
  await open(page, `<h1>A page</h1>${plain}<p>Words</p>`);
  await settle(page);
  const before = await takeScreenshot(page);
  const place = await page.locator('volume-view').boundingBox();
  await page.keyboard.press('Tab');
  expect(compare(await takeScreenshot(page), before).worst).toBeGreaterThan(100);
  await page.emulateMedia({ media: 'print' });
  expect(await page.locator('volume-view').boundingBox()).toEqual(place);
  expect(compare(await takeScreenshot(page), before).worst).toBeLessThanOrEqual(2);
  expect(await withElement(page, (element) => getComputedStyle(element).getPropertyValue('print-color-adjust'))).toBe(
    'exact',
  );
});
