// `npm run bench -- folder`: a folder of DICOM slices, and a ZIP archive of it, from the choice to the first and the final
// picture: times, memory, the longest task of the page, bytes from the disk; and other readers on the same files in the same
// run (test/bench/peers). SLICES=600 EDGE=512 REPEATS=3 FORMS=raw,rle,zip PEERS=dicom-parser,dcm2niix,cornerstone
import {
  existsSync,
  mkdtempSync,
  openSync,
  closeSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Zip, ZipDeflate } from 'fflate';
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { repeats as usualRepeats } from './knobs.mjs';
import { writeSeries } from './synthetic-dicom.mjs';
import { buildLoader } from './peers/build.mjs';
import { formatMegabytes, median, printTable } from './table.mjs';
import { traceTasks } from './trace-tasks.mjs';
import { watchMemory } from './watch-memory.mjs';
import { watchTasks } from './watch-tasks.mjs';

const slices = Number(process.env.SLICES ?? 600);
const edge = Number(process.env.EDGE ?? 512);
const repeats = process.env.REPEATS ? usualRepeats : 3;
const forms = /** @type {('raw' | 'rle' | 'zip')[]} */ ((process.env.FORMS ?? 'raw,rle,zip').split(','));
const peers = (process.env.PEERS ?? 'dicom-parser,dcm2niix,cornerstone').split(',').filter(Boolean);

/** Bytes of the samples. */
const sampleBytes = 2 * edge * edge * slices;

/**
 * In the page: the chosen files in an element of ours.
 * @returns {Promise<Record<'first' | 'lastVoxel' | 'loaded' | 'final' | 'longestTask' | 'isMonotone' | 'voxels', number>>} ms since the choice
 */
async function openInElement() {
  await customElements.whenDefined('volume-view');
  const element = document.createElement('volume-view');
  element.style.cssText = 'width: 512px; height: 512px; max-height: none; aspect-ratio: auto';
  document.body.append(element);
  /** @type {Record<string, number>} */
  const at = {};
  let share = 0;
  let isMonotone = 1;
  element.addEventListener('progress', ({ detail: { loaded, total } }) => {
    at.lastVoxel = performance.now();
    if (total === 0) return;
    if (loaded / total < share) isMonotone = 0;
    share = loaded / total;
  });
  element.addEventListener('load', () => (at.loaded = performance.now()));
  element.addEventListener('render', () => (at.first ??= performance.now()));
  /** @type {any} */ (window).longestTask = 0;
  const began = performance.now();
  performance.mark('begin');
  element.files = /** @type {HTMLInputElement} */ (document.querySelector('input')).files;
  await element.whenRendered();
  at.final = performance.now();
  await new Promise((resolve) => setTimeout(resolve, 100)); // Observers are told of tasks a little later.
  const since = (/** @type {number} */ time) => time - began;
  const volume = /** @type {any} */ (element.volume);
  return {
    first: since(at.first),
    lastVoxel: since(at.lastVoxel),
    loaded: since(at.loaded),
    final: since(at.final),
    longestTask: /** @type {any} */ (window).longestTask,
    isMonotone,
    voxels: volume.dimensions[0] * volume.dimensions[1] * volume.dimensions[2],
  };
}

/**
 * In the page: the plain loop around dicom-parser that many pages have. All slices in one array, in the order of their
 * places.
 */
async function openWithParser() {
  const script = document.createElement('script');
  script.src = '/test/bench/peers/node_modules/dicom-parser/dist/dicomParser.min.js';
  document.head.append(script);
  await new Promise((resolve) => (script.onload = resolve));
  const parser = /** @type {any} */ (window).dicomParser;
  const files = /** @type {FileList} */ (/** @type {HTMLInputElement} */ (document.querySelector('input')).files);
  /** @type {any} */ (window).longestTask = 0;
  const began = performance.now();
  const found = [];
  for (const file of files) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const set = parser.parseDicom(bytes);
    const { dataOffset, length } = set.elements.x7fe00010;
    const z = Number(set.string('x00200032').split('\\')[2]);
    found.push({ z, numbers: new Int16Array(bytes.slice(dataOffset, dataOffset + length).buffer) });
  }
  found.sort((a, b) => a.z - b.z);
  const size = found[0].numbers.length;
  const all = new Int16Array(size * found.length);
  found.forEach(({ numbers }, k) => all.set(numbers, k * size));
  const lastVoxel = performance.now() - began;
  await new Promise((resolve) => setTimeout(resolve, 100));
  return { lastVoxel, longestTask: /** @type {any} */ (window).longestTask, voxels: all.length };
}

