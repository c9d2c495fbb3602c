// `npm run bench -- lit`: what light costs, and surfaces alone: frames of the same size and steps, in turns.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { printTable } from './table.mjs';

const steps = 200;

export async function run() {
  const sizes = readSizes([256]);
  await measureSource(async ({ machine, openPage }) => {
    console.log(`${nameMachine(machine)}, ${steps} steps, all pixels have rays, medians of ${repeats} turns`);
    for (const size of sizes) {
      const page = await openPage('test/accuracy/page.html');
      const rows = await page.evaluate(async ({ module, asked }) => {
        const { compareLit } = /** @type {typeof import('./lit-page.ts')} */ (await import(module));
        return compareLit(asked);
      }, { module: '/test/bench/lit-page.ts', asked: { size, steps, turns: repeats } });
      await page.close();
      printTable(`${size} x ${size} pixels`, rows.map(({ scene, unlit, lit, ratio, surfaces }) => ({ scene, 'unlit, ms': unlit.toFixed(0), 'lit, ms': lit.toFixed(0), ratio: ratio.toFixed(2), 'surfaces alone': surfaces?.toFixed(2) ?? '' })));
    }
  });
}
