import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import type { Page } from '@playwright/test';
import { files } from './helpers/data.ts';
import {
  ballUrl,
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  networkLines,
  open,
  seenEvents,
  settle,
  takePicture,
  takeScreenshot,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { serveSlowly } from './helpers/slow-server.ts';
import { ball } from './helpers/volumes.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;
const projectRoot = join(import.meta.dirname, '../..');

test.describe('below the fold', () => {
  const far = `<div style="height: 6000px"></div>${plain}`;

  /** Whoever waits for its picture makes an element load: so these wait for the page. */
  const idle = (page: Page): Promise<void> =>
    withElement(page, async (element) => {
      await element.updateComplete;
      for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
      await new Promise((resolve) => requestIdleCallback(resolve));
    });

  for (const loading of ['', 'loading="lazy"']) {
    test(`${loading || 'without loading'} nothing is loaded until it is scrolled to`, async ({ page }) => {
      const requests: string[] = [];
      page.on('request', (request) => requests.push(new URL(request.url()).pathname));
      await open(page, far.replace('<volume-view', `<volume-view ${loading}`));
      await idle(page);
      expect(requests.filter((path) => /field|x3dom|worker/.test(path))).toEqual([]);
      expect(await seenEvents(page)).toEqual([]);
      await page.evaluate(() => scrollTo(0, 6000));
      await waitForEvent(page, 'render');
      expectSamePicture(await takePicture(page), drawReference());
      expect(requests).toContain(fieldUrl);
    });
  }

  test('loading="eager" loads at once, and draws when it is scrolled to', async ({ page }) => {
    await open(page, far);
    await idle(page);
    await withElement(page, (element) => element.setAttribute('loading', 'eager'));
    await waitForEvent(page, 'load');
    await idle(page);
    expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('render');
    await page.evaluate(() => scrollTo(0, 6000));
    await waitForEvent(page, 'render');
  });

  test('who asks for the picture gets it, of another source and other attributes too', async ({ page }) => {
    await open(page, far);
    await settle(page);
    expectSamePicture(await takePicture(page), drawReference());
    expect(
      await withElement(
        page,
        async (element, src) => {
          element.src = src;
          return (await element.redraw()).steps;
        },
        { argument: ballUrl },
      ),
    ).toBe(30);
    await withElement(page, async (element) => {
      element.steps = 90;
      await element.whenRendered();
    });
    expectSamePicture(await takePicture(page), drawReference({ volume: ball, steps: 90 }));
    expect(await page.evaluate(() => scrollY)).toBe(0);
    // And then it lets go of the GPU again.
    await expect.poll(() => withElement(page, (element) => element.shadowRoot!.querySelector('x3d'))).toBe(null);
  });

  test('a load under way ends when its element is scrolled away, and begins again when it is back', async ({
    page,
  }) => {
    const server = await serveSlowly(files['field.nii'], 0.5);
    await open(page, `<div style="height: 6000px">${plain.replace(fieldUrl, server.url)}</div>`);
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { loaded: number }).loaded > 0));
    await page.evaluate(() => scrollTo(0, 6000));
    await server.dropped;
    await expect(page.locator('volume-view progress')).toHaveCount(0);
    server.release();
    await page.evaluate(() => scrollTo(0, 0));
    await waitForEvent(page, 'render');
    expectSamePicture(await takePicture(page), drawReference());
    expect(server.requests()).toBe(2);
    expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('error');
    server.close();
  });
});

test('without src it asks for nothing, not even x3dom', async ({ page }) => {
  const requests: string[] = [];
  page.on('request', (request) => requests.push(new URL(request.url()).pathname));
  await open(page, '<volume-view alt="Nothing yet"></volume-view>');
  await settle(page);
  await page.evaluate(() => new Promise((resolve) => requestIdleCallback(resolve)));
  expect(requests.filter((path) => /x3dom|worker/.test(path))).toEqual([]);
});

test('the poster stands there until the first picture', async ({ page }) => {
  const server = await serveSlowly(files['field.nii'], 0.5);
  const red =
    '<svg xmlns="http://www.w3.org/2000/svg" width="4" height="3"><rect width="4" height="3" fill="red"/></svg>';
  await page.route('**/poster.svg', (route) => route.fulfill({ contentType: 'image/svg+xml', body: red }));
  await open(page, `<volume-view poster="/poster.svg" src="${server.url}" ${attributesOf()}></volume-view>`, {
    head: '<style>volume-view { background: white }</style>',
  });
  const middle = async (): Promise<number[]> => [
    ...(await takeScreenshot(page)).data.slice((45 * 120 + 60) * 4, (45 * 120 + 60) * 4 + 3),
  ];
  await expect.poll(middle).toEqual([255, 0, 0]);
  server.release();
  await settle(page);
  await expect(page.locator('volume-view img')).toHaveCount(0);
  expectSamePicture(await takeScreenshot(page), drawReference({ background: [255, 255, 255] }));
  server.close();
});