/** In the page: dcm2niix, through which NiiVue opens DICOM, in its worker. */
async function openWithConverter() {
  const module = '/test/bench/peers/node_modules/@niivue/dcm2niix/dist/index.js';
  const { Dcm2niix } = await import(module);
  const converter = new Dcm2niix();
  await converter.init();
  const files = /** @type {HTMLInputElement} */ (document.querySelector('input')).files;
  /** @type {any} */ (window).longestTask = 0;
  const began = performance.now();
  const made = await converter.input(files).run();
  const image = made.find((/** @type {File} */ file) => file.name.endsWith('.nii'));
  const bytes = await image.arrayBuffer();
  const lastVoxel = performance.now() - began;
  await new Promise((resolve) => setTimeout(resolve, 100));
  converter.worker.terminate();
  return { lastVoxel, longestTask: /** @type {any} */ (window).longestTask, voxels: (bytes.byteLength - 352) / 2 };
}

/** In the page: Cornerstone's loader, which decodes in workers. */
async function openWithLoader() {
  const module = '/test/bench/peers/dist/cornerstone.js';
  const { openFolder } = await import(module);
  const { files } = /** @type {HTMLInputElement} */ (document.querySelector('input'));
  /** @type {any} */ (window).longestTask = 0;
  const began = performance.now();
  const all = await openFolder(files);
  const lastVoxel = performance.now() - began;
  await new Promise((resolve) => setTimeout(resolve, 100));
  return { lastVoxel, longestTask: /** @type {any} */ (window).longestTask, voxels: all.length };
}

const readers = {
  ours: openInElement,
  'dicom-parser': openWithParser,
  dcm2niix: openWithConverter,
  cornerstone: openWithLoader,
};

/** Bytes that the browser's own process, which reads files for its pages, has read; null where the system does not tell. */
function countRead(/** @type {number} */ id) {
  if (process.platform !== 'linux') return null;
  return Number(/^rchar: (\d+)$/m.exec(readFileSync(`/proc/${id}/io`, 'utf8'))?.[1]);
}

