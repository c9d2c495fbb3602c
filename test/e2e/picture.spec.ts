import {
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  open,
  setAttributes,
  settle,
  sharePage,
  takePicture,
  takeScreenshot,
  test,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference, plainAttributes } from './helpers/reference.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

/** As x3dom sees Apple's systems, where it asks for WebGL 1. */
function pretendMac(): void {
  Object.defineProperty(Navigator.prototype, 'platform', { get: () => 'MacIntel' });
}

for (const version of [2, 1] as const) {
  test.describe(`WebGL ${version}`, () => {
    test.beforeEach(async ({ page }) => {
      if (version === 1) await page.addInitScript(pretendMac);
    });

    const sources = {
      'NIfTI, gzipped': plain,
      NIfTI: `<volume-view src="/test/e2e/pages/data/field.nii" ${attributesOf()}></volume-view>`,
      'a manifest and its mosaic': `<volume-view src="/test/e2e/pages/data/field.json" ${attributesOf()}></volume-view>`,
    };
    for (const [name, body] of Object.entries(sources)) {
      test(`${name} gives the reference's picture`, async ({ page }) => {
        await open(page, body);
        expectSamePicture(await takePicture(page), drawReference());
        const isWebGl2 = await withElement(
          page,
          (element) => element.shadowRoot!.querySelector('canvas')!.getContext('webgl2') !== null,
        );
        expect(isWebGl2).toBe(version === 2);
      });
    }

    test('a mosaic by attributes is the same volume', async ({ page }) => {
      // Stops in the image's own values, as no manifest rescales them.
      const tf = plainAttributes['transfer-function']
        .replace('0.15 ', '38.25 ')
        .replace('0.4 ', '102 ')
        .replace('0.8 ', '204 ');
      const mosaic = { mosaic: '4x4', spacing: '1 1.5 2', 'transfer-function': tf };
      await open(page, `<volume-view src="/test/e2e/pages/data/field.png" ${attributesOf(mosaic)}></volume-view>`);
      expectSamePicture(await takePicture(page), drawReference());
      await setAttributes(page, { slices: '8' });
      expect(await withElement(page, (element) => element.volume!.dimensions)).toEqual([24, 20, 8]);
      expect(compare(await takePicture(page), drawReference()).worst).toBeGreaterThan(20);
    });
  });
}

test.describe('on a page', () => {
  const sharedPage = sharePage(plain, { head: '<style>volume-view { background: none }</style>' });

  for (const [name, background] of Object.entries({
    white: [255, 255, 255],
    black: [0, 0, 0],
    orange: [255, 128, 0],
  } as const)) {
    test(`a ${name} page shows through, with no fringe`, async () => {
      await sharedPage().evaluate((color) => (document.body.style.background = color), `rgb(${background.join(' ')})`);
      expectSamePicture(await takeScreenshot(sharedPage()), drawReference({ background }));
    });
  }
});

test('toBlob at another size, and back', async ({ page }) => {
  await open(page, `<body style="background: black">${plain}`, {
    head: '<style>volume-view { background: none }</style>',
  });
  await settle(page);
  const before = await takeScreenshot(page);
  const stats = await withElement(page, (element) => element.renderStats);
  expectSamePicture(await takePicture(page, { width: 200, height: 80 }), drawReference({ width: 200, height: 80 }));
  expectSamePicture(await takePicture(page, { width: 60 }), drawReference({ width: 60, height: 45 }));
  expect(compare(await takeScreenshot(page), before).worst).toBe(0);
  expect(await withElement(page, (element) => element.renderStats)).toEqual(stats);
});

test('toBlob knows file types, and refuses sizes that no device has', async ({ page }) => {
  await open(page, plain);
  const types = await withElement(page, async (element) =>
    Promise.all(['image/png', 'image/webp', 'image/jpeg'].map(async (type) => (await element.toBlob({ type })).type)),
  );
  expect(types).toEqual(['image/png', 'image/webp', 'image/jpeg']);
  const refusal = await withElement(page, (element) => element.toBlob({ width: 1e6 }).catch(String));
  expect(refusal).toMatch(/RangeError: toBlob got 1000000 x 750000 pixels; expected 1 to \d+/);
});

test("the picture has the screen's pixels, also on a dense one", async ({ browser }) => {
  const page = await browser.newPage({ deviceScaleFactor: 2 });
  await open(page, plain);
  await settle(page);
  const stats = await withElement(page, (element) => element.renderStats!);
  expect([stats.width, stats.height]).toEqual([240, 180]);
  expectSamePicture(await takePicture(page), drawReference({ width: 240, height: 180 }));
  await page.close();
});

test('another size or pixel ratio while it stands there gives another picture', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  const canvasSize = (): Promise<string> =>
    withElement(page, (element) => {
      const canvas = element.shadowRoot!.querySelector('canvas')!;
      return `${canvas.width} x ${canvas.height}`;
    });
  await page.locator('volume-view').evaluate((element) => {
    element.style.width = '160px';
    element.style.height = '100px';
  });
  await expect.poll(canvasSize).toBe('160 x 100');
  expectSamePicture(await takePicture(page), drawReference({ width: 160, height: 100 }));
  const session = await page.context().newCDPSession(page);
  for (const deviceScaleFactor of [1.5, 2]) {
    // Chromium's emulation tells media queries of a new ratio only when the window has another size too, as zooming does.
    const width = 900 / deviceScaleFactor;
    await session.send('Emulation.setDeviceMetricsOverride', { width, height: 700, deviceScaleFactor, mobile: false });
    await expect.poll(canvasSize).toBe(`${160 * deviceScaleFactor} x ${100 * deviceScaleFactor}`);
  }
});
