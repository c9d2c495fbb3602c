// `npm run bench -- phases`: a page's first element from its script to its first and its final picture, phase by phase.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { startStaticServer } from '../../scripts/static-server.mjs';
import { repeats } from './knobs.mjs';
import { listScenes } from './page.mjs';
import { median, printTable } from './table.mjs';
import { loadByPhases, watchPhases } from './watch-phases.mjs';

const pixels = 512;

/** Columns of the table, and what the page calls them. */
const columns = {
  script: 'script',
  x3dom: 'x3dom',
  'worker ready': 'worker ready',
  fetch: 'first bytes',
  decode: 'decoding',
  'worker coarse': 'stand-in',
  'worker done': 'counted',
  scene: 'context',
  linked: 'linked',
  first: 'first picture',
  load: 'uploaded',
  probing: 'probing',
  final: 'final picture',
};

/** Another checkout, built, whose package is measured in turns with this one's. */
const before = process.env.BEFORE;

export async function run() {
  const old = before ? await startStaticServer({ root: before }) : null;
  try {
    await measurePackage(async ({ url, machine, openPage }) => {
      const builds = [...(old ? [{ name: ', before', url: `${old.url}/` }] : []), { name: '', url }];
      const rows = [];
      for (const { name, attributes } of listScenes()) {
        /** @type {Record<string, number>[][]} */
        const loads = builds.map(() => []);
        for (let i = 0; i < repeats; i++) {
          for (const [build, { url: at }] of builds.entries()) {
            const page = await openPage(`${at}test/bench/empty.html`, { before: watchPhases });
            loads[build].push(await page.evaluate(loadByPhases, { attributes, pixels }));
            await page.close();
          }
        }
        for (const [build, { name: which }] of builds.entries())
          rows.push({ scene: `${name}${which}`, ...sumUp(loads[build]) });
      }
      console.log(`\n${nameMachine(machine)}, medians of ${repeats}, ${pixels} x ${pixels} pixels\n`);
      printTable(
        'From the script on, ms, the first time that each phase begins (x3dom, worker, counted, linked, uploaded, pictures: is done)',
        rows,
      );
    });
  } finally {
    old?.close();
  }
}

/** @param {Record<string, number>[]} loads */
function sumUp(loads) {
  const of = (/** @type {string} */ phase) => {
    const times = loads.map((load) => load[phase]).filter((time) => time !== undefined);
    return times.length > 0 ? median(times).toFixed(0) : '-';
  };
  return Object.fromEntries(Object.entries(columns).map(([phase, title]) => [title, of(phase)]));
}
