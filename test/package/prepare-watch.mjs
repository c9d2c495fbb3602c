// `volume-view-prepare FOLDER --out SITE --watch` on the built program, with a folder into which a radar writes.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  appendFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  statSync,
  utimesSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { runnerImport } from 'vite';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const work = mkdtempSync(join(tmpdir(), 'volume-view-watch-'));
const { readManifest } = (
  await runnerImport(join(projectRoot, 'src/formats/manifest/manifest.ts'), {
    configFile: false,
    logLevel: 'error',
    root: projectRoot,
  })
).module;

/** A scan of three sweeps, at 12:00 of that day. */
const scan = readFileSync(join(projectRoot, 'test/fixtures/radar/odim-2.0.h5'));

/** The same at another time, which stands in the file as text. @param {number} minute */
function scanAt(minute) {
  const text = scan.toString('latin1');
  return Buffer.from(text.replace(/12000(\d)/g, `12${String(minute).padStart(2, '0')}0$1`), 'latin1');
}

const folder = join(work, 'in');
const site = join(work, 'site');
mkdirSync(folder);
/** @type {Record<string, unknown>[]} */
const lines = [];
let errors = '';
/** @type {import('node:child_process').ChildProcess} */
let watch;
process.on('exit', () => {
  watch.kill('SIGKILL');
  rmSync(work, { recursive: true, force: true });
});

