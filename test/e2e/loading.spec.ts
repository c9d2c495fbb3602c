// Volumes that are large, or larger than the device: what is shown when, where the bytes are, what happens on the way.
import { encode } from 'fast-png';
import type { Page } from '@playwright/test';
import { countGpuBytes } from '../bench/count-gpu-bytes.mjs';
import { compare, expect, open, seenEvents, setAttributes, settle, takePicture, test, waitForEvent, withElement } from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';

/** What the pages note of the GPU's work, in the page. */
interface Watch {
  gpuBytes(): { samples: number; textures: number; all: number };
  /** Called with the context after each piece of an upload. */
  onPiece(gl: WebGL2RenderingContext, pieces: number): void;
  /** Pieces so far. */
  pieces: number;
}

/** Run before the page: counts pieces of uploads to 3D textures. */
function watchPieces(): void {
  const watch = window as unknown as Watch;
  watch.pieces = 0;
  const original = WebGL2RenderingContext.prototype.texSubImage3D as (...args: unknown[]) => void;
  Object.defineProperty(WebGL2RenderingContext.prototype, 'texSubImage3D', {
    value(this: WebGL2RenderingContext, ...args: unknown[]) {
      original.apply(this, args);
      watch.onPiece?.(this, ++watch.pieces);
    },
  });
}

/**
 * Give the page's element a NIfTI file that is made there: a lumpy ellipsoid, brighter inside.
 * @param edge - voxels along each axis
 * @param bits - 8 or 16 of each
 */
async function loadLump(page: Page, edge: number, bits: 8 | 16): Promise<void> {
  await withElement(page, (element, [n, b]) => {
    const header = new DataView(new ArrayBuffer(352));
    header.setInt32(0, 348, true);
    [3, n, n, n, 1, 1, 1, 1].forEach((length, i) => header.setInt16(40 + 2 * i, length, true));
    header.setInt16(70, b === 16 ? 512 : 2, true);
    header.setInt16(72, b, true);
    [1, 1, 1, 1].forEach((spacing, i) => header.setFloat32(76 + 4 * i, spacing * (100 / n), true));
    header.setFloat32(108, 352, true);
    [0x6e, 0x2b, 0x31, 0].forEach((byte, i) => header.setUint8(344 + i, byte));
    const samples = b === 16 ? new Uint16Array(n ** 3) : new Uint8Array(n ** 3);
    const [base, gain] = b === 16 ? [20000, 40000] : [80, 150];
    const squares = Float32Array.from({ length: n }, (_, i) => ((2 * i + 1) / n - 1) ** 2);
    for (let k = 0, at = 0; k < n; k++) {
      for (let j = 0; j < n; j++) {
        const rest = 1 - squares[k] - 1.6 * squares[j] + 0.1 * Math.sin((40 * j) / n) * Math.sin((50 * k) / n);
        for (let i = 0; i < n; i++, at++) {
          const depth = rest - 2 * squares[i];
          if (depth > 0) samples[at] = base + gain * depth;
        }
      }
    }
    element.setAttribute('src', URL.createObjectURL(new Blob([header, samples])));
  }, { argument: [edge, bits] as const });
}

/** 36 MB: above the size from which there is a coarse picture first, and uploaded in more than 30 pieces. */
const largeEdge = 330;

const plain = '<volume-view transfer-function="30% #024 0, 45% #c63 5%, 90% #ffc 60%" camera-orbit="35deg 65deg 100%" steps="120"></volume-view>';

test.beforeEach(async ({ page }) => {
  await page.addInitScript(countGpuBytes);
  await page.addInitScript(watchPieces);
});

/** Bytes of all array buffers that the page holds, after its garbage is gone. */
async function countHeapBytes(page: Page): Promise<number> {
  const client = await page.context().newCDPSession(page);
  await client.send('HeapProfiler.collectGarbage');
  const usage = await client.send('Runtime.getHeapUsage') as { backingStorageSize?: number };
  if (usage.backingStorageSize === undefined) throw new Error('this Chromium does not tell what array buffers take; a newer one does');
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

function meanAlpha({ data }: Picture): number {
  return data.reduce((sum, x, i) => (i % 4 === 3 ? sum + x : sum), 0) / (data.length / 4);
}

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
    const { coarse, changes } = window as unknown as { coarse: { converged: boolean; picture: string }[]; changes: number };
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
    element.addEventListener('render', () => {
      for (let i = 0; i < 4; i++) element.shadowRoot!.querySelector('.picture')!.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true }));
    }, { once: true });
  });
  await loadLump(page, largeEdge, 8);
  await waitForEvent(page, 'load');
  await settle(page);
  const orbits = (await seenEvents(page)).filter(({ type }) => type === 'camera-change')
    .map(({ detail }) => (detail as { orbit: { theta: number } }).orbit.theta);
  expect(Math.abs(orbits.at(-1)! - (35 * Math.PI) / 180), 'radians that it turned').toBeGreaterThan(0.2);
  const turned = await takePicture(page);
  await setAttributes(page, { 'camera-orbit': `${orbits.at(-1)}rad 65deg 100%` });
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
  expect(loads.map(({ type, detail }) => [type, (detail as { dimensions: number[] }).dimensions[0]])).toEqual([['load', 12]]);
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
  expect(await page.evaluate(() => (window as unknown as Watch).pieces), 'pieces of one upload and a part').toBeGreaterThan(45);
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
  const since = (await seenEvents(page)).length;
  await loadLump(page, largeEdge, 8);
  await waitForEvent(page, 'error', { since });
  expect((await seenEvents(page)).slice(since).filter(({ type }) => type === 'render').length, 'pictures of the coarse one').toBeGreaterThan(0);
  // The words of the error cover it, and toBlob says them.
  const url = await withElement(page, async (element) => {
    await element.redraw();
    return element.shadowRoot!.querySelector('canvas')!.toDataURL();
  });
  expect(compare(decodeUrl(url), before).rmse).toBeLessThan(0.5);
});

