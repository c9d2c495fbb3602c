import { compare, expect, open, settle, takeScreenshot, test, withElement } from './helpers/harness.ts';
import type { Page } from '@playwright/test';

const tag = (attributes: string): string =>
  `<volume-view src="/demos/data/mni152-t1.nii.gz" ${attributes} style="width: 300px; height: 240px" alt="A head"></volume-view>`;

/** Turn to a view, and tell what its picture took once it is final. */
function turnTo(page: Page, orbit: string): Promise<{ rays: number; steps: number; rms: number | null; converged: boolean; keeps: boolean | null }> {
  return withElement(page, async (element, asked) => {
    element.cameraOrbit = asked;
    await element.updateComplete;
    await element.whenRendered();
    const { rays, steps, error, converged, keepsMaxError } = element.renderStats!;
    return { rays, steps, rms: error?.rms ?? null, converged, keeps: keepsMaxError };
  }, { argument: orbit });
}

test('a picture at rest has a ray for every pixel and a step for every voxel, keeps max-error, and says so', async ({ page }) => {
  await open(page, tag('max-error="2"'));
  await settle(page);
  const stats = await turnTo(page, '40deg 70deg auto');
  expect(stats).toMatchObject({ converged: true, rays: 1, keeps: true });
  expect(stats.steps).toBeGreaterThanOrEqual(359);
  expect(stats.rms).toBeLessThanOrEqual(2);
  const shown = await takeScreenshot(page);
  await withElement(page, async (element) => {
    element.steps = 1400;
    await element.updateComplete;
    await element.whenRendered();
  });
  const { rmse } = compare(shown, await takeScreenshot(page));
  expect(rmse).toBeGreaterThan(0.02);
  expect(rmse).toBeLessThan(1);
});

test('a picture is called final when it is, and then states its error', async ({ page }) => {
  await open(page, tag('max-error="0.6"'));
  await settle(page);
  await withElement(page, (element) => {
    const list: unknown[] = [];
    Object.assign(window, { finals: list });
    element.addEventListener('render', ({ detail }) => detail.converged && list.push(detail.error));
  });
  for (const orbit of ['40deg 70deg auto', '80deg 60deg auto', '200deg 100deg auto']) await turnTo(page, orbit);
  const finals = await page.evaluate(() => (window as unknown as { finals: { rms: number; p99: number; max: number }[] }).finals);
  expect(finals).toHaveLength(3);
  for (const { rms, p99, max } of finals) {
    expect(rms).toBeLessThanOrEqual(0.6);
    expect(p99).toBeLessThanOrEqual(max);
    expect(max).toBeLessThanOrEqual(255);
  }
});

test('given steps have a ray for every pixel, and their error is stated', async ({ page }) => {
  await open(page, tag('steps="60"'));
  await settle(page);
  const stats = await turnTo(page, '40deg 70deg auto');
  expect(stats).toMatchObject({ rays: 1, steps: 60, converged: true });
  expect(stats.rms).toBeGreaterThan(0);
});

test('the same view has the same picture, first or later, in a file and on the screen', async ({ page }) => {
  await open(page, tag('camera-orbit="40deg 70deg auto"'));
  await settle(page);
  const first = await takeScreenshot(page);
  const readFile = (): Promise<number[]> => withElement(page, async (element) => {
    const bitmap = await createImageBitmap(await element.toBlob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    context.drawImage(bitmap, 0, 0);
    const own = element.shadowRoot!.querySelector('canvas')!;
    const file = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    context.clearRect(0, 0, bitmap.width, bitmap.height);
    context.drawImage(own, 0, 0);
    const shown = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    return [bitmap.width - own.width, ...new Set(file.map((byte, i) => Math.abs(byte - shown[i])))];
  });
  expect(await readFile(), 'no difference').toEqual([0, 0]);
  await turnTo(page, '80deg 60deg auto');
  await turnTo(page, '200deg 100deg auto');
  await turnTo(page, '40deg 70deg auto');
  expect(compare(await takeScreenshot(page), first).worst).toBe(0);
  expect(await readFile()).toEqual([0, 0]);
});
