// Large volumes: what is shown when, where the bytes are, what happens on the way.
import type { Page } from '@playwright/test';
import { countGpuBytes } from '../bench/count-gpu-bytes.mjs';
import {
  compare,
  expect,
  fewPixels,
  open,
  seenEvents,
  setAttributes,
  settle,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { largeEdge, loadLump, meanAlpha, plain, watchPieces } from './helpers/lump.ts';
import type { Watch } from './helpers/lump.ts';
import { decodePicture } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';

test.use(fewPixels);

test.beforeEach(async ({ page }) => {
  await page.addInitScript(countGpuBytes);
  await page.addInitScript(watchPieces);
});

/** Bytes of all array buffers that the page holds, after its garbage is gone. */
async function countHeapBytes(page: Page): Promise<number> {
  const client = await page.context().newCDPSession(page);
  await client.send('HeapProfiler.collectGarbage');
  const usage = (await client.send('Runtime.getHeapUsage')) as { backingStorageSize?: number };
  if (usage.backingStorageSize === undefined)
    throw new Error('this Chromium does not tell what array buffers take; a newer one does');
  return usage.backingStorageSize;
}

test('512 x 512 x 512 voxels of 16 bits load and turn, once in the heap and once on the GPU', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  const before = await countHeapBytes(page);
  await loadLump(page, 512, 16);
  const { detail } = await waitForEvent(page, 'load');
  expect(detail).toMatchObject({ dimensions: [512, 512, 512] });
  expect((detail as { reduced?: unknown }).reduced).toBeUndefined();
  await settle(page);
  const bytes = 2 * 512 ** 3;
  const gpu = await page.evaluate(() => (window as unknown as Watch).gpuBytes());
  expect(gpu.samples, 'bytes of the largest texture').toBe(bytes);
  expect(gpu.all / bytes, 'of all textures and buffers').toBeLessThanOrEqual(1.3);
  const held = (await countHeapBytes(page)) - before;
  expect(held / bytes, 'of all array buffers').toBeGreaterThan(0.9);
  expect(held / bytes).toBeLessThanOrEqual(1.05);

  const first = await takePicture(page);
  await setAttributes(page, { 'camera-orbit': '125deg 65deg 100%' });
  const turned = await takePicture(page);
  expect(meanAlpha(first), 'something is seen').toBeGreaterThan(20);
  expect(compare(first, turned).rmse, 'it turned').toBeGreaterThan(8);
});

test('a coarse picture comes first, and the whole takes its place without a jump', async ({ page }) => {
  await open(page, plain);
  await withElement(page, (element) => {
    const watch = window as unknown as { coarse: unknown[]; changes: number };
    watch.coarse = [];
    watch.changes = 0;
    element.addEventListener('optics-change', () => watch.changes++);
    element.addEventListener('render', ({ detail }) => {
      if (element.volume) return;
      const canvas = element.shadowRoot!.querySelector('canvas')!;
      watch.coarse.push({ converged: detail.converged, picture: canvas.toDataURL() });
    });
  });
  await loadLump(page, largeEdge, 8);
  await waitForEvent(page, 'load');
  await settle(page);
  const seen = await page.evaluate(() => {
    const { coarse, changes } = window as unknown as {
      coarse: { converged: boolean; picture: string }[];
      changes: number;
    };
    return { coarse, changes };
  });
  expect(seen.coarse.length, 'pictures before the volume is there').toBeGreaterThan(0);
  expect(seen.coarse.map(({ converged }) => converged)).not.toContain(true);
  expect(seen.changes, 'times that the optics changed').toBe(1);
  expect((await withElement(page, (element) => element.renderStats))!.converged).toBe(true);
  const whole = await takePicture(page);
  const coarse = decodeUrl(seen.coarse.at(-1)!.picture);
  expect(meanAlpha(whole)).toBeGreaterThan(20);
  // Voxels of a third of the resolution blur surfaces; another window or camera would differ by tens.
  expect(compare(coarse, whole).rmse).toBeLessThan(4);
});

