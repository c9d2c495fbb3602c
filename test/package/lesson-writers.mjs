// A lesson as a person makes and plays it: the built program writes its packages, a browser plays them with scorm-again 3.4.3 as the learning
// management system, and the picture is that of the same lesson as a page.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { unzipSync } from 'fflate';
import { runnerImport } from 'vite';
import { findBrowser, listTestArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { startLrs } from '../helpers/lrs.mjs';
import { check, finish } from './checks.mjs';
import { difference, longestWait, openLessonPage, pictureOf, serveFiles } from './lesson-pages.mjs';

const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const work = mkdtempSync(join(tmpdir(), 'volume-view-lesson-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

const body = `<h1>Two steps</h1>
<div class="lesson">
<volume-view id="v" src="scans/head.nii.gz" alt="A phantom"></volume-view>
<volume-tour for="v" duration="0">
<volume-step><h2>First</h2><p>From outside.</p></volume-step>
<volume-step camera-orbit="90deg 90deg auto"><h2>Second</h2>
<volume-question id="tissue" remember><h3>Which one?</h3><ul><li>A</li><li correct>B, or C</li><li>D</li></ul></volume-question>
</volume-step>
<volume-step camera-orbit="0deg 20deg auto"><h2>Third</h2>
<volume-question type="value" answer="140" tolerance="15" tries="1" for="v"><h3>What value?</h3></volume-question>
</volume-step>
</volume-tour>
</div>`;
const head = `<meta charset="utf-8"><title>Bones &amp; "air"</title>
<meta name="license" content="CC0 1.0"><meta name="author" content="Made by a program">
<link rel="stylesheet" href="dist/volume-view.css"><script type="module" src="dist/volume-view.js"></script>`;
mkdirSync(join(work, 'scans'));
copyFileSync(join(projectRoot, 'demos/data/ct-phantom.nii.gz'), join(work, 'scans/head.nii.gz'));
writeFileSync(
  join(work, 'lesson.html'),
  `<!doctype html><html lang="en"><head>${head}</head><body>${body}</body></html>`,
);

/** @param {...string} args */
const run = (...args) => spawnSync(process.execPath, [program, ...args], { cwd: work, encoding: 'utf8' });
/** @param {string} name @returns {Record<string, Uint8Array>} */
const unpack = (name) => unzipSync(new Uint8Array(readFileSync(join(work, name))));
/** @param {Record<string, Uint8Array>} files @returns {(path: string) => Uint8Array | undefined} */
const serve = (files) => (path) => files[path];
/** @param {Record<string, Uint8Array>} files @param {string} path */
const textOf = (files, path) => new TextDecoder().decode(files[path]);

/** Files by the first part of their addresses. @type {Record<string, (path: string) => Uint8Array | undefined>} */
const served = {};

await check('a lesson becomes a package for SCORM 1.2, for SCORM 2004, and a page; the same bytes each time', () => {
  for (const [as, out] of [
    ['scorm', 'first.zip'],
    ['scorm-2004', 'second.zip'],
  ]) {
    const { status, stderr, stdout } = run('lesson.html', '--as', as, '--pass', '50', '--out', out);
    assert.equal(status, 0, stderr);
    assert.match(stdout, new RegExp(`^${out}: \\d+ files, \\d+\\.\\d MB\n$`));
    const bytes = readFileSync(join(work, out));
    assert.equal(run('lesson.html', '--as', as, '--pass', '50', '--out', out).status, 0);
    assert.ok(readFileSync(join(work, out)).equals(bytes), 'the same bytes');
    const files = unpack(out);
    assert.ok(Buffer.from(files['data/scans/head.nii.gz']).equals(readFileSync(join(work, 'scans/head.nii.gz'))));
    // A package has a list of all of its other files.
    const listed = [...textOf(files, 'imsmanifest.xml').matchAll(/<file href="([^"]*)"/g)].map(([, href]) => href);
    assert.deepEqual(new Set([...listed, 'imsmanifest.xml']), new Set(Object.keys(files)));
    assert.equal(listed.length + 1, Object.keys(files).length);
  }
  served.first = serve(unpack('first.zip'));
  served.second = serve(unpack('second.zip'));
  const page = run('lesson.html', '--as', 'page', '--out', 'page');
  assert.equal(page.status, 0, page.stderr);
  assert.equal(run('lesson.html', '--out', 'page').status, 0, 'an earlier page is replaced');
  served.page = (path) => readFileSync(join(work, 'page', path));
  return `${(readFileSync(join(work, 'first.zip')).length / 1e6).toFixed(1)} MB`;
});

await check('what is refused is said in words, with its line, and nothing is written', () => {
  const names = readdirSync(work);
  for (const [html, args, words] of /** @type {[string, string[], RegExp][]} */ ([
    [
      `<volume-view src="scans/head.nii.gz"></volume-view>\n<p onclick="x()">x</p>`,
      [],
      /line 2: <p> got onclick; expected none/,
    ],
    ['<volume-view src="https://example.org/a.nii"></volume-view>', [], /expected a file in the folder of the lesson/],
    [
      '<volume-view src="absent.nii"></volume-view>',
      [],
      /got no file absent\.nii; expected it in the folder of bad\.html/,
    ],
    ['<volume-view src="scans"></volume-view>', [], /scans is a folder; expected a file/],
    [
      '<volume-view src="scans/head.nii.gz"></volume-view>',
      [],
      /got no title[^]*got no language[^]*got no licence[^]*got no credits/,
    ],
    [body, ['--as', 'film'], /got --as film; expected page, single-file, embed, scorm, scorm-2004, cmi5, h5p/],
    [body, ['--as', 'scorm', '--pass', '0'], /got --pass 0; expected a whole number from 1 to 100/],
    [body, ['--pass', '50'], /expected it with --as scorm or --as cmi5/],
    [
      body,
      ['--title', 'x', '--language', 'en', '--licence', 'y', '--credits', 'z', '--out', 'scans'],
      /where other files are/,
    ],
  ])) {
    writeFileSync(join(work, 'bad.html'), html);
    const { status, stderr } = run('bad.html', ...(args.includes('--as') ? args : ['--as', 'page', ...args]));
    assert.equal(status, 1, html);
    assert.match(stderr, words);
    assert.doesNotMatch(stderr, /^\s+at /m, 'no stack');
  }
  rmSync(join(work, 'bad.html'));
  assert.deepEqual(readdirSync(work), names);
});

const lms = (/** @type {string} */ version) => `<!doctype html><title>LMS</title>
<style>body { margin: 0 } iframe { display: block; border: 0; width: 480px; height: 700px }</style>
<script src="/lms/${version === '1.2' ? 'scorm12' : 'scorm2004'}.js"></script>
<script>
  const api = new ${version === '1.2' ? 'Scorm12API' : 'Scorm2004API'}({ autocommit: false, logLevel: 5 });
  const prefix = ${version === '1.2' ? "'LMS'" : "''"};
  const kept = sessionStorage.getItem('kept');
  if (kept) api.loadFromJSON(JSON.parse(kept), 'cmi');
  // What the LMS refuses, with its error code.
  window.refused = [];
  window.commits = 0;
  const set = api[prefix + 'SetValue'].bind(api);
  api[prefix + 'SetValue'] = (name, value) => {
    const answer = set(name, value);
    if (String(answer) !== 'true') refused.push([name, value, api[prefix + 'GetLastError']()]);
    return answer;
  };
  window.${version === '1.2' ? 'API' : 'API_1484_11'} = api;
  window.learned = () => JSON.parse(JSON.stringify(api.cmi));
</script>
<iframe src="/${version === '1.2' ? 'first' : 'second'}/index.html" allow="fullscreen"></iframe>`;

const { origin, close } = await serveFiles((address) => {
  const [, place, ...rest] = address.split('/');
  const path = rest.join('/');
  if (place !== 'lms') return served[place]?.(path);
  return path.endsWith('.js')
    ? readFileSync(join(projectRoot, 'node_modules/scorm-again/dist', path.replace('.js', '.min.js')))
    : lms(path);
});
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });

const newPage = () => openLessonPage(browser, origin, 0.5);

/** @type {ReturnType<typeof import('fast-png').decode> | null} */
let asPage = null;
await check('a lesson as a page shows its picture, its licence and its credits', async () => {
  const { page, problems } = await newPage();
  await page.goto(`${origin}/page/index.html`);
  asPage = await pictureOf(page);
  assert.ok(new Set(asPage.data).size > 20, 'a picture, and not one colour');
  await page.getByText('CC0 1.0').waitFor();
  await page.getByText('Made by a program').waitFor();
  assert.deepEqual(problems, []);
  await page.context().close();
});

for (const version of ['1.2', '2004']) {
  const is2004 = version === '2004';
  await check(
    `SCORM ${version}: the LMS gets step, answers, score and status, and a second visit goes on`,
    async () => {
      const { page, problems } = await newPage();
      const learned = () => page.evaluate(() => /** @type {any} */ (window).learned());
      const lesson = page.frameLocator('iframe');
      const openStep = () => lesson.locator('volume-tour').evaluate((tour) => /** @type {any} */ (tour).step);
      const status = (/** @type {any} */ cmi) =>
        is2004 ? [cmi.completion_status, cmi.success_status] : [cmi.core.lesson_status];
      const place = (/** @type {any} */ cmi) => (is2004 ? cmi.location : cmi.core.lesson_location);
      const score = (/** @type {any} */ cmi) => (is2004 ? cmi.score : cmi.core.score);
      const refused = () => page.evaluate(() => /** @type {any} */ (window).refused);

      await page.goto(`${origin}/lms/${version}`);
      assert.equal(difference(await pictureOf(lesson), asPage), 0, 'the picture is that of the page');
      let cmi = await learned();
      assert.deepEqual([place(cmi), ...status(cmi)], ['1', 'incomplete', ...(is2004 ? ['unknown'] : [])]);

      // The first visit: a wrong and a right answer in the second step.
      await lesson.getByRole('button', { name: 'Next' }).click();
      await lesson.getByRole('heading', { name: 'Second' }).waitFor();
      await lesson.getByText('A', { exact: true }).last().click();
      await lesson.getByRole('button', { name: 'Answer' }).click();
      await lesson.getByText('B, or C').last().click();
      await lesson.getByRole('button', { name: 'Answer' }).click();
      await lesson.locator('#tissue').getByText('Right.').first().waitFor();
      cmi = await learned();
      assert.equal(place(cmi), '2');
      assert.equal(score(cmi).raw, '50');
      if (is2004) assert.equal(score(cmi).scaled, '0.5');
      assert.equal(status(cmi)[0], 'incomplete');
      const childrenOf = (/** @type {any} */ array) => array.childArray ?? Object.values(array);
      const answers = childrenOf(cmi.interactions);
      assert.deepEqual(
        answers.map((/** @type {any} */ one) => [
          one.id,
          one.type,
          is2004 ? one.learner_response : one.student_response,
          one.result,
          childrenOf(one.correct_responses)[0].pattern,
        ]),
        [
          ['tissue', 'choice', 'a', is2004 ? 'incorrect' : 'wrong', 'b'],
          ['tissue', 'choice', 'b', 'correct', 'b'],
        ],
      );

      // The learner leaves: the page is gone, the LMS keeps what it was given.
      await page.evaluate(() => document.querySelector('iframe')?.remove());
      cmi = await learned();
      assert.deepEqual(await refused(), []);
      await page.evaluate((kept) => sessionStorage.setItem('kept', kept), JSON.stringify(cmi));

      // The second visit begins in the second step, with the answer.
      await page.goto(`${origin}/lms/${version}`);
      await lesson.getByRole('heading', { name: 'Second' }).waitFor();
      await lesson.locator('#tissue').getByText('Right.').first().waitFor();
      assert.equal(await openStep(), 2);
      assert.equal(await lesson.getByRole('radio', { name: 'B, or C' }).isChecked(), true);
      await lesson.getByRole('button', { name: 'Next' }).click();
      await lesson.getByRole('textbox').fill('7');
      await lesson.getByRole('button', { name: 'Answer' }).click();
      await lesson.getByText('Not right').first().waitFor();
      cmi = await learned();
      assert.equal(place(cmi), '3');
      assert.equal(score(cmi).raw, '50');
      assert.deepEqual(status(cmi), is2004 ? ['completed', 'passed'] : ['passed']);
      assert.equal(childrenOf(cmi.interactions).length >= 1, true);
      assert.deepEqual(await refused(), []);
      assert.deepEqual(problems, []);
      await page.context().close();
    },
  );
}

await check('cmi5: the record store gets what the learner does, and a second visit goes on', async () => {
  const { status, stderr } = run('lesson.html', '--as', 'cmi5', '--pass', '50', '--out', 'third.zip');
  assert.equal(status, 0, stderr);
  served.third = serve(unpack('third.zip'));
  const lrs = await startLrs();
  const until = async (/** @type {string[]} */ verbs) => {
    const late = performance.now() + longestWait;
    while (lrs.verbs().length < verbs.length && performance.now() < late)
      await new Promise((resolve) => setTimeout(resolve, 50));
    assert.deepEqual(lrs.verbs(), verbs);
  };
  const visit = async () => {
    const opened = await newPage();
    await opened.page.goto(`${origin}/third/index.html${lrs.launch}`);
    return opened;
  };

  const first = await visit();
  assert.equal(difference(await pictureOf(first.page), asPage), 0, 'the picture is that of the page');
  await first.page.getByRole('button', { name: 'Next' }).click();
  await first.page.getByRole('heading', { name: 'Second' }).waitFor();
  await first.page.getByText('B, or C').last().click();
  await first.page.getByRole('button', { name: 'Answer' }).click();
  await first.page.locator('#tissue').getByText('Right.').first().waitFor();
  await first.page.goto('about:blank');
  await until(['initialized', 'answered', 'terminated']);
  await first.page.context().close();

  lrs.again();
  const second = await visit();
  await second.page.getByRole('heading', { name: 'Second' }).waitFor();
  await second.page.locator('#tissue').getByText('Right.').first().waitFor();
  await second.page.getByRole('button', { name: 'Next' }).click();
  await second.page.getByRole('textbox').fill('7');
  await second.page.getByRole('button', { name: 'Answer' }).click();
  await until(['initialized', 'answered', 'completed', 'passed']);
  assert.equal(lrs.statements.at(-1).result.score.scaled, 0.5);
  await second.page.goto('about:blank');
  await until(['initialized', 'answered', 'completed', 'passed', 'terminated']);
  assert.deepEqual(lrs.broken, []);
  // The record store is another server. It has no preferences of the learner, and no state at first, which the browser notes.
  const isOfStore = (/** @type {string} */ problem) =>
    problem.includes(lrs.origin) || problem.includes('status of 404');
  assert.deepEqual(
    [...first.problems, ...second.problems].filter((problem) => !isOfStore(problem)),
    [],
  );
  await second.page.context().close();
  lrs.close();
  return `${lrs.asked.length} requests`;
});

await check('the manifests are well-formed XML, whatever titles, licences and credits say', async () => {
  const { module: writers } = await runnerImport(join(projectRoot, 'packages/lesson-writers/src/index.ts'), {
    configFile: false,
    logLevel: 'error',
    root: projectRoot,
  });
  const { page } = await newPage();
  await page.goto(`${origin}/page/lesson.css`);
  const texts = [
    ...[
      '<',
      '>',
      '&',
      '"',
      "'",
      ']]>',
      '<![CDATA[',
      '<!--',
      '-->',
      '<?x?>',
      '&#0;',
      '&nbsp;',
      '</title>',
      '\0',
      '\u0008',
    ],
    ...['\u000b', '\ufffe', '\ud800', '\udc00x', '\u2028', '😀', 'שלום', '%s%n', '\r\n', '\t'],
  ];
  const titles = texts.flatMap((one, i) => [`a${one}b`, `${one}${texts[(i * 7 + 3) % texts.length]}x`]);
  let count = 0;
  for (const version of ['1.2', '2004'])
    for (const title of titles) {
      const files = writers.writeScormFiles(
        {
          html: '<volume-view src="a%26b.nii"></volume-view>',
          files: [{ path: 'a&b.nii', bytes: new Uint8Array(1) }],
          title,
          language: 'en',
          licence: title,
          credits: title,
        },
        [{ path: 'volume-view.iife.js', bytes: new Uint8Array(1) }],
        { version, pass: 50 },
      );
      const { bytes } = files.find((/** @type {any} */ one) => one.path === 'imsmanifest.xml');
      const found = await page.evaluate((xml) => {
        const parsed = new DOMParser().parseFromString(xml, 'application/xml');
        const error = parsed.querySelector('parsererror')?.textContent ?? '';
        const hrefs = [...parsed.querySelectorAll('file')].map((one) => one.getAttribute('href'));
        return {
          error,
          hrefs,
          title: parsed.querySelector('organization > title')?.textContent,
          scripts: parsed.querySelectorAll('script').length,
        };
      }, new TextDecoder().decode(bytes));
      assert.equal(found.error, '', JSON.stringify(title));
      assert.ok(found.hrefs.includes('data/a%26b.nii'));
      // What XML does not have becomes another sign; all else is as it was.
      if (!/[\p{Cc}\p{Cs}\ufffe]/u.test(title)) assert.equal(found.title, title, JSON.stringify(title));
      count += 1;
    }
  await page.context().close();
  return `${count} manifests`;
});

await browser.close();
close();
finish();
