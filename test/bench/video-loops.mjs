// `npm run bench -- video-loops` (`LOOPS=1000`): the memory of a page that shows a video of scans in time from its first to its last frame, again and again: the
// heap of the page after a garbage collection, and what the page's processes have for themselves alone, with the workers and the frames that a
// decoder holds; and how many frames the decoders of the worker have given that nobody has closed. One such frame, or a line about it in the browser's
// console, fails it.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { formatMegabytes, printTable } from './table.mjs';
import { readHeap } from './read-heap.mjs';
import { watchMemory } from './watch-memory.mjs';

const loops = Number(process.env.LOOPS ?? 1000);
const framesOfVideo = 12;

/** Loops after which memory is read: the first ones fill what stays. */
const stops = [...[5, 25, 100, 250, 500, 750].filter((stop) => stop < loops), loops];

const workerFile = 'dist/decode-worker.js';

/** In the worker, before its own code: counts the frames that decoders give, and those that are closed. */
function countFrames() {
  const counts = { given: 0, closed: 0 };
  const { close } = VideoFrame.prototype;
  VideoFrame.prototype.close = function () {
    if (this.format !== null) counts.closed++;
    close.call(this);
  };
  globalThis.VideoDecoder = class extends VideoDecoder {
    /** @param {VideoDecoderInit} init */
    constructor({ output, error }) {
      super({
        output(frame) {
          counts.given++;
          output(frame);
        },
        error,
      });
    }
  };
  Object.assign(globalThis, { countedFrames: counts });
}

/**
 * The frames of all workers of a page.
 * @param {import('@playwright/test').Page} page
 */
async function readFrames(page) {
  let [given, open] = [0, 0];
  for (const worker of page.workers()) {
    const counts = await worker.evaluate(() => /** @type {any} */ (globalThis).countedFrames);
    given += counts.given;
    open += counts.given - counts.closed;
  }
  return { given, open };
}

/**
 * In the page: shows the video from its first to its last frame, so many times. It is opened again each time, because a page keeps the scans of so small a video, and
 * its frames would be decoded once.
 * @param {[string, number, number]} settings
 */
async function showLoops([base, loops, frames]) {
  const view = /** @type {import('../../src/index.ts').VolumeView} */ (document.querySelector('volume-view'));
  for (let loop = 0; loop < loops; loop++) {
    const manifest = {
      video: `${base}test/fixtures/video/vp9-lossless.webm`,
      mosaic: '4x3',
      spacing: [1, 1, 1.3],
      window: [0, 255],
    };
    const url = URL.createObjectURL(new Blob([JSON.stringify(manifest)], { type: 'application/json' }));
    view.time = '0 s';
    view.src = url;
    await view.whenRendered();
    for (let frame = 0; frame < frames; frame++) {
      const shown =
        view.scan?.index === frame
          ? null
          : new Promise((resolve) => view.addEventListener('time-change', resolve, { once: true }));
      view.time = `${frame / 5} s`;
      await shown;
      if (view.scan?.index !== frame) throw new Error(`got frame ${view.scan?.index}; expected ${frame}`);
    }
    await view.whenRendered();
    URL.revokeObjectURL(url);
  }
}

/** In the page. @param {string} base */
async function openPackage(base) {
  await import(`${base}dist/volume-view.js`);
  document.body.innerHTML =
    '<volume-view steps="8" style="width: 48px; height: 48px"></volume-view><volume-timeline></volume-timeline>';
}

export async function run() {
  const counting = () =>
    Buffer.concat([Buffer.from(`(${String(countFrames)})();\n`), readFileSync(join(projectRoot, workerFile))]);
  await measurePackage(measure, { [`/${workerFile}`]: counting });
}

/** @param {import('../helpers/measure-in-browser.mjs').Tools} tools */
async function measure({ browser, url, openPage, machine }) {
  const page = await openPage('test/bench/empty.html');
  /** @type {string[]} */
  const lines = [];
  page.on('console', (message) => {
    if (/VideoFrame|garbage/i.test(message.text())) lines.push(message.text());
  });
  await page.evaluate(openPackage, url);
  /** @type {Record<string, string | number>[]} */
  const rows = [];
  const memory = await watchMemory(browser);
  let done = 0;
  let mostOpen = 0;
  let first = { heap: 0, own: 0, given: 0 };
  for (const stop of stops) {
    await page.evaluate(showLoops, /** @type {[string, number, number]} */ ([url, stop - done, framesOfVideo]));
    done = stop;
    const heap = await readHeap(page);
    const own = memory.now() ?? 0;
    const frames = await readFrames(page);
    mostOpen = Math.max(mostOpen, frames.open);
    if (rows.length === 0) first = { heap, own, given: frames.given };
    rows.push({
      loops: stop,
      frames: stop * framesOfVideo,
      'heap, MB': formatMegabytes(heap),
      'since the first row, kB': Math.round((heap - first.heap) / 1000),
      'processes, MB': formatMegabytes(own),
      'since the first row, MB': formatMegabytes(own - first.own),
      'frames of decoders': frames.given,
      'open frames': frames.open,
    });
    console.error(JSON.stringify(rows.at(-1)));
  }
  memory.stop();
  printTable(`A video of ${framesOfVideo} frames, ${loops} times (${nameMachine(machine)})`, rows);
  if (lines.length > 0) throw new Error(`frames were left open: ${lines[0]}`);
  if (first.given === 0 || mostOpen > 0)
    throw new Error(`got ${mostOpen} open frames of ${first.given}; expected 0 of some`);
}
