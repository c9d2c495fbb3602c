// `npm run test:fast`: the tests of test/unit in Node, without a browser. Arguments are parts of file names. Node 20 can't read TypeScript,
// so the tests are first bundled into a folder of their own. mocha runs the files on all cores.
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import Mocha from 'mocha';
import { build } from 'vite';
import { projectRoot } from './shared-data.mjs';

const folder = join(projectRoot, 'test/unit');
const asked = process.argv.slice(2);
const files = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  .map((name) => name.replaceAll('\\', '/'))
  .filter(
    (name) =>
      name.endsWith('.test.ts') && (asked.length === 0 || asked.some((part) => `test/unit/${name}`.includes(part))),
  );
files.sort();
if (files.length === 0) throw new Error(`no test file of test/unit has ${asked.join(' or ')} in its name`);

const bundled = mkdtempSync(join(projectRoot, 'node_modules/.test-fast-'));
process.on('exit', () => rmSync(bundled, { recursive: true, force: true }));
const nameOf = (/** @type {string} */ file) => file.replace(/\.ts$/, '');
await build({
  configFile: false,
  root: projectRoot,
  publicDir: false,
  logLevel: 'warn',
  ssr: { noExternal: true },
  build: {
    ssr: true,
    outDir: bundled,
    minify: false,
    target: 'node20',
    rolldownOptions: {
      input: Object.fromEntries(files.map((file) => [nameOf(file), join(folder, file)])),
      output: { entryFileNames: '[name].mjs', chunkFileNames: 'chunks/[name]-[hash].mjs' },
    },
  },
});

/** How many of the slowest tests are named at the end. */
const longestShown = 12;

const mocha = new Mocha({
  ui: 'bdd',
  timeout: 120_000,
  parallel: files.length > 1,
  jobs: availableParallelism(),
  reporter: 'dot',
  require: [join(projectRoot, 'scripts/test-fast-setup.mjs')],
});
for (const file of files) mocha.addFile(join(bundled, `${nameOf(file)}.mjs`));
await import('./test-fast-setup.mjs');
if (files.length === 1) await mocha.loadFilesAsync();
/** @type {{ title: string, ms: number }[]} */
const times = [];
const runner = mocha.run((failures) => {
  const { passes = 0 } = runner.stats ?? {};
  times.sort((a, b) => b.ms - a.ms);
  if (files.length > 1)
    for (const { title, ms } of times.slice(0, longestShown))
      console.log(`${(ms / 1000).toFixed(1).padStart(6)} s ${title}`);
  console.log(`${passes} passed, ${failures} failed`);
  process.exit(failures > 0 ? 1 : 0); // Some tests leave a timer or a worker running.
});
runner.on('pass', (test) => times.push({ title: test.fullTitle(), ms: test.duration ?? 0 }));
runner.on('fail', (test) => console.log(`FAILED: ${test.fullTitle()}`));
