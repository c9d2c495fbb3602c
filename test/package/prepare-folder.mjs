// `volume-view-prepare FOLDER --out SITE` as a person runs it, on the built program: what is found, what is written, what no file says, and
// what is left when it is ended at any moment. The moments are drawn anew in each run; `--kills 50` ends it more often.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  utimesSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import { decode } from 'fast-png';
import { runnerImport } from 'vite';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const { values } = parseArgs({ options: { kills: { type: 'string', default: '8' } } });
const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const work = mkdtempSync(join(tmpdir(), 'volume-view-folder-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

/** @param {string} path */
const importHelper = async (path) =>
  (await runnerImport(join(projectRoot, path), { configFile: false, logLevel: 'error', root: projectRoot })).module;
const { dicomBytes, ctSlice } = await importHelper('test/helpers/dicom-bytes.ts');
const { readManifest } = await importHelper('src/formats/manifest/manifest.ts');
const { zipSync } = await import('fflate');

/** @param {string} name */
const fixture = (name) => join(projectRoot, 'test/fixtures', name);

/** Words that only the files have. */
const planted = {
  PatientName: 'Plantedname^Erika',
  PatientID: 'PLANTEDID77',
  PatientBirthDate: '19011231',
  StudyDate: '20111213',
  AcquisitionDate: '20111213',
  InstitutionName: 'Plantedhospital',
  SeriesDescription: 'Plantedseries',
  StudyInstanceUID: '1.2.3.98765.1',
};
const inPaths = ['Plantedfolder', 'plantedfile'];

/** A folder of a hospital. */
const folder = join(work, 'in');
/** @param {string} name @param {Uint8Array | string} bytes */
function put(name, bytes) {
  mkdirSync(join(folder, name, '..'), { recursive: true });
  writeFileSync(join(folder, name), bytes);
}
/** @param {string} uid @param {number} count @param {number} base @returns {Uint8Array[]} */
const series = (uid, count, base) =>
  Array.from({ length: count }, (_, i) =>
    dicomBytes(
      ctSlice(
        5 * i,
        { ...planted, SeriesInstanceUID: uid, SOPInstanceUID: `${uid}.${i}`, InstanceNumber: [i + 1] },
        base + 100 * i,
      ),
    ),
  );
// One series lies in two folders, another between its files.
series('1.2.3.98765.10', 6, 100).forEach((bytes, i) =>
  put(`Plantedfolder/${i % 2 ? 'a' : 'b'}/plantedfile-${i}`, bytes),
);
series('1.2.3.98765.11', 4, 900).forEach((bytes, i) => put(`Plantedfolder/a/plantedfile-x${i}.dcm`, bytes));
put(
  'Plantedfolder/plantedfile.zip',
  zipSync(
    Object.fromEntries(series('1.2.3.98765.12', 3, 500).map((bytes, i) => [`Plantedfolder/plantedfile${i}`, bytes])),
  ),
);
put('Plantedfolder/plantedfile.nii', readFileSync(fixture('nifti/v1-le-i2.nii')));
// Volumes every 2.5 seconds.
const series4d = readFileSync(fixture('nifti/v1-le-series.nii'));
series4d[123] = 2 + 8;
series4d.writeFloatLE(2.5, 76 + 4 * 4);
put('Plantedfolder/plantedfile-series.nii', series4d);
put('Plantedfolder/plantedfile-cut.nii', readFileSync(fixture('nifti/v1-le-i2.nii')).subarray(0, 400));
put('Plantedfolder/plantedfile.txt', 'Plantedname');
for (const name of ['formats/analyze-le-i2.hdr', 'formats/analyze-le-i2.img', 'radar/odim-2.2.h5']) copyFixture(name);
/** @param {string} name */
function copyFixture(name) {
  copyFileSync(fixture(name), join(folder, 'Plantedfolder', `plantedfile-${basename(name)}`));
}

/** Pixels across in posters: one of 256, as without the option, takes 2.5 seconds of a processor a volume. */
const posterSize = 32;
/** @param {string} site @param {...string} args */
const argsOf = (site, ...args) => [
  ...[program, folder, '--out', site, '--jobs', '2', '--poster', String(posterSize)],
  ...args,
];

/** @param {string} site @param {...string} args */
function run(site, ...args) {
  const { status, stdout, stderr } = spawnSync(process.execPath, argsOf(site, ...args), {
    encoding: 'utf8',
    cwd: work,
  });
  const lines = stdout.split('\n').filter(Boolean);
  return { status, stderr, stdout, lines: lines.map((line) => JSON.parse(line)) };
}

/** All files of a site with their times of change. @param {string} site @returns {Map<string, number>} */
const listSite = (site) =>
  new Map(
    readdirSync(site, { recursive: true, encoding: 'utf8' })
      .filter((name) => statSync(join(site, name)).isFile())
      .map((name) => [name, statSync(join(site, name)).mtimeMs]),
  );

const site = join(work, 'site');
const began = performance.now();
const first = run(site);
/** Milliseconds. */
const wholeRun = performance.now() - began;
const done = first.lines.filter(({ status }) => status === 'done');

await check('all volumes of a folder are made, a broken one is listed, and the exit status says so', () => {
  assert.equal(first.status, 2, first.stderr);
  assert.equal(first.lines.filter(({ status }) => status === 'failed').length, 1, first.stdout);
  const sizes = done.map(({ dimensions }) => dimensions.join('x'));
  // The series of 6, 4 and 3 slices, wherever their files are.
  for (const size of ['4x3x6', '4x3x4', '4x3x3'])
    assert.equal(sizes.filter((one) => one === size).length, 1, `${size} of ${sizes.join()}`);
  for (const line of done) {
    assert.ok(existsSync(join(site, line.page)), line.page);
    const manifest = JSON.parse(readFileSync(join(site, line.id, 'volume.json'), 'utf8'));
    const png = decode(readFileSync(join(site, line.id, manifest.image)));
    const [columns, rows] = manifest.mosaic.split('x').map(Number);
    assert.ok(png.width % columns === 0 && png.height % rows === 0);
    assert.equal(png.depth, line.bits);
    const poster = decode(readFileSync(join(site, line.id, 'poster.png')));
    assert.deepEqual([poster.width, poster.height, poster.channels], [posterSize, posterSize, 4]);
    assert.match(readFileSync(join(site, line.page), 'utf8'), / poster="poster.png"/);
  }
  assert.equal(readFileSync(join(site, 'index.html'), 'utf8').split('<img src="').length - 1, countCards());
  const values = done.find(({ dimensions }) => dimensions.join('x') === '4x3x6');
  assert.deepEqual(values.error, { max: 0, rms: 0 });
  assert.equal(values.unit, 'HU');
  return `${done.length} volumes`;
});

/** Places in the index: a series of scans has one. */
function countCards() {
  return new Set(done.map(({ page, scans = page }) => scans)).size;
}

await check('scans in time have a page of their own, and one place in the index', () => {
  const series = done.filter(({ scans }) => scans !== undefined);
  assert.ok(series.length > 1 && countCards() === done.length - series.length + 1, first.stdout);
  const page = join(site, series[0].scans);
  assert.match(readFileSync(page, 'utf8'), /src="scans.json"[^]*<volume-timeline for="view">/);
  const { scans } = readManifest(new Uint8Array(readFileSync(join(page, '../scans.json'))));
  assert.deepEqual(
    scans.map((/** @type {{ time: string }} */ { time }) => time),
    ['0 s', '2.5 s'],
  );
  for (const { image } of scans) assert.ok(existsSync(join(page, '..', image)), image);
  return `${scans.length} scans, ${scans[0].time} to ${scans.at(-1).time}`;
});

await check('a volume has the numbers of its files', () => {
  const { id } = done.find(({ dimensions }) => dimensions.join('x') === '4x3x6');
  const manifest = JSON.parse(readFileSync(join(site, id, 'volume.json'), 'utf8'));
  const png = decode(readFileSync(join(site, id, 'volume.png')));
  const columns = Number(manifest.mosaic.split('x')[0]);
  for (let k = 0; k < 6; k++) {
    for (let i = 0; i < 12; i++) {
      const at = (Math.floor(k / columns) * 3 + Math.floor(i / 4)) * png.width + (k % columns) * 4 + (i % 4);
      assert.equal(manifest.slope * png.data[at] + manifest.intercept, 100 + 100 * k + i - 1024);
    }
  }
});

await check('no name, date, number or folder of a file is in the site or in what is printed', () => {
  const all = [...Object.values(planted), ...inPaths, '1.2.3.98765', 'Erika', work];
  const texts = [...listSite(site).keys()].map((name) => `${name}\n${readFileSync(join(site, name), 'latin1')}`);
  // The summary for the person says where the site is.
  for (const text of [...texts, first.stdout])
    for (const word of all)
      assert.ok(!text.toLowerCase().includes(word.toLowerCase()), `${word} is in ${text.slice(0, 200)}`);
  const table = readFileSync(join(`${site}.private`, 'scans.tsv'), 'utf8');
  assert.ok(table.includes('plantedfile-cut.nii'), 'the person can find the file that failed');
});

await check('without --poster a poster has 256 pixels a side', () => {
  const alone = join(work, 'alone');
  mkdirSync(alone);
  copyFileSync(fixture('nifti/v1-le-i2.nii'), join(alone, 'one.nii'));
  const { stdout } = spawnSync(process.execPath, [program, alone, '--out', join(work, 'alone-site')], {
    encoding: 'utf8',
  });
  const poster = decode(readFileSync(join(work, 'alone-site', JSON.parse(stdout).id, 'poster.png')));
  assert.deepEqual([poster.width, poster.height, poster.channels], [256, 256, 4]);
});

await check('names of files are kept where a person asks for it, those of DICOM never', () => {
  const named = run(join(work, 'named'), '--keep-names');
  const titles = named.lines.filter(({ status }) => status === 'done').map(({ title }) => title);
  assert.ok(titles.includes('plantedfile.nii'), titles.join());
  assert.ok(!titles.some((title) => /plantedfile-?\d/.test(title)), titles.join());
});

await check('a second run writes nothing, and one after a file changed makes that one alone', () => {
  const before = listSite(site);
  const second = run(site);
  assert.deepEqual(listSite(site), before);
  assert.equal(second.lines.filter(({ status }) => status === 'unchanged').length, done.length);
  // Nor does it make anything with more or less memory.
  assert.equal(run(site, '--memory', '2000').lines.filter(({ status }) => status === 'done').length, 0);
  // Another time and the same bytes are no change.
  utimesSync(join(folder, 'Plantedfolder/plantedfile.nii'), 1e9, 1e9);
  assert.equal(run(site).lines.filter(({ status }) => status === 'done').length, 0);
  assert.deepEqual(listSite(site), before);
  const bytes = readFileSync(fixture('nifti/v1-le-u1.nii'));
  writeFileSync(join(folder, 'Plantedfolder/plantedfile.nii'), bytes);
  assert.equal(run(site).lines.filter(({ status }) => status === 'done').length, 1);
});

await check('pages for the disk hold their data', () => {
  const single = join(work, 'single');
  run(single, '--as', 'single-file', '--poster', '0');
  assert.ok(![...listSite(single).keys()].some((name) => name.includes('poster')), 'no picture is wanted');
  for (const name of readdirSync(single).filter((one) => /^[0-9a-f]{16}/.test(one))) {
    assert.deepEqual(
      readdirSync(join(single, name)).filter((one) => one.startsWith('volume')),
      [],
    );
    const [, json] =
      /src="data:application\/json,([^"]*)"/.exec(readFileSync(join(single, name, 'index.html'), 'utf8')) ?? [];
    const manifest = JSON.parse(decodeURIComponent(json.replaceAll('&quot;', '"').replaceAll('&amp;', '&')));
    decode(Buffer.from(manifest.image.split(',')[1], 'base64'));
  }
});

