// `npm run bench -- pick`: what a pick costs, from the call to its answer.
import { findSharedData } from '../../scripts/shared-data.mjs';
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { makeNifti } from './synthetic-nifti.mjs';
import { median, printTable } from './table.mjs';

/** Picks along each side of the picture. */
const side = 12;

/** @type {{ name: string, attributes: Record<string, string> }[]} */
const allScenes = [
  {
    name: 'cube 256^3, 16 bit, translucent',
    attributes: { src: '/made/cube.nii', 'transfer-function': 'viridis', 'opacity-factor': '0.2' },
  },
  { name: 'the same, as by default', attributes: { src: '/made/cube.nii' } },
  { name: 'the same, projection="max"', attributes: { src: '/made/cube.nii', projection: 'max' } },
  { name: 'MRI 197 x 233 x 189', attributes: { src: '/demos/data/mni152-t1.nii.gz' } },
  { name: 'radar 14 x 360 x 400, synthetic storm', attributes: { src: '/demos/data/storm-radar-1510.json' } },
  {
    name: 'radar 14 x 360 x 598, ODIM_H5',
    attributes: { src: '/shared-data/radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5' },
  },
];

/** Scenes whose data are here; says what is left out. */
function listScenes() {
  return allScenes.filter(({ name, attributes: { src } }) => {
    const isAbsent = src.startsWith('/shared-data/') && !findSharedData(src);
    if (isAbsent) console.log(`left out: ${name} (needs ../shared/data)`);
    return !isAbsent;
  });
}

/**
 * In the page: pick all over the picture.
 * @param {{ attributes: Record<string, string>, count: number }} scene
 */
async function pickInPage({ attributes, count }) {
  await customElements.whenDefined('volume-view');
  const element = document.createElement('volume-view');
  for (const [name, value] of Object.entries({ ...attributes, steps: '40' })) element.setAttribute(name, value);
  element.style.cssText = 'width: 480px; height: 360px';
  document.body.append(element);
  await element.whenRendered();
  const began = performance.now();
  await element.pick(240, 180); // Loads the code, and makes what is kept for later picks.
  const first = performance.now() - began;
  /** @type {number[]} */
  const times = [];
  let found = 0;
  for (let i = 0; i < count ** 2; i++) {
    const [x, y] = [120 + (240 * (i % count)) / count, 60 + (240 * Math.floor(i / count)) / count];
    const start = performance.now();
    const pick = await element.pick(x, y);
    // Where nothing is there is no time to be had.
    if (pick) times.push(performance.now() - start);
    if (pick) found++;
  }
  element.remove();
  return { first, times, found };
}

export async function run() {
  await measurePackage(
    async ({ machine, openPage }) => {
      const page = await openPage('test/bench/page.html');
      const rows = [];
      for (const { name, attributes } of listScenes()) {
        const { first, times, found } = await page.evaluate(pickInPage, { attributes, count: side });
        times.sort((a, b) => a - b);
        rows.push({
          volume: name,
          'picks that found something': found,
          'median, ms': median(times).toFixed(2),
          '95 %, ms': times[Math.floor(0.95 * (times.length - 1))].toFixed(2),
          'the first one, with its code, ms': first.toFixed(0),
        });
      }
      console.log(`\n${nameMachine(machine)}\n`);
      printTable('A pick, from the call to its answer', rows);
    },
    { '/made/cube.nii': () => makeNifti(256) },
  );
}
