// `npm run bench -- gpu`: one table of the built package on this machine's graphics processor: does it draw right, when do pictures come, how long
// does a frame at rest take, and how smoothly does it turn. VOLUME_VIEW_GPU=1 takes the graphics processor; without it the table is of software GL.
// SIZES are pixels along each side, SECONDS those of the orbit, SCENES=mri,storm names some of the scenes.
import { countGpuBytes } from './count-gpu-bytes.mjs';
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { scenes } from './gpu-scenes.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { formatMegabytes, median, printTable } from './table.mjs';

const seconds = Number(process.env.SECONDS ?? 4);

/** Times of a page's own tasks, and what a picture needs to be checked, may take this long: ms. */
const checkTimeout = 30000;

/**
 * @typedef {object} GpuRow - times in ms
 * @property {number} first - from the insertion of the element, whose script is there, to its first picture
 * @property {number} final - to the picture at rest
 * @property {number} rest - a frame at rest, until the graphics processor has finished
 * @property {number} steps
 * @property {number} rays - share of the pixels
 * @property {{ rms: number, max: number | null } | null} error
 * @property {boolean | null} keeps - whether `max-error` is kept
 * @property {{ rays: number, off: number, max: number, agrees: boolean } | null} check
 * @property {number[]} intervals - between frames of the orbit
 * @property {number[]} frames - what each took
 * @property {number} turnedPixels - share of the full picture's pixels, median
 * @property {number} turnedSteps - median
 */

/**
 * In the page.
 * @param {{ attributes: Record<string, string>, size: number, seconds: number, checkTimeout: number, redraws: number }} asked
 * @returns {Promise<GpuRow>}
 */
async function measureInPage({ attributes, size, seconds: turning, checkTimeout: patience, redraws }) {
  await customElements.whenDefined('volume-view');
  const element = /** @type {any} */ (document.createElement('volume-view'));
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.style.cssText = `width: ${size}px; height: ${size}px; max-height: none; aspect-ratio: auto`;
  let first = NaN;
  element.addEventListener('render', () => (first = performance.now()), { once: true });
  const began = performance.now();
  document.body.append(element);
  await element.whenRendered();
  const final = performance.now() - began;
  const { steps, rays, error, keepsMaxError } = element.renderStats;
  const rest = [];
  for (let i = 0; i < redraws; i++) rest.push((await element.redraw()).frameMs);
  const check = await new Promise((resolve) => {
    element.addEventListener('picture-check', (/** @type {CustomEvent} */ { detail }) => resolve(detail), {
      once: true,
    });
    setTimeout(() => resolve(null), patience);
    element.setAttribute('self-check', '');
  });
  element.removeAttribute('self-check');
  await turn(1); // The controller learns what frames of this scene take.
  const turned = await turn(turning);
  const middle = (/** @type {number[]} */ values) => {
    const sorted = [...values];
    sorted.sort((a, b) => a - b);
    return sorted[sorted.length >> 1] ?? NaN;
  };
  return {
    first: first - began,
    final,
    rest: middle(rest),
    steps,
    rays,
    error: error && { rms: error.rms, max: error.max },
    keeps: keepsMaxError,
    check: check && { rays: check.rays, off: check.off, max: check.max, agrees: check.agrees },
    intervals: turned.slice(1).map(({ at }, i) => at - turned[i].at),
    frames: turned.map(({ ms }) => ms),
    turnedPixels: middle(turned.map((one) => one.pixels)),
    turnedSteps: middle(turned.map((one) => one.steps)),
  };

  /** Drag the camera around as a mouse of 60 movements a second does. @param {number} time */
  async function turn(time) {
    /** @type {{ at: number, ms: number, steps: number, pixels: number }[]} */
    const drawn = [];
    const note = () => {
      const { frameMs, steps: taken, width, height } = element.renderStats;
      drawn.push({ at: performance.now(), ms: frameMs, steps: taken, pixels: (width * height) / size ** 2 });
    };
    const picture = element.shadowRoot.querySelector('.picture');
    picture.setPointerCapture = () => {}; // A made event has no pointer to capture.
    const start = performance.now();
    const point = (/** @type {string} */ type) => {
      const clientX = ((performance.now() - start) / 1000 / time) * 2 * size;
      picture.dispatchEvent(
        new PointerEvent(type, { pointerId: 1, isPrimary: true, bubbles: true, clientX, clientY: 100 }),
      );
    };
    element.addEventListener('camera-change', note);
    point('pointerdown');
    while (performance.now() - start < 1000 * time) {
      await new Promise((resolve) => setTimeout(resolve, 1000 / 60));
      point('pointermove');
    }
    element.removeEventListener('camera-change', note);
    point('pointerup');
    await element.whenRendered();
    return drawn;
  }
}

export async function run() {
  const asked = process.env.SCENES?.split(',') ?? Object.keys(scenes);
  await measurePackage(async ({ machine, openPage }) => {
    const rows = [];
    for (const size of readSizes([512, 1024]))
      for (const [id, { name, attributes }] of Object.entries(scenes)) {
        if (!asked.includes(id)) continue;
        const page = await openPage('test/bench/page.html', {
          width: size + 40,
          height: size + 40,
          before: countGpuBytes,
        });
        const row = await page.evaluate(measureInPage, { attributes, size, seconds, checkTimeout, redraws: repeats });
        const { textures } = await page.evaluate(() => /** @type {any} */ (window).gpuBytes());
        await page.close();
        rows.push({ scene: `${name}, ${size}²`, ...formatRow(row), 'textures, MB': formatMegabytes(textures) });
      }
    console.log(`\n${nameMachine(machine)}, orbits of ${seconds} s; frames at rest: medians of ${repeats}\n`);
    printTable('The built package on this device: ms', rows);
  });
}

/** @param {GpuRow} row @returns {Record<string, string>} */
function formatRow({
  first,
  final,
  rest,
  steps,
  rays,
  error,
  keeps,
  check,
  intervals,
  frames,
  turnedPixels,
  turnedSteps,
}) {
  const total = intervals.reduce((sum, one) => sum + one, 0);
  const sorted = [...intervals];
  sorted.sort((a, b) => a - b);
  return {
    'self-check': check ? `${check.agrees ? 'right' : 'WRONG'}: ${check.off} of ${check.rays} off` : 'not checked',
    first: first.toFixed(0),
    final: final.toFixed(0),
    'a frame at rest': rest.toFixed(1),
    'steps, rays': `${steps}, ${(100 * rays).toFixed(0)} %`,
    'error, kept': error
      ? `${error.rms.toFixed(2)} (max ${error.max?.toFixed(0) ?? 'not known'}), ${keeps ? 'yes' : 'no'}`
      : 'not known',
    'turning, frames/s': ((1000 * intervals.length) / total).toFixed(1),
    '95 % of intervals below': (sorted[Math.floor(0.95 * sorted.length)] ?? NaN).toFixed(0),
    'a turning frame': median(frames).toFixed(1),
    'its pixels, steps': `${(100 * turnedPixels).toFixed(0)} %, ${turnedSteps}`,
  };
}
