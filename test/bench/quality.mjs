// `npm run bench -- quality`: time to a picture of a given error: as shipped, with each technique off, and plain samples.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { errorSize, readScenes, readSizes, repeats } from './knobs.mjs';
import { median, printTable } from './table.mjs';

const targets = [1, 4];

export async function run() {
  const options = { scenes: readScenes(), sizes: readSizes([512, 800]), targets, repeats, errorSize };
  await measureSource(async ({ machine, openPage }) => {
    const page = await openPage('test/accuracy/page.html');
    const rows = await page.evaluate(
      async ({ module, asked }) => {
        const { measureQuality } = /** @type {typeof import('./quality-page.ts')} */ (await import(module));
        return measureQuality(asked, (what) => /** @type {any} */ (window).sayProgress(what));
      },
      { module: '/test/bench/quality-page.ts', asked: options },
    );
    console.log(
      `\n${nameMachine(machine)}, medians of ${repeats}. Errors: E, the larger of the RMSE over the pixels that the volume covers and an eighth of their 99.9th percentile, of ${errorSize} x ${errorSize} rays in floats, against the scene at very many steps.\n`,
    );
    for (const size of options.sizes)
      for (const target of targets)
        printQuality(
          rows.filter((row) => row.size === size),
          { size, target },
        );
  });
}

/**
 * @param {import('./quality-page.ts').QualityRow[]} rows
 * @param {{ size: number, target: number }} what
 */
function printQuality(rows, { size, target }) {
  printTable(
    `Time to an error of ${target}/255, ${size} x ${size} pixels: ms (steps × the most substeps)`,
    rows.map(({ volume, transferFunction, reached }) => ({
      volume,
      'transfer function': transferFunction,
      ...Object.fromEntries(Object.entries(reached[target]).map(([name, one]) => [name, notify(one)])),
      'plain / shipped': reportRatio(reached[target]),
    })),
  );
  const ratios = rows.map(({ reached }) => ratioOf(reached[target])).filter((ratio) => ratio !== null);
  if (ratios.length === 0) return console.log('plain samples reach it in no scene\n');
  console.log(
    `plain samples / shipped: median ${median(ratios).toFixed(1)}, min ${Math.min(...ratios).toFixed(2)}, of ${ratios.length} of ${rows.length} scenes in which both reach it and are timed\n`,
  );
}

/** @typedef {Readonly<Record<string, import('./quality-page.ts').Reached | null>>} Reaches */

/** @param {import('./quality-page.ts').Reached | null} one */
function notify(one) {
  if (!one) return 'never';
  return `${one.ms === null ? 'too long' : one.ms.toFixed(0)} (${one.steps}${one.substeps ? ` × ${one.substeps}` : ''})`;
}

/** @param {Reaches} reached */
function ratioOf({ shipped, 'plain samples': plain }) {
  return shipped?.ms && plain?.ms ? plain.ms / shipped.ms : null;
}

/** @param {Reaches} reached */
function reportRatio(reached) {
  if (!reached.shipped) return 'never';
  return ratioOf(reached)?.toFixed(2) ?? (reached['plain samples'] ? 'not drawn' : 'only shipped');
}
