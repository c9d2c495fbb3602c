// What touches nothing of a scan is hidden by an attribute, for the picture and for picks, and shown again without it.
import type { Page } from '@playwright/test';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import {
  compare,
  expect,
  open,
  setAttributes,
  settle,
  size,
  takePicture,
  test,
  withElement,
} from './helpers/harness.ts';

/** A ball, and a plate to its right that is a twentieth of it. World x runs to the left of the picture's voxels: the plate is at low x of the grid. */
const scan = syntheticVolume({
  dimensions: [32, 32, 32],
  kind: 'float32',
  field: (x, y, z) =>
    Math.hypot(x - 0.6, y - 0.5, z - 0.5) < 0.3
      ? 1
      : x < 0.1 && Math.abs(z - 0.5) < 0.1 && Math.abs(y - 0.5) < 0.16
        ? 0.7
        : 0,
});
const src = `data:application/octet-stream;base64,${Buffer.from(niftiBytes(scan)).toString('base64')}`;
const view = `<volume-view src="${src}" transfer-function="0.2 black 0, 0.6 white 60%, 1 white 80%" camera-orbit="0deg 90deg 100%" style="${size}" alt="A ball and a plate"></volume-view>`;

const left = (page: Page): Promise<readonly string[] | undefined> =>
  withElement(page, (element) => element.volume?.left);

/** Pixels across in which something shows, and in how many of them a pick finds something. */
async function lookAcross(page: Page): Promise<{ shown: number[]; picked: number[] }> {
  const { pixels, width } = await takePicture(page).then((picture) => ({ pixels: picture.data, width: picture.width }));
  const row = 4 * width * 45;
  const shown = Array.from({ length: width }, (_, x) => x).filter((x) => pixels[row + 4 * x + 3] > 2);
  const picked = await withElement(page, (element) =>
    Promise.all(Array.from({ length: 120 }, (_, x) => element.pick(x + 0.5, 45.5))).then((picks) =>
      picks.flatMap((pick, x) => (pick ? [x] : [])),
    ),
  );
  return { shown, picked };
}

test('clean hides a plate next to a ball, for eyes and picks', async ({ page }) => {
  await open(page, view);
  await settle(page);
  const whole = await lookAcross(page);
  expect(await left(page)).toBe(undefined);
  await setAttributes(page, { clean: '0.2' });
  await settle(page);
  const cleaned = await lookAcross(page);
  expect(await left(page)).toEqual([
    expect.stringMatching(/^clean hides one part that touches nothing larger: \d+ voxels above 0\.2$/),
  ]);
  const gone = whole.shown.filter((x) => !cleaned.shown.includes(x));
  expect(gone.length).toBeGreaterThan(3);
  expect(cleaned.shown.length).toBeGreaterThan(10);
  expect(whole.picked.filter((x) => gone.includes(x)).length).toBeGreaterThan(3);
  expect(cleaned.picked.filter((x) => gone.includes(x))).toEqual([]);
  await setAttributes(page, { clean: null });
  await settle(page);
  expect((await lookAcross(page)).shown).toEqual(whole.shown);
});

test('a value that is none is reported in the element, and without it the picture is as it was', async ({ page }) => {
  await open(page, view);
  await settle(page);
  const before = await takePicture(page);
  await withElement(page, (element) => element.setAttribute('clean', 'much'));
  await expect(page.getByRole('alert')).toContainText(
    'clean got "much"; expected nothing, or the data value from which on something is shown',
  );
  await setAttributes(page, { clean: null });
  expect(compare(await takePicture(page), before).worst).toBe(0);
});
