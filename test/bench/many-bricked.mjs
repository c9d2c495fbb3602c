// `npm run bench -- many-bricked` (`VIEWS=12,60`): views in bricks, more than a page has contexts, that share the bytes of one limit: when each has its first
// and its final picture, the most bytes of 3D textures at once, counted by WebGL's calls, and the errors that they state. More bytes than the limit, or a view that
// is not final, fail it.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { countGpuBytes } from './count-gpu-bytes.mjs';
import { startStone } from './start-stone.mjs';
import { formatMegabytes, printTable } from './table.mjs';

const counts = (process.env.VIEWS ?? '6,12,60').split(',').map(Number);
const limit = 6e6;
const maxError = 3;

/** In the page. @param {{ base: string, src: string, count: number, limit: number, maxError: number }} asked */
async function show({ base, src, count, limit: bytes, maxError: wanted }) {
  await import(`${base}dist/volume-view.js`);
  const began = performance.now();
  /** @type {number[]} */
  const firsts = [];
  const views = Array.from({ length: count }, () => {
    const view = document.createElement('volume-view');
    for (const [name, value] of Object.entries({
      alt: 'A stone',
      src,
      'max-gpu-bytes': String(bytes),
      'max-error': String(wanted),
      'camera-orbit': '0deg 68deg 72%',
      'transfer-function': '50 #4a3423 0%, 105 #9a744c 45%, 165 #d8bc8e 75%, 255 #fff6e2 90%',
    }))
      view.setAttribute(name, value);
    view.style.cssText = 'display: inline-block; width: 90px; height: 64px';
    view.addEventListener('render', () => firsts.push(performance.now() - began), { once: true });
    document.body.append(view);
    return view;
  });
  const isFinal = () => views.every((view) => view.renderStats?.converged);
  await Promise.all(views.map((view) => view.whenRendered()));
  // A view whose share has grown, as others have left, gets more bricks once more.
  for (const end = performance.now() + 60_000; !isFinal() && performance.now() < end;)
    await new Promise((resolve) => setTimeout(resolve, 50));
  const finalMs = performance.now() - began;
  const errors = views.map((view) => view.renderStats?.error?.rms ?? NaN);
  errors.sort((a, b) => a - b);
  const { in3d } = /** @type {any} */ (globalThis).gpuBytes();
  for (const view of views) view.remove();
  return {
    isFinal: isFinal(),
    firstMs: Math.max(...firsts),
    finalMs,
    errors,
    most: in3d.most,
  };
}

export async function run() {
  const stone = await startStone();
  try {
    await measure(stone);
  } finally {
    stone.close();
  }
}

/** @param {Awaited<ReturnType<typeof startStone>>} stone */
async function measure(stone) {
  await measurePackage(async ({ url, openPage, machine }) => {
    const rows = [];
    // Chunks are computed when they are first asked for.
    const src = `${stone.url}/4/stone.ome.zarr/`;
    for (const count of counts) {
      const page = await openPage('test/bench/empty.html', { before: countGpuBytes });
      stone.counts.chunks = 0;
      const found = await page.evaluate(show, { base: url, src, count, limit, maxError });
      await page.close();
      const { errors } = found;
      rows.push({
        views: count,
        'all first pictures, s': (found.firstMs / 1000).toFixed(1),
        'all final, s': (found.finalMs / 1000).toFixed(1),
        chunks: stone.counts.chunks,
        'most in 3D textures, MB': formatMegabytes(found.most),
        'error stated: median': errors[Math.floor(errors.length / 2)].toFixed(2),
        worst: errors[errors.length - 1].toFixed(2),
      });
      console.error(JSON.stringify(rows.at(-1)));
      if (!found.isFinal || found.most > limit)
        throw new Error(
          `${count} views: final ${found.isFinal}, ${found.most} bytes; expected all final, and at most ${limit}`,
        );
    }
    printTable(
      `Views in bricks that share ${formatMegabytes(limit)} MB, max-error ${maxError} (${nameMachine(machine)})`,
      rows,
    );
  });
}
