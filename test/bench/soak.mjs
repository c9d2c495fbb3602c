// `npm run bench -- soak` (`SECONDS=60`, `LIMIT=48e6`): a view in bricks that is turned and zoomed, in and out, for a minute, over a network of 10 MB/s with 300 ms before each
// answer, of which a tenth fails: errors, bytes on the GPU, memory, and requests that are alive once the element has left the page, which fail it. No program
// follows the browser meanwhile: see browser-alone.mjs.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { openAlone } from './browser-alone.mjs';
import { formatMegabytes, printTable } from './table.mjs';

const seconds = Number(process.env.SECONDS ?? 60);
const limit = Number(process.env.LIMIT ?? 48e6);

/** In the page. @param {{ base: string, limit: number }} asked */
async function begin({ base, limit: bytes }) {
  await import(`${base}dist/volume-view.js`);
  const { serveStone } = /** @type {typeof import('./serve-stone.mjs')} */ (
    await import(`${base}test/bench/serve-stone.mjs`)
  );
  const stone = serveStone(base, 1, { delay: 300, bytesPerSecond: 10e6, failing: 0.1 });
  const view = document.createElement('volume-view');
  view.fetch = stone.fetch;
  const seen = { errors: /** @type {string[]} */ ([]), gpu: 0, frames: 0 };
  view.addEventListener('error', (event) => seen.errors.push(String(/** @type {any} */ (event).detail?.message)));
  view.addEventListener('render', () => {
    seen.frames++;
    seen.gpu = Math.max(seen.gpu, view.renderStats?.bricks?.bytes ?? 0);
  });
  for (const [name, value] of Object.entries({
    alt: 'A stone',
    loading: 'eager',
    src: stone.folder,
    'max-gpu-bytes': String(bytes),
    'max-error': '2',
    'camera-orbit': '0deg 68deg 72%',
    'transfer-function': '50 #4a3423 0%, 105 #9a744c 45%, 165 #d8bc8e 75%, 255 #fff6e2 90%',
  }))
    view.setAttribute(name, value);
  view.style.cssText = 'display: block; width: 240px; height: 180px';
  document.body.append(view);
  Object.assign(globalThis, { soak: { view, stone, seen } });
}

/** In the page: turns and zooms, in and out in 20 s. @param {[number, number]} span - s */
async function move([from, to]) {
  const { view, stone, seen } = /** @type {any} */ (globalThis).soak;
  const began = performance.now();
  for (let at = from; at < to; at = from + (performance.now() - began) / 1000) {
    const distance = 72 * 0.06 ** (0.5 - 0.5 * Math.cos((2 * Math.PI * at) / 20));
    view.setAttribute('camera-orbit', `${(12 * at) % 360}deg 68deg ${distance}%`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  return { ...stone.counts, ...seen, bricks: view.renderStats?.bricks?.count ?? 0 };
}

/** In the page: takes the element out, and counts what is still asked for. */
async function end() {
  const { view, stone } = /** @type {any} */ (globalThis).soak;
  view.remove();
  await new Promise((resolve) => setTimeout(resolve, 500));
  const { asked } = stone.counts;
  await new Promise((resolve) => setTimeout(resolve, 1500));
  return { alive: stone.counts.alive, later: stone.counts.asked - asked };
}

/** In the page: all of it, with a report each 20 s. @param {{ base: string, limit: number, seconds: number }} asked */
async function soakAll({ base, limit: bytes, seconds: length }) {
  const reports = location.search.slice(1);
  /** @param {object} what */
  const report = (what) => fetch(reports, { method: 'POST', body: JSON.stringify(what) });
  try {
    await begin({ base, limit: bytes });
    for (let from = 0; from < length; from += 20) {
      const to = Math.min(length, from + 20);
      const found = await move([from, to]);
      /** @type {any} */ (globalThis).gc();
      await report({ after: to, ...found, heap: /** @type {any} */ (performance).memory.usedJSHeapSize });
    }
    await report({ left: await end() });
    await report({ isOver: true });
  } catch (error) {
    await report({ thrown: String(error) });
  }
}

const pagePath = 'test/bench/soak.html';

export async function run() {
  const functions = [begin, move, end, soakAll].map(String).join('\n');
  let base = '';
  const page = () =>
    `<!doctype html><body><script type="module">${functions}\nsoakAll(${JSON.stringify({ base, limit, seconds })})</script>`;
  await measurePackage(
    async ({ url, machine, browser }) => {
      base = url;
      await browser.close();
      await measure(url, machine);
    },
    { [`/${pagePath}`]: () => Buffer.from(page()) },
  );
}

/** @param {string} url @param {import('../helpers/measure-in-browser.mjs').Machine} machine */
async function measure(url, machine) {
  /** @type {Record<string, string | number>[]} */
  const rows = [];
  /** @type {string[]} */
  let errors = [];
  let left = { alive: NaN, later: NaN };
  /** @type {import('./browser-alone.mjs').Alone | null} */
  let alone = null;
  /** @param {any} said */
  const take = (said) => {
    if (said.left) {
      ({ left } = said);
      return;
    }
    ({ errors } = said);
    rows.push({
      'after, s': said.after,
      frames: said.frames,
      requests: said.asked,
      failed: said.failed,
      'at once': said.most,
      'read, MB': formatMegabytes(said.bytes),
      bricks: said.bricks,
      'most on the GPU, MB': formatMegabytes(said.gpu),
      errors: errors.length,
      'heap, MB': formatMegabytes(said.heap),
      'processes, MB': formatMegabytes(alone?.readMemory() ?? 0),
    });
    console.error(JSON.stringify(rows.at(-1)));
  };
  await openAlone(`${url}${pagePath}`, { take }, async (opened) => {
    alone = opened;
    await opened.ended;
  });
  printTable(`A stone of 2,048 voxels, turned and zoomed (${nameMachine(machine)})`, rows);
  console.log(
    `after it left the page: ${left.alive} requests alive, ${left.later} new ones; errors: ${errors.slice(0, 2).join('; ')}`,
  );
  if (left.alive !== 0 || left.later !== 0)
    throw new Error('the element asks for chunks after it has left the page, or it was not counted');
}
