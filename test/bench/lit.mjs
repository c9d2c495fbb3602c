// `npm run bench -- lit`: what light, surfaces alone, a second field and labels cost: frames of the same size and steps, in turns with plain ones.
// SCENES=mri,mri-surface,ct,ct-skin,radar names some of the scenes, WITH=lit,layer some of what is in them.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { printTable } from './table.mjs';

const steps = 200;

export async function run() {
  const sizes = readSizes([256]);
  await measureSource(async ({ machine, openPage, browser }) => {
    const session = await browser.newBrowserCDPSession();
    console.log(`${nameMachine(machine)}, ${steps} steps, all pixels have rays, medians of ${repeats} turns; processor: time of all cores that the drawing process took`);
    for (const size of sizes) {
      const page = await openPage('test/accuracy/page.html');
      await page.exposeFunction('processorSeconds', async () => {
        const { processInfo } = await session.send('SystemInfo.getProcessInfo');
        return processInfo.find(({ type }) => type === 'GPU')?.cpuTime ?? 0;
      });
      const rows = await page.evaluate(async ({ module, asked }) => {
        const { compareLit } = /** @type {typeof import('./lit-page.ts')} */ (await import(module));
        return compareLit(asked);
      }, { module: '/test/bench/lit-page.ts', asked: { size, steps, turns: repeats, scenes: process.env.SCENES?.split(',') ?? [], variants: process.env.WITH?.split(',') ?? [] } });
      await page.close();
      printTable(`${size} x ${size} pixels`, rows.map(({ scene, variant, plain, shown, ratio, clock }) => ({
        scene, 'with': variant, 'plain, processor, ms': plain.toFixed(0), 'so, processor, ms': shown.toFixed(0), ratio: ratio.toFixed(2), 'by the clock': clock.toFixed(2),
      })));
    }
  });
}
