// `npm run bench -- dial`: what `max-error` and `detail` buy in time: from a turn of the camera to the picture at rest, and a frame of that picture
// alone. The built package, ten scenes, the settings in turns. SCENES=mri,storm, SIZES=512, ERRORS=16,8,4,2,1 and REPEATS name others.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { scenes as ofGpu } from './gpu-scenes.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { median, printTable } from './table.mjs';

/** Ten scenes: those of `gpu`, and four more. */
const scenes = {
  ...ofGpu,
  rain: { name: 'Storm, voxels (default)', attributes: { src: '/demos/data/storm-synthetic.nii.gz' } },
  colin: { name: 'MRI of another brain (default)', attributes: { src: '/demos/data/colin27-t1.nii.gz' } },
  bones: { name: 'CT, fog', attributes: { src: '/demos/data/ct-phantom.nii.gz', shading: 'unlit' } },
  velocity: {
    name: 'Storm, velocity, lit',
    attributes: { src: '/demos/data/storm-radar-velocity.json', shading: 'lit' },
  },
};

const errors = (process.env.ERRORS ?? '16,8,4,2,1').split(',').map(Number);

/** The setting that every element has at first. */
const usual = { detail: 'keep', maxError: 1 };

const settings = [
  usual,
  ...['keep', 'free'].flatMap((detail) => errors.map((maxError) => ({ detail, maxError }))),
].filter(({ detail, maxError }, i) => i === 0 || detail !== usual.detail || maxError !== usual.maxError);

/**
 * @typedef {object} Turn - times in ms
 * @property {number} rest - from the turn of the camera to the picture at rest
 * @property {number} frame - to draw the picture at rest again, until the device has finished
 * @property {string} spent - steps, substeps, share of the pixels that had a ray
 */

/**
 * In the page: the camera is turned to the same places for each setting.
 * @param {{ attributes: Record<string, string>, size: number, settings: { detail: string, maxError: number }[], turns: number }} asked
 * @returns {Promise<Turn[][]>} by setting
 */
async function turnByEach({ attributes, size, settings: all, turns }) {
  await customElements.whenDefined('volume-view');
  const element = /** @type {any} */ (document.createElement('volume-view'));
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.setAttribute('interpolation-decay', '0');
  element.style.cssText = `width: ${size}px; height: ${size}px; max-height: none; aspect-ratio: auto`;
  document.body.append(element);
  await element.whenRendered();
  /** @type {Turn[][]} */
  const taken = all.map(() => []);
  // The first turn of each setting loads code and compiles programs: it does not count.
  for (let turn = 0; turn <= turns; turn++) {
    for (const [i, { detail, maxError }] of all.entries()) {
      element.cameraOrbit = `${200 + 17 * turn}deg 70deg auto`;
      element.setAttribute('detail', detail);
      element.setAttribute('max-error', String(maxError));
      await element.whenRendered();
      const began = performance.now();
      element.cameraOrbit = `${30 + 17 * turn}deg 75deg auto`;
      await element.whenRendered();
      const rest = performance.now() - began;
      const { steps, substeps, rays } = element.renderStats;
      const { frameMs } = await element.redraw();
      if (turn > 0)
        taken[i].push({ rest, frame: frameMs, spent: `${steps} × ${substeps}, ${(100 * rays).toFixed(0)} %` });
    }
  }
  return taken;
}

export async function run() {
  const asked = process.env.SCENES?.split(',') ?? Object.keys(scenes);
  await measurePackage(async ({ machine, openPage }) => {
    for (const size of readSizes([512])) {
      const rows = [];
      /** @type {number[][]} by setting, the ratio to the usual one of each scene */
      const ratios = settings.map(() => []);
      for (const id of asked) {
        const page = await openPage('test/bench/page.html', { width: size + 40, height: size + 40 });
        const { name, attributes } = scenes[/** @type {keyof typeof scenes} */ (id)];
        const taken = await page.evaluate(turnByEach, { attributes, size, settings, turns: repeats });
        await page.close();
        const usualRest = median(taken[0].map(({ rest }) => rest));
        for (const [i, turns] of taken.entries()) {
          const rest = median(turns.map((turn) => turn.rest));
          ratios[i].push(rest / usualRest);
          rows.push({
            scene: name,
            detail: settings[i].detail,
            'max-error': settings[i].maxError,
            'to the picture at rest, ms': rest.toFixed(0),
            ratio: (rest / usualRest).toFixed(2),
            'its frame, ms': median(turns.map(({ frame }) => frame)).toFixed(1),
            'steps × substeps, rays': turns[0].spent,
          });
        }
      }
      console.log(`\n${nameMachine(machine)}, medians of ${repeats} turns of the camera, ${size} x ${size} pixels\n`);
      printTable('Time to the picture at rest, to that of the default setting', rows);
      printTable(
        'The same, medians of the scenes',
        settings.map(({ detail, maxError }, i) => ({
          detail,
          'max-error': maxError,
          ratio: median(ratios[i]).toFixed(2),
        })),
      );
    }
  });
}
