// volume-view-prepare as npm would publish it: packed, unpacked, and run where nothing of this checkout is but its dependencies.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  realpathSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { decode } from 'fast-png';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const folder = join(projectRoot, 'packages/prepare');
const consumer = realpathSync(mkdtempSync(join(tmpdir(), 'volume-view-prepare-')));
const installed = join(consumer, 'node_modules/volume-view-prepare');
const work = join(consumer, 'work');
mkdirSync(installed, { recursive: true });
mkdirSync(work);

/** Run the packed program. @param {...string} args */
function run(...args) {
  const { bin } = JSON.parse(readFileSync(join(installed, 'package.json'), 'utf8'));
  const program = join(installed, bin['volume-view-prepare']);
  return spawnSync(process.execPath, [program, ...args], { cwd: work, encoding: 'utf8' });
}

/** @param {string} name */
const fixture = (name) => join(projectRoot, 'test/fixtures', name);

await check('npm pack takes what the program needs, and no source', () => {
  const npm = spawnSync('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', consumer], {
    cwd: folder,
    encoding: 'utf8',
    shell: process.platform === 'win32',
  });
  assert.equal(npm.status, 0, npm.stderr);
  const [pack] = Object.values(JSON.parse(npm.stdout));
  const paths = pack.files.map((/** @type {{ path: string }} */ { path }) => path);
  assert.deepEqual(
    paths.filter((/** @type {string} */ path) => !/^(bin\/|dist\/|package\.json$|README\.md$|LICENSE$)/.test(path)),
    [],
  );
  for (const path of [
    'dist/index.js',
    'dist/volume-view-prepare.js',
    'bin/volume-view-prepare.js',
    'README.md',
    'LICENSE',
    'dist/THIRD-PARTY-LICENSES.txt',
  ])
    assert.ok(paths.includes(path), path);
  const licences = readFileSync(join(folder, 'dist/THIRD-PARTY-LICENSES.txt'), 'utf8');
  for (const library of ['parse5', 'fflate', '@cornerstonejs/codec-charls', 'CharLS', 'OpenJPEG'])
    assert.match(licences, new RegExp(`^${library} .*\\((MIT|BSD-[23]-Clause)\\)`, 'm'), `the licence of ${library}`);
  assert.equal(
    spawnSync('tar', ['-xzf', join(consumer, pack.filename), '-C', installed, '--strip-components=1']).status,
    0,
  );
  for (const name of Object.keys(JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')).dependencies))
    linkDependency(name);
  return `${pack.size} bytes`;
});

await check('in a checkout that is installed, then built, npx finds the program', () => {
  const npx = spawnSync('npx', ['--no-install', 'volume-view-prepare', '--help'], {
    cwd: projectRoot,
    encoding: 'utf8',
    shell: process.platform === 'win32',
  });
  assert.equal(npx.status, 0, npx.stderr);
  assert.match(npx.stdout, /^volume-view-prepare FILE/);
});

/** A dependency, and what that one needs, from this checkout. @param {string} name */
function linkDependency(name) {
  const target = join(consumer, 'node_modules', name);
  if (existsSync(target)) return;
  symlinkSync(join(projectRoot, 'node_modules', name), target, 'junction');
  const { dependencies = {} } = JSON.parse(
    readFileSync(join(projectRoot, 'node_modules', name, 'package.json'), 'utf8'),
  );
  for (const inner of Object.keys(dependencies))
    if (existsSync(join(projectRoot, 'node_modules', inner))) linkDependency(inner);
}

// The numbers of the file are those of test/fixtures/make-radar-fixtures.py, which h5py wrote: 16 radials in the first sweep.
await check('a radar file becomes an image and its manifest', () => {
  const { status, stdout, stderr } = run(fixture('radar/odim-2.2.h5'));
  assert.equal(status, 0, stderr);
  const json = readdirSync(work).find((name) => name.endsWith('.json')) ?? '';
  const manifest = JSON.parse(readFileSync(join(work, json), 'utf8'));
  const png = decode(readFileSync(join(work, manifest.image)));
  const [columns, rows] = manifest.mosaic.split('x').map(Number);
  assert.ok(columns * rows >= manifest.slices && manifest.slices > 1, stdout);
  assert.equal(png.width % columns, 0);
  assert.equal(png.height % rows, 0);
  assert.ok(stdout.includes(`${manifest.slices} sweeps`), stdout);
});

await check('the modules are there for scripts too', async () => {
  const { makeRadarMosaic } = await import(pathToFileURL(join(installed, 'dist/index.js')).href);
  const { manifest, png } = await makeRadarMosaic(
    new Uint8Array(readFileSync(fixture('radar/cfradial1-nc4.nc'))),
    'scan.nc',
  );
  assert.ok(manifest.slices > 0 && png.length > 100);
});

await check('any file becomes a page that holds its bytes', () => {
  const name = 'nifti/' + readdirSync(fixture('nifti')).filter((one) => /\.nii(\.gz)?$/.test(one))[0];
  const { status, stderr } = run(fixture(name), '--as', 'page', '--out', 'head', '--alt', 'A "head" <b>&');
  assert.equal(status, 0, stderr);
  const page = readFileSync(join(work, 'head.html'), 'utf8');
  const [, base64] = /src="data:application\/octet-stream;base64,([^"]*)"/.exec(page) ?? [];
  assert.ok(Buffer.from(base64, 'base64').equals(readFileSync(fixture(name))));
  assert.ok(page.includes('alt="A &quot;head&quot; &lt;b&gt;&amp;"'), 'no markup comes from the words');
});

