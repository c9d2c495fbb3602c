// `npm run accuracy`: the study of error and time, in a browser. Prints tables, writes them between the marks of
// docs/accuracy.md, and writes demos/accuracy/results.json, which the demo page shows. All but the times come out the
// same on the same browser. VOLUME_VIEW_GPU=1 takes the GPU instead of software GL; SIZE=256 measures errors on more
// pixels; SCENES=mni152,ct-phantom takes some of the volumes; DRY=1 writes nothing.
import { existsSync, writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
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

// Changes of files by others must not reload the page while it measures.
const server = await createServer({
  root: projectRoot,
  logLevel: 'error',
  cacheDir: 'node_modules/.vite-accuracy',
  server: { port: 0, open: false, hmr: false, watch: null },
});
await server.listen();
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
try {
  const url = server.resolvedUrls?.local[0];
  if (!url) throw new Error('vite says no address');
  const page = await browser.newPage();
  page.on('pageerror', (error) => console.error(error));
  const began = performance.now();
  await page.exposeFunction('sayProgress', (/** @type {number} */ share, /** @type {string} */ what) => {
    process.stderr.write(`\r\u001b[K${Math.round((performance.now() - began) / 1000)} s, ${Math.round(share * 100)} %, ${what}`);
  });
  await page.goto(`${url}test/accuracy/page.html`);
  const loadBefore = loadavg()[0];
  const { results, tables, headline, found } = await page.evaluate(async ({ options: asked, modules, note }) => {
    const [study, tableModule, findings] = await Promise.all(modules.map((name) => import(name)));
    const measured = await study.runStudy({
      ...asked,
      signal: new AbortController().signal,
      onProgress: (/** @type {number} */ share, /** @type {string} */ what) => /** @type {any} */ (window).sayProgress(share, what),
    });
    measured.where.note = note;
    const list = tableModule.listTables(measured);
    return {
      results: measured,
      headline: /** @type {string} */ (findings.describeResults(measured)),
      found: /** @type {string} */ (findings.listFindings(measured)),
      tables: list.map((/** @type {any} */ table) => ({ ...table, markdown: tableModule.toMarkdown(table) })),
    };
  }, { options, modules: ['/demos/accuracy/study.ts', '/demos/accuracy/tables.ts', '/demos/accuracy/findings.ts'], note: `${cpus().length} cores (${cpus()[0].model.trim()}).` });
  // The browser alone keeps one core per thread of its software GL busy.
  const busiest = Math.max(loadBefore, loadavg()[0] - cpus().length);
  if (busiest > 0.5 * cpus().length) results.where.note += ` The machine was busy with other work, which blurs the times (load ${busiest.toFixed(0)}).`;

  process.stderr.write('\r\u001b[K');
  console.log(`${browser.version()}, ${results.where.renderer}, ${results.where.note}`);
  console.log(`${headline}\n\n${found}\n`);
  for (const { title, markdown } of tables) console.log(`${title}\n\n${markdown}\n`);
  for (const name of results.leftOut) console.log(`left out: ${name} (needs ../shared/data)`);
  process.stderr.write('orders of convergence, in float64 …');
  const orders = await measureOrders();
  process.stderr.write('\r\u001b[K');
  if (orders) console.log(`Orders of convergence\n\n${orders}\n`);

  if (process.env.DRY !== '1') {
    writeFileSync(join(projectRoot, 'demos/accuracy/results.json'), `${JSON.stringify(results)}\n`);
    const where = `Measured with Chromium ${browser.version()}, ${results.where.renderer}; ${results.where.note} Errors at ${results.size} × ${results.size} pixels, times at ${results.timeSize} × ${results.timeSize}${results.where.software ? ', in software: they tell proportions, not what a device takes' : ''}.`;
    fillMarks(join(projectRoot, 'docs/accuracy.md'), {
      where,
      headline,
      findings: found,
      ...Object.fromEntries(tables.map((/** @type {any} */ { id, title, markdown }) => [id, `${title}.\n\n${markdown}`])),
      ...(orders ? { orders } : {}),
    });
    for (const { file, ...what } of sheets) {
      const image = await page.evaluate(async (asked) => {
        const { drawSheet } = await import(asked.module);
        return /** @type {string} */ ((await drawSheet({ ...asked, size: 250 })).toDataURL('image/webp', 0.9));
      }, { ...what, module: '/demos/accuracy/sheet.ts' });
      writeFileSync(join(projectRoot, `docs/images/${file}.webp`), Buffer.from(image.split(',')[1], 'base64'));
    }
    console.log('written: demos/accuracy/results.json, docs/accuracy.md, docs/images/accuracy-*.webp');
  }
  console.log(`${Math.round((performance.now() - began) / 1000)} s`);
} finally {
  await browser.close();
  await server.close();
}

/** The observed orders of convergence as a table, where the program for them is there. */
async function measureOrders() {
  const file = join(projectRoot, 'test/accuracy/orders.ts');
  if (!existsSync(file)) return null;
  const { measureOrders: measure } = /** @type {typeof import('./orders.ts')} */ (await server.ssrLoadModule(file));
  const range = (/** @type {readonly number[]} */ values) => [values[0], values[values.length - 1]].map((x) => Number(x.toPrecision(3))).join(' … ');
  return [
    '| refined | by | transfer function | counts | RMSE, 1/255 | order |',
    '| --- | --- | --- | --- | --- | --: |',
    ...measure().map(({ study, by, transferFunction, counts, errors, order }) =>
      `| ${[study, by, transferFunction, range(counts), range(errors.map((error) => error * 255)), order.toFixed(2)].join(' | ')} |`),
  ].join('\n');
}
