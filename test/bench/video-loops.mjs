// `npm run bench -- video-loops` (`LOOPS=1000`): the memory of a page that shows a video of scans in time from its first to its last frame, again and again: the
// heap of the page after a garbage collection, and what the page's processes have for themselves alone, with the workers and the frames that a
// decoder holds; and how many frames the decoders of the worker have given that nobody has closed. One such frame, or a line about it in the browser's
// console, fails it. No program follows the browser meanwhile: see browser-alone.mjs.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { openAlone } from './browser-alone.mjs';
import { formatMegabytes, printTable } from './table.mjs';

const loops = Number(process.env.LOOPS ?? 1000);
const framesOfVideo = 12;

/** Loops after which memory is read: the first ones fill what stays. */
const stops = [...[5, 25, 100, 250, 500, 750].filter((stop) => stop < loops), loops];

const workerFile = 'dist/decode-worker.js';

/** In the worker, before its own code: counts the frames that decoders give, and those that are closed, and collects garbage. @param {string} reports */
function countFrames(reports) {
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
  const collected = new BroadcastChannel('collect garbage');
  collected.onmessage = async () => {
    /** @type {any} */ (globalThis).gc();
    await fetch(reports, { method: 'POST', body: JSON.stringify({ frames: counts }) });
    collected.postMessage('done');
  };
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

/**
 * In the page: shows the video, and reports its heap after so many loops.
 * @param {string} base @param {readonly number[]} loopsOfReports @param {number} frames
 */
async function showAll(base, loopsOfReports, frames) {
  const reports = location.search.slice(1);
  /** @param {object} what */
  const report = (what) => fetch(reports, { method: 'POST', body: JSON.stringify(what) });
  const worker = new BroadcastChannel('collect garbage');
  try {
    await import(`${base}dist/volume-view.js`);
    document.body.innerHTML =
      '<volume-view alt="A video" steps="8" style="width: 48px; height: 48px"></volume-view><volume-timeline></volume-timeline>';
    let done = 0;
    for (const loops of loopsOfReports) {
      await showLoops([base, loops - done, frames]);
      done = loops;
      const collected = new Promise((resolve) => (worker.onmessage = resolve));
      worker.postMessage('');
      await collected;
      for (let n = 0; n < 3; n++) {
        /** @type {any} */ (globalThis).gc();
        await new Promise((resolve) => setTimeout(resolve, 300));
      }
      await report({ loops, heap: /** @type {any} */ (performance).memory.usedJSHeapSize });
    }
    await report({ isOver: true });
  } catch (error) {
    await report({ thrown: String(error) });
  }
}

const pagePath = 'test/bench/video-loops.html';

export async function run() {
  const page = (/** @type {string} */ base) =>
    `<!doctype html><body><script type="module">${String(showLoops)}\n(${String(showAll)})(${JSON.stringify(base)}, ${JSON.stringify(stops)}, ${framesOfVideo})</script>`;
  /** @type {{ base?: string, reports?: string }} */
  const known = {};
  await measurePackage(
    async ({ url, machine, browser }) => {
      known.base = url;
      await browser.close();
      await measure(url, machine, (reports) => (known.reports = reports));
    },
    {
      [`/${pagePath}`]: () => Buffer.from(page(known.base ?? '')),
      [`/${workerFile}`]: () =>
        Buffer.from(
          `(${String(countFrames)})('${known.reports}');\n${readFileSync(join(projectRoot, workerFile), 'utf8')}`,
        ),
    },
  );
}

/**
 * @param {string} url @param {import('../helpers/measure-in-browser.mjs').Machine} machine
 * @param {(reports: string) => void} setReports
 */
async function measure(url, machine, setReports) {
  /** @type {Record<string, string | number>[]} */
  const rows = [];
  let frames = { given: 0, closed: 0 };
  let mostOpen = 0;
  let first = { heap: 0, own: 0 };
  /** @type {import('./browser-alone.mjs').Alone | null} */
  let alone = null;
  /** @param {{ frames?: { given: number, closed: number }, loops?: number, heap?: number }} said */
  const take = ({ frames: counted, loops: done = 0, heap = 0 }) => {
    if (counted) {
      frames = counted;
      mostOpen = Math.max(mostOpen, counted.given - counted.closed);
      return;
    }
    const own = alone?.readMemory() ?? 0;
    if (rows.length === 0) first = { heap, own };
    rows.push({
      loops: done,
      frames: done * framesOfVideo,
      'heap, MB': formatMegabytes(heap),
      'since the first row, kB': Math.round((heap - first.heap) / 1000),
      'processes, MB': formatMegabytes(own),
      'since the first row, MB': formatMegabytes(own - first.own),
      'frames of decoders': frames.given,
      'open frames': frames.given - frames.closed,
    });
    console.error(JSON.stringify(rows.at(-1)));
  };
  await openAlone(`${url}${pagePath}`, { take, setReports }, async (opened) => {
    alone = opened;
    await opened.ended;
    const line = opened
      .readConsole()
      .split('\n')
      .find((one) => /VideoFrame.*garbage/i.test(one));
    if (line) throw new Error(`frames were left open: ${line}`);
  });
  printTable(`A video of ${framesOfVideo} frames, ${loops} times (${nameMachine(machine)})`, rows);
  if (frames.given === 0 || mostOpen > 0)
    throw new Error(`got ${mostOpen} open frames of ${frames.given}; expected 0 of some`);
}
