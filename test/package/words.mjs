// One word for one idea (GLOSSARY.md): comments have none of the private words that a newcomer would have to learn.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

/** A private word, and what to write. @type {readonly (readonly [RegExp, string])[]} */
const words = [
  [/\b(?:is|are|be|was|were) told\b/i, 'notify, receive, get'],
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
];

const folders = ['src', 'components', 'shaders', 'packages/prepare/src'];
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

await check('a list that finds nothing is no list', () => {
  const [found] = listComments('const a = 1; // Who is told of it.\n').filter(({ comment }) =>
    words.some(([word]) => word.test(comment)),
  );
  assert.equal(found?.line, 1);
  assert.deepEqual(listComments('const url = "http://a"; wear(sheet);'), []);
});

await check('comments have no private words', () => {
  const found = files.flatMap((file) =>
    listComments(readFileSync(join(projectRoot, file), 'utf8')).flatMap(({ line, comment }) =>
      words
        .filter(([word]) => word.test(comment))
        .map(([word, better]) => `${file}:${line}: "${word.exec(comment)?.[0]}"; write: ${better}`),
    ),
  );
  assert.deepEqual(found, []);
  return `${files.length} files`;
});

finish();
