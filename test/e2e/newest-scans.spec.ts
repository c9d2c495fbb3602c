import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { runnerImport } from 'vite';
import type * as SitePages from '../../packages/prepare/src/site-pages.ts';
import type { DoneLine } from '../../packages/prepare/src/job.ts';
import { expect, test } from './helpers/harness.ts';
import type { VolumeView } from '../../src/index.ts';

// The page of `volume-view-prepare --watch`: an open page takes new scans, and leaves a reader where he is.

const root = join(import.meta.dirname, '../..');
const line = { format: 'ODIM_H5', dimensions: [60, 360, 14], unit: 'dBZ' } as unknown as DoneLine;
const scanAt = (minutes: string): object => ({
  ...(JSON.parse(readFileSync(join(root, `demos/data/storm-radar-${minutes}.json`), 'utf8')) as object),
  image: `/demos/data/storm-radar-${minutes}.png`,
});

test('an open page of newest scans shows the next one, and leaves who looks at another scan there', async ({
  page,
}) => {
  const { module } = await runnerImport<typeof SitePages>(join(root, 'packages/prepare/src/site-pages.ts'), {
    configFile: false,
    logLevel: 'error',
    root,
  });
  let list = ['1500', '1510'];
  await page.route('**/site/**', (route) => {
    const { pathname } = new URL(route.request().url());
    if (pathname.endsWith('.html'))
      return route.fulfill({
        contentType: 'text/html',
        body: module.writeRollingPage('Storm', line, { seconds: 0.2, hasPoster: false }),
      });
    if (pathname.endsWith('scans.json')) return route.fulfill({ json: { scans: list.map(scanAt) } });
    return route.continue({ url: route.request().url().replace('/site/', '/dist/') });
  });
  const shown = (): Promise<string | undefined> =>
    page.evaluate(() => document.querySelector<VolumeView>('volume-view')?.scan?.time?.slice(11, 16));
  await page.goto('/site/newest/index.html');
  await expect.poll(shown).toBe('15:10');
  list = ['1500', '1510', '1520'];
  await expect.poll(shown, 'the newest one follows').toBe('15:20');
  const view = page.locator('volume-view');
  await view.evaluate((one: VolumeView) => one.showScan(1));
  await expect.poll(shown).toBe('15:10');
  list = ['1510', '1520'];
  await expect.poll(() => view.evaluate((one: VolumeView) => one.times.length)).toBe(2);
  await view.evaluate((one: VolumeView) => one.whenRendered());
  expect(await shown(), 'the reader stays at his scan').toBe('15:10');
});
