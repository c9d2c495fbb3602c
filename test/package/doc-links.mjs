// Relative links of the pages: the file is there, and so is the heading. The index leads to every page. Files that pages and comments name are there.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { findBrokenLinks } from '../../scripts/find-broken-links.mjs';
import { listDirectArrows } from '../../scripts/map-rooms.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

await check('a broken link is found, in a page and to a heading', () => {
  const folder = mkdtempSync(join(tmpdir(), 'volume-view-links-'));
  try {
    const [one, other] = ['one.md', 'other.md'].map((name) => join(folder, name));
    writeFileSync(
      one,
      '# One, `first`\n[a](other.md) [b](other.md#its-heading) [c](#one-first) [d](https://example.org)\n```\n[x](no.md)\n```\n[e](no.md) [f](other.md#no) [g](#no)\n',
    );
    writeFileSync(other, '## Its heading\n');
    assert.deepEqual(
      findBrokenLinks([one, other]).map((line) => line.split(': ')[1]),
      ['no.md', 'other.md#no', '#no'],
    );
  } finally {
    rmSync(folder, { recursive: true });
  }
});

const pages = readdirSync(join(projectRoot, 'docs'), { recursive: true })
  .map(String)
  .filter((name) => name.endsWith('.md'))
  .map((name) => `docs/${name}`);
const otherPages = [
  'README.md',
  'CONTRIBUTING.md',
  'GLOSSARY.md',
  'CHANGELOG.md',
  'CREDITS.md',
  'test/bench/peers/README.md',
];
const files = [...otherPages, ...pages].map((name) => join(projectRoot, name));

await check('the pages of this project have none', () => {
  assert.deepEqual(findBrokenLinks(files), []);
});

await check('docs/README.md leads to every page', () => {
  const index = readFileSync(join(projectRoot, 'docs/README.md'), 'utf8');
  const listed = pages
    .map((path) => path.slice('docs/'.length))
    .filter((path) => !path.startsWith('reference/') && path !== 'README.md');
  for (const folder of ['guide', 'numbers', 'develop'])
    assert.ok(
      listed.some((path) => path.startsWith(`${folder}/`)),
      folder,
    );
  assert.deepEqual(
    listed.filter((path) => !index.includes(`](${path})`)),
    [],
  );
});

/**
 * Names of files in a text that are not there: paths from the root of the project anywhere, and names of code between backticks.
 * @param {string} text @param {{ names: ReadonlySet<string> }} code - the names of all files of code, without their folders
 */
function listLostNames(text, { names }) {
  const paths = [
    ...text.matchAll(
      /(?<![\w./-])(?:src|components|shaders|docs|scripts|test|demos|packages)\/[\w./-]*\.(?:ts|mjs|glsl|md|html|css|json)\b/g,
    ),
  ].map(([path]) => path);
  const short = [...text.matchAll(/`([\w-]+(?:\.[\w-]+)*\.(?:ts|mjs|glsl))`/g)].map(([, name]) => name);
  return [...paths.filter((path) => !existsSync(join(projectRoot, path))), ...short.filter((name) => !names.has(name))];
}

/** Files of code, from the root of the project. */
const code = ['src', 'components', 'shaders', 'scripts', 'test', 'demos', 'packages']
  .flatMap((folder) =>
    readdirSync(join(projectRoot, folder), { recursive: true }).map(
      (name) => `${folder}/${String(name).replaceAll('\\', '/')}`,
    ),
  )
  .filter((path) => /\.(?:ts|mjs|glsl)$/.test(path) && !/node_modules|\/dist\//.test(path));
const names = new Set(code.map((path) => path.slice(path.lastIndexOf('/') + 1)));

await check('files of code that pages for developers name are there', () => {
  assert.deepEqual(listLostNames('`src/core/errors.ts`, `errors.ts`', { names }), []);
  assert.deepEqual(listLostNames('`src/core/gone.ts`, docs/gone.md, `gone.ts`', { names }), [
    'src/core/gone.ts',
    'docs/gone.md',
    'gone.ts',
  ]);
  const developer = [...otherPages, ...pages.filter((path) => path.startsWith('docs/develop/'))];
  assert.deepEqual(
    developer.flatMap((path) =>
      listLostNames(readFileSync(join(projectRoot, path), 'utf8'), { names }).map((name) => `${path}: ${name}`),
    ),
    [],
  );
});

await check('pages that code names are there', () => {
  const lost = code
    .filter((path) => path !== 'test/package/doc-links.mjs')
    .flatMap((path) =>
      [...readFileSync(join(projectRoot, path), 'utf8').matchAll(/\bdocs\/[\w/-]+\.md\b/g)]
        .filter(([page]) => !existsSync(join(projectRoot, page)))
        .map(([page]) => `${path}: ${page}`),
    );
  assert.deepEqual(lost, []);
  return `${code.length} files of code`;
});

/** The file of the formula that a comment `Twin: optics/…` names, from src. */
const listTwins = (/** @type {string} */ text) =>
  [...text.matchAll(/\bTwin: ((?:[\w-]+\/)+[\w-]+\.ts)/g)].map(([, twin]) => twin);

await check('the file in float64 that a chunk of GLSL names as its twin is there', () => {
  assert.deepEqual(listTwins('/// Waits. Twin: optics/rays/gone.ts, wait'), ['optics/rays/gone.ts']);
  const twins = code
    .filter((path) => path.endsWith('.glsl'))
    .flatMap((path) => listTwins(readFileSync(join(projectRoot, path), 'utf8')).map((twin) => ({ path, twin })));
  assert.ok(twins.length > 50, `${twins.length}`);
  assert.deepEqual(
    twins.filter(({ twin }) => !existsSync(join(projectRoot, 'src', twin))),
    [],
  );
  return `${twins.length} twins`;
});

await check('the map of the code leaves out arrows that follow from others', () => {
  assert.deepEqual(listDirectArrows({ a: [], b: ['a'], c: ['a', 'b'], d: ['a'] }), [
    ['b', 'a'],
    ['c', 'b'],
    ['d', 'a'],
  ]);
});

await check('each element has a page of its own, and the index leads to it', () => {
  const elements = readdirSync(join(projectRoot, 'components')).filter((name) => name.startsWith('volume-'));
  assert.ok(elements.length > 10);
  const index = readFileSync(join(projectRoot, 'docs/reference.md'), 'utf8');
  for (const name of elements) {
    assert.ok(index.includes(`](reference/${name}.md)`), `docs/reference.md has no link to ${name}`);
    assert.match(
      readFileSync(join(projectRoot, `docs/reference/${name}.md`), 'utf8'),
      new RegExp(`^# \`<${name}>\`\n`),
    );
  }
});

await check('no page has the marks of a merge that was not finished', () => {
  const marks = /^(<{7} |={7}$|>{7} )/m;
  assert.match(`a\n${'<'.repeat(7)} HEAD\nb`, marks);
  assert.deepEqual(
    files.filter((file) => marks.test(readFileSync(file, 'utf8'))),
    [],
  );
});

finish();
