// A lesson as one file: it opens from disk and from a server, in each browser that is there, asks for nothing, and its pictures are those of the
// same lesson as a page.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from '@playwright/test';
import { findBrowser, listTestArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { engine as firefox } from '../engines/firefox.mjs';
import { check, finish } from './checks.mjs';
import { difference, openLessonPage, pictureOf, serveFiles } from './lesson-pages.mjs';

const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const work = mkdtempSync(join(tmpdir(), 'volume-view-single-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

// What a lesson may have with files: volumes, labels with their table, a layer, surfaces, terrain, posters, pictures.
const body = `<h1>One file</h1>
<p><img id="drawn" src="pictures/camera.webp" alt="A camera" width="100"></p>
<div class="lesson">
<volume-view id="brain" src="data/mni152-t1.json" poster="pictures/camera.webp" alt="A brain" camera-orbit="-30deg 75deg 420" region="0 -60 -50 70 60 50">
<volume-labels src="data/brodmann-2mm.nii.gz" table="data/brodmann-dseg.tsv" only="17 18"></volume-labels>
<volume-layer src="data/motor-synthetic.nii.gz" label="z value"></volume-layer>
<volume-surface src="data/mni152-white.surf.gii" color="orange"></volume-surface>
</volume-view>
<volume-tour for="brain" duration="0">
<volume-step><h2>First</h2><p>From outside.</p></volume-step>
<volume-step camera-orbit="90deg 90deg auto"><h2>Second</h2>
<volume-question id="tissue"><h3>Which one?</h3><ul><li>A</li><li correct>B</li></ul></volume-question></volume-step>
</volume-tour>
</div>
<volume-view id="storm" src="data/storm-radar-island.json" alt="A storm"><volume-terrain src="data/island/N00E000.hgt.gz"></volume-terrain></volume-view>`;
const head = `<meta charset="utf-8"><title>One &lt;file&gt;</title>
<meta name="license" content="CC0 1.0"><meta name="author" content="Made by a program">`;
for (const folder of ['data/island', 'pictures']) mkdirSync(join(work, folder), { recursive: true });
for (const name of [
  'mni152-t1.json',
  'mni152-t1.png',
  'brodmann-2mm.nii.gz',
  'brodmann-dseg.tsv',
  'motor-synthetic.nii.gz',
])
  copyFileSync(join(projectRoot, 'demos/data', name), join(work, 'data', name));
for (const name of [
  'mni152-white.surf.gii',
  'storm-radar-island.json',
  'storm-radar-1500.png',
  'island/N00E000.hgt.gz',
])
  copyFileSync(join(projectRoot, 'demos/data', name), join(work, 'data', name));
copyFileSync(join(projectRoot, 'demos/images/camera.webp'), join(work, 'pictures/camera.webp'));
const lesson = `<!doctype html><html lang="en"><head>${head}</head><body>${body}</body></html>`;
writeFileSync(join(work, 'lesson.html'), lesson);

/** @param {...string} args */
const run = (...args) => spawnSync(process.execPath, [program, ...args], { cwd: work, encoding: 'utf8' });

await check('a lesson becomes one file; the same bytes each time', () => {
  assert.equal(run('lesson.html', '--as', 'page', '--out', 'page').status, 0);
  const { status, stdout, stderr } = run('lesson.html', '--as', 'single-file');
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^lesson-single\.html: 1 file, \d+\.\d MB\n$/);
  assert.equal(stderr, '');
  const bytes = readFileSync(join(work, 'lesson-single.html'));
  assert.equal(run('lesson.html', '--as', 'single-file').status, 0);
  assert.ok(readFileSync(join(work, 'lesson-single.html')).equals(bytes), 'the same bytes');
  return `${(bytes.length / 1e6).toFixed(1)} MB`;
});

await check(
  'a file above 25 MB is written with a warning that names its size; what can not be inside is refused',
  () => {
    writeFileSync(join(work, 'data/noise.nii'), Buffer.alloc(17e6, 'noise'));
    /** @param {string} html @param {...string} args */
    const write = (html, ...args) => {
      writeFileSync(join(work, 'other.html'), `<html lang="en"><head>${head}</head><body>${html}</body></html>`);
      return run('other.html', '--as', 'single-file', '--out', 'other-single.html', ...args);
    };
    const large = write('<volume-view src="data/noise.nii"></volume-view>');
    assert.equal(large.status, 0, large.stderr);
    assert.match(
      large.stderr,
      /^other-single\.html has 2[6-9]\.\d MB: many mail systems and courses take at most 25 MB/,
    );
    const names = readdirSync(work);
    rmSync(join(work, 'other-single.html'));
    const view = '<volume-view src="data/mni152-t1.json"></volume-view>';
    writeFileSync(join(work, 'data/x.ozx'), 'x');
    writeFileSync(join(work, 'data/huge.nii'), Buffer.alloc(65 * 2 ** 20));
    for (const [html, words, ...args] of /** @type {[string, RegExp, ...string[]][]} */ ([
      ['<volume-view src="data/x.ozx"></volume-view>', /got an OME-Zarr, which a single file can not hold/],
      [`${view}<volume-terrain src="data/island/N00E000.hgt.gz data/x.ozx"></volume-terrain>`, /got several tiles/],
      ['<volume-view src="data/huge.nii"></volume-view>', /the files have 65 MiB; expected at most 64/],
      [view, /got the lesson itself as --out/, '--out', 'other.html'],
      [view, /got --pass for a single-file/, '--pass', '50'],
    ])) {
      const { status, stderr } = write(html, ...args);
      assert.equal(status, 1, html);
      assert.match(stderr, words);
      assert.doesNotMatch(stderr, /^\s+at /m, 'no stack');
    }
    assert.deepEqual(
      readdirSync(work),
      names.filter((name) => name !== 'other-single.html'),
    );
  },
);

const { origin, close } = await serveFiles((path) => readFileSync(join(work, path)));
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });

const views = ['#brain', '#storm'];
/** @type {Awaited<ReturnType<typeof pictureOf>>[]} */
const asPage = [];
const served = `${origin}/lesson-single.html`;
const onDisk = pathToFileURL(join(work, 'lesson-single.html')).href;
for (const address of [`${origin}/page/index.html`, served, onDisk]) {
  const isPage = address.includes('/page/');
  await check(`Chromium: ${isPage ? 'the page' : address === served ? 'from a server' : 'from disk'}`, async () => {
    const { page, problems } = await openLessonPage(browser, isPage ? origin : address, 0.5);
    await page.goto(address);
    for (const [i, view] of views.entries()) {
      const picture = await pictureOf(page, view);
      assert.ok(new Set(picture.data).size > 20, 'a picture, and not one colour');
      if (isPage) asPage.push(picture);
      else assert.equal(difference(picture, asPage[i]), 0, `the picture of ${view} is that of the page`);
    }
    const attached = await page.locator('#brain').evaluate((view) => /** @type {any} */ (view).renderStats !== null);
    assert.ok(attached);
    assert.equal(
      await page.locator('#drawn').evaluate((image) => /** @type {HTMLImageElement} */ (image).naturalWidth > 0),
      true,
    );
    await page.getByText('CC0 1.0').waitFor();
    await page.getByText('Made by a program').waitFor();
    await page.getByRole('button', { name: 'Next' }).click();
    await page.locator('#tissue').getByText('B', { exact: true }).last().click();
    await page.getByRole('button', { name: 'Answer' }).click();
    await page.locator('#tissue').getByText('Right.').first().waitFor();
    assert.equal(await page.getByRole('alert').count(), 0);
    assert.deepEqual(problems, []);
    await page.context().close();
  });
}
await browser.close();

const firefoxPath = await firefox.find();
if (firefoxPath === null) console.log('left out: Firefox is not there');
for (const address of [served, onDisk]) {
  if (firefoxPath === null) break;
  await check(`Firefox: ${address === served ? 'from a server' : 'from disk'}`, async () => {
    const page = await firefox.open(address, firefoxPath);
    try {
      const { formats, alerts } = JSON.parse(
        String(
          await page.evaluate(`(async () => {
            await customElements.whenDefined('volume-view');
            const views = [...document.querySelectorAll('volume-view')];
            for (const view of views) { view.scrollIntoView(); await view.whenRendered(); }
            return JSON.stringify({
              formats: views.map(({ volume }) => volume?.format ?? ''),
              alerts: views.map(({ shadowRoot }) => shadowRoot.querySelectorAll('[role=alert]').length),
            });
          })()`),
        ),
      );
      assert.deepEqual(
        formats.map((/** @type {string} */ one) => one !== ''),
        [true, true],
        formats.join(),
      );
      assert.deepEqual(alerts, [0, 0]);
      assert.deepEqual(
        page.messages.filter((line) => /^(error|page error)/.test(line)),
        [],
      );
    } finally {
      await page.close();
    }
  });
}

close();
finish();