await check('a small edge makes a large volume smaller, and says what is lost', () => {
  const large = join(work, 'large');
  mkdirSync(large);
  const [n, k] = [300, 128];
  const header = Buffer.from(
    `NRRD0004\ntype: uint8\ndimension: 3\nsizes: ${n} ${n} ${k}\nspace: right-anterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,2)\nspace origin: (0,0,0)\nencoding: raw\n\n`,
  );
  const data = Buffer.alloc(n * n * k);
  for (let z = 0; z < k; z++)
    for (let y = 0; y < n; y++)
      for (let x = 0; x < n; x++) data[x + n * (y + n * z)] = 100 + 50 * Math.sin(x / 9) + 0.1 * y + 0.3 * z;
  writeFileSync(join(large, 'large.nrrd'), Buffer.concat([header, data]));
  const { stdout } = spawnSync(
    process.execPath,
    [program, large, '--out', join(work, 'phone'), '--fit', 'phone', '--poster', '0'],
    {
      encoding: 'utf8',
    },
  );
  const line = JSON.parse(stdout);
  assert.deepEqual(line.from, [n, n, k]);
  // The values change most along the columns: these stay as they are.
  assert.equal(line.dimensions[0], n, stdout);
  assert.ok(line.error.max > 0 && line.error.max < 10 && line.error.rms <= line.error.max, stdout);
  const manifest = JSON.parse(readFileSync(join(work, 'phone', line.id, 'volume.json'), 'utf8'));
  assert.deepEqual(manifest.prepared.from, [n, n, k]);
  const [factorY, factorZ] = [n / line.dimensions[1], k / line.dimensions[2]];
  // The centre of the first voxel is half of a larger voxel less half of a small one from where it was.
  assert.ok(Math.abs(manifest.indexToWorld[7] - (factorY - 1) / 2) < 1e-9, stdout);
  assert.ok(Math.abs(manifest.indexToWorld[11] - factorZ + 1) < 1e-9, stdout);
  return `${line.dimensions.join(' x ')}, rms ${line.error.rms.toFixed(2)}`;
});

