// `npm test`: every part in turn, and as the last line the sum. With `--engines`, the smoke test in the other engines too; with
// `--bundlers`, the apps of test/bundlers, which are installed for it. A part is a program that ends with `N passed, N failed`, or, where it counts nothing, is one check itself.
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** @param {string} path - of a script below node_modules */
const bin = (path) => join(projectRoot, 'node_modules', path);

/** @type {{ title: string, args: string[], counts: boolean }[]} */
const parts = [
  { title: 'Lint', args: ['scripts/lint.mjs'], counts: false },
  { title: 'Lint: the rule of the modules works', args: ['test/package/lint-modules.mjs'], counts: true },
  { title: 'Sizes of files', args: ['test/package/sizes.mjs'], counts: true },
  { title: 'No cycles of imports', args: ['test/package/cycles.mjs'], counts: true },
  { title: 'Engines of packages', args: ['test/package/engines.mjs'], counts: true },
  { title: 'Types', args: [bin('typescript/bin/tsc'), '--noEmit'], counts: false },
  { title: 'Types: the pure modules know no DOM', args: [bin('typescript/bin/tsc'), '-p', 'tsconfig.pure.json'], counts: false },
  { title: 'Unit tests in Chromium', args: [bin('@web/test-runner/dist/bin.js')], counts: true },
  { title: 'Files that fuzzing found', args: ['test/fuzz/corpus.mjs'], counts: true },
  { title: 'Build', args: ['scripts/build.mjs'], counts: false },
  { title: 'Docs: the reference is what the code says', args: ['scripts/docs.mjs', '--check'], counts: false },
  { title: 'Docs: links', args: ['test/package/doc-links.mjs'], counts: true },
  { title: 'Package', args: ['test/package/run.mjs'], counts: true },
  { title: 'End to end, on the built package', args: [bin('@playwright/test/cli.js'), 'test'], counts: true },
];
if (process.argv.includes('--engines')) {
  parts.push({ title: 'Smoke test in three engines', args: ['test/engines/run.mjs'], counts: true });
}

if (process.argv.includes('--bundlers')) {
  parts.push({ title: 'Apps of bundlers and frameworks', args: ['test/bundlers/run.mjs'], counts: true });
}

/**
 * Run one part, showing what it says.
 * @param {string[]} args - of node
 * @returns {Promise<{ status: number, output: string }>}
 */
function runPart(args) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, args, { cwd: projectRoot, stdio: ['ignore', 'pipe', 'inherit'] });
    let output = '';
    child.stdout.on('data', (chunk) => {
      output += chunk;
      process.stdout.write(chunk);
    });
    child.once('close', (status) => resolve({ status: status ?? 1, output }));
  });
}

let passed = 0;
let failed = 0;
/** @type {string[]} */
const summary = [];
for (const { title, args, counts } of parts) {
  console.log(`\n=== ${title} ===`);
  const start = Date.now();
  const { status, output } = await runPart(args);
  const found = counts ? [...output.matchAll(/^(\d+) passed, (\d+) failed$/gm)].at(-1) : undefined;
  const partPassed = found ? Number(found[1]) : Number(!counts && status === 0);
  // A part that ends badly has failed, whatever it counted; so has one that counts and did not say how much.
  const partFailed = Math.max(found ? Number(found[2]) : 0, Number(status !== 0 || (counts && !found)));
  passed += partPassed;
  failed += partFailed;
  const seconds = ((Date.now() - start) / 1000).toFixed(1);
  const told = partFailed > 0 ? /^.*(?:not ok|FAILED|second try): .*$/gm : /^.*second try: .*$/gm;
  const named = [...output.matchAll(told)].map(([line]) => `\n        ${line}`).join('');
  summary.push(`${partFailed > 0 ? 'FAILED' : 'ok    '}  ${title}: ${partPassed} passed, ${partFailed} failed (${seconds} s)${named}`);
}
console.log(`\n=== Summary ===\n${summary.join('\n')}\n`);
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
