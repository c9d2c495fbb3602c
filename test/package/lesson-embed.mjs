// A lesson as a folder for frames, on a server that sends no header for other sites: a site of another origin finds oembed.json by the line in
// index.html and shows its frame, which has no origin. The picture is that of the page.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { findBrowser, listTestArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';
import { difference, openLessonPage, pictureOf, serveFiles } from './lesson-pages.mjs';

const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const work = mkdtempSync(join(tmpdir(), 'volume-view-embed-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

mkdirSync(join(work, 'data'));
copyFileSync(join(projectRoot, 'demos/data/ct-phantom.nii.gz'), join(work, 'data/torso.nii.gz'));
copyFileSync(join(projectRoot, 'demos/images/preset-ct-bone.webp'), join(work, 'data/torso.webp'));
writeFileSync(
  join(work, 'lesson.html'),
  `<!doctype html><html lang="en"><head><title>A torso</title><meta name="license" content="CC0 1.0"><meta name="author" content="Made by a program"></head>
<body><h1>A torso</h1><volume-view id="v" src="data/torso.nii.gz" poster="data/torso.webp" alt="A torso"></volume-view>
<volume-tour for="v" duration="0"><volume-step><h2>First</h2></volume-step><volume-step camera-orbit="90deg 90deg auto"><h2>Second</h2></volume-step></volume-tour></body></html>`,
);
/** @param {...string} args */
const run = (...args) =>
  spawnSync(process.execPath, [program, 'lesson.html', ...args], { cwd: work, encoding: 'utf8' });

/** What the site shows. */
let site = '';
const server = await serveFiles((path) => readFileSync(join(work, path)));
const other = await serveFiles((path) => (path === '/' ? `<!doctype html><title>A site</title>${site}` : ''));
const [origin, otherOrigin] = [server.origin, other.origin];

await check('a lesson becomes a folder for frames, the same bytes each time; without an address it is refused', () => {
  const { status, stdout, stderr } = run('--as', 'embed', '--address', `${origin}/out`, '--out', 'out');
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^out: \d+ files, \d+\.\d MB\n$/);
  const read = () =>
    readdirSync(join(work, 'out'), { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map((entry) => [entry.name, readFileSync(join(entry.parentPath, entry.name)).toString('base64')]);
  const before = read();
  assert.equal(run('--as', 'embed', '--address', `${origin}/out/`, '--out', 'out').status, 0);
  assert.deepEqual(read(), before);
  const lacking = run('--as', 'embed', '--out', 'lacking');
  assert.match(lacking.stderr, /^got no address of the folder; expected the one that it will have on your web server/);
  assert.match(run('--address', origin).stderr, /got --address for a page; expected it with --as embed/);
  return stdout.trim();
});

const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });
await check(
  'another site shows the poster, then the lesson without an origin; its picture is that of the page',
  async () => {
    const own = await openLessonPage(browser, origin);
    await own.page.goto(`${origin}/out/index.html`);
    const asPage = await pictureOf(own.page);
    const found = await own.page.locator('link[type="application/json+oembed"]').getAttribute('href');
    assert.equal(found, `${origin}/out/oembed.json`);
    const answer = await own.page.evaluate(async (address) => (await fetch(address)).json(), found);
    const shown = await own.page.evaluate(async (address) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      return [image.naturalWidth, image.naturalHeight];
    }, answer.thumbnail_url);
    assert.deepEqual([answer.thumbnail_width, answer.thumbnail_height], shown);
    assert.deepEqual(own.problems, []);

    // As WordPress 6.1 does it: a secret in the address, and the frame is hidden until it has said its height with it. It is as wide as the page
    // was: then the lesson has the same size in it.
    const hidden = 'style="position: absolute; clip: rect(1px, 1px, 1px, 1px)"';
    site = `<style>body { margin: 0 } blockquote { display: none }</style>${answer.html.replace(/(<iframe src="[^"]*)"/, '$1#?secret=a1b2c3d4e5"').replace(/style="[^"]*"/, hidden)}
<script>
  const heard = [];
  addEventListener('message', ({ data }) => {
    heard.push(data);
    if (data.message === 'height') document.querySelector('iframe').style = 'border: 0; width: 480px';
  });
</script>`;
    const { page, problems } = await openLessonPage(browser, '');
    await page.goto(otherOrigin);
    const frame = page.frameLocator('iframe');
    await frame.getByText('CC0 1.0').waitFor();
    assert.equal(await frame.locator('script[src*=iife]').count(), 0);
    await frame.getByRole('link', { name: 'Show in 3D' }).click();
    await frame.getByRole('heading', { name: 'First' }).waitFor();
    assert.equal(await frame.locator('html').evaluate(() => self.origin), 'null');
    await frame.getByText('Made by a program').waitFor();
    const inFrame = await pictureOf(frame);
    assert.ok(new Set(inFrame.data).size > 20, 'a picture, and not one colour');
    assert.deepEqual([inFrame.width, inFrame.height], [asPage.width, asPage.height]);
    assert.equal(difference(inFrame, asPage), 0);
    await page.evaluate(() => {
      frames[0].postMessage({ volumeView: 1, id: 1, step: 2 }, '*');
      frames[0].postMessage({ volumeView: 1, id: 2, get: true }, '*');
    });
    await frame.getByRole('heading', { name: 'Second' }).waitFor();
    const heard = /** @type {any[]} */ (await page.evaluate('heard'));
    assert.ok(heard.some((one) => one.message === 'height' && one.secret === 'a1b2c3d4e5' && one.value > 200));
    assert.ok(heard.some((one) => one.id === 1 && one.ok === true));
    await page.waitForFunction('heard.some(({ id }) => id === 2)');
    const { attributes, steps } = await page.evaluate('heard.find(({ id }) => id === 2)');
    assert.equal(typeof attributes.alt, 'string');
    assert.equal(attributes.src, undefined, 'the data are inside the address');
    assert.ok(steps > 1);
    assert.deepEqual(problems, []);
  },
);
await browser.close();
server.close();
other.close();
finish();
