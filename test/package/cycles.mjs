// No two files import each other, by whatever way; and what says so finds the cycles that are made for it.
import assert from 'node:assert/strict';
import { mkdtempSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { findCycles } from '../../scripts/find-cycles.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';
import { listCode } from './list-code.mjs';

const folder = realpathSync(mkdtempSync(join(tmpdir(), 'volume-view-cycles-')));

/**
 * The cycles among files a.ts, b.ts and c.ts of these texts.
 * @param {readonly string[]} texts
 */
function findAmong(texts) {
  const paths = texts.map((_, i) => join(folder, `${'abc'[i]}.ts`));
  texts.forEach((text, i) => writeFileSync(paths[i], text));
  return findCycles(paths).map((cycle) => cycle.map((path) => relative(folder, path)));
}

const back = `import { a } from './a.ts';\nexport const b = a;`;
const ways = [
  `import { b } from './b.ts';\nexport const a = b;`,
  `import './b.ts';\nexport const a = 1;`,
  `import type { b } from './b.ts';\nexport let a: typeof b;`,
  `export { b } from './b.ts';\nexport const a = 1;`,
  `export type { b } from './b.ts';\nexport const a = 1;`,
  `export * from './b.ts';\nexport const a = 1;`,
  `export const a = () => import('./b.ts');`,
  `export let a: import('./b.ts').B;`,
  `export const a: typeof import('./b.ts') = 1;`,
  `import { b } from './b.ts?raw';\nexport const a = b;`,
];
for (const way of ways) {
  await check(`a cycle by ${JSON.stringify(way)} is found`, () =>
    assert.deepEqual(findAmong([way, back]), [['a.ts', 'b.ts']]),
  );
}
await check('a cycle of types alone is found, over three files', () => {
  const types = ['b', 'c', 'a'].map((next) => `export type T = import('./${next}.ts').T[];`);
  assert.deepEqual(findAmong(types), [['a.ts', 'b.ts', 'c.ts']]);
});
await check('what is no cycle is none', () => {
  const text = `// import './a.ts'\nexport const b = "import './a.ts'";`;
  assert.deepEqual(findAmong([ways[0], text, `import './a.ts';\nimport './b.ts';`]), []);
});
rmSync(folder, { recursive: true });

await check('no file imports itself, over others or directly', () => {
  const paths = listCode(/\.(ts|mjs|js)$/);
  const cycles = findCycles(paths.map((path) => join(projectRoot, path)));
  const lines = cycles.map((cycle) => [...cycle, cycle[0]].map((path) => relative(projectRoot, path)).join(' -> '));
  assert.ok(cycles.length === 0, lines.join('\n'));
  return `${paths.length} files`;
});
finish();
