// `npm run accuracy`: the study of error and time, in a browser. Prints tables, writes them between the marks of
// docs/numbers/accuracy.md, and writes demos/accuracy/results.json, which the demo page shows. All but the times come out the
// same on the same browser. VOLUME_VIEW_GPU=1 takes the GPU instead of software GL; SIZE=256 measures errors on more
// pixels; SCENES=mni152,ct-phantom takes some of the volumes; DRY=1 writes nothing.
import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { measureSource } from '../helpers/measure-in-browser.mjs';
import { fillMarks } from './fill-marks.mjs';

const scenes = (process.env.SCENES ?? 'mni152,ct-phantom,aorta,cranium').split(',');
const options = {
  scenes,
  timed: scenes.filter((id) => id === 'mni152' || id === 'ct-phantom'),
  size: Number(process.env.SIZE ?? 128),
  timeSize: Number(process.env.TIME_SIZE ?? 256),
  repeats: Number(process.env.REPEATS ?? 5),
};

/** Pictures for the docs and the page: what they show, and the file's name. */
const sheets = [
  { file: 'accuracy-sheet', scene: 'mni152', fn: 'peaks', steps: 80 },
  { file: 'accuracy-sheet-smooth', scene: 'mni152', fn: 'smooth', steps: 80 },
  { file: 'accuracy-sheet-step', scene: 'ct-phantom', fn: 'step', steps: 80 },
].filter(({ scene }) => scenes.includes(scene));

export const run = () =>
  measureSource(async ({ machine, vite, openPage }) => {
    const page = await openPage('test/accuracy/page.html');
    const began = performance.now();
    const { results, tables, headline, found } = await page.evaluate(
      async ({ options: asked, modules, note }) => {
        const [study, tableModule, findings] = await Promise.all(modules.map((name) => import(name)));
        const measured = await study.runStudy({
          ...asked,
          signal: new AbortController().signal,
          onProgress: (/** @type {number} */ share, /** @type {string} */ what) =>
            /** @type {any} */ (window).sayProgress(`${Math.round(share * 100)} %, ${what}`),
        });
        measured.where.note = note;
        const list = tableModule.listTables(measured);
        return {
          results: measured,
          headline: /** @type {string} */ (findings.describeResults(measured)),
          found: /** @type {string} */ (findings.listFindings(measured)),
          tables: list.map((/** @type {any} */ table) => ({ ...table, markdown: tableModule.toMarkdown(table) })),
        };
      },
      {
        options,
        modules: ['/demos/accuracy/study.ts', '/demos/accuracy/tables.ts', '/demos/accuracy/findings.ts'],
        note: `${machine.cores}.`,
      },
    );
    if (machine.busy) results.where.note += ' The machine was busy with other work, which blurs the times.';

    process.stderr.write('\r\u001b[K');
    console.log(`${machine.browser}, ${results.where.renderer}, ${results.where.note}`);
    console.log(`${headline}\n\n${found}\n`);
    for (const { title, markdown } of tables) console.log(`${title}\n\n${markdown}\n`);
    for (const name of results.leftOut) console.log(`left out: ${name} (needs ../shared/data)`);
    process.stderr.write('orders of convergence, in float64 …');
    const orders = await measureOrders(vite);
    process.stderr.write('\r\u001b[K');
    if (orders) console.log(`Orders of convergence\n\n${orders}\n`);

    if (process.env.DRY !== '1') {
      writeFileSync(join(projectRoot, 'demos/accuracy/results.json'), `${JSON.stringify(results)}\n`);
      const where = `Measured with ${machine.browser}, ${results.where.renderer}; ${results.where.note} Errors at ${results.size} × ${results.size} pixels, times at ${results.timeSize} × ${results.timeSize}${results.where.software ? ', in software: they show proportions, not the speed of a device' : ''}.`;
      fillMarks(join(projectRoot, 'docs/numbers/accuracy.md'), {
        where,
        headline,
        findings: found,
        ...Object.fromEntries(
          tables.map((/** @type {any} */ { id, title, markdown }) => [id, `${title}.\n\n${markdown}`]),
        ),
        ...(orders ? { orders } : {}),
      });
      for (const { file, ...what } of sheets) {
        const image = await page.evaluate(
          async (asked) => {
            const { drawSheet } = await import(asked.module);
            return /** @type {string} */ ((await drawSheet({ ...asked, size: 250 })).toDataURL('image/webp', 0.9));
          },
          { ...what, module: '/demos/accuracy/sheet.ts' },
        );
        writeFileSync(join(projectRoot, `docs/images/${file}.webp`), Buffer.from(image.split(',')[1], 'base64'));
      }
      console.log('written: demos/accuracy/results.json, docs/numbers/accuracy.md, docs/images/accuracy-*.webp');
    }
    console.log(`${Math.round((performance.now() - began) / 1000)} s`);
  });

/**
 * The observed orders of convergence as a table, where the program for them is there.
 * @param {import('vite').ViteDevServer} vite
 */
async function measureOrders(vite) {
  const file = join(projectRoot, 'test/accuracy/orders.ts');
  if (!existsSync(file)) return null;
  const { measureOrders: measure } = /** @type {typeof import('./orders.ts')} */ (await vite.ssrLoadModule(file));
  const range = (/** @type {readonly number[]} */ values) =>
    [values[0], values[values.length - 1]].map((x) => Number(x.toPrecision(3))).join(' … ');
  return [
    '| refined | by | transfer function | counts | RMSE, 1/255 | order |',
    '| --- | --- | --- | --- | --- | --: |',
    ...measure().map(
      ({ study, by, transferFunction, counts, errors, order }) =>
        `| ${[study, by, transferFunction, range(counts), range(errors.map((error) => error * 255)), order.toFixed(2)].join(' | ')} |`,
    ),
  ].join('\n');
}
