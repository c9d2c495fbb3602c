// Volumes larger than the device: reduced to what fits, and seen all the same.
import { encode } from 'fast-png';
import {
  compare,
  expect,
  open,
  seenEvents,
  settle,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { largeEdge, loadLump, meanAlpha, plain } from './helpers/lump.ts';

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

/** A mosaic of 4 x 4 tiles of 512 x 512 pixels with a ball in it, as a PNG of 2,048 x 2,048. */
function mosaicOfBall(): Uint8Array {
  const [tile, tiles] = [512, 4];
  const width = tile * tiles;
  const data = new Uint8Array(width * width);
  for (let y = 0; y < width; y++) {
    for (let x = 0; x < width; x++) {
      const slice = Math.floor(y / tile) * tiles + Math.floor(x / tile);
      const [u, v, w] = [((x % tile) + 0.5) / tile, ((y % tile) + 0.5) / tile, (slice + 0.5) / (tiles * tiles)].map(
        (c) => 2 * c - 1,
      );
      data[y * width + x] = Math.max(0, 255 * (1 - 1.2 * (u * u + 1.5 * v * v + w * w)));
    }
  }
  return encode({ width, height: width, data, channels: 1, depth: 8 });
}

for (const [what, webgl1, limit] of [
  ['one texture of 2D', true, 512],
  ['a 3D texture', false, 128],
] as const) {
  test(`a mosaic larger than ${what} of the device becomes one that fits`, async ({ page }) => {
    await page.route('**/ball.png', (route) =>
      route.fulfill({ contentType: 'image/png', body: Buffer.from(mosaicOfBall()) }),
    );
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
