// One word for one idea (GLOSSARY.md): comments, sentences that a person reads, titles of tests, and pages have none of the private words that a
// newcomer would have to learn.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';
import { listCode } from './list-code.mjs';

/** A private word, and what to write. @type {readonly (readonly [RegExp, string])[]} */
const words = [
  [/\banew\b/i, 'again'],
  [/\bbe it\b/i, 'or'],
  [/\btongues?\b/i, 'locale, language'],
  [/\bobey(?:s|ed)?\b/i, 'run, follow'],
  [/\bforet(?:ell|ells|old)\b/i, 'predict'],
  [/\bfurnish(?:es|ed)?\b/i, 'apply'],
  [/\bforgiv(?:e|es|en)\b/i, 'clear'],
  [/\brehears(?:e|es|ed|al)\b/i, 'precompile'],
  [/\b(?:wears?|worn|wore|dressed)\b/i, 'apply, have'],
  [/\bbut for\b/i, 'except'],
  [/\b(?:tells?|told|telling)\b/i, 'say, report, notify, show'],
  [/\bbeside\b/i, 'next to, in addition to, together with'],
  [/\bat the (?:most|least)\b/i, 'at most, at least'],
  [/\bkeepers?\b/i, 'controller'],
  [/\bwhat is there\b/i, 'name it'],
];

const folders = [
  ...['src', 'components', 'shaders'],
  ...['prepare', 'lesson-writers', 'studio', 'embed'].map((name) => `packages/${name}/src`),
];
const files = folders.flatMap((folder) =>
  readdirSync(join(projectRoot, folder), { recursive: true, encoding: 'utf8' })
    .map((name) => `${folder}/${name.replaceAll('\\', '/')}`)
    .filter((name) => /\.(?:ts|glsl)$/.test(name)),
);

