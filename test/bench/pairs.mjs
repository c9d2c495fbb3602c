// `npm run bench -- pairs`: time and error of the controller's pictures, at rest and moving, against fixed numbers of steps.
// PLOT=docs/images/time-and-error.svg draws them too. SIZES=96 REPEATS=1 SECONDS=1 SCENES=mri make a quick run.
import { writeFileSync } from 'node:fs';
import { findSharedData } from '../../scripts/shared-data.mjs';
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { drawPlot } from './plot.mjs';
import { printTable } from './table.mjs';

const targets = {
  stepCounts: [25, 50, 100, 200, 400, 800],
  maxErrors: [8, 4, 2, 1, 0.5, 0.25],
  targetFps: [60, 30, 15, 10, 5],
};
const seconds = Number(process.env.SECONDS ?? 3);

/** Smaller errors are plotted as this, 1/255. */
const minShown = 0.02;

const peaks =
  '19.5% #48c 0, 20% #48c 60%, 20.5% #48c 0, 44.5% #f93 0, 45% #f93 60%, 45.5% #f93 0, 69.5% white 0, 70% white 60%, 70.5% white 0';

/** @type {{ id: string, name: string, attributes: Record<string, string> }[]} */
const allScenes = [
  {
    id: 'mri',
    name: 'MRI of a brain',
    attributes: { src: '/demos/data/mni152-t1.nii.gz', 'transfer-function': 'mri' },
  },
  {
    id: 'peaks',
    name: 'MRI, three peaks of 1 %',
    attributes: { src: '/demos/data/mni152-t1.nii.gz', 'transfer-function': peaks },
  },
  {
    id: 'phantom',
    name: 'CT phantom',
    attributes: { src: '/demos/data/ct-phantom.nii.gz', 'transfer-function': 'ct-bone' },
  },
  { id: 'storm', name: 'Radar, synthetic storm', attributes: { src: '/demos/data/storm-radar-1510.json' } },
  {
    id: 'aorta',
    name: 'Aorta of the 2011 paper',
    attributes: {
      src: '/shared-data/medical/aorta_mosaic/aorta4096.png',
      mosaic: '10x10',
      slices: '96',
      spacing: '0.8 0.8 -1.2',
      'transfer-function': 'mri',
    },
  },
];

/** Scenes that are asked for and whose data are here; says what is left out. */
function listScenes() {
  const asked = process.env.SCENES?.split(',') ?? allScenes.map(({ id }) => id);
  const unknown = asked.find((id) => !allScenes.some((scene) => scene.id === id));
  if (unknown !== undefined)
    throw new Error(`SCENES got "${unknown}"; expected some of ${allScenes.map(({ id }) => id).join(', ')}`);
  return allScenes.filter(({ id, name, attributes }) => {
    const isAbsent = attributes.src.startsWith('/shared-data/') && !findSharedData(attributes.src);
    if (isAbsent && asked.includes(id)) console.log(`left out: ${name} (needs ../shared/data)`);
    return asked.includes(id) && !isAbsent;
  });
}

/** @typedef {import('./pairs-page.ts').Pair} Pair */
/** @typedef {{ name: string, pairs: import('./pairs-page.ts').ScenePairs }} Measured */

export async function run() {
  const [size] = readSizes([512]);
  await measureSource(async ({ machine, openPage }) => {
    /** @type {Measured[]} */
    const measured = [];
    for (const { name, attributes } of listScenes()) {
      const page = await openPage('test/accuracy/page.html');
      const pairs = await page.evaluate(
        async ({ module, asked, scene }) => {
          const { measurePairs } = /** @type {typeof import('./pairs-page.ts')} */ (await import(module));
          return measurePairs(asked, (what) => /** @type {any} */ (window).sayProgress(`${scene}: ${what}`));
        },
        { module: '/test/bench/pairs-page.ts', asked: { ...targets, attributes, size, repeats, seconds }, scene: name },
      );
      await page.close();
      measured.push({ name, pairs });
    }
    console.log(
      `\n${nameMachine(machine)}, ${size} x ${size} pixels, medians of ${repeats} redraws, and of the frames of ${seconds} s.`,
    );
    console.log(
      'Cells: error, RMS in 1/255; time, ms; steps; at rest the error that the element states, moving the share of pixels.\n',
    );
    printPolicy('Fixed steps', measured, { policy: 'fixed', head: (target) => `steps ${target}`, describe: says });
    printPolicy('The controller at rest', measured, {
      policy: 'atRest',
      head: (target) => `max-error ${target}`,
      describe: says,
    });
    printPolicy('The controller, moving', measured, {
      policy: 'moving',
      head: (target) => `target-fps ${target}`,
      describe: ({ pixels }) => `, ${(pixels * 100).toFixed(0)} %`,
    });
    if (process.env.PLOT) {
      writeFileSync(process.env.PLOT, plotPairs(measured, size));
      console.log(`drawn: ${process.env.PLOT}`);
    }
  });
}

/** @param {Pair} pair */
const says = ({ stated }) => `, says ${stated?.toFixed(2) ?? 'nothing'}`;

/**
 * @param {string} title
 * @param {readonly Measured[]} measured
 * @param {{ policy: keyof Measured['pairs'], head: (target: number) => string, describe: (pair: Pair) => string }} columns
 */
function printPolicy(title, measured, { policy, head, describe }) {
  printTable(
    title,
    measured.map(({ name, pairs }) => ({
      scene: name,
      ...Object.fromEntries(
        pairs[policy].map((pair) => [
          head(pair.target),
          `${pair.error.toFixed(2)}; ${pair.ms.toFixed(0)} ms; ${pair.steps}${describe(pair)}`,
        ]),
      ),
    })),
  );
}

/** @param {readonly Measured[]} measured @param {number} size */
function plotPairs(measured, size) {
  const toLine = (/** @type {readonly Pair[]} */ pairs) =>
    pairs.map(({ target, ms, error }) => ({ x: ms, y: Math.max(minShown, error), label: String(target) }));
  return drawPlot({
    title: 'Time and error of pictures: the controller against fixed steps',
    description:
      `${measured.length} scenes at ${size} x ${size} pixels, a panel each; time of one picture across, its error upwards, both logarithmic. ` +
      'Fixed numbers of steps make a falling line whose marks lie at other errors and times in each scene. ' +
      "The controller's pictures at rest lie on about the same line, at or below the error that each was asked for; " +
      'its moving frames lie near the time that the frame rate grants. The same numbers are in the tables beside the plot.',
    xName: 'time of one picture, ms',
    yName: 'error, RMS in 1/255',
    kinds: [
      { shape: 'square', name: 'fixed: number of steps', labels: 'above' },
      { shape: 'circle', name: 'controller at rest: max-error', labels: 'below' },
      { shape: 'triangle', name: 'controller, moving: target-fps', labels: 'below' },
    ],
    panels: measured.map(({ name, pairs }) => ({
      title: name,
      lines: [toLine(pairs.fixed), toLine(pairs.atRest), toLine(pairs.moving)],
    })),
  });
}
