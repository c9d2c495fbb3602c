// `npm run bench -- load`: from the last byte to the first and to the final picture, what blocks the page meanwhile, and
// the peak of memory. SIZES are voxels along each edge of a cube of 16 bit.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { readHeap } from './read-heap.mjs';
import { makeNifti } from './synthetic-nifti.mjs';
import { formatMegabytes, median, printTable } from './table.mjs';
import { watchMemory } from './watch-memory.mjs';
import { watchTasks } from './watch-tasks.mjs';

const pixels = 512;

/** @typedef {{ bytesIn: number, loaded: number, first: number, final: number, longestTask: number }} Load - ms since the element was put in, and the longest task */

/**
 * In the page.
 * @param {{ src: string, pixels: number }} what
 * @returns {Promise<Load>}
 */
async function loadInPage({ src, pixels: size }) {
  await customElements.whenDefined('volume-view');
  const element = document.createElement('volume-view');
  element.setAttribute('src', src);
  element.style.cssText = `width: ${size}px; height: ${size}px; max-height: none; aspect-ratio: auto`;
  /** @type {Record<string, number>} */
  const at = {};
  element.addEventListener('progress', ({ detail }) => {
    if (detail.phase === 'fetch') at.bytesIn = performance.now();
  });
  element.addEventListener('load', () => (at.loaded = performance.now()));
  element.addEventListener('render', () => (at.first ??= performance.now()));
  /** @type {any} */ (window).longestTask = 0;
  const began = performance.now();
  document.body.append(element);
  await element.whenRendered();
  at.final = performance.now();
  await new Promise((resolve) => setTimeout(resolve, 100)); // Observers are told of tasks a little later.
  const since = (/** @type {number} */ time) => time - began;
  return {
    bytesIn: since(at.bytesIn),
    loaded: since(at.loaded),
    first: since(at.first),
    final: since(at.final),
    longestTask: /** @type {any} */ (window).longestTask,
  };
}

export async function run() {
  const edges = readSizes([160, 512]);
  const made = Object.fromEntries(edges.map((edge) => [`/made/${edge}.nii`, () => makeNifti(edge)]));
  await measurePackage(async ({ browser, machine, openPage }) => {
    const rows = [];
    for (const edge of edges) {
      const src = `/made/${edge}.nii`;
      const megabytes = formatMegabytes(made[src]().length);
      /** @type {Load[]} */
      const loads = [];
      const peaks = [];
      const heaps = [];
      for (let i = 0; i < repeats; i++) {
        const page = await openPage('test/bench/page.html', { before: watchTasks });
        const memory = await watchMemory(browser);
        loads.push(await page.evaluate(loadInPage, { src, pixels }));
        peaks.push(memory.stop());
        heaps.push(await readHeap(page));
        await page.close();
      }
      const of = (/** @type {(load: Load) => number} */ pick) => median(loads.map(pick)).toFixed(0);
      const longest = median(loads.map((load) => load.longestTask));
      const known = peaks.filter((peak) => peak !== null);
      rows.push({
        volume: `${edge}^3, 16 bit`,
        MB: megabytes,
        'bytes in, ms': of(({ bytesIn }) => bytesIn),
        'then first picture': of(({ first, bytesIn }) => first - bytesIn),
        'then final picture': of(({ final, bytesIn }) => final - bytesIn),
        'longest task': longest > 0 ? longest.toFixed(0) : 'under 50',
        'peak memory, MB': known.length > 0 ? formatMegabytes(median(known)) : 'not known',
        'heap after, MB': formatMegabytes(median(heaps)),
      });
    }
    console.log(`\n${nameMachine(machine)}, medians of ${repeats}, ${pixels} x ${pixels} pixels\n`);
    printTable("Load: a file from this machine, ms; memory of the page's own process beyond an empty page's", rows);
  }, made);
}