/** @param {string} newest */
function start(newest = '3') {
  const args = ['--watch', '--newest', newest, '--every', '0.2', '--settle', '1.2', '--poster', '0'];
  watch = spawn(process.execPath, [program, folder, '--out', site, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
  let rest = '';
  watch.stdout?.on('data', (text) => {
    const parts = (rest + text).split('\n');
    rest = /** @type {string} */ (parts.pop());
    lines.push(...parts.map((part) => JSON.parse(part)));
  });
  watch.stderr?.on('data', (text) => (errors += text));
}

/** @param {NodeJS.Signals} signal @returns {Promise<number | null>} the exit status */
async function end(signal) {
  const ended = new Promise((resolve) => watch.once('exit', resolve));
  watch.kill(signal);
  return ended;
}

/** @param {() => boolean} isSo */
async function until(isSo) {
  for (let left = 300; !isSo(); left--) {
    assert.ok(left > 0, `waited in vain for ${String(isSo)}\n${JSON.stringify(lines)}\n${errors}`);
    await wait(100);
  }
}

/** A file of the site; empty before it is there: the program writes one after the other. @param {string[]} path */
function textOf(...path) {
  try {
    return readFileSync(join(...path), 'utf8');
  } catch (error) {
    if (/** @type {NodeJS.ErrnoException} */ (error).code === 'ENOENT') return '';
    throw error;
  }
}

/** Minutes of the scans in a page. */
function minutesIn(page = 'newest') {
  const text = textOf(site, page, 'scans.json');
  if (!text) return '';
  const { scans } = readManifest(new TextEncoder().encode(text));
  for (const { image } of scans) assert.ok(existsSync(join(site, page, image)), image);
  return scans.map((/** @type {{ time: string }} */ { time }) => Number(time.slice(14, 16))).join();
}
const count = (/** @type {string} */ status) => lines.filter((line) => line.status === status).length;
const folders = () => readdirSync(site).filter((name) => /^[0-9a-f]{16}/.test(name)).length;

writeFileSync(join(folder, 'a10.h5'), scanAt(10));
writeFileSync(join(folder, 'a05.h5'), scanAt(5));
start();

await check('the scans of a folder are in a page with a timeline, in the order of time', async () => {
  await until(() => minutesIn() === '5,10');
  await until(() => textOf(site, 'index.html').includes('href="newest/index.html"'));
  const page = textOf(site, 'newest/index.html');
  assert.match(page, /src="scans.json" time="9999[^]*<volume-timeline for="view">/);
  assert.match(page, /<h1>[^<]+, DBZH</);
  assert.equal(textOf(site, 'index.html').split('<li>').length - 1, 1);
});

await check('a file that is being written is not taken before it is whole', async () => {
  const bytes = scanAt(15);
  const step = Math.ceil(bytes.length / 8);
  for (let at = 0; at < bytes.length; at += step) {
    appendFileSync(join(folder, 'a15.h5'), bytes.subarray(at, at + step));
    // Far less than the time for which a file has to stay: this process may have to wait for its turn.
    await wait(100);
  }
  // Under another name it is not taken however long it stays.
  writeFileSync(join(folder, 'a20.h5.part'), bytes.subarray(0, 1000));
  writeFileSync(join(folder, '.a20.h5'), bytes.subarray(0, 1000));
  await until(() => minutesIn() === '5,10,15');
  await wait(2500);
  assert.equal(count('failed'), 0, JSON.stringify(lines));
  writeFileSync(join(folder, 'a20.h5.part'), scanAt(20));
  renameSync(join(folder, 'a20.h5.part'), join(folder, 'a20.h5'));
  await until(() => minutesIn() === '10,15,20');
  assert.equal(count('failed'), 0, JSON.stringify(lines));
});

await check('a broken file is listed once, and taken when it is whole', async () => {
  writeFileSync(join(folder, 'a25.h5'), scanAt(25).subarray(0, 5000));
  await until(() => count('failed') === 1);
  assert.equal(lines.find(({ status }) => status === 'failed')?.code, 'format/corrupt');
  const table = () => textOf(`${site}.private`, 'scans.tsv');
  await until(() => /failed\tformat\/corrupt\ta25.h5/.test(table()));
  await wait(2500);
  assert.equal(count('failed'), 1);
  writeFileSync(join(folder, 'a25.h5'), scanAt(25));
  await until(() => minutesIn() === '15,20,25');
  await until(() => table() !== '' && !/failed/.test(table()));
});

await check('old scans are removed, and files of old scans change nothing', async () => {
  for (const minute of [30, 35]) {
    writeFileSync(join(folder, `a${minute}.h5`), scanAt(minute));
    await until(() => minutesIn().endsWith(String(minute)));
  }
  // Those of 10 to 35 minutes: an open page may still have the list of before.
  await until(() => folders() === 6);
  for (const minute of [1, 2, 3, 4]) writeFileSync(join(folder, `late${minute}.h5`), scanAt(minute));
  await until(() => count('done') === 11);
  await wait(2500);
  assert.equal(minutesIn(), '25,30,35');
  assert.equal(folders(), 6);
  assert.equal(count('done'), 11, 'a scan that is removed is not made again');
});

await check('another quantity has a page of its own', async () => {
  const other = Buffer.from(scanAt(40).toString('latin1').replaceAll('DBZH', 'TH\0\0'), 'latin1');
  writeFileSync(join(folder, 'b40.h5'), other);
  await until(() => minutesIn('newest-2') === '40');
  assert.equal(minutesIn(), '25,30,35');
});

await check('ended by SIGKILL it goes on, makes nothing twice, and leaves no half folder', async () => {
  const made = count('done');
  for (const minute of [45, 50, 55]) {
    writeFileSync(join(folder, `a${minute}.h5`), scanAt(minute));
    await wait(1300);
    await end('SIGKILL');
    for (const name of readdirSync(site).filter((one) => /^[0-9a-f]{16}/.test(one)))
      for (const file of ['index.html', 'volume.json', 'volume.png'])
        assert.ok(existsSync(join(site, name, file)), `${name}/${file}`);
    start();
  }
  await until(() => minutesIn() === '45,50,55');
  await wait(2500);
  assert.equal(new Set(lines.filter(({ status }) => status === 'done').map(({ id }) => id)).size, made + 3);
  assert.ok(count('done') <= made + 6, 'at most the scan that was being made is made again');
  assert.deepEqual(
    readdirSync(site).filter((name) => name.startsWith('.')),
    [],
  );
});

await check('a file of the same bytes and another time is not made again', async () => {
  const before = statSync(join(site, 'newest/scans.json')).mtimeMs;
  const made = count('done');
  utimesSync(join(folder, 'a55.h5'), 1e9, 1e9);
  await wait(2500);
  assert.equal(count('done'), made);
  assert.equal(statSync(join(site, 'newest/scans.json')).mtimeMs, before);
});

await check(
  'SIGTERM ends it with status 0, the next one has its own options, and what can not be done is said in words',
  async () => {
    assert.equal(await end('SIGTERM'), 0);
    assert.ok(!existsSync(join(`${site}.private`, 'lock')));
    start('2');
    await until(() => minutesIn() === '50,55');
    assert.equal(await end('SIGTERM'), 0);
    const plain = join(work, 'plain');
    assert.equal(spawnSync(process.execPath, [program, folder, '--out', plain, '--poster', '0']).status, 0);
    for (const [args, words] of /** @type {[string[], RegExp][]} */ ([
      [[folder, '--out', site], /--watch, which removes old scans/],
      [[folder, '--out', plain, '--watch'], /without --watch/],
      [[folder, '--out', join(work, 'one'), '--watch', '--as', 'single-file'], /with --watch; expected mosaic/],
      [[folder, '--out', join(work, 'one'), '--watch', '--newest', '0'], /whole number from 1 to 1000/],
      [[folder, '--out', join(work, 'one'), '--watch', '--every', '0'], /seconds from 0.1/],
    ])) {
      const { status, stderr } = spawnSync(process.execPath, [program, ...args], { encoding: 'utf8', timeout: 60_000 });
      assert.equal(status, 1, args.join(' '));
      assert.match(stderr, words);
    }
    assert.ok(folders() > 0 && readdirSync(plain).length > 6);
  },
);

finish();
