// `npm run bench -- video-loops` (`LOOPS=1000`): the memory of a page that shows a video of scans in time from its first to its last frame, again and again: the
// heap of the page after a garbage collection, and what the page's processes have for themselves alone, with the workers and the frames that a
// decoder holds. A frame that nobody closes is a line of the browser's console, and fails it.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { formatMegabytes, printTable } from './table.mjs';
import { readHeap } from './read-heap.mjs';
import { watchMemory } from './watch-memory.mjs';

const loops = Number(process.env.LOOPS ?? 1000);
const frames = 12;

/** Loops after which memory is read: the first ones fill what stays. */
const stops = [...[5, 25, 100, 250, 500, 750].filter((stop) => stop < loops), loops];

/** In the page. @param {[number, number]} counts */
async function showLoops([count, frames]) {
  const view = /** @type {import('../../src/index.ts').VolumeView} */ (document.querySelector('volume-view'));
  for (let loop = 0; loop < count; loop++)
    for (let frame = 0; frame < frames; frame++) {
      const shown =
        view.scan?.index === frame
          ? null
          : new Promise((resolve) => view.addEventListener('time-change', resolve, { once: true }));
      view.time = `${frame / 5} s`;
      await shown;
      await view.whenRendered();
      if (view.scan?.index !== frame) throw new Error(`got frame ${view.scan?.index}; expected ${frame}`);
    }
}

/** In the page. @param {string} base */
async function openVideo(base) {
  await import(`${base}dist/volume-view.js`);
  const manifest = {
    video: `${base}test/fixtures/video/vp9-lossless.webm`,
    mosaic: '4x3',
    spacing: [1, 1, 1.3],
    window: [0, 255],
  };
  document.body.innerHTML =
    '<volume-view steps="8" style="width: 48px; height: 48px"></volume-view><volume-timeline></volume-timeline>';
  const view = /** @type {import('../../src/index.ts').VolumeView} */ (document.querySelector('volume-view'));
  view.src = URL.createObjectURL(new Blob([JSON.stringify(manifest)], { type: 'application/json' }));
  await view.whenRendered();
}

export async function run() {
  await measurePackage(async ({ browser, url, openPage, machine }) => {
    const page = await openPage('test/bench/empty.html');
    /** @type {string[]} */
    const lines = [];
    page.on('console', (message) => {
      if (/VideoFrame|garbage/i.test(message.text())) lines.push(message.text());
    });
    await page.evaluate(openVideo, url);
    /** @type {Record<string, string | number>[]} */
    const rows = [];
    const memory = await watchMemory(browser);
    let done = 0;
    let first = { heap: 0, own: 0 };
    for (const stop of stops) {
      await page.evaluate(showLoops, /** @type {[number, number]} */ ([stop - done, frames]));
      done = stop;
      const heap = await readHeap(page);
      const own = memory.now() ?? 0;
      if (rows.length === 0) first = { heap, own };
      rows.push({
        loops: stop,
        frames: stop * frames,
        'heap, MB': formatMegabytes(heap),
        'since the first row, kB': Math.round((heap - first.heap) / 1000),
        'processes, MB': formatMegabytes(own),
        'since the first row, MB': formatMegabytes(own - first.own),
      });
      console.error(JSON.stringify(rows.at(-1)));
    }
    memory.stop();
    printTable(`A video of ${frames} frames, ${loops} times (${nameMachine(machine)})`, rows);
    if (lines.length > 0) throw new Error(`frames were left open: ${lines[0]}`);
  });
}