test('a poster slot wins over the poster', async ({ page }) => {
  await open(page, '<volume-view poster="/favicon.ico"><b slot="poster">Wait for it</b></volume-view>');
  await settle(page);
  await expect(page.getByText('Wait for it')).toBeVisible();
  await expect(page.locator('volume-view img')).toBeHidden();
});

for (const name of ['strict', 'classic']) {
  test.describe(`a strict Content-Security-Policy: ${name}.html`, () => {
    test('is no hindrance', async ({ page, lines }) => {
      const response = await page.goto(`/test/e2e/pages/csp/${name}.html`);
      expect(response!.headers()['content-security-policy']).toContain("default-src 'self'");
      expectSamePicture(await takePicture(page), drawReference());
      await page.locator('.picture').press('+');
      await settle(page);
      expect(compare(await takePicture(page), drawReference()).worst).toBeGreaterThan(20);
      expect(lines).toEqual([]);
    });
  });
}

const dataUrl = `data:application/octet-stream;base64,${Buffer.from(files['field.nii.gz']).toString('base64')}`;

/** A NIfTI file of 8 voxels with 32-bit whole numbers, as the ids of Allen's atlases are. */
function wholeNumbers(values: readonly number[]): Buffer {
  const file = Buffer.alloc(352 + 4 * values.length);
  file.writeInt32LE(348, 0);
  for (const [i, n] of [3, 2, 2, 2, 1, 1, 1, 1].entries()) file.writeInt16LE(n, 40 + 2 * i);
  file.writeInt16LE(8, 70); // int32
  file.writeInt16LE(32, 72);
  for (let i = 0; i < 4; i++) file.writeFloatLE(1, 76 + 4 * i);
  file.writeFloatLE(352, 108);
  file.write('n+1\0', 344, 'latin1');
  for (const [i, value] of values.entries()) file.writeInt32LE(value, 352 + 4 * i);
  return file;
}

