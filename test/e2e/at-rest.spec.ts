import { compare, expect, keptTest as test, open, settle, takeScreenshot, withElement } from './helpers/harness.ts';
import type { Page } from '@playwright/test';

const tag = (
  attributes: string,
  [width, height] = [120, 96],
  src = '/demos/data/mni152-t1.nii.gz',
  inside = '',
): string =>
  `<volume-view src="${src}" ${attributes} style="width: ${width}px; height: ${height}px" alt="What is shown">${inside}</volume-view>`;

/** Turn to a view, and tell what its picture took once it is final. */
function turnTo(
  page: Page,
  orbit: string,
): Promise<{ rays: number; steps: number; rms: number | null; converged: boolean; keeps: boolean | null }> {
  return withElement(
    page,
    async (element, asked) => {
      element.cameraOrbit = asked;
      await element.updateComplete;
      await element.whenRendered();
      const { rays, steps, error, converged, keepsMaxError } = element.renderStats!;
      return { rays, steps, rms: error?.rms ?? null, converged, keeps: keepsMaxError };
    },
    { argument: orbit },
  );
}

test('a picture at rest has a ray for every pixel and a step for every voxel, keeps max-error, and says so', async ({
  page,
}) => {
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
  const finals = await page.evaluate(
    () => (window as unknown as { finals: { rms: number; p99: number; max: number }[] }).finals,
  );
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

/** How a file of the picture and the screen differ: in width, and all differences of bytes. */
const readFile = (page: Page): Promise<number[]> =>
  withElement(page, async (element) => {
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

// Just large enough that software GL draws them in pieces; those of surfaces take longer and are smaller.
for (const [what, appearance, size, ...more] of [
  ['fog', '', [200, 160]],
  ['surfaces, whose edges are smooth', 'surface-values="35% #d8a48f 30%, 72% #fff4e0"', [80, 64]],
  [
    'a radar with a slice',
    'vertical-exaggeration="4" rings="none"',
    [120, 96],
    '/demos/data/storm-radar-1510.json',
    '<volume-slice type="ppi"></volume-slice>',
  ],
  ['fog with fewer rays', 'detail="free" max-error="8" shading="unlit"', [200, 160]],
  [
    'fog with fewer rays around a shape',
    'detail="free" max-error="8" shading="unlit"',
    [200, 160],
    '/demos/data/mni152-t1.nii.gz',
    '<Transform translation="0 -60 20"><Shape><Appearance><Material diffuseColor="1 0 0"></Material></Appearance><Sphere radius="25"></Sphere></Shape></Transform>',
  ],
  ['surfaces with fewer steps', 'detail="free" max-error="8" surface-values="35% #d8a48f 30%, 72% #fff4e0"', [80, 64]],
  [
    'a radar with fewer rays',
    'detail="free" max-error="8" rings="none"',
    [120, 96],
    '/demos/data/storm-radar-1510.json',
  ],
] as const) {
  test(`the same view has the same picture, first or later, in a file and on the screen: ${what}`, async ({ page }) => {
    await open(page, tag(`camera-orbit="40deg 70deg auto" ${appearance}`, [...size], ...more));
    await settle(page);
    const first = await takeScreenshot(page);
    expect(await readFile(page), 'no difference').toEqual([0, 0]);
    await turnTo(page, '80deg 60deg auto');
    await turnTo(page, '200deg 100deg auto');
    await turnTo(page, '40deg 70deg auto');
    expect(compare(await takeScreenshot(page), first).worst).toBe(0);
    expect(await readFile(page)).toEqual([0, 0]);
  });
}

test('edges of surfaces are smooth at rest, in pieces, at once and while a file is written, and stay as they are with a large max-error', async ({
  page,
}) => {
  const appearance = (more: string): string =>
    `<volume-view src="/demos/data/mni152-t1.nii.gz" surface-values="72% #fff4e0" ${more} style="width: 120px; height: 90px" alt="A brain"></volume-view>`;
  await open(page, appearance('camera-orbit="40deg 70deg auto"'));
  await settle(page);
  const smooth = await takeScreenshot(page);
  await turnTo(page, '80deg 60deg auto');
  // Files that are asked for while pieces of the picture come are drawn where these lie: they wait for it.
  await withElement(page, async (element) => {
    const isFinal = new Promise<void>((resolve) =>
      element.addEventListener('render', ({ detail }) => detail.converged && resolve()),
    );
    element.cameraOrbit = '40deg 70deg auto';
    await new Promise((resolve) => element.addEventListener('render', resolve, { once: true }));
    for (let i = 0; i < 3; i++) await element.toBlob({ width: 100 });
    await isFinal;
    await element.whenRendered();
  });
  expect(compare(await takeScreenshot(page), smooth).worst, 'after files').toBe(0);
  await withElement(page, (element) => element.redraw());
  expect(compare(await takeScreenshot(page), smooth).worst, 'at once').toBe(0);
  const jagged = await withElement(page, async (element) => {
    element.maxError = 30;
    await element.updateComplete;
    await element.whenRendered();
    return element.renderStats!.converged;
  });
  expect(jagged).toBe(true);
  const { worst, rmse } = compare(await takeScreenshot(page), smooth);
  expect(worst).toBeGreaterThan(60);
  expect(rmse).toBeGreaterThan(2);
});

test("while a camera moves pictures are as at rest, where these are within a frame's time: nothing small comes and goes", async ({
  page,
}) => {
  // Frames of a second, so that a busy machine has time enough for all pixels.
  await open(page, tag('target-fps="1" max-error="0.5"', [40, 32]));
  await settle(page);
  const frames = await withElement(page, async (element) => {
    await element.redraw(); // Without what was compiled for the first one.
    const { steps, substeps, width } = element.renderStats!;
    const picture = element.shadowRoot!.querySelector<HTMLElement>('.picture')!;
    picture.setPointerCapture = () => {}; // A made event has no pointer to capture.
    const point = (type: string, clientX: number): boolean =>
      picture.dispatchEvent(
        new PointerEvent(type, { pointerId: 1, isPrimary: true, bubbles: true, clientX, clientY: 10 }),
      );
    const seen: unknown[] = [];
    point('pointerdown', 0);
    for (let i = 1; i <= 4; i++) {
      const drawn = new Promise<typeof element.renderStats>((resolve) =>
        element.addEventListener('render', ({ detail }) => resolve(detail), { once: true }),
      );
      point('pointermove', 3 * i);
      const now = (await drawn)!;
      seen.push([now.converged, now.width - width, now.rays, now.steps - steps, now.substeps - substeps]);
    }
    point('pointerup', 12);
    await element.whenRendered();
    return { seen, hasMoved: element.cameraOrbit !== 'auto auto auto' };
  });
  expect(frames).toEqual({ seen: Array.from({ length: 4 }, () => [false, 0, 1, 0, 0]), hasMoved: true });
});
