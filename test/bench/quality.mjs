// `npm run bench:quality`: time to a picture of a given error: as shipped, with each technique off, and plain samples.
// Prints a table for each error; run it on a machine that does nothing else (ten minutes with software GL).
// VOLUME_VIEW_GPU=1 takes the GPU; SIZE=800, REPEATS=5.
import { cpus } from 'node:os';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { median, printTable } from './table.mjs';

const options = { size: Number(process.env.SIZE ?? 512), errorSize: 128, repeats: Number(process.env.REPEATS ?? 5) };
const targets = (process.env.TARGETS ?? '1,4').split(',').map(Number);

const server = await createServer({ root: projectRoot, logLevel: 'error', cacheDir: 'node_modules/.vite-bench', server: { port: 0, open: false, hmr: false, watch: null } });
await server.listen();
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
try {
  const url = server.resolvedUrls?.local[0];
  if (!url) throw new Error('vite says no address');
  const page = await browser.newPage();
  page.on('pageerror', (error) => console.error(error));
  await page.exposeFunction('sayProgress', (/** @type {string} */ what) => process.stderr.write(`\r\u001b[K${what}`));
  await page.goto(`${url}test/accuracy/page.html`);
  for (const target of targets) {
    const { renderer, rows } = await page.evaluate(async ({ module, asked }) => {
      const { measureQuality } = await import(module);
      return /** @type {{ renderer: string, rows: import('./quality-page.ts').QualityRow[] }} */ (
        await measureQuality(asked, (/** @type {string} */ what) => /** @type {any} */ (window).sayProgress(what)));
    }, { module: '/test/bench/quality-page.ts', asked: { ...options, target } });
    process.stderr.write('\r\u001b[K');
    console.log(`Chromium ${browser.version()}, ${renderer}, ${cpus().length} cores (${cpus()[0].model.trim()}), ${options.size} x ${options.size} pixels, medians of ${options.repeats}`);
    const techniques = Object.keys(rows[0].reached);
    printTable(`Time to an error of ${target}/255 RMSE: ms (steps)`, rows.map(({ volume, transferFunction, reached }) => ({
      volume,
      'transfer function': transferFunction,
      ...Object.fromEntries(techniques.map((name) => [name, tell(reached[name])])),
      'plain / shipped': ratio(reached),
    })));
    const ratios = rows.map(({ reached }) => Number(ratio(reached))).filter(Number.isFinite);
    console.log(`plain samples / shipped: median ${median(ratios).toFixed(1)}, least ${Math.min(...ratios).toFixed(2)}, of ${ratios.length} scenes in which both reach it\n`);
  }
} finally {
  await browser.close();
  await server.close();
}

/** @param {import('./quality-page.ts').Reached | null} reached */
function tell(reached) {
  return reached ? `${reached.ms.toFixed(0)} (${reached.steps})` : 'never';
}

/** @param {import('./quality-page.ts').QualityRow['reached']} reached */
function ratio(reached) {
  const [plain, shipped] = [reached['plain samples'], reached.shipped];
  if (!shipped) return 'never';
  return plain ? (plain.ms / shipped.ms).toFixed(2) : 'only shipped';
}
