import { measureShare } from '../../scripts/measure-share.mjs';
import { ballUrl, expect, open, setAttributes, settle, takePicture, test, withElement } from './helpers/harness.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import type { Page } from '@playwright/test';

const fixture = '/test/fixtures/radar/odim-2.1.h5';

/** How much of its picture an element fills. */
async function shareOf(page: Page): Promise<NonNullable<ReturnType<typeof measureShare>>> {
  const { data, width, height } = await takePicture(page);
  const alpha = Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + 3]);
  const share = measureShare(alpha, [width, height]);
  expect(share, 'something is seen').not.toBeNull();
  return share!;
}

test.describe('a bare tag', () => {
  for (const [name, size] of Object.entries({
    'a desktop': [200, 150],
    'a phone held upright': [100, 200],
    'a banner': [300, 100],
  })) {
    test(`fills most of the picture on ${name}, and nothing is cut`, async ({ page }) => {
      await open(
        page,
        `<volume-view src="${ballUrl}" style="width: ${size[0]}px; height: ${size[1]}px; aspect-ratio: auto"></volume-view>`,
      );
      await settle(page);
      const { fits, isCut } = await shareOf(page);
      expect(fits).toBeGreaterThan(0.75);
      expect(fits).toBeLessThan(0.9);
      expect(isCut).toBe(false);
    });
  }
});

/** Four bands of one slice: 0, 1000, 2000 and 4000. */
const bands = syntheticVolume({
  dimensions: [32, 24, 1],
  field: (x) => [0, 0.25, 0.5, 1][Math.floor(4 * x)],
  slope: 4000 / 65535,
});
const bandsUrl = `data:application/octet-stream;base64,${Buffer.from(niftiBytes(bands)).toString('base64')}`;

test('a single slice is a picture in gray, from black to white, and nothing shines through', async ({ page }) => {
  await open(page, `<volume-view src="${bandsUrl}" style="width: 200px; height: 150px"></volume-view>`);
  await settle(page);
  const { data, width, height } = await takePicture(page);
  const row = data.subarray(4 * width * Math.floor(height / 2)).subarray(0, 4 * width);
  const seen = Array.from({ length: width }, (_, i) => i).filter((i) => row[4 * i + 3] > 0);
  expect(seen.length).toBeGreaterThan(0.5 * width);
  const pixels = [1, 3, 5, 7].map((eighth) => {
    const at = 4 * seen[Math.floor((eighth * seen.length) / 8)];
    return [...row.subarray(at, at + 4)];
  });
  const grays = pixels.map(([gray]) => gray);
  for (const [i, pixel] of pixels.entries()) expect(pixel).toEqual([grays[i], grays[i], grays[i], 255]);
  // The columns of the volume run to the patient's left: to the right, as patients are looked at from their feet.
  for (const [i, gray] of [0, 63.75, 127.5, 255].entries()) expect(Math.abs(grays[i] - gray)).toBeLessThan(2);
});

test('the camera stays where it is when colours change, and is framed again for another place', async ({ page }) => {
  await open(page, `<volume-view src="${ballUrl}"></volume-view>`);
  await settle(page);
  const before = await shareOf(page);
  await setAttributes(page, { 'value-window': '0 60', 'opacity-factor': '3' });
  await setAttributes(page, { 'value-window': null, 'opacity-factor': null });
  const after = await shareOf(page);
  expect(after).toEqual(before);
  await setAttributes(page, { 'camera-orbit': '30deg 75deg 200%' });
  expect((await shareOf(page)).fits).toBeLessThan(0.6);
  await setAttributes(page, { 'camera-orbit': null });
  expect(await shareOf(page)).toEqual(before);
});

test('a bare radar has rings, north and a ground; none switches them off, and the window follows the scan', async ({
  page,
}) => {
  await open(page, `<volume-view src="${fixture}" style="width: 200px; height: 150px"></volume-view>`);
  await settle(page);
  const labels = page.locator('volume-view .labels span');
  expect((await labels.allTextContents()).at(-1)).toBe('N');
  expect((await labels.allTextContents())[0]).toMatch(/km$/);
  const optics = await withElement(page, (element) => element.optics!);
  expect(optics.window[1]).toBeGreaterThan(optics.window[0]);
  const withGround = await takePicture(page);
  await setAttributes(page, { rings: 'none' });
  expect(await labels.count()).toBe(0);
  const without = await takePicture(page);
  const sum = (data: ArrayLike<number>): number =>
    Array.from(data)
      .filter((_, i) => i % 4 === 3)
      .reduce((total, x) => total + x, 0);
  expect(sum(withGround.data)).toBeGreaterThan(sum(without.data));
  expect(sum(without.data)).toBeGreaterThan(0);
});
