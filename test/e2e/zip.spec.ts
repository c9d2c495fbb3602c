// The zip that one unpacks on a web server, and the page for frames.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { FrameLocator, Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { findFaults } from './helpers/axe.ts';
import { expect, fewPixels, fieldUrl, open, settle, takePicture, test } from './helpers/harness.ts';

test.use(fewPixels);

/** Unpack what `npm run zip` makes. */
function unpackInto(folder: string): string[] {
  mkdirSync(folder, { recursive: true });
  const file = join(folder, 'made.zip');
  const { status, stderr } = spawnSync(process.execPath, [join(projectRoot, 'scripts/make-zip.mjs'), '--out', file], {
    encoding: 'utf8',
  });
  expect(status, stderr).toBe(0);
  const files = unzipSync(new Uint8Array(readFileSync(file)));
  for (const [name, bytes] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), bytes);
  }
  return Object.keys(files);
}

/** A narrow window, where the sample's picture is small. */
const viewport = { width: 240, height: 480 };

test.describe('from disk', () => {
  test.use({ viewport });
  // axe wants to read the style sheet, which a page from disk may not.
  test.use({ allowedLines: /Access to XMLHttpRequest at 'file:.*index\.css|load preload assets|net::ERR_FAILED/ });

  test('the zip, unpacked, shows its sample at once, also from disk', async ({ page }, testInfo) => {
    const folder = testInfo.outputPath('zip');
    const names = unpackInto(folder);
    for (const name of [
      'index.html',
      'embed.html',
      'volume-view.js',
      'volume-view.iife.js',
      'x3dom.js',
      'sample.nii.gz',
      'LICENSE',
      'THIRD-PARTY-LICENSES.txt',
    ]) {
      expect(names).toContain(`volume-view/${name}`);
    }
    await page.goto(pathToFileURL(join(folder, 'volume-view/index.html')).href);
    const picture = await takePicture(page);
    const shown = Array.from({ length: picture.data.length / 4 }, (_, i) => picture.data[4 * i + 3]).filter(
      (alpha) => alpha > 128,
    ).length;
    expect(shown / (picture.data.length / 4)).toBeGreaterThan(0.1);
    expect(await findFaults(page)).toEqual([]);
  });
});

test.describe('from a plain static server', () => {
  test.use({ viewport });

  test('the zip shows its sample, and its page for frames any volume next to it', async ({ page }, testInfo) => {
    const folder = testInfo.outputPath('served');
    unpackInto(folder);
    const asked: string[] = [];
    // Files by their path, and nothing else: no listing, no fallback.
    await page.route('http://static.test/**', async (route) => {
      const { pathname } = new URL(route.request().url());
      const path = join(folder, decodeURIComponent(pathname.endsWith('/') ? `${pathname}index.html` : pathname));
      asked.push(pathname);
      await (existsSync(path) ? route.fulfill({ path }) : route.fulfill({ status: 404 }));
    });
    for (const path of ['index.html', '', 'embed.html?src=sample.nii.gz&alt=Sample&controls']) {
      await page.goto(`http://static.test/volume-view/${path}`);
      const picture = await takePicture(page);
      const shown = Array.from({ length: picture.data.length / 4 }, (_, i) => picture.data[4 * i + 3]).filter(
        (alpha) => alpha > 128,
      ).length;
      expect(shown / (picture.data.length / 4), path).toBeGreaterThan(0.1);
    }
    expect(asked.filter((path) => !path.startsWith('/volume-view/') && path !== '/favicon.ico')).toEqual([]);
  });
});

test.describe('the page for frames', () => {
  test.use({ bypassCSP: true }); // For axe, which is put into the page.

  /** A frame as a site has it that trusts nobody. */
  const openFrame = async (
    page: Page,
    query: string,
    data = `${process.env.VOLUME_VIEW_CROSS_URL}/cors${fieldUrl}`,
  ): Promise<FrameLocator> => {
    await open(
      page,
      `<iframe sandbox="allow-scripts" width="320" height="240" title="A field" src="/dist/embed.html?src=${encodeURIComponent(data)}&${query}"></iframe>`,
    );
    return page.frameLocator('iframe');
  };

  test('shows a volume in a sandboxed frame, as large as that, with what its address says', async ({ page }) => {
    const frame = await openFrame(
      page,
      'alt=A+field&transfer-function=gray&steps=40&legend&onload=alert(1)&style=color:red',
    );
    const view = frame.locator('volume-view');
    await expect(frame.locator('volume-legend')).toBeVisible();
    await expect(frame.locator('.hint li')).toHaveText([/^"onload" is no attribute/, /^"style" is no attribute/]);
    await view.evaluate((element) => (element as HTMLElementTagNameMap['volume-view']).whenRendered());
    expect(await view.evaluate((element) => [element.getAttributeNames(), element.clientWidth, self.origin])).toEqual([
      ['src', 'transfer-function', 'steps', 'alt'],
      320,
      'null',
    ]);
    expect(
      await frame
        .locator('html')
        .evaluate(() => [document.title, document.documentElement.scrollHeight <= innerHeight]),
    ).toEqual(['A field', true]);
  });

  test('says what is missing', async ({ page }) => {
    await page.goto('/dist/embed.html');
    await expect(page.getByText('embed.html?src=scan.nii.gz')).toBeVisible();
    expect(await findFaults(page)).toEqual([]);
  });

  test('is a page like others on its own server', async ({ page }) => {
    await page.goto(`/dist/embed.html?src=${fieldUrl}&alt=A%20field&controls&lang=de`);
    await settle(page);
    await expect(page.locator('html')).toHaveAttribute('lang', 'de');
    await expect(page.locator('volume-view')).toHaveAttribute('controls', '');
  });
});
