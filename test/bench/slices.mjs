// `npm run bench -- slices`: what a slice in a pane costs, from the beginning of its frame to the canvas.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { makeNifti } from './synthetic-nifti.mjs';
import { median, printTable } from './table.mjs';

const repeats = Number(process.env.REPEATS ?? 15);

/** @type {{ name: string, attributes: Record<string, string> }[]} */
const scenes = [
  { name: 'axial', attributes: {} },
  { name: 'sagittal', attributes: { type: 'sagittal' } },
  { name: 'oblique', attributes: { type: 'oblique', normal: '0.4 -0.5 0.8' } },
  { name: 'axial, nearest voxels', attributes: { interpolation: 'nearest' } },
  { name: 'slab of 20 mm, average', attributes: { thickness: '20' } },
  {
    name: 'oblique slab of 20 mm, maximum',
    attributes: { type: 'oblique', normal: '0.4 -0.5 0.8', thickness: '20', projection: 'max' },
  },
];

/**
 * In the page: go from slice to slice.
 * @param {{ attributes: Record<string, string>, count: number }} scene
 */
async function sliceInPage({ attributes, count }) {
  const script = '/dist/volume-slice-view.js';
  await import(script);
  const pane = document.createElement('volume-slice-view');
  for (const [name, value] of Object.entries({ src: '/made/cube.nii', ...attributes })) pane.setAttribute(name, value);
  pane.style.cssText = 'display: block; width: 512px; height: 512px';
  document.body.append(pane);
  await pane.whenRendered();
  let [began, put] = [0, 0];
  /** @type {number[]} */
  const puts = [];
  const { requestAnimationFrame: request } = window;
  // The first frame after a change begins its picture.
  window.requestAnimationFrame = (act) =>
    request((time) => {
      if (began === 0) began = performance.now();
      act(time);
    });
  const { putImageData } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.putImageData = function put2d(
    /** @type {ImageData} */ image,
    /** @type {number} */ x,
    /** @type {number} */ y,
  ) {
    Reflect.apply(putImageData, this, [image, x, y]);
    put = performance.now();
    puts.push(put - began);
  };
  /** @type {{ first: number, full: number }[]} */
  const times = [];
  for (let i = 0; i < count; i++) {
    [began, put] = [0, 0];
    puts.length = 0;
    pane.setAttribute('at', String(-40 + 4 * i));
    await pane.whenRendered();
    times.push({ first: puts[0], full: puts[puts.length - 1] });
  }
  window.requestAnimationFrame = request;
  CanvasRenderingContext2D.prototype.putImageData = putImageData;
  pane.remove();
  return times;
}

export async function run() {
  await measurePackage(
    async ({ machine, openPage }) => {
      const page = await openPage('test/bench/page.html');
      const rows = [];
      for (const { name, attributes } of scenes) {
        const times = await page.evaluate(sliceInPage, { attributes, count: repeats });
        rows.push({
          'pane of 512 x 512, 256^3 voxels, 16 bit': name,
          'first picture, median, ms': median(times.map(({ first }) => first)).toFixed(1),
          'in full, median, ms': median(times.map(({ full }) => full)).toFixed(1),
        });
      }
      console.log(`\n${nameMachine(machine)}\n`);
      printTable('A slice, from the beginning of its frame to the canvas', rows);
    },
    { '/made/cube.nii': () => makeNifti(256) },
  );
}