await check('a file becomes an OME-Zarr, which replaces only an OME-Zarr', () => {
  const name = 'nifti/members.nii.gz';
  for (const turn of [1, 2]) {
    const { status, stdout, stderr } = run(fixture(name), '--as', 'ome-zarr', '--out', 'pyramid');
    assert.equal(status, 0, `turn ${turn}: ${stderr}`);
    assert.match(stdout, /^pyramid\.ome\.zarr: \d+ x \d+ x \d+ voxels, \d+ files, [\d.]+ MB$/m);
  }
  const { attributes } = JSON.parse(readFileSync(join(work, 'pyramid.ome.zarr/zarr.json'), 'utf8'));
  assert.equal(attributes.ome.version, '0.5');
  assert.ok(existsSync(join(work, 'pyramid.ome.zarr/0/c/0/0/0')));
  mkdirSync(join(work, 'other.ome.zarr'));
  writeFileSync(join(work, 'other.ome.zarr/mine.txt'), '');
  const { status, stderr } = run(fixture(name), '--as', 'ome-zarr', '--out', 'other');
  assert.equal(status, 1);
  assert.match(stderr, /other\.ome\.zarr is there, and is no OME-Zarr/);
  assert.ok(existsSync(join(work, 'other.ome.zarr/mine.txt')));
});

await check('what can not be done is said in words, with exit status 1', () => {
  writeFileSync(join(work, 'text.h5'), 'no radar file');
  for (const [args, words] of /** @type {[string[], RegExp][]} */ ([
    [[], /got 0 files; expected one/],
    [['absent.h5'], /absent\.h5/],
    [['text.h5'], /text\.h5 is no radar file/],
    [[fixture('radar/odim-2.2.h5'), '--moment', 'NONE'], /NONE/],
    [[fixture('radar/odim-2.2.h5'), '--as', 'film'], /got --as film; expected mosaic, page or ome-zarr/],
  ])) {
    const { status, stderr } = run(...args);
    assert.equal(status, 1, args.join(' '));
    assert.match(stderr, words);
    assert.doesNotMatch(stderr, /^\s+at /m, 'no stack');
  }
  const large = join(work, 'large.nii');
  writeFileSync(large, Buffer.alloc(64 * 2 ** 20 + 1));
  assert.match(run(large, '--as', 'page').stderr, /64 MiB; expected at most 64/);
});

