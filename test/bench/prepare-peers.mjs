// `npm run bench -- prepare-peers` (`SLICES=200 EDGE=256 REPEATS=3 NGFF_ZARR=path/of/ngff-zarr`): volume-view-prepare beside other programs on the same files in
// one run: dcm2niix reads a series of DICOM, and ngff-zarr makes a pyramid of a NIfTI file. What is not on the PATH is left out. Wall clock, processor time of
// all processes, the memory of the largest one, and bytes that are written. The time of GNU (/usr/bin/time) measures.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { cpus, loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { repeats as usualRepeats } from './knobs.mjs';
import { writeSeries } from './synthetic-dicom.mjs';
import { formatMegabytes, median, printTable } from './table.mjs';

const slices = Number(process.env.SLICES ?? 200);
const edge = Number(process.env.EDGE ?? 256);
const repeats = process.env.REPEATS ? usualRepeats : 3;
const ngffZarr = process.env.NGFF_ZARR ?? 'ngff-zarr';
const prepare = [process.execPath, join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js')];

/** @typedef {{ seconds: number, processor: number, memory: number, bytes: number }} Measured */

/** @param {string} name */
const isThere = (name) => spawnSync(name, ['--help'], { stdio: 'ignore' }).error === undefined;

/** @param {string} path @returns {number} of all files */
const bytesIn = (path) =>
  statSync(path).isFile()
    ? statSync(path).size
    : readdirSync(path).reduce((sum, name) => sum + bytesIn(join(path, name)), 0);

/** @param {string} work @param {readonly string[]} command @returns {Measured} */
function measure(work, command) {
  const out = join(work, 'out');
  rmSync(out, { recursive: true, force: true });
  rmSync(`${out}.private`, { recursive: true, force: true });
  spawnSync('mkdir', [out]);
  const log = join(work, 'time');
  const { status, stderr } = spawnSync('/usr/bin/time', ['-o', log, '-f', '%e %U %S %M', ...command], {
    cwd: work,
    encoding: 'utf8',
  });
  if (status !== 0) throw new Error(`${command.join(' ')}: ${stderr.slice(-500)}`);
  const [seconds, user, system, kilobytes] = readFileSync(log, 'utf8').trim().split(/\s+/).map(Number);
  return { seconds, processor: user + system, memory: 1024 * kilobytes, bytes: bytesIn(out) };
}

/** @param {string} work @param {Record<string, readonly string[]>} commands @param {string} title */
function compare(work, commands, title) {
  /** @type {Record<string, Measured[]>} */
  const all = Object.fromEntries(Object.keys(commands).map((name) => [name, []]));
  // One after the other, again and again, so that a machine that becomes busy is so for all of them.
  for (let i = 0; i < repeats; i++)
    for (const [name, command] of Object.entries(commands)) all[name].push(measure(work, command));
  const middle = (/** @type {string} */ name, /** @type {keyof Measured} */ what) =>
    median(all[name].map((one) => one[what]));
  printTable(
    title,
    Object.keys(commands).map((name) => ({
      program: name,
      'time, s': middle(name, 'seconds').toFixed(1),
      'processor, s': middle(name, 'processor').toFixed(1),
      'memory, MB': formatMegabytes(middle(name, 'memory')),
      'written, MB': formatMegabytes(middle(name, 'bytes')),
    })),
  );
}

export async function run() {
  if (!existsSync('/usr/bin/time')) return console.log('left out: it needs /usr/bin/time (apt install time)');
  const work = mkdtempSync(join(tmpdir(), 'volume-view-peers-'));
  try {
    console.log(`${cpus().length} processors, load ${loadavg()[0].toFixed(1)} at the start, median of ${repeats}\n`);
    writeSeries(join(work, 'series'), { slices, edge, packing: 'raw' });
    const size = `${edge} x ${edge} x ${slices} voxels of 16 bits`;
    const hasConverter = isThere('dcm2niix');
    const site = (/** @type {string} */ form) => [
      ...prepare,
      'series',
      '--out',
      'out',
      '--as',
      form,
      '--poster',
      '0',
      '--jobs',
      '1',
    ];
    compare(
      work,
      {
        'volume-view-prepare, PNG mosaic and page': site('mosaic'),
        'volume-view-prepare, OME-Zarr and page': site('ome-zarr'),
        ...(hasConverter && {
          'dcm2niix, not packed': ['dcm2niix', '-z', 'n', '-o', 'out', 'series'],
          'dcm2niix, packed': ['dcm2niix', '-z', 'i', '-o', 'out', 'series'],
        }),
      },
      `A series of DICOM, ${size}`,
    );
    if (!hasConverter)
      return console.log('pyramids are left out: dcm2niix, which writes the NIfTI file, is not on the PATH');
    spawnSync('dcm2niix', ['-z', 'n', '-f', 'volume', '-b', 'n', '-o', work, join(work, 'series')]);
    compare(
      work,
      {
        'volume-view-prepare': [...prepare, 'volume.nii', '--as', 'ome-zarr', '--out', 'out/volume'],
        ...(isThere(ngffZarr) && {
          'ngff-zarr, its default': [ngffZarr, '-q', '-i', 'volume.nii', '-o', 'out/volume.ome.zarr'],
          'ngff-zarr, means, 0.5, gzip, chunks of 32': [
            ...[ngffZarr, '-q', '-i', 'volume.nii', '-o', 'out/volume.ome.zarr', '--ome-zarr-version', '0.5'],
            ...['-m', 'dask_bin_shrink', '-c', '32', '--chunks-per-shard', '8', '--codec', 'gzip'],
          ],
        }),
      },
      `An OME-Zarr of a NIfTI file, ${size}`,
    );
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}
