// projection="max | min | average": by attribute and property, in either WebGL, and back.
import {
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  open,
  setAttributes,
  settle,
  takePicture,
  keptTest as test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

for (const kind of ['max', 'average'] as const) {
  test(`${kind} gives the reference's picture from the start, and goes away`, async ({ page }) => {
    await open(page, plain.replace('<volume-view', `<volume-view projection="${kind}"`));
    expectSamePicture(await takePicture(page), drawReference({ projection: kind }));
    expect(await withElement(page, (element) => element.optics!.projection)).toBe(kind);
    await setAttributes(page, { projection: null });
    expectSamePicture(await takePicture(page), drawReference());
  });
}

test('the last of several in a row holds, with the colours that came with it', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  await withElement(page, async (element) => {
    for (const kind of ['max', null, 'min', 'average', 'max'] as const) {
      element.projection = kind;
      await element.updateComplete;
    }
    element.steps = 61;
    await element.whenRendered();
  });
  const inRow = await takePicture(page);
  expectSamePicture(inRow, drawReference({ projection: 'max', steps: 61 }));
  expect(compare(inRow, drawReference()).worst).toBeGreaterThan(20);
});

test('what cannot be read is reported, and leaves the picture', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  await page.locator('volume-view').evaluate((element) => element.setAttribute('projection', 'mip'));
  const { detail } = await waitForEvent(page, 'error');
  expect((detail as { message: string }).message).toBe('projection got "mip"; expected max or min or average.');
});
