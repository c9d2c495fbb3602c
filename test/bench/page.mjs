// `npm run bench -- page`: what a page with one element costs.
import { findSharedData } from '../../scripts/shared-data.mjs';
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { countGpuBytes } from './count-gpu-bytes.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { measureBytes } from './measure-bytes.mjs';
import { readHeap } from './read-heap.mjs';
import { formatMegabytes, median, printTable } from './table.mjs';

/** The paper's Table 2. */
const stepCounts = [80, 140, 170, 200];
const [side] = readSizes([800]);
const picture = { width: side, height: side };

/** @type {{ name: string, attributes: Record<string, string> }[]} */
const allScenes = [
  { name: 'MRI 197 x 233 x 189, NIfTI', attributes: { src: '/demos/data/mni152-t1.nii.gz' } },
  { name: 'the same, mosaic', attributes: { src: '/demos/data/mni152-t1.json' } },
  { name: 'CT phantom, 16 bit', attributes: { src: '/demos/data/ct-phantom.nii.gz', 'transfer-function': 'ct-bone' } },
  { name: 'radar 14 x 360 x 400, synthetic storm', attributes: { src: '/demos/data/storm-radar-1510.json' } },
  {
    name: 'radar 14 x 360 x 598, ODIM_H5',
    attributes: { src: '/shared-data/radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5' },
  },
  {
    name: 'aorta of the 2011 paper, mosaic 4096 x 4096',
    attributes: {
      src: '/shared-data/medical/aorta_mosaic/aorta4096.png',
      mosaic: '10x10',
      slices: '96',
      spacing: '0.8 0.8 -1.2',
    },
  },
];

/** Scenes whose data are here; says what is left out. */
export function listScenes() {
  return allScenes.filter(({ name, attributes }) => {
    const absent = attributes.src.startsWith('/shared-data/') && !findSharedData(attributes.src);
    if (absent) console.log(`left out: ${name} (needs ../shared/data)`);
    return !absent;
  });
}

/** @typedef {{ fetch: number, decode: number, scene: number, picture: number, total: number }} Phases */

/**
 * In the page: put the element in and time its phases, ms since it was put in.
 * @param {{ attributes: Record<string, string>, width: number, height: number }} scene
 * @returns {Promise<Phases>}
 */
async function loadInPage({ attributes, width, height }) {
  await customElements.whenDefined('volume-view');
  const element = document.createElement('volume-view');
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.style.cssText = `width: ${width}px; height: ${height}px; max-height: none; aspect-ratio: auto`;
  const began = performance.now();
  /** @type {Record<string, number>} */
  const at = {};
  element.addEventListener('progress', (event) => {
    at[event.detail.phase] = performance.now();
  });
  element.addEventListener('load', () => (at.load = performance.now()));
  element.addEventListener('render', () => (at.render ??= performance.now()));
  document.body.append(element);
  await element.whenRendered();
  return {
    fetch: at.fetch - began,
    decode: at.decode - at.fetch,
    scene: at.load - at.decode,
    picture: at.render - at.load,
    total: at.render - began,
  };
}

/**
 * In the page: frames at each number of steps, taken in turns so that all see the same machine.
 * @param {{ stepCounts: number[], repeats: number }} order
 */
async function timeFrames({ stepCounts: counts, repeats: times }) {
  const element = document.querySelector('volume-view');
  if (!element) throw new Error('no element');
  /** @type {Record<string, number[]>} */
  const frames = Object.fromEntries(counts.map((steps) => [steps, []]));
  for (let i = -1; i < times; i++) {
    for (const steps of counts) {
      element.steps = steps;
      await element.whenRendered(); // Also warms the transfer function's table for this number of steps.
      const { frameMs } = await element.redraw();
      if (i >= 0) frames[steps].push(frameMs);
    }
  }
  return frames;
}

export async function run() {
  await measurePackage(async ({ machine, openPage }) => {
    const loads = [];
    const frames = [];
    const memory = [];
    for (const { name, attributes } of listScenes()) {
      /** @type {Phases[]} */
      const phases = [];
      for (let i = 0; i < repeats; i++) {
        const page = await openPage('test/bench/page.html', { before: countGpuBytes });
        phases.push(await page.evaluate(loadInPage, { attributes, ...picture }));
        if (i === repeats - 1) {
          const times = await page.evaluate(timeFrames, { stepCounts, repeats });
          frames.push({
            scene: name,
            ...Object.fromEntries(stepCounts.map((s) => [`${s} steps`, median(times[s]).toFixed(1)])),
          });
          const gpu = await page.evaluate(() => /** @type {any} */ (window).gpuBytes());
          const [samples, textures, all, heap] = [gpu.samples, gpu.textures, gpu.all, await readHeap(page)].map(
            formatMegabytes,
          );
          memory.push({ scene: name, samples, 'GPU textures': textures, 'GPU in all': all, heap });
        }
        await page.close();
      }
      const of = (/** @type {keyof Phases} */ phase) => median(phases.map((p) => p[phase])).toFixed(0);
      loads.push({
        scene: name,
        fetch: of('fetch'),
        decode: of('decode'),
        'x3dom, upload': of('scene'),
        'compile, draw': of('picture'),
        'first picture': of('total'),
      });
    }
    console.log(`\n${nameMachine(machine)}\nmedians of ${repeats}; ${picture.width} x ${picture.height} pixels\n`);
    printTable('Load, ms (fetch begins when the element is put in; x3dom loads beside fetch and decode)', loads);
    printTable('One frame, ms', frames);
    printTable('Memory, MB, after loading and a garbage collection', memory);
    printTable('JavaScript, bytes', await measureBytes());
  });
}