export async function run() {
  if (findPeers().includes('cornerstone')) await buildLoader();
  const scratch = mkdtempSync(join(tmpdir(), 'volume-view-folder-'));
  try {
    const chosen = Object.fromEntries(forms.map((form) => [form, makeFiles(scratch, form)]));
    await measurePackage(async ({ browser, machine, openPage }) => {
      const session = await browser.newBrowserCDPSession();
      const { processInfo } = await session.send('SystemInfo.getProcessInfo');
      const browserId = processInfo.find(({ type }) => type === 'browser')?.id ?? 0;
      const rows = [];
      /** @type {Awaited<ReturnType<typeof findLongTasks>>} */
      let tasks = [];
      for (const form of forms) {
        const names = /** @type {(keyof typeof readers)[]} */ (['ours', ...(form === 'raw' ? findPeers() : [])]);
        /** @type {Record<string, any[]>} */
        const all = Object.fromEntries(names.map((name) => [name, []]));
        for (let turn = 0; turn < repeats; turn++) {
          for (const name of names) {
            const page = await openPage('test/bench/folder.html', { before: watchTasks });
            await page.setInputFiles('input', chosen[form]);
            const memory = await watchMemory(browser);
            const before = countRead(browserId);
            const result = await page.evaluate(readers[name]);
            const after = countRead(browserId);
            if (result.voxels !== sampleBytes / 2)
              throw new Error(`${name} read ${result.voxels} voxels of ${sampleBytes / 2}`);
            all[name].push({
              ...result,
              peak: memory.stop() ?? NaN,
              read: before === null || after === null ? NaN : after - before,
            });
            await page.close();
          }
        }
        if (form === 'raw') tasks = await findLongTasks(browser, openPage, chosen[form]);
        const size = chosen[form].reduce((sum, file) => sum + statSync(file).size, 0);
        for (const name of names) rows.push(describe(form, name, all, size));
      }
      console.log(
        `\n${nameMachine(machine)}, medians of ${repeats}, ${slices} slices of ${edge} x ${edge} numbers of 16 bits, ${formatMegabytes(sampleBytes)} MB\n`,
      );
      printTable(
        "A folder of DICOM: ms since the choice; memory of the page's own process beyond that before, through the bytes of the samples",
        rows,
      );
      if (tasks.length > 0)
        printTable(
          'Tasks of the page above 50 ms in one more run, which is traced: ms since the choice; of them, of its processor, and waiting for the GPU',
          tasks,
        );
    });
  } finally {
    rmSync(scratch, { recursive: true, force: true });
  }
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {import('../helpers/measure-in-browser.mjs').Tools['openPage']} openPage
 * @param {string[]} files
 */
async function findLongTasks(browser, openPage, files) {
  const page = await openPage('test/bench/folder.html', { before: watchTasks });
  await page.setInputFiles('input', files);
  /** @type {Awaited<ReturnType<typeof openInElement>> | undefined} */
  let result;
  const tasks = await traceTasks(browser, page, async () => (result = await page.evaluate(openInElement)));
  await page.close();
  const { lastVoxel = 0, loaded = 0 } = result ?? {};
  return tasks.map(({ at, ms, ownMs, waitMs, waits }) => ({
    at: at.toFixed(0),
    while: at < lastVoxel ? 'files are read' : at < loaded ? 'values are looked at, upload' : 'pictures of the volume',
    ms: ms.toFixed(0),
    'own ms': ownMs.toFixed(0),
    'waits ms': waitMs.toFixed(0),
    for: waits,
  }));
}

/** @param {string} form @param {string} name @param {Record<string, any[]>} all @param {number} size */
function describe(form, name, all, size) {
  const of = (/** @type {string} */ key, /** @type {string} */ who = name) => median(all[who].map((one) => one[key]));
  const ms = (/** @type {string} */ key) => (all[name][0][key] === undefined ? '' : of(key).toFixed(0));
  return {
    files: { raw: 'folder, not packed', rle: 'folder, RLE', zip: 'ZIP archive (Deflate)' }[form] ?? form,
    MB: formatMegabytes(size),
    reader: name,
    'first picture': ms('first'),
    'last voxel': ms('lastVoxel'),
    'last voxel / ours': median(all[name].map(({ lastVoxel }, i) => lastVoxel / all.ours[i].lastVoxel)).toFixed(2),
    'volume shown': ms('loaded'),
    'final picture': ms('final'),
    'longest task': of('longestTask') > 0 ? of('longestTask').toFixed(0) : 'under 50',
    'peak memory / samples': (of('peak') / sampleBytes).toFixed(2),
    'read / size of the files': (of('read') / size).toFixed(2),
    'progress goes back': name === 'ours' ? (of('isMonotone') ? 'no' : 'YES') : '',
  };
}

/** @returns {string[]} */
function findPeers() {
  const isThere = existsSync(join(projectRoot, 'test/bench/peers/node_modules/dicom-parser'));
  if (!isThere)
    console.log('peers left out, as they are not installed: npm ci --prefix test/bench/peers --ignore-scripts');
  return isThere ? peers : [];
}

/** @param {string} scratch @param {'raw' | 'rle' | 'zip'} form @returns {string[]} paths */
function makeFiles(scratch, form) {
  const packing = form === 'rle' ? 'rle' : 'raw';
  const folder = join(scratch, packing);
  const files = existsSync(folder)
    ? readdirSync(folder).map((name) => join(folder, name))
    : writeSeries(folder, { slices, edge, packing });
  if (form !== 'zip') return files;
  const path = join(scratch, 'series.zip');
  const out = openSync(path, 'w');
  const zip = new Zip((error, data) => {
    if (error) throw error;
    writeSync(out, data);
  });
  files.forEach((file, i) => {
    const entry = new ZipDeflate(`series/${i}.dcm`, { level: 1 });
    zip.add(entry);
    entry.push(readFileSync(file), true);
  });
  zip.end();
  closeSync(out);
  return [path];
}
