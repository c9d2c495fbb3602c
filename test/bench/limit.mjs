// `npm run bench -- limit`: our time over that of a loop that only fetches the samples that show, one a voxel.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { errorSize, readScenes, readSizes, repeats } from './knobs.mjs';
import { median, printTable } from './table.mjs';

const targets = [1, 4];

export async function run() {
  const options = { scenes: readScenes(), sizes: readSizes([512]), targets, repeats, errorSize };
  await measureSource(async ({ machine, openPage }) => {
    const page = await openPage('test/accuracy/page.html');
    const rows = await page.evaluate(
      async ({ module, asked }) => {
        const { measureLimits } = /** @type {typeof import('./limit-page.ts')} */ (await import(module));
        const measured = await measureLimits(asked, (what) => /** @type {any} */ (window).sayProgress(what));
        return measured.map((row) => ({ ...row, reached: Object.fromEntries(row.reached) }));
      },
      { module: '/test/bench/limit-page.ts', asked: options },
    );
    console.log(`\n${nameMachine(machine)}, medians of ${repeats}\n`);
    printTable(
      'Time divided by that of a loop that only fetches the visible samples, one per voxel',
      rows.map((row) => ({
        volume: row.volume,
        'transfer function': row.transferFunction,
        pixels: `${row.size} x ${row.size}`,
        'rays that show something': `${(row.rays * 100).toFixed(0)} %`,
        'samples per ray': row.samples.toFixed(0),
        'fetch, ms': row.ms.toFixed(1),
        ...Object.fromEntries(
          targets.flatMap((target) => {
            const one = row.reached[target];
            return [
              [`ours to ${target}/255, ms`, one ? one.ms.toFixed(1) : 'never'],
              [`over fetch, ${target}/255`, one ? (one.ms / row.ms).toFixed(2) : ''],
            ];
          }),
        ),
      })),
    );
    for (const target of targets) {
      const ratios = rows.map(({ reached, ms }) => (reached[target]?.ms ?? NaN) / ms).filter(Number.isFinite);
      if (ratios.length > 0)
        console.log(
          `ours to ${target}/255 over fetch: median ${median(ratios).toFixed(2)}, max ${Math.max(...ratios).toFixed(2)}`,
        );
    }
  });
}
