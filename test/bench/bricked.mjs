// `npm run bench -- bricked`: what a view of a pyramid costs as its volume grows, in bricks and, where a device holds it, as a whole: the stone of
// demos/large at one place, from 256 x 192 x 160 voxels to 16,384 x 12,288 x 10,240. Workers of the page compute its chunks, on the same processor.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { formatMegabytes, printTable } from './table.mjs';

/** Levels of the stone that are left out: the next one is then the finest. Below 0: so many are added. */
const shifts = (process.env.SHIFTS ?? '4,3,2,1,0,-1,-2').split(',').map(Number);

/** Up to so many levels left out, the volume is also read as a whole. */
const wholeFrom = 3;

/** What small stones may take on the GPU, so that they come in bricks, too. @type {Record<number, string>} */
const gpuBytes = { 3: '40e6', 4: '6e6' };

/** Looks that are measured. */
const wanted = (process.env.LOOKS ?? 'soft,opaque').split(',');

/** Longest time for one picture, s. */
const patience = 150;

/** Pictures of which the median time is taken. */
const pictures = 5;

const looks = {
  soft: '50 #4a3423 0%, 105 #9a744c 45%, 165 #d8bc8e 75%, 255 #fff6e2 90%',
  opaque: '40 #5a4632 0%, 50 #5a4632 100%, 130 #c9a877 100%, 255 #fff4dd 100%',
};

/**
 * In the page.
 * @param {{ base: string, shift: number, attributes: Record<string, string>, patience: number, again: number }} asked
 */
async function showStone({ base, shift, attributes, patience: seconds, again }) {
  await import(`${base}dist/volume-view.js`);
  const { serveStone } = /** @type {typeof import('./serve-stone.mjs')} */ (
    await import(`${base}test/bench/serve-stone.mjs`)
  );
  const stone = serveStone(base, shift);
  const view = document.createElement('volume-view');
  view.fetch = stone.fetch;
  for (const [name, value] of Object.entries({ alt: 'A stone', loading: 'eager', src: stone.folder, ...attributes }))
    view.setAttribute(name, value);
  view.style.cssText = 'display: block; width: 320px; height: 240px';
  const began = performance.now();
  let first = 0;
  view.addEventListener('render', () => (first ||= performance.now() - began));
  document.body.append(view);
  const late = new Promise((resolve) => setTimeout(() => resolve('late'), 1000 * seconds));
  const isFinal = (await Promise.race([view.whenRendered(), late])) !== 'late';
  const final = performance.now() - began;
  const { steps, error, bricks } = /** @type {any} */ (view.renderStats);
  const counts = { ...stone.counts };
  // The same picture from nearly the same place, once all is there: some more chunks come.
  /** @type {number[]} */
  const times = [];
  for (let n = 1; n <= (isFinal ? again : 0); n++) {
    view.setAttribute('camera-orbit', attributes['camera-orbit'].replace('deg', `.${n}deg`));
    await Promise.race([view.whenRendered(), late]);
    if (view.renderStats) times.push(view.renderStats.frameMs);
  }
  times.sort((a, b) => a - b);
  const frameMs = times[Math.floor(times.length / 2)] ?? null;
  view.remove();
  stone.close();
  return { first, final: isFinal ? final : null, frameMs, steps, error, bricks, ...counts };
}

export async function run() {
  await measurePackage(async ({ url, openPage, machine }) => {
    for (const [look, transferFunction] of Object.entries(looks)) {
      if (!wanted.includes(look)) continue;
      const rows = [];
      for (const shift of shifts)
        for (const way of shift >= wholeFrom ? ['whole', 'bricks'] : ['bricks']) {
          const page = await openPage('test/bench/empty.html');
          const size = [4096, 3072, 2560].map((n) => n / 2 ** shift).join(' × ');
          const found = await page.evaluate(showStone, {
            base: url,
            shift,
            patience,
            again: pictures,
            attributes: {
              'transfer-function': transferFunction,
              'camera-orbit': '30deg 68deg 72%',
              'max-error': '2',
              ...(look === 'soft' && { shading: 'lit' }),
              ...(way === 'whole' ? { 'max-bytes': '100e6' } : { 'max-gpu-bytes': gpuBytes[shift] ?? '64e6' }),
            },
          });
          await page.close();
          const { first, final, frameMs, steps, error, bricks, chunks, bytes } = found;
          rows.push({
            voxels: size,
            way,
            'first picture, s': (first / 1000).toFixed(1),
            'final, s': final === null ? `not in ${patience}` : (final / 1000).toFixed(1),
            'a picture, ms': frameMs?.toFixed(0) ?? '',
            steps,
            chunks,
            'read, MB': formatMegabytes(bytes),
            bricks: bricks?.count ?? '',
            'bricks on the GPU, MB': bricks ? formatMegabytes(bricks.bytes) : '',
            'error stated': error ? error.rms.toFixed(2) : '',
          });
          console.error(JSON.stringify(rows.at(-1)));
        }
      printTable(`A stone, ${look}, 320 x 240 pixels, max-error 2 (${nameMachine(machine)})`, rows);
    }
  });
}
