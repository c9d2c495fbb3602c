// A lesson as an H5P package: the built program writes it, h5p-standalone 3.8.2 plays it, and the picture is that of the same lesson as a page.
// The player is a package of its own, test/h5p, which is installed here alone.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { unzipSync } from 'fflate';
import { findBrowser, listTestArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';
import { atRest, difference, openLessonPage, pictureOf, serveFiles } from './lesson-pages.mjs';

const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const work = mkdtempSync(join(tmpdir(), 'volume-view-h5p-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

mkdirSync(join(work, 'scans'));
for (const name of ['ct-phantom.nii.gz', 'mni152-t1.json', 'mni152-t1.png'])
  copyFileSync(join(projectRoot, 'demos/data', name), join(work, 'scans', name));

const player = join(projectRoot, 'test/h5p/node_modules/h5p-standalone/dist');
await check('the player is installed', () => {
  const { status, stderr } = spawnSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {
    cwd: join(projectRoot, 'test/h5p'),
    encoding: 'utf8',
    shell: process.platform === 'win32',
  });
  assert.equal(status, 0, stderr);
  assert.ok(existsSync(join(player, 'main.bundle.js')));
});

/** @param {string} src @param {string} more */
const lesson = (src, more = '') => `<!doctype html><html lang="en"><head><title>Bones &amp; "air" &lt;b&gt;</title>
<meta name="license" content="CC BY 4.0"><meta name="author" content="Made by a program"></head><body>
<volume-view id="v" src="scans/${src}" alt="A brain"></volume-view>${more}
<volume-tour for="v" duration="0">
<volume-step><h2>First</h2><p>2 &lt; 3 &amp; "so on" <a href="https://example.org/">more</a></p></volume-step>
<volume-step camera-orbit="90deg 90deg auto"><h2>Second</h2>
<volume-question id="tissue" remember><h3>Which one?</h3><ul><li>A</li><li correct>B, or C</li><li>D</li></ul></volume-question>
</volume-step>
<volume-step camera-orbit="0deg 20deg auto"><h2>Third</h2>
<volume-question type="value" answer="140" tolerance="15" tries="1" for="v"><h3>What value?</h3></volume-question>
</volume-step>
</volume-tour></body></html>`;

/** @param {...string} args */
const run = (...args) => spawnSync(process.execPath, [program, ...args], { cwd: work, encoding: 'utf8' });

/** @type {Record<string, Uint8Array>} */
let files = {};
const encode = (/** @type {string} */ text) => new TextEncoder().encode(text);
const textOf = (/** @type {string} */ path) => new TextDecoder().decode(files[path]);
const folder = 'H5P.VolumeViewLesson-1.0/';

await check(
  'a lesson becomes a package of H5P, with files of the kinds that it takes; the same bytes each time',
  () => {
    writeFileSync(join(work, 'lesson.html'), lesson('mni152-t1.json'));
    const { status, stderr } = run('lesson.html', '--as', 'h5p', '--out', 'lesson.h5p');
    assert.equal(status, 0, stderr);
    const bytes = readFileSync(join(work, 'lesson.h5p'));
    assert.equal(run('lesson.html', '--as', 'h5p', '--out', 'lesson.h5p').status, 0);
    assert.ok(readFileSync(join(work, 'lesson.h5p')).equals(bytes), 'the same bytes');
    files = unzipSync(new Uint8Array(bytes));
    // Source: contentWhitelist and libraryWhitelist of @lumieducation/h5p-server 10.0.4.
    for (const path of Object.keys(files)) {
      assert.match(
        path,
        path.startsWith('content/')
          ? /\.(?:json|png)$/
          : /^h5p\.json$|^H5P\.VolumeViewLesson-1\.0\/.*\.(?:js|css|json|txt)$/,
      );
      assert.doesNotMatch(path, /(?:^|\/)[._]/, 'H5P leaves out such names');
    }
    const about = JSON.parse(textOf('h5p.json'));
    assert.deepEqual(
      [about.title, about.language, about.license, about.licenseVersion, about.authors],
      ['Bones & "air" <b>', 'en', 'CC BY', '4.0', [{ name: 'Made by a program', role: 'Author' }]],
    );
    const library = JSON.parse(textOf(`${folder}library.json`));
    assert.equal(`${library.machineName}-${library.majorVersion}.${library.minorVersion}/`, folder);
    for (const { path } of [...library.preloadedJs, ...library.preloadedCss]) assert.ok(files[folder + path], path);
    const content = JSON.parse(textOf('content/content.json'));
    assert.doesNotMatch(content.html, /[<>"']/, 'a text without tags, of which H5P changes nothing');
    assert.deepEqual(
      content.files.map((/** @type {any} */ { name, file }) => [name, file.path, file.mime]),
      [
        ['scans/mni152-t1.json', 'data/scans/mni152-t1.json', 'application/json'],
        ['scans/mni152-t1.png', 'data/scans/mni152-t1.png', 'image/png'],
      ],
    );
    for (const { file } of content.files) assert.ok(files[`content/${file.path}`], file.path);
    return `${(bytes.length / 1e6).toFixed(1)} MB`;
  },
);

await check('a file that H5P does not take is refused in words', () => {
  writeFileSync(join(work, 'bad.html'), lesson('ct-phantom.nii.gz'));
  const { status, stderr } = run('bad.html', '--as', 'h5p');
  assert.equal(status, 1);
  assert.match(stderr, /H5P does not take a file like scans\/ct-phantom\.nii\.gz; expected one of \.json, \.png/);
});

const host = `<!doctype html><title>H5P</title><style>body { margin: 0 } #place { width: 480px }</style><div id="place"></div>
<script src="/player/main.bundle.js"></script>
<script>
  window.statements = [];
  const previous = sessionStorage.getItem('kept');
  new H5PStandalone.H5P(document.getElementById('place'), {
    id: 'one', h5pJsonPath: '/content', frameJs: '/player/frame.bundle.js', frameCss: '/player/styles/h5p.css',
    xAPIObjectIRI: 'https://example.org/lesson', saveFreq: 1000,
    ...(previous && { contentUserData: [{ state: previous }] }),
  }).then(() => H5P.externalDispatcher.on('xAPI', ({ data }) => statements.push(JSON.parse(JSON.stringify(data.statement)))));
</script>`;

const { origin, close } = await serveFiles((address) => {
  const [, place, ...rest] = address.split('/');
  const path = rest.join('/');
  if (place === 'host') return host;
  if (place === 'player') return readFileSync(join(player, path));
  return place === 'page' ? readFileSync(join(work, 'page', path)) : files[path];
});
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });

await check(
  'H5P shows the picture of the page, gets answers, score and completion, and a second visit goes on',
  async () => {
    assert.equal(run('lesson.html', '--as', 'page', '--out', 'page').status, 0);
    const { page, problems } = await openLessonPage(browser, origin);
    await page.goto(`${origin}/page/index.html`);
    const asPage = await pictureOf(page);
    assert.ok(new Set(asPage.data).size > 20, 'a picture, and not one colour');

    const content = page.frameLocator('iframe');
    const statements = () => page.evaluate(() => /** @type {any} */ (window).statements.splice(0));
    const brief = async () =>
      (await statements())
        .filter((/** @type {any} */ one) => /answered|completed/.test(one.verb.id))
        .map((/** @type {any} */ { verb, object, result, context }) => [
          verb.id.split('/').at(-1),
          object.id,
          object.definition.interactionType,
          object.definition.correctResponsesPattern,
          result.response,
          result.success,
          result.score.raw,
          result.score.max,
          context?.contextActivities?.parent?.map((/** @type {any} */ one) => one.id),
        ]);
    await page.goto(`${origin}/host/`);
    await content.getByRole('heading', { name: 'First' }).waitFor();
    assert.equal(difference(await pictureOf(content), asPage), 0, 'the picture is that of the page');
    await content.getByText('2 < 3 & "so on" more').waitFor();
    await content.getByText('Made by a program').waitFor();
    await content.getByText('CC BY 4.0').waitFor();
    await page.emulateMedia({ colorScheme: 'dark' });
    const colors = await content.getByRole('heading', { name: 'First' }).evaluate((heading) => {
      const background = /** @type {Element} */ (heading.closest('.h5p-content'));
      return [getComputedStyle(heading).color, getComputedStyle(background).backgroundColor];
    });
    assert.deepEqual(colors, ['rgb(0, 0, 0)', 'rgb(254, 254, 254)'], 'dark text on the white of H5P');
    await page.emulateMedia({ colorScheme: 'light' });
    const height = () => page.locator('iframe').evaluate((frame) => frame.clientHeight);
    assert.ok((await height()) > 500, 'the frame is as high as the lesson');

    await content.getByRole('button', { name: 'Next' }).click();
    for (const answer of ['A', 'B, or C']) {
      await content.locator('#tissue').getByText(answer, { exact: true }).last().click();
      await content.getByRole('button', { name: 'Answer' }).click();
      await content
        .locator('#tissue')
        .getByText(answer === 'A' ? 'Not right' : 'Right.')
        .first()
        .waitFor();
    }
    const lessonId = 'https://example.org/lesson';
    const answered = (/** @type {string} */ response, /** @type {boolean} */ isRight) => [
      ...['answered', `${lessonId}?subContentId=tissue`, 'choice', ['b'], response, isRight, Number(isRight), 1],
      [lessonId],
    ];
    assert.deepEqual(await brief(), [answered('a', false), answered('b', true)]);

    // The learner leaves. What H5P asks of the content then is given to the next visit.
    const kept = await page
      .locator('iframe')
      .evaluate((frame) => JSON.stringify(/** @type {any} */ (frame).contentWindow.H5P.instances[0].getCurrentState()));
    await page.evaluate((state) => sessionStorage.setItem('kept', state), kept);
    // Meanwhile the package was moved to another host: that of @lumieducation/h5p-server 10.0.4 renames all files.
    for (const name of ['t1.json', 't1.png']) {
      const path = `content/data/scans/mni152-${name}`;
      const renamed = path.replace(name, name.replace('.', '-AfJ5BW6t.'));
      files[renamed] = files[path];
      delete files[path];
      files['content/content.json'] = encode(textOf('content/content.json').replace(path.slice(8), renamed.slice(8)));
    }
    await page.goto(`${origin}/host/`);
    await content.getByRole('heading', { name: 'Second' }).waitFor();
    await content.locator('#tissue').getByText('Right.').first().waitFor();
    await atRest(content);
    await content.getByRole('button', { name: 'Next' }).click();
    await content.getByRole('textbox').fill('7');
    await content.getByRole('button', { name: 'Answer' }).click();
    await content.getByText('Not right').first().waitFor();
    const [last, completed] = await brief();
    assert.deepEqual(last.slice(0, 2), ['answered', `${lessonId}?subContentId=question-2`]);
    assert.deepEqual(
      [completed[0], completed[1], ...completed.slice(5)],
      ['completed', lessonId, false, 1, 2, undefined],
    );
    assert.deepEqual(
      await content.locator('main').evaluate((main) => [main.getAttribute('lang'), main.getAttribute('dir')]),
      ['en', 'ltr'],
    );

    // What H5P asks of content with a score.
    const result = await page.locator('iframe').evaluate((frame) => {
      const { statement, children } = /** @type {any} */ (frame).contentWindow.H5P.instances[0].getXAPIData();
      const brief = (/** @type {any} */ { object, result }) => [
        ...[object.id, object.definition.interactionType, result.success, result.score.raw, result.score.max],
      ];
      return [statement, ...children.map((/** @type {any} */ one) => one.statement)].map(brief);
    });
    assert.deepEqual(result, [
      [lessonId, 'compound', false, 1, 2],
      [`${lessonId}?subContentId=tissue`, 'choice', true, 1, 1],
      [`${lessonId}?subContentId=question-2`, 'numeric', false, 0, 1],
    ]);
    const call = (/** @type {string} */ name) =>
      page
        .locator('iframe')
        .evaluate((frame, method) => /** @type {any} */ (frame).contentWindow.H5P.instances[0][method](), name);
    await call('resetTask');
    await content.getByRole('heading', { name: 'First' }).waitFor();
    await atRest(content);
    await content.getByRole('button', { name: 'Next' }).click();
    assert.equal(await content.getByText('Right.').count(), 0, 'no answer is left');
    assert.deepEqual(await Promise.all(['getScore', 'getAnswerGiven'].map(call)), [0, false]);
    await call('showSolutions');
    await content.locator('#tissue').getByText('B, or C', { exact: true }).last().waitFor();
    await content.locator('#tissue label.right').getByText('B, or C').waitFor();
    await content.getByText('140').first().waitFor({ state: 'attached' });
    assert.deepEqual(
      await Promise.all(['getScore', 'getAnswerGiven'].map(call)),
      [0, false],
      'a solution is no answer',
    );
    assert.deepEqual(problems, []);
    await page.context().close();
  },
);

await check('what an author of H5P may not bring in is refused: the page says so, and nothing of it runs', async () => {
  const { page, problems } = await openLessonPage(browser, origin);
  const good = files['content/content.json'];
  for (const html of [
    '<volume-view src="data/a.json"></volume-view><img src=x onerror="parent.ran = 1">',
    '<script>parent.ran = 1</script><volume-view src="data/a.json"></volume-view>',
    '<volume-view src="https://example.org/a.nii"></volume-view>',
    '<a href="javascript:parent.ran=1">x</a><volume-view src="data/a.json"></volume-view>',
  ]) {
    for (const text of [html, html.replaceAll('&', '&amp;').replaceAll('<', '&lt;')]) {
      files['content/content.json'] = encode(JSON.stringify({ html: text }));
      await page.goto(`${origin}/host/`);
      await page.frameLocator('iframe').getByRole('alert').getByText('This lesson is not shown').waitFor();
      assert.equal(await page.evaluate(() => /** @type {any} */ (window).ran), undefined);
    }
  }
  files['content/content.json'] = good;
  assert.deepEqual(problems, []);
  await page.context().close();
});

await browser.close();
close();
finish();