test('a person who turns the coarse picture keeps what they see', async ({ page }) => {
  await open(page, plain);
  await withElement(page, (element) => {
    // What takes the keys comes with the first picture: they are pressed until it is there.
    const press = (): void => {
      for (let i = 0; i < 4; i++)
        element
          .shadowRoot!.querySelector('.picture')!
          .dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true }));
    };
    element.addEventListener(
      'render',
      () => {
        const pressing = setInterval(press, 5);
        element.addEventListener('camera-change', () => clearInterval(pressing), { once: true });
      },
      { once: true },
    );
  });
  await loadLump(page, largeEdge, 8);
  await waitForEvent(page, 'load');
  await settle(page);
  const moves = (await seenEvents(page)).filter(({ type }) => type === 'camera-change');
  const {
    orbit: { theta, radius },
    target,
  } = moves.at(-1)!.detail as { orbit: { theta: number; radius: number }; target: number[] };
  expect(Math.abs(theta - (35 * Math.PI) / 180), 'radians that it turned').toBeGreaterThan(0.2);
  const turned = await takePicture(page);
  await setAttributes(page, { 'camera-orbit': `${theta}rad 65deg ${radius}`, 'camera-target': target.join(' ') });
  expect(compare(await takePicture(page), turned).rmse).toBeLessThan(0.5);
});

test('another source ends an upload and takes its memory back', async ({ page }) => {
  await open(page, plain);
  await withElement(page, (element) => {
    (window as unknown as Watch).onPiece = (_, pieces) => {
      if (pieces === 12) element.setAttribute('src', '/test/e2e/pages/data/ball.nii');
    };
  });
  await loadLump(page, largeEdge, 8);
  await waitForEvent(page, 'load');
  await settle(page);
  const { pieces, textures } = await page.evaluate(() => {
    const watch = window as unknown as Watch;
    return { pieces: watch.pieces, textures: watch.gpuBytes().textures };
  });
  expect(pieces, 'pieces of the coarse volume, a part of the large one, and the ball').toBeLessThan(30);
  expect(textures).toBeLessThan(8e6);
  const loads = (await seenEvents(page)).filter(({ type }) => type === 'load' || type === 'error');
  expect(loads.map(({ type, detail }) => [type, (detail as { dimensions: number[] }).dimensions[0]])).toEqual([
    ['load', 12],
  ]);
});

test('a context that is lost during an upload costs nothing but time', async ({ page }) => {
  await open(page, plain);
  await withElement(page, () => {
    (window as unknown as Watch).onPiece = (gl, pieces) => {
      if (pieces === 12) gl.getExtension('WEBGL_lose_context')!.loseContext();
    };
  });
  await loadLump(page, largeEdge, 8);
  await waitForEvent(page, 'load');
  await settle(page);
  const after = await takePicture(page);
  expect(
    await page.evaluate(() => (window as unknown as Watch).pieces),
    'pieces of one upload and a part',
  ).toBeGreaterThan(45);
  expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toEqual([]);
  await loadLump(page, largeEdge, 8);
  await waitForEvent(page, 'load', { since: (await seenEvents(page)).length });
  await settle(page);
  expect(compare(await takePicture(page), after).rmse).toBeLessThan(0.5);
});

test('where the whole fails after its coarse picture, the last good picture is back', async ({ page }) => {
  await page.addInitScript(() => {
    const { texStorage3D } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.texStorage3D = function (...args) {
      if (args[3] * args[4] * args[5] > 1e7) throw new Error('no such texture');
      texStorage3D.apply(this, args);
    };
  });
  await open(page, plain.replace('<volume-view', '<volume-view src="/test/e2e/pages/data/field.nii.gz"'));
  await settle(page);
  const before = await takePicture(page);
  // On a busy machine the whole may come before the coarse one is drawn: then the same again.
  let coarse = 0;
  for (let attempt = 0; attempt < 4 && coarse === 0; attempt++) {
    const since = (await seenEvents(page)).length;
    await loadLump(page, largeEdge, 8);
    await waitForEvent(page, 'error', { since });
    coarse = (await seenEvents(page)).slice(since).filter(({ type }) => type === 'render').length;
  }
  expect(coarse, 'pictures of the coarse one').toBeGreaterThan(0);
  // The words of the error cover it, and toBlob says them.
  const url = await withElement(page, async (element) => {
    await element.redraw();
    return element.shadowRoot!.querySelector('canvas')!.toDataURL();
  });
  expect(compare(decodeUrl(url), before).rmse).toBeLessThan(0.5);
});

function decodeUrl(url: string): Picture {
  return decodePicture(Buffer.from(url.slice(url.indexOf(',') + 1), 'base64'));
}
