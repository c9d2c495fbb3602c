import { compare, expect, open, settle, takeScreenshot, test, withElement } from './helpers/harness.ts';
import type { Page } from '@playwright/test';

const tag = (attributes: string): string =>
  `<volume-view src="/demos/data/mni152-t1.nii.gz" ${attributes} style="width: 400px; height: 320px" alt="A head"></volume-view>`;

/** Turn to a view, and tell what its picture took once it is final. */
function turnTo(page: Page, orbit: string): Promise<{ rays: number; steps: number; rms: number | null; converged: boolean }> {
  return withElement(page, async (element, asked) => {
    element.cameraOrbit = asked;
    await element.updateComplete;
    await element.whenRendered();
    const { rays, steps, error, converged } = element.renderStats!;
    return { rays, steps, rms: error?.rms ?? null, converged };
  }, { argument: orbit });
}

test('a smooth picture at rest gets rays for some of its pixels, keeps max-error, and says so', async ({ page }) => {
  await open(page, tag('max-error="2"'));
  await settle(page);
  // The first picture of all got all its rays, and told where the volume is smooth.
  const stats = await turnTo(page, '40deg 70deg auto');
  expect(stats.converged).toBe(true);
  expect(stats.rays).toBeLessThan(0.7);
  expect(stats.rms).toBeLessThanOrEqual(2 * 1.05);
  const adaptive = await takeScreenshot(page);
  await withElement(page, async (element) => {
    element.steps = 800;
    await element.updateComplete;
    await element.whenRendered();
  });
  const { rmse } = compare(adaptive, await takeScreenshot(page));
  expect(rmse).toBeGreaterThan(0.05);
  expect(rmse).toBeLessThan(3);
});

test('a picture is called final when it is, and then states its error', async ({ page }) => {
  await open(page, tag('max-error="0.6"'));
  await settle(page);
  await withElement(page, (element) => {
    const list: unknown[] = [];
    Object.assign(window, { finals: list });
    element.addEventListener('render', ({ detail }) => detail.converged && list.push(detail.error?.rms ?? null));
  });
  for (const orbit of ['40deg 70deg auto', '80deg 60deg auto', '200deg 100deg auto']) await turnTo(page, orbit);
  const finals = await page.evaluate(() => (window as unknown as { finals: (number | null)[] }).finals);
  expect(finals).toHaveLength(3);
  for (const rms of finals) expect(rms).toBeLessThanOrEqual(0.6 * 1.05);
});

test('given steps have a ray for every pixel', async ({ page }) => {
  await open(page, tag('steps="60"'));
  await settle(page);
  const stats = await turnTo(page, '40deg 70deg auto');
  expect(stats).toMatchObject({ rays: 1, steps: 60, converged: true });
});

test('other colours are looked at with all rays first', async ({ page }) => {
  await open(page, tag('max-error="2"'));
  await settle(page);
  expect((await turnTo(page, '40deg 70deg auto')).rays).toBeLessThan(0.7);
  await withElement(page, async (element) => {
    element.transferFunction = '0% #222 0, 50% #fa6 10%, 100% white 60%';
    await element.updateComplete;
    await element.whenRendered();
  });
  expect(await withElement(page, (element) => element.renderStats!.rays)).toBe(1);
});

test('a picture file has all its rays, and the element\'s own picture stays', async ({ page }) => {
  await open(page, tag('max-error="4"'));
  await settle(page);
  await turnTo(page, '40deg 70deg auto');
  const before = await takeScreenshot(page);
  const differs = await withElement(page, async (element) => {
    const read = async (): Promise<Uint8ClampedArray> => {
      const bitmap = await createImageBitmap(await element.toBlob());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d')!;
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    };
    const file = await read();
    const shown = document.createElement('canvas');
    const own = element.shadowRoot!.querySelector('canvas')!;
    [shown.width, shown.height] = [own.width, own.height];
    const context = shown.getContext('2d')!;
    context.drawImage(own, 0, 0);
    const picture = context.getImageData(0, 0, own.width, own.height).data;
    return file.length === picture.length && file.some((byte, i) => Math.abs(byte - picture[i]) > 2);
  });
  expect(differs).toBe(true);
  expect(compare(await takeScreenshot(page), before).worst).toBeLessThanOrEqual(1);
});
