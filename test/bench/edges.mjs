// `npm run bench -- edges`: what smooth edges of surfaces cost at rest: pictures in turns with the same ones with one ray a pixel.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { printTable } from './table.mjs';

export async function run() {
  const sizes = readSizes([512]);
  await measureSource(async ({ machine, openPage, browser }) => {
    const session = await browser.newBrowserCDPSession();
    console.log(`${nameMachine(machine)}, steps of a voxel, medians of ${repeats} turns; processor: time of all cores that the drawing process took`);
    for (const size of sizes) {
      const page = await openPage('test/accuracy/page.html');
      await page.exposeFunction('processorSeconds', async () => {
        const { processInfo } = await session.send('SystemInfo.getProcessInfo');
        return processInfo.find(({ type }) => type === 'GPU')?.cpuTime ?? 0;
      });
      const rows = await page.evaluate(async ({ module, asked }) => {
        const { compareEdges } = /** @type {typeof import('./edges-page.ts')} */ (await import(module));
        return compareEdges(...asked);
      }, { module: '/test/bench/edges-page.ts', asked: /** @type {[number, number, string[]]} */ ([size, repeats, process.env.SCENES?.split(',') ?? []]) });
      await page.close();
      printTable(`${size} x ${size} pixels`, rows.map(({ scene, edges, ofSeen, plain, ratio, clock }) => ({
        scene, 'pixels with edges': `${(100 * edges).toFixed(1)} %`, 'of those seen': `${(100 * ofSeen).toFixed(0)} %`,
        'one ray, processor, ms': plain.toFixed(0), ratio: ratio.toFixed(2), 'by the clock': clock.toFixed(2),
      })));
    }
  });
}
