import { compare, expect, open, settle, takeScreenshot, test, withElement } from './helpers/harness.ts';

/** Much to draw: with software GL several times what a frame may take. */
const body =
  '<volume-view src="/demos/data/mni152-t1.nii.gz" max-error="0.1" style="width: 240px; height: 180px" alt="A head"></volume-view>';

test('a picture at rest that takes long lets the page go on', async ({ page }) => {
  await open(page, body);
  await settle(page);
  const { frames, stats } = await withElement(page, async (element) => {
    let count = 0;
    let counting = true;
    const tick = (): void => {
      count++;
      if (counting) requestAnimationFrame(tick);
    };
    // From the last quick picture to the final one.
    element.addEventListener('render', ({ detail }) => {
      if (!detail.converged) count = 0;
    });
    requestAnimationFrame(tick);
    element.cameraOrbit = '40deg 70deg auto';
    await element.updateComplete;
    await element.whenRendered();
    counting = false;
    return { frames: count, stats: element.renderStats! };
  });
  expect(stats.converged).toBe(true);
  expect(stats).toMatchObject({ width: 240, height: 180 });
  // A piece is planned for a thirtieth of a second; slow machines may take several times as long.
  expect(frames).toBeGreaterThan(stats.frameMs / 250);
  // Drawn at once, it is the same.
  const inPieces = await takeScreenshot(page);
  await withElement(page, (element) => element.redraw());
  expect(compare(await takeScreenshot(page), inPieces).worst).toBeLessThanOrEqual(1);
});

test('a change gives such a picture up', async ({ page }) => {
  await open(page, body);
  await settle(page);
  const seen = await withElement(page, async (element) => {
    const list: string[] = [];
    element.addEventListener('render', ({ detail }) =>
      list.push(`${detail.converged ? 'final' : 'quick'} ${element.opacityFactor}`),
    );
    for (const factor of [2, 3, 4]) {
      const quick = new Promise((resolve) => element.addEventListener('render', resolve, { once: true }));
      element.opacityFactor = factor;
      await quick;
      for (let i = 0; i < 2; i++) await new Promise(requestAnimationFrame);
    }
    await element.updateComplete;
    await element.whenRendered();
    return list;
  });
  expect(seen.filter((entry) => entry.startsWith('quick')).length).toBeGreaterThanOrEqual(3);
  expect(seen.filter((entry) => entry.startsWith('final'))).toEqual(['final 4']);
  expect(seen.at(-1)).toBe('final 4');
});
