// `npm run bench -- motion`: what is seen while a camera moves, where there is time for a fraction of the picture: the same work spent on
// pixels or on steps, and what the controller makes of it. It needs no clock. SIZES=400 SCENES=mri,ct,radar make a quick run.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes } from './knobs.mjs';
import { printTable } from './table.mjs';

export async function run() {
  await measureSource(async ({ machine, openPage }) => {
    console.log(nameMachine({ ...machine, busy: false }));
    for (const size of readSizes([800])) {
      const page = await openPage('test/accuracy/page.html');
      const rows = await page.evaluate(
        async ({ module, asked }) => {
          const { compareMotion } = /** @type {typeof import('./motion-page.ts')} */ (await import(module));
          return compareMotion(asked, (what) => /** @type {any} */ (window).sayProgress(what));
        },
        { module: '/test/bench/motion-page.ts', asked: { size, scenes: process.env.SCENES?.split(',') ?? [] } },
      );
      await page.close();
      printTable(
        `Errors of moving frames that cost the same, ${size} x ${size} pixels, 1/255`,
        rows.map(({ scene, pixels, steps, isChosen, rms, p99, silhouette }) => ({
          scene,
          'pixels, steps': `${pixels} x ${pixels}, ${steps}${isChosen ? ' (chosen)' : ''}`,
          RMS: rms.toFixed(1),
          '99 %': p99.toFixed(0),
          silhouettes: silhouette.toFixed(1),
        })),
      );
    }
  });
}