await check('files are named without folders, whatever a radar file calls its quantity', async () => {
  const { nameFiles } = await import(pathToFileURL(join(installed, 'dist/index.js')).href);
  assert.equal(nameFiles('/data/scan.h5.gz', 'DBZH'), 'scan-DBZH');
  for (const moment of ['../../etc/cron', '..', '/tmp/x', 'a\\b', 'C:x', 'a\0b', '\u001b[2J'])
    assert.match(nameFiles('scan.h5', moment), /^scan-[\w.-]+$/);
  assert.doesNotMatch(nameFiles('scan.h5', '../x'), /\.\.\//);
  assert.equal(nameFiles('.h5', '.x').startsWith('.'), false);
  assert.ok(nameFiles('s'.repeat(4000), 'm'.repeat(4000)).length < 250);
});

/** Whole numbers of 16 bits over some times, as NIfTI-1 has them. */
const moving = {
  dimensions: [12, 9, 5],
  times: 6,
  valueAt: (/** @type {number} */ i, /** @type {number} */ t) => Math.round(300 + 290 * Math.sin(i / 7 + t / 2)),
};

/** @param {string} path */
function writeMoving(path) {
  const { dimensions, times, valueAt } = moving;
  const count = dimensions.reduce((a, b) => a * b);
  const bytes = Buffer.alloc(352 + 2 * count * times);
  bytes.writeInt32LE(348, 0);
  [4, ...dimensions, times, 1, 1, 1].forEach((n, i) => bytes.writeInt16LE(n, 40 + 2 * i));
  bytes.writeInt16LE(4, 70);
  bytes.writeInt16LE(16, 72);
  [1, 2, 2, 3, 0.5].forEach((n, i) => bytes.writeFloatLE(n, 76 + 4 * i));
  bytes.writeFloatLE(352, 108);
  bytes[123] = 2 + 8; // mm and seconds
  bytes.write('n+1\0', 344, 'latin1');
  for (let t = 0; t < times; t++)
    for (let i = 0; i < count; i++) bytes.writeInt16LE(valueAt(i, t), 352 + 2 * (t * count + i));
  writeFileSync(path, bytes);
}

const needsFfmpeg = () => (spawnSync('ffmpeg', ['-version']).error ? 'left out: ffmpeg is not on the PATH' : null);

await check('scans in time become a video, within the error that is stated and allowed', () => {
  const left = needsFfmpeg();
  if (left) return left;
  writeMoving(join(work, 'moving.nii'));
  const { dimensions, times, valueAt } = moving;
  const [nx, ny, nz] = dimensions;
  const sizes = [];
  for (const [error, codec] of [
    ['0', 'vp9'],
    ['8', 'vp9'],
    ['8', 'av1'],
  ]) {
    const { status, stderr, stdout } = run(
      'moving.nii',
      '--as',
      'video',
      '--out',
      'moving',
      '--error',
      error,
      '--codec',
      codec,
    );
    assert.equal(status, 0, stderr);
    assert.match(stdout, /6 scans/);
    const {
      video,
      mosaic,
      slices,
      slope,
      intercept,
      scans,
      lossy,
      spacing: _,
      ...rest
    } = JSON.parse(readFileSync(join(work, 'moving.json'), 'utf8'));
    assert.equal(video, 'moving.webm');
    assert.equal(slices, nz);
    assert.ok(rest.indexToWorld.length === 12);
    assert.deepEqual(
      scans.map((/** @type {{ time: string }} */ { time }) => time),
      ['0 s', '0.5 s', '1 s', '1.5 s', '2 s', '2.5 s'],
    );
    // The true error, by ffmpeg alone.
    const columns = Number(mosaic.split('x')[0]);
    const [width, height] = [columns * nx, Number(mosaic.split('x')[1]) * ny];
    const frameBytes = width * height + 2 * Math.ceil(width / 2) * Math.ceil(height / 2);
    const raw = spawnSync(
      'ffmpeg',
      ['-loglevel', 'error', '-i', 'moving.webm', '-f', 'rawvideo', '-pix_fmt', 'yuv420p', '-'],
      {
        cwd: work,
        maxBuffer: 2 ** 24,
      },
    ).stdout;
    assert.equal(raw.length, times * frameBytes);
    let [squares, max] = [0, 0];
    for (let t = 0; t < times; t++)
      for (let k = 0, i = 0; k < nz; k++)
        for (let y = 0; y < ny; y++)
          for (let x = 0; x < nx; x++, i++) {
            const at = t * frameBytes + (Math.floor(k / columns) * ny + y) * width + (k % columns) * nx + x;
            const off = Math.abs(slope * raw[at] + intercept - valueAt(i, t));
            squares += off * off;
            max = Math.max(max, off);
          }
    const rms = Math.sqrt(squares / (times * nx * ny * nz));
    assert.ok(Math.abs(lossy.rms - rms) < 1e-3 * rms, `${lossy.rms} for ${rms}`);
    assert.ok(max <= lossy.max * 1.001, `${lossy.max} for ${max}`);
    assert.ok(error === '0' ? rms < 580 / 255 : rms <= 8, `${rms} for ${error}`);
    assert.ok(lossy.picture.rms >= 0 && lossy.picture.max >= lossy.picture.p99);
    sizes.push(readFileSync(join(work, 'moving.webm')).length);
  }
  assert.ok(sizes[1] < sizes[0] && sizes[2] < sizes[0], sizes.join());
  return `${sizes.join(', ')} bytes`;
});

await check('a video without ffmpeg, of one scan, of labels and with wrong options is refused in words', () => {
  writeMoving(join(work, 'moving.nii'));
  const { bin } = JSON.parse(readFileSync(join(installed, 'package.json'), 'utf8'));
  const program = join(installed, bin['volume-view-prepare']);
  const without = spawnSync(process.execPath, [program, 'moving.nii', '--as', 'video'], {
    cwd: work,
    encoding: 'utf8',
    env: { PATH: work },
  });
  assert.equal(without.status, 1);
  assert.match(without.stderr, /needs the program ffmpeg.*install it/);
  assert.match(run('moving.nii', '--as', 'video', '--codec', 'mpeg').stderr, /got --codec mpeg; expected vp9 or av1/);
  assert.match(run('moving.nii', '--as', 'video', '--error', '-1').stderr, /got --error -1|ambiguous/);
  const left = needsFfmpeg();
  if (left) return left;
  const one = run(fixture('radar/odim-2.2.h5'), '--as', 'video');
  assert.equal(one.status, 1);
  assert.match(one.stderr, /got one scan; expected several/);
  return '';
});

rmSync(consumer, { recursive: true });
finish();