await check(`ended at ${values.kills} moments it leaves no half folder, and the next run goes on`, async () => {
  const killed = join(work, 'killed');
  let whole = 0;
  for (let i = 0; i < Number(values.kills); i++) {
    const child = spawn(process.execPath, argsOf(killed), { stdio: 'ignore' });
    // One in each part of a run: moments that are all near its beginning show nothing.
    await new Promise((resolve) => setTimeout(resolve, (wholeRun * (i + Math.random())) / Number(values.kills)));
    child.kill('SIGKILL');
    await new Promise((resolve) =>
      child.exitCode === null && child.signalCode === null ? child.once('exit', resolve) : resolve(null),
    );
    if (!existsSync(killed)) continue;
    for (const name of readdirSync(killed)) {
      if (name === 'volume-view.iife.js')
        for (const part of ['classic', 'x3dom.js']) assert.ok(existsSync(join(killed, part)), part);
      if (!/^[0-9a-f]{16}/.test(name)) continue;
      // A web server is another user.
      if (process.platform !== 'win32') assert.equal(statSync(join(killed, name)).mode & 0o777, 0o755);
      const isSeries = name.endsWith('-scans');
      for (const file of ['index.html', 'poster.png', ...(isSeries ? ['scans.json'] : ['volume.json', 'volume.png'])])
        assert.ok(existsSync(join(killed, name, file)), `${name}/${file}`);
      if (isSeries) {
        const { scans } = JSON.parse(readFileSync(join(killed, name, 'scans.json'), 'utf8'));
        for (const { image } of scans) assert.ok(existsSync(join(killed, name, image)), `${name}: ${image}`);
        continue;
      }
      const manifest = JSON.parse(readFileSync(join(killed, name, 'volume.json'), 'utf8'));
      decode(readFileSync(join(killed, name, manifest.image)));
      whole++;
    }
    // Some begin again from nothing, so that also the first files of a run are interrupted.
    if (i % 5 === 4) rmSync(killed, { recursive: true, force: true });
  }
  const last = run(killed);
  assert.equal(last.status, 2, last.stderr);
  assert.equal(last.lines.filter(({ status }) => status !== 'failed').length, done.length);
  assert.deepEqual(
    readdirSync(killed).filter((name) => name.startsWith('.')),
    [],
  );
  assert.ok(whole > 0, 'no run came as far as to write something');
  return `${whole} whole folders seen`;
});

await check('what can not be done is said in words', () => {
  for (const [args, words] of /** @type {[string[], RegExp][]} */ ([
    [[folder], /--out/],
    [[folder, '--out', site, '--as', 'page'], /expected mosaic, ome-zarr, video, single-file/],
    [[folder, '--out', site, '--fit', 'watch'], /expected phone/],
    [[folder, '--out', site, '--jobs', '0'], /whole number from 1/],
    [[folder, '--out', site, '--memory', '1.5'], /whole number from 1/],
    [[folder, '--out', site, '--poster', '9999'], /whole number from 0 to 1024/],
    [[folder, '--out', site, '--deface'], /pydeface.*mri_deface/],
    [[join(work, 'nothing'), '--out', site], /nothing/],
  ])) {
    const { status, stderr } = spawnSync(process.execPath, [program, ...args], { encoding: 'utf8' });
    assert.equal(status, 1, args.join(' '));
    assert.match(stderr, words);
  }
});

finish();
