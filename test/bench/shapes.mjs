// `npm run bench -- shapes`: what shapes and lines among a volume, and labels of it, cost in motion: frames of the same size, steps and limit of
// curvature with them and without, in turns.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { printTable } from './table.mjs';

const [steps, maxCurvature] = [64, 24];

/** Frames of each kind: the machine may do other things meanwhile. */
const turns = 2 * repeats;

export async function run() {
  const sizes = readSizes([512]);
  await measureSource(async ({ machine, openPage, browser }) => {
    const session = await browser.newBrowserCDPSession();
    console.log(`${nameMachine(machine)}, ${steps} steps, curvature of at most ${maxCurvature}/255 between rays, medians of ${turns} turns with 4 frames of each; processor: time of all cores that the drawing process took`);
    for (const size of sizes) {
      const page = await openPage('test/accuracy/page.html');
      await page.exposeFunction('processorSeconds', async () => {
        const { processInfo } = await session.send('SystemInfo.getProcessInfo');
        return processInfo.find(({ type }) => type === 'GPU')?.cpuTime ?? 0;
      });
      const rows = await page.evaluate(async ({ module, asked }) => {
        const { compareShapes } = /** @type {typeof import('./shapes-page.ts')} */ (await import(module));
        return compareShapes(asked);
      }, { module: '/test/bench/shapes-page.ts', asked: { size, steps, maxCurvature, turns } });
      await page.close();
      printTable(`${size} x ${size} pixels`, rows.map(({ scene, shapes, ms, ratio, work, workRatio, allRays, share }) => ({
        scene, shapes,
        ms: ms.toFixed(0), 'over none': ratio.toFixed(2),
        'processor, ms': work.toFixed(0), 'over none ': workRatio.toFixed(3), 'with all rays': allRays.toFixed(0),
        'quads with rays for shapes': `${(100 * share).toFixed(1)} %`,
      })));
    }
  });
}