test.describe('from disk', () => {
  // The browser's own words on a file that a page from disk may not read.
  test.use({ allowedLines: /^error: (Access to fetch at 'file:|Failed to load resource)/ });

  test('the classic script', async ({ page }, testInfo) => {
    const script = pathToFileURL(join(projectRoot, 'dist/volume-view.iife.js')).href;
    const path = testInfo.outputPath('page.html');
    writeFileSync(
      path,
      `<!doctype html><title>From disk</title><script src="${script}"></script>
    <style>volume-view { width: 120px; height: 90px }</style>${plain.replace(fieldUrl, dataUrl)}`,
    );
    await page.goto(pathToFileURL(path).href);
    expectSamePicture(await takePicture(page), drawReference());
    const missing = await withElement(page, (element) => {
      element.src = 'field.nii';
      return element
        .whenRendered()
        .catch((error: { code: string; message: string }) => `${error.code}: ${error.message}`);
    });
    expect(missing).toMatch(
      /^source\/cross-origin: .*field\.nii can not be read: browsers let a page opened from disk read no files/,
    );
  });

  test('32-bit whole numbers are read exactly, in a worker', async ({ page }, testInfo) => {
    const [workers, parts]: [string[], string[]] = [[], []];
    page.on('worker', (worker) => workers.push(worker.url()));
    page.on('request', (request) => parts.push(request.url()));
    const values = [0, 1, 997, 312_782_546, 312_782_547, 614_454_277, 1_000_000_007, 2_147_483_647];
    const path = testInfo.outputPath('page.html');
    const url = `data:application/octet-stream;base64,${wholeNumbers(values).toString('base64')}`;
    const script = pathToFileURL(join(projectRoot, 'dist/volume-view.iife.js')).href;
    writeFileSync(
      path,
      `<!doctype html><title>From disk</title><script src="${script}"></script>
    <style>volume-view { width: 120px; height: 90px }</style><volume-view src="${url}" alt="Numbers"></volume-view>`,
    );
    await page.goto(pathToFileURL(path).href);
    await settle(page);
    const { range, left } = await withElement(page, ({ volume }) => ({
      range: [...volume!.range],
      left: volume!.left,
    }));
    expect(range).toEqual([0, 2_147_483_647]);
    expect(left, 'nothing is rounded').toBeUndefined();
    // The small worker for usual files does not know such numbers, the whole one does: the page's thread decodes nothing.
    expect(workers.filter((one) => one.startsWith('blob:'))).toHaveLength(2);
    const texts = parts.filter((one) => one.includes('/dist/')).map((one) => readFileSync(fileURLToPath(one), 'utf8'));
    expect(texts.length).toBeGreaterThan(1);
    expect(
      texts.filter((text) => text.includes('The file was read by the page itself') && !text.includes('VERSION=')),
    ).toEqual([]);
  });
});

test('the classic script in a sandboxed frame', async ({ page }) => {
  await page.goto('/test/e2e/pages/sandbox.html');
  const frame = page.frameLocator('iframe');
  const base64 = await frame.locator('volume-view').evaluate(async (element) => {
    const blob = await (element as HTMLElementTagNameMap['volume-view']).toBlob();
    return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
  });
  expectSamePicture(decodePicture(Buffer.from(base64, 'base64')), drawReference());
  expect(await frame.locator('volume-view').evaluate(() => self.origin)).toBe('null');
});

test.describe('a file that a sandboxed frame may not read', () => {
  test.use({ allowedLines: networkLines });

  test('is reported in words that say what to do', async ({ page }) => {
    await open(
      page,
      '<iframe sandbox="allow-scripts" width="400" height="320" title="A field" src="sandbox-refused.html"></iframe>',
    );
    const alert = page.frameLocator('iframe').getByRole('alert');
    await expect(alert).toContainText('field.nii.gz can not be read from this page, which has no origin');
    await expect(alert).toContainText('Access-Control-Allow-Origin: *');
    await expect(alert.getByRole('button', { name: 'Try again' })).toBeVisible();
    expect(
      await page
        .frameLocator('iframe')
        .locator('html')
        .evaluate(() => self.origin),
    ).toBe('null');
  });
});

test('the classic script on a served page', async ({ page }) => {
  await open(page, plain, { script: '<script src="/dist/volume-view.iife.js"></script>' });
  expectSamePicture(await takePicture(page), drawReference());
});

test('data of another origin, with CORS', async ({ page }) => {
  await open(page, plain.replace(fieldUrl, `${process.env.VOLUME_VIEW_CROSS_URL}/cors${fieldUrl}`));
  expectSamePicture(await takePicture(page), drawReference());
});

test('the package from another origin, as from a CDN', async ({ page }) => {
  const workers: string[] = [];
  page.on('worker', (worker) => workers.push(worker.url()));
  await page.goto(`/test/e2e/pages/other-origin.html?${process.env.VOLUME_VIEW_CROSS_URL}/cors/dist/volume-view.js`);
  expectSamePicture(await takePicture(page), drawReference());
  expect(workers[0]).toMatch(/^blob:/);
});

test('data from a blob: URL', async ({ page }) => {
  await open(page, plain.replace(fieldUrl, ''));
  await withElement(
    page,
    (element, base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      element.src = URL.createObjectURL(new Blob([bytes]));
    },
    { argument: Buffer.from(files['field.nii']).toString('base64') },
  );
  expectSamePicture(await takePicture(page), drawReference());
});

test("a page's own X3D scene goes on next to it", async ({ page }) => {
  const scene =
    '<x3d width="80px" height="60px"><scene><shape><appearance><material diffusecolor="0 1 0"></material></appearance><box></box></shape></scene></x3d>';
  const head = '<script src="/dist/x3dom.js"></script><link rel="stylesheet" href="/node_modules/x3dom/x3dom.css">';
  const isDrawn = async (): Promise<boolean> => {
    const [red, green] = (await takeScreenshot(page, 'body > x3d')).data.slice((30 * 80 + 40) * 4);
    return green > red + 10;
  };
  await open(page, scene, { head });
  await expect.poll(isDrawn).toBe(true);
  const alone = await takeScreenshot(page, 'body > x3d');
  await open(page, scene + plain, { head });
  expectSamePicture(await takePicture(page), drawReference());
  await expect.poll(isDrawn).toBe(true);
  expect(compare(await takeScreenshot(page, 'body > x3d'), alone).worst).toBe(0);
});

test.describe("together with a page's own x3dom", () => {
  // x3dom puts hands for a headset into the first scene that it finds.
  test.use({ allowedLines: /<inline> was left out of the picture/ });

  test('a whole scene in it that x3dom has taken before is read as its author wrote it', async ({ page }) => {
    const viewpoint =
      '<viewpoint position="0 80 0" orientation="0 0.70710678 0.70710678 3.14159265" fieldofview="0.5"></viewpoint>';
    const camera = { eye: [0, 80, 0], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: 0.5 } as const;
    const scene = plain.replace('></volume-view>', `><x3d><scene>${viewpoint}</scene></x3d></volume-view>`);
    // The element's script comes when x3dom is done.
    await open(page, scene, { head: '<script src="/dist/x3dom.js"></script>', script: '' });
    await page.waitForFunction(() => document.querySelector('viewpoint')!.hasOwnProperty('getAttribute'));
    await page.addScriptTag({ type: 'module', url: '/dist/volume-view.js' });
    expectSamePicture(await takePicture(page), drawReference({ camera }));
  });
});
