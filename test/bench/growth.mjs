// `npm run bench -- growth`: what larger volumes, larger pictures and more elements cost. SIZES are pixels along each side
// of pictures, EDGES voxels along each edge of volumes, COUNTS numbers of elements.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { countGpuBytes } from './count-gpu-bytes.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { readHeap } from './read-heap.mjs';
import { makeNifti } from './synthetic-nifti.mjs';
import { formatMegabytes, median, printTable } from './table.mjs';

/** @param {string} name @param {readonly number[]} usual */
const readList = (name, usual) => process.env[name]?.split(',').map(Number) ?? [...usual];

/** Pixels along each side where volumes grow, and of each of many elements. */
const pixels = { volumes: 512, many: 240 };
const volumeOfPictures = '/demos/data/mni152-t1.nii.gz';

/** An element that has no picture after this long will have none, ms. */
const patience = 120_000;

/** @typedef {{ loadMs: number, frames: number[], steps: number }} Shown */

/**
 * In the page: load, wait for the final picture, then draw frames like it.
 * @param {{ src: string, size: number, repeats: number }} what
 * @returns {Promise<Shown>}
 */
async function showInPage({ src, size, repeats: times }) {
  await customElements.whenDefined('volume-view');
  const element = document.createElement('volume-view');
  element.setAttribute('src', src);
  element.style.cssText = `width: ${size}px; height: ${size}px; max-height: none; max-width: none; aspect-ratio: auto`;
  const began = performance.now();
  document.body.append(element);
  await element.whenRendered();
  const loadMs = performance.now() - began;
  const frames = [];
  for (let i = 0; i < times; i++) frames.push((await element.redraw()).frameMs);
  return { loadMs, frames, steps: element.renderStats?.steps ?? NaN };
}

/** @typedef {{ visible: number, visibleMs: number, pictures: number, scrolledMs: number }} Many */

/**
 * In the page: many elements with one volume from all sides, most of them out of sight; then the end of the page.
 * @param {{ src: string, size: number, count: number, patience: number }} what
 * @returns {Promise<Many>} times until all in sight have their final picture, ms; NaN where not all got one
 */
async function showManyInPage({ src, size, count, patience: max }) {
  await customElements.whenDefined('volume-view');
  const elements = Array.from({ length: count }, (_, i) => {
    const element = document.createElement('volume-view');
    element.setAttribute('src', src);
    element.setAttribute('loading', 'lazy');
    element.setAttribute('camera-orbit', `${i * 37}deg 75deg 100%`);
    element.style.cssText = `display: inline-block; width: ${size}px; height: ${size}px; aspect-ratio: auto`;
    return element;
  });
  const done = new Set();
  for (const element of elements) {
    element.addEventListener('render', ({ detail }) => {
      if (detail.converged) done.add(element);
    });
  }
  const inSight = () =>
    elements.filter((element) => {
      const { top, bottom } = element.getBoundingClientRect();
      return bottom > 0 && top < innerHeight;
    });
  const waitForSight = async () => {
    const began = performance.now();
    while (!inSight().every((element) => done.has(element))) {
      if (performance.now() - began > max) return NaN;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    return performance.now() - began;
  };
  document.body.append(...elements);
  const visible = inSight().length;
  const visibleMs = await waitForSight();
  scrollTo(0, document.body.scrollHeight);
  await new Promise((resolve) => requestAnimationFrame(resolve));
  const scrolledMs = await waitForSight();
  return { visible, visibleMs, scrolledMs, pictures: done.size };
}

export async function run() {
  const edges = readList('EDGES', [64, 128, 256, 512]);
  const made = Object.fromEntries(edges.map((edge) => [`/made/${edge}.nii`, () => makeNifti(edge)]));
  await measurePackage(async (tools) => {
    const volumes = [];
    for (const edge of edges) {
      const shown = await show(tools, `/made/${edge}.nii`, pixels.volumes);
      volumes.push({ volume: `${edge}^3, 16 bit`, 'samples, MB': formatMegabytes(2 * edge ** 3), ...shown });
    }
    const pictures = [];
    for (const size of readSizes([256, 512, 800, 1600])) {
      pictures.push({ pixels: `${size} x ${size}`, ...(await show(tools, volumeOfPictures, size)) });
    }
    const many = [];
    for (const count of readList('COUNTS', [1, 10, 100])) many.push(await showMany(tools, count));
    console.log(`\n${nameMachine(tools.machine)}, medians of ${repeats} frames, one load each\n`);
    printTable(`Volumes, at ${pixels.volumes} x ${pixels.volumes} pixels`, volumes);
    printTable('Pictures, of the MRI', pictures);
    printTable(`Elements of ${pixels.many} x ${pixels.many} pixels with the MRI, loading="lazy"`, many);
  }, made);
}

/**
 * @param {import('../helpers/measure-in-browser.mjs').Tools} tools
 * @param {string} src
 * @param {number} size - pixels along each side
 */
async function show({ openPage }, src, size) {
  const page = await openPage('test/bench/page.html', { width: size + 40, height: size + 40, before: countGpuBytes });
  const { loadMs, frames, steps } = await page.evaluate(showInPage, { src, size, repeats });
  const { textures } = await page.evaluate(() => /** @type {any} */ (window).gpuBytes());
  const heap = await readHeap(page);
  await page.close();
  return {
    'to final, ms': loadMs.toFixed(0),
    'one frame, ms': median(frames).toFixed(1),
    steps,
    'GPU textures, MB': formatMegabytes(textures),
    'heap, MB': formatMegabytes(heap),
  };
}

/**
 * @param {import('../helpers/measure-in-browser.mjs').Tools} tools
 * @param {number} count
 */
async function showMany({ openPage }, count) {
  const page = await openPage('test/bench/page.html', { before: countGpuBytes });
  const asked = { src: volumeOfPictures, size: pixels.many, count, patience };
  const { visible, visibleMs, scrolledMs, pictures } = await page.evaluate(showManyInPage, asked);
  const { contexts, all } = await page.evaluate(() => /** @type {any} */ (window).gpuBytes());
  const heap = await readHeap(page);
  await page.close();
  const notify = (/** @type {number} */ ms) => (Number.isNaN(ms) ? `not in ${patience / 1000} s` : ms.toFixed(0));
  return {
    elements: count,
    'in sight': visible,
    'all in sight final, ms': notify(visibleMs),
    'after scrolling to the end, ms': notify(scrolledMs),
    'drew at all': pictures,
    'contexts alive': contexts,
    'GPU in all, MB': formatMegabytes(all),
    'heap, MB': formatMegabytes(heap),
  };
}