/** Comments of a text, each with the number of its line; names of code in backticks or braces are no words. @param {string} text */
function listComments(text) {
  const lines = text.split('\n');
  let isInside = false;
  return lines.flatMap((line, i) => {
    const start = isInside ? 0 : line.search(/\/\*|(?<![:'"`\w])\/\/(?=\s)/);
    if (start < 0) return [];
    isInside = isInside ? !line.includes('*/') : line.slice(start).startsWith('/*') && !line.includes('*/', start);
    return [{ line: i + 1, comment: line.slice(start).replace(/`[^`]*`|\{[^}]*\}|@\w+ \w+/g, '') }];
  });
}

/**
 * Sentences in the code of a text: strings and templates of two words or more, each with the number of its line.
 * @param {string} text
 */
function listSentences(text) {
  return text.split('\n').flatMap((line, i) => {
    if (/^\s*(?:\*|\/\/|\/\*|import )/.test(line)) return [];
    const strings = [...line.matchAll(/'((?:[^'\\]|\\.)*)'|"((?:[^"\\]|\\.)*)"|`([^`]*)`/g)].map(([, ...found]) =>
      found.join('').replace(/\$\{[^}]*\}/g, ''),
    );
    return strings.filter((one) => /[a-z],? [a-z]/.test(one)).map((sentence) => ({ line: i + 1, sentence }));
  });
}

/** Calls whose first argument is the title of a test. */
const titled =
  /(?<![\w.])(?:it|test|describe|check|\w+Test)(?:\.\w+)*\(\s*(?:'((?:[^'\\]|\\.)*)'|"((?:[^"\\]|\\.)*)"|`((?:[^`\\]|\\.)*)`)/g;

/** Titles of tests in a text, each with the number of its line. @param {string} text */
function listTitles(text) {
  return [...text.matchAll(titled)].map(({ index, 0: call, 1: single, 2: double, 3: template }) => ({
    line: text.slice(0, index + call.length).split('\n').length,
    title: (single ?? double ?? template).replace(/\$\{[^}]*\}/g, ''),
  }));
}

/** The prose of a page, line by line: without code, addresses and comments. @param {string} text */
function listProse(text) {
  const blank = (/** @type {string} */ block) => block.replace(/[^\n]/g, '');
  return text
    .replace(/^ *```[\s\S]*?^ *```/gm, blank)
    .replace(/<!--[\s\S]*?-->/g, blank)
    .replace(/`[^`\n]*`/g, '')
    .replace(/\]\([^)\s]*\)/g, ']')
    .split('\n')
    .map((prose, i) => ({ line: i + 1, prose }));
}

/**
 * Private words in a text, as lines that say what to write.
 * @param {string} file @param {number} line @param {string} text
 */
const findWords = (file, line, text) =>
  words
    .filter(([word]) => word.test(text))
    .map(([word, better]) => `${file}:${line}: "${word.exec(text)?.[0]}"; write: ${better}`);

await check('a list that finds nothing is no list', () => {
  const [found] = listComments('const a = 1; // Who is told of it.\n').filter(({ comment }) =>
    words.some(([word]) => word.test(comment)),
  );
  assert.equal(found?.line, 1);
  assert.deepEqual(listComments('const url = "http://a"; wear(sheet);'), []);
});

await check('a sentence in a string, and one in a page, is found', () => {
  assert.deepEqual(
    listSentences("fail('Nobody is told of it.');").map(({ sentence }) => findWords('a.ts', 1, sentence)),
    [['a.ts:1: "told"; write: say, report, notify, show']],
  );
  assert.deepEqual(listSentences('const shadowRoot = `beside`;'), []);
  const page = listProse('It lies\nbeside `tell` [a](beside.md).\n```\ntell\n```\n').flatMap(({ line, prose }) =>
    findWords('a.md', line, prose),
  );
  assert.deepEqual(page, ['a.md:2: "beside"; write: next to, in addition to, together with']);
});

await check('a title of a test is found, on any line', () => {
  const text =
    "it('reads', () => {});\ntest.describe(\n  `${name}: is told`, () => wear('told'));\nawait check(\"it's anew\", act);\n";
  const found = listTitles(text).flatMap(({ line, title }) => findWords('a.ts', line, title));
  assert.deepEqual(found, ['a.ts:3: "told"; write: say, report, notify, show', 'a.ts:4: "anew"; write: again']);
});

await check('comments have no private words', () => {
  const found = files.flatMap((file) =>
    listComments(readFileSync(join(projectRoot, file), 'utf8')).flatMap(({ line, comment }) =>
      findWords(file, line, comment),
    ),
  );
  assert.deepEqual(found, []);
  return `${files.length} files`;
});

await check('sentences that a person reads have none', () => {
  const code = files.filter((file) => file.endsWith('.ts') && !file.startsWith('src/messages/locales/'));
  const found = code.flatMap((file) =>
    listSentences(readFileSync(join(projectRoot, file), 'utf8')).flatMap(({ line, sentence }) =>
      findWords(file, line, sentence),
    ),
  );
  assert.deepEqual(found, []);
});

await check('titles of tests have none', () => {
  const tests = listCode(/\.(?:ts|js|mjs)$/).filter((path) => path.startsWith('test/'));
  let count = 0;
  const found = tests.flatMap((file) => {
    const titles = listTitles(readFileSync(join(projectRoot, file), 'utf8'));
    count += titles.length;
    return titles.flatMap(({ line, title }) => findWords(file, line, title));
  });
  assert.ok(count > 1000);
  assert.deepEqual(found, []);
  return `${count} titles`;
});

await check('pages have none', () => {
  // The glossary lists the words that are not to be used.
  const pages = listCode(/\.md$/).filter((path) => !/^(?:GLOSSARY|CREDITS)\.md$|LICENSES\.md$/.test(path));
  assert.ok(pages.length > 50);
  const found = pages.flatMap((file) =>
    listProse(readFileSync(join(projectRoot, file), 'utf8')).flatMap(({ line, prose }) => findWords(file, line, prose)),
  );
  assert.deepEqual(found, []);
  return `${pages.length} pages`;
});

finish();
