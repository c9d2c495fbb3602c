// `npm run bench:radar`: a radar scan in its own geometry against the usual resampling to cartesian cells: error and time of
// pictures with the same step. Prints a table; run it on a machine that does nothing else.
import { cpus } from 'node:os';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';
import { findSharedData, projectRoot } from '../../scripts/shared-data.mjs';
import { printTable } from './table.mjs';

const repeats = Number(process.env.REPEATS ?? 5);
const size = Number(process.env.SIZE ?? 512);
const scans = [
  { name: 'storm, synthetic', url: '/demos/data/storm-radar-1510.json' },
  { name: 'Captains Flat, 2018-12-20', url: '/shared-data/radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5' },
];

const server = await createServer({ root: projectRoot, logLevel: 'error', cacheDir: 'node_modules/.vite-bench', server: { port: 0, open: false, hmr: false, watch: null } });
await server.listen();
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
try {
  const url = server.resolvedUrls?.local[0];
  if (!url) throw new Error('vite says no address');
  const page = await browser.newPage();
  page.on('pageerror', (error) => console.error(error));
  await page.goto(`${url}test/accuracy/page.html`);
  console.log(`Chromium ${browser.version()}, ${cpus().length} cores (${cpus()[0].model.trim()}), ${size} x ${size} pixels, steps of 1 km, medians of ${repeats}`);
  for (const scan of scans) {
    if (scan.url.startsWith('/shared-data/') && !findSharedData(scan.url)) {
      console.log(`left out: ${scan.name} (needs ../shared/data)`);
      continue;
    }
    const rows = await page.evaluate(async ({ module, asked, pixels, times }) => {
      const { compareResamplings } = await import(module);
      return /** @type {import('./radar-page.ts').Resampling[]} */ (await compareResamplings(asked, [2000, 1000, 500], pixels, times));
    }, { module: '/test/bench/radar-page.ts', asked: scan.url, pixels: size, times: repeats });
    const native = rows[0].ms;
    printTable(
      scan.name,
      rows.map(({ name, size: grid, megabytes, rms, p99, ms }) => ({
        grid: name, size: grid, MB: megabytes.toFixed(1), 'RMSE, 1/255': rms.toFixed(2), P99: p99.toFixed(1), ms: ms.toFixed(0), 'ms / native': (ms / native).toFixed(2),
      })),
    );
  }
} finally {
  await browser.close();
  await server.close();
}
