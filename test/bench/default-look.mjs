// `npm run bench -- default-look`: what light costs a page: a tag that says nothing of its look, the same unlit, as it was by default
// before, and with ambient occlusion. A new page for each, in turns; ratios within a turn. SIZES are pixels along each side.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { median, printTable } from './table.mjs';

const volumes = {
  MRI: { src: '/demos/data/mni152-t1.nii.gz', dense: '6' },
  CT: { src: '/demos/data/ct-phantom.nii.gz', dense: '3' },
};

/** @typedef {{ first: number, final: number, rest: number }} Times - ms: from the insertion of the element to its first picture and to the picture at rest; a frame at rest */

/**
 * In the page.
 * @param {{ attributes: Record<string, string>, size: number }} asked
 * @returns {Promise<Times>}
 */
async function measureInPage({ attributes, size }) {
  await customElements.whenDefined('volume-view');
  const element = document.createElement('volume-view');
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.style.cssText = `width: ${size}px; height: ${size}px; max-height: none; aspect-ratio: auto`;
  let first = NaN;
  element.addEventListener('render', () => (first = performance.now()), { once: true });
  const began = performance.now();
  document.body.append(element);
  await element.whenRendered();
  const final = performance.now();
  const frames = [];
  for (let i = 0; i < 5; i++) frames.push((await element.redraw()).frameMs);
  frames.sort((a, b) => a - b);
  return { first: first - began, final: final - began, rest: frames[2] };
}

export async function run() {
  await measurePackage(async ({ machine, openPage }) => {
    const rows = [];
    for (const size of readSizes([512]))
      for (const [name, { src, dense }] of Object.entries(volumes)) {
        const looks = {
          'look="flat"': { src, look: 'flat' },
          default: { src },
          'ambient occlusion': { src, shading: 'ambient-occlusion', 'opacity-factor': dense },
        };
        /** @type {Record<string, Times[]>} */
        const times = Object.fromEntries(Object.keys(looks).map((look) => [look, []]));
        // The first turn fills the caches of the browser and of the driver, and does not count.
        for (let turn = -1; turn < repeats; turn++)
          for (const [look, attributes] of Object.entries(looks)) {
            const page = await openPage('test/bench/page.html', { width: size + 40, height: size + 40 });
            const row = await page.evaluate(measureInPage, { attributes, size });
            await page.close();
            if (turn >= 0) times[look].push(row);
          }
        const plain = times['look="flat"'];
        for (const [look, list] of Object.entries(times)) {
          const of = (/** @type {keyof Times} */ key) =>
            `${median(list.map((row) => row[key])).toFixed(key === 'rest' ? 1 : 0)} (${median(list.map((row, i) => row[key] / plain[i][key])).toFixed(2)})`;
          rows.push({
            volume: `${name}, ${size}²`,
            look,
            first: of('first'),
            final: of('final'),
            'a frame at rest': of('rest'),
          });
        }
      }
    console.log(`\n${nameMachine(machine)}, medians of ${repeats} turns\n`);
    printTable('What light costs a page: ms (ratio to flat)', rows);
  });
}
