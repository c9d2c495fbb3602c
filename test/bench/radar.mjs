// `npm run bench -- radar`: a radar scan in its own geometry against the usual resampling to cartesian cells: error and
// time of pictures with the same step.
import { findSharedData } from '../../scripts/shared-data.mjs';
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { printTable } from './table.mjs';

const scans = [
  { name: 'storm, synthetic', url: '/demos/data/storm-radar-1510.json' },
  { name: 'Captains Flat, 2018-12-20', url: '/shared-data/radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5' },
];

export async function run() {
  const [size] = readSizes([512]);
  await measureSource(async ({ machine, openPage }) => {
    const page = await openPage('test/accuracy/page.html');
    console.log(`${nameMachine(machine)}, ${size} x ${size} pixels, steps of 1 km, medians of ${repeats}`);
    for (const scan of scans) {
      if (scan.url.startsWith('/shared-data/') && !findSharedData(scan.url)) {
        console.log(`left out: ${scan.name} (needs ../shared/data)`);
        continue;
      }
      const rows = await page.evaluate(
        async ({ module, asked, pixels, times }) => {
          const { compareResamplings } = /** @type {typeof import('./radar-page.ts')} */ (await import(module));
          return compareResamplings(asked, [2000, 1000, 500], pixels, times);
        },
        { module: '/test/bench/radar-page.ts', asked: scan.url, pixels: size, times: repeats },
      );
      const native = rows[0].ms;
      printTable(
        scan.name,
        rows.map(({ name, size: grid, megabytes, rms, p99, ms }) => ({
          grid: name,
          size: grid,
          MB: megabytes.toFixed(1),
          'RMSE, 1/255': rms.toFixed(2),
          P99: p99.toFixed(1),
          ms: ms.toFixed(0),
          'ms / native': (ms / native).toFixed(2),
        })),
      );
    }
  });
}