test('where the GPU has no memory for a volume it shows a reduced one', async ({ page }) => {
  await page.addInitScript(() => {
    let isFull = false;
    const { texStorage3D, getError } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.texStorage3D = function (...args) {
      isFull = args[3] * args[4] * args[5] > 1e7;
      if (!isFull) texStorage3D.apply(this, args);
    };
    WebGL2RenderingContext.prototype.getError = function () {
      const error = isFull ? this.OUT_OF_MEMORY : getError.call(this);
      isFull = false;
      return error;
    };
  });
  await open(page, plain);
  await loadLump(page, largeEdge, 8);
  const { detail } = await waitForEvent(page, 'load');
  await settle(page);
  const { from, to } = (detail as { reduced: { from: number[]; to: number[] } }).reduced;
  expect(from).toEqual([largeEdge, largeEdge, largeEdge]);
  expect(to.reduce((product, n) => product * n)).toBeLessThanOrEqual(largeEdge ** 3 / 4);
  expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toEqual([]);
  expect(meanAlpha(await takePicture(page))).toBeGreaterThan(20);
});

function decodeUrl(url: string): Picture {
  return decodePicture(Buffer.from(url.slice(url.indexOf(',') + 1), 'base64'));
}

/** A mosaic of 4 x 4 tiles of 512 x 512 pixels with a ball in it, as a PNG of 2,048 x 2,048. */
function mosaicOfBall(): Uint8Array {
  const [tile, tiles] = [512, 4];
  const width = tile * tiles;
  const data = new Uint8Array(width * width);
  for (let y = 0; y < width; y++) {
    for (let x = 0; x < width; x++) {
      const slice = Math.floor(y / tile) * tiles + Math.floor(x / tile);
      const [u, v, w] = [((x % tile) + 0.5) / tile, ((y % tile) + 0.5) / tile, (slice + 0.5) / (tiles * tiles)].map((c) => 2 * c - 1);
      data[y * width + x] = Math.max(0, 255 * (1 - 1.2 * (u * u + 1.5 * v * v + w * w)));
    }
  }
  return encode({ width, height: width, data, channels: 1, depth: 8 });
}

for (const [what, webgl1, limit] of [['one texture of 2D', true, 512], ['a 3D texture', false, 128]] as const) {
  test(`a mosaic larger than ${what} of the device becomes one that fits`, async ({ page }) => {
    await page.route('**/ball.png', (route) => route.fulfill({ contentType: 'image/png', body: Buffer.from(mosaicOfBall()) }));
    const body = plain.replace('<volume-view', '<volume-view src="/ball.png" mosaic="4x4" spacing="1 1 32"');
    await open(page, body);
    await settle(page);
    const whole = await takePicture(page);
    expect((await withElement(page, (element) => element.volume))!.reduced).toBeUndefined();

    await page.addInitScript(pretendSmall, [webgl1, limit] as const);
    await page.reload();
    const { detail } = await waitForEvent(page, 'load');
    await settle(page);
    const { reduced, dimensions } = detail as { reduced: { from: number[]; to: number[] }; dimensions: number[] };
    expect(reduced.from).toEqual([512, 512, 16]);
    expect(reduced.to).toEqual(dimensions);
    expect(await withElement(page, (element) => element.volume!.reduced)).toEqual(reduced);
    const largest = await page.evaluate(() => (window as unknown as { largest: number }).largest);
    expect(largest, 'longest edge of a texture with samples').toBeLessThanOrEqual(limit);
    expect(largest).toBeGreaterThan(limit / 3);
    const { rmse } = compare(await takePicture(page), whole);
    expect(meanAlpha(whole)).toBeGreaterThan(20);
    expect(rmse).toBeLessThan(2);
  });
}

/** Run before the page: a device of small textures, and the longest edge of what is made there of one channel. */
function pretendSmall([webgl1, limit]: readonly [boolean, number]): void {
  if (webgl1) Object.defineProperty(navigator, 'platform', { value: 'MacIntel' });
  const watch = window as unknown as { largest: number };
  watch.largest = 0;
  const note = (...edges: number[]): void => void (watch.largest = Math.max(watch.largest, ...edges));
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
    const { getParameter, texImage2D } = prototype;
    const limits = [0x0d33, 0x8073]; // MAX_TEXTURE_SIZE, MAX_3D_TEXTURE_SIZE
    prototype.getParameter = function (name: number): unknown {
      const isLimit = limits[webgl1 ? 0 : 1] === name;
      return isLimit ? limit : (getParameter.call(this, name) as unknown);
    };
    prototype.texImage2D = function (this: WebGLRenderingContext, ...args: unknown[]) {
      if (args[2] === this.LUMINANCE) note(args[3] as number, args[4] as number);
      (texImage2D as (...all: unknown[]) => void).apply(this, args);
    };
  }
  const { texStorage3D } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.texStorage3D = function (...args) {
    note(args[3], args[4], args[5]);
    texStorage3D.apply(this, args);
  };
}
