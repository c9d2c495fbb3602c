// `npm test` runs every part; the last line is the sum. With `--engines`, it also runs the smoke test in the other engines; with
// `--bundlers`, also the apps of test/bundlers, which are then installed. A part is a program that ends with `N passed, N failed`; a part
// that counts nothing is one check.
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** @param {string} path - of a script below node_modules */
const bin = (path) => join(projectRoot, 'node_modules', path);

/**
 * @typedef {object} Part
 * @property {string} title
 * @property {string[]} args - of node
 * @property {boolean} counts - whether it prints how many tests passed and failed
 * @property {string} [after] - the part whose files it reads, or which reads files that it changes
 * @property {boolean} [browser] - whether it runs a browser that keeps all cores busy
 * @property {boolean} [retries] - whether it tries its own tests once more
 * @property {boolean} [waits] - whether it mostly waits, and so takes no core from another part
 * @property {string} [option] - of `npm test`, without which it does not run
 */

/** @type {Part[]} */
const allParts = [
  { title: 'Lint', args: ['scripts/lint.mjs'], counts: false },
  { title: 'Lint: the rule of the modules works', args: ['test/package/lint-modules.mjs'], counts: true },
  { title: 'No cycles of imports', args: ['test/package/cycles.mjs'], counts: true },
  { title: 'One word for one idea, in comments, sentences and pages', args: ['test/package/words.mjs'], counts: true },
  { title: 'Engines of packages', args: ['test/package/engines.mjs'], counts: true },
  { title: 'Types', args: [bin('typescript/bin/tsc'), '--noEmit'], counts: false },
  {
    title: 'Types: the pure modules know no DOM',
    args: [bin('typescript/bin/tsc'), '-p', 'tsconfig.pure.json'],
    counts: false,
  },
  { title: 'Files that fuzzing found', args: ['test/fuzz/corpus.mjs'], counts: true },
  { title: 'Build: dist stays whole meanwhile', args: ['test/package/rebuild.mjs'], counts: true },
  {
    title: 'Docs: the reference is what the code says',
    args: ['scripts/docs.mjs', '--check'],
    counts: false,
    after: 'Build: dist stays whole meanwhile',
  },
  // First of those that wait for the build, as it takes longest.
  {
    title: 'Apps of bundlers and frameworks',
    args: ['test/bundlers/run.mjs'],
    counts: true,
    option: '--bundlers',
    after: 'Docs: the reference is what the code says',
  },
  { title: 'Docs: links', args: ['test/package/doc-links.mjs'], counts: true },
  // The check of the reference writes the manifest of the elements again, and the package contains that file.
  {
    title: 'Package',
    args: ['test/package/run.mjs'],
    counts: true,
    after: 'Docs: the reference is what the code says',
  },
  {
    title: 'Package volume-view-prepare',
    args: ['test/package/prepare.mjs'],
    counts: true,
    after: 'Build: dist stays whole meanwhile',
  },
  {
    title: 'A folder for a web site',
    args: ['test/package/prepare-folder.mjs'],
    counts: true,
    after: 'Build: dist stays whole meanwhile',
  },
  {
    title: 'A folder in each form',
    args: ['test/package/prepare-forms.mjs'],
    counts: true,
    after: 'Build: dist stays whole meanwhile',
  },
  {
    title: "A radar's folder",
    args: ['test/package/prepare-watch.mjs'],
    counts: true,
    waits: true, // 9 seconds of a processor in 40.
    after: 'Build: dist stays whole meanwhile',
  },
  {
    title: 'Lessons as pages and courses',
    args: ['test/package/lesson-writers.mjs'],
    counts: true,
    after: 'Docs: the reference is what the code says',
  },
  {
    title: 'Lessons as one file',
    args: ['test/package/lesson-single-file.mjs'],
    counts: true,
    after: 'Docs: the reference is what the code says',
  },
  {
    title: 'Lessons for H5P',
    args: ['test/package/lesson-h5p.mjs'],
    counts: true,
    after: 'Docs: the reference is what the code says',
  },
  {
    title: 'Lessons for frames of other sites',
    args: ['test/package/lesson-embed.mjs'],
    counts: true,
    after: 'Docs: the reference is what the code says',
  },
  { title: 'Tests in Python that can not run', args: ['test/package/python-missing.mjs'], counts: true },
  {
    title: 'The widget for notebooks, in Python',
    args: ['test/package/jupyter.mjs'],
    counts: true,
    after: 'Build: dist stays whole meanwhile',
  },
  {
    title: 'The archive of many scans, in Python',
    args: ['test/package/archive.mjs'],
    counts: true,
    after: 'Build: dist stays whole meanwhile',
  },
  {
    title: 'The plugin for WordPress',
    args: ['test/package/wordpress.mjs'],
    counts: true,
    after: 'Docs: the reference is what the code says',
  },
  {
    title: 'The site of the docs',
    args: ['test/package/site.mjs'],
    counts: true,
    after: 'Docs: the reference is what the code says',
  },
  {
    title: 'Smoke test in three engines',
    args: ['test/engines/run.mjs'],
    counts: true,
    option: '--engines',
    after: 'Build: dist stays whole meanwhile',
  },
  // The last of these: it fills all cores when no other part is left.
  { title: 'Unit tests in Node', args: ['scripts/test-fast.mjs'], counts: true },
  { title: 'Unit tests in Chromium', args: [bin('@web/test-runner/dist/bin.js')], counts: true, browser: true },
  {
    title: 'End to end, on the built package',
    args: [bin('@playwright/test/cli.js'), 'test'],
    counts: true,
    browser: true,
    retries: true,
  },
];
const parts = allParts.filter(({ option }) => !option || process.argv.includes(option));

/** Minutes that a part may take, several times what it takes on a busy machine: one that waits for ever is ended, and its output shown. */
const LONGEST = { browser: 30, other: 10 };

/**
 * How a part has ended: with its standard output.
 * @typedef {{ status: number, output: string, seconds: number }} End
 */

/** Processes that run now. @type {Set<import('node:child_process').ChildProcess>} */
const children = new Set();
// A part is the leader of a group, so that what it started ends with it.
const hasGroups = process.platform !== 'win32';

/** Ends a part with all that it started. @param {import('node:child_process').ChildProcess} child */
function end(child) {
  try {
    if (hasGroups && child.pid) process.kill(-child.pid, 'SIGKILL');
    else child.kill('SIGKILL');
  } catch {
    // Nothing of it runs.
  }
}
for (const signal of /** @type {const} */ (['SIGINT', 'SIGTERM'])) {
  process.on(signal, () => {
    for (const child of children) end(child);
    process.exit(1);
  });
}

/** Lines of what a part prints that name what failed. */
const failures = /^.*(?:not ok|FAILED|second try): .*$/gm;

/**
 * Run one part. In CI a part that fails is tried once more, as single tests of the end-to-end part are, and what had failed is named at the
 * end of the run: a busy machine is late once, a fault is there twice.
 * @param {Part} part
 * @returns {Promise<End>}
 */
async function runPart(part) {
  const first = await tryPart(part);
  if (first.status === 0 || !process.env.CI || part.retries) return first;
  const named = [...new Set(first.output.match(failures) ?? [])].slice(0, 10).map((line) => line.trim());
  const words = `second try: it failed after ${first.seconds.toFixed(0)} s: ${named.join('; ')}\n`;
  console.log(`${part.title}: ${words}`);
  const second = await tryPart(part);
  return { ...second, output: `${words}${second.output}` };
}

/**
 * Run one part, and show its output: for a part with a browser, which takes minutes, at once; for others when it ends.
 * @param {Part} part
 * @returns {Promise<End>}
 */
function tryPart({ title, args, browser = false }) {
  return new Promise((resolve) => {
    const start = Date.now();
    let [output, held] = ['', `\n=== ${title} ===\n`];
    const show = () => {
      process.stdout.write(held);
      held = '';
    };
    if (browser) show();
    const child = spawn(process.execPath, args, {
      cwd: projectRoot,
      stdio: ['ignore', 'pipe', 'pipe'],
      detached: hasGroups,
    });
    children.add(child);
    for (const stream of [child.stdout, child.stderr]) {
      stream.setEncoding('utf8').on('data', (text) => {
        if (stream === child.stdout) output += text;
        held += text;
        if (browser) show();
      });
    }
    const minutes = browser ? LONGEST.browser : LONGEST.other;
    const limit = setTimeout(() => {
      const words = `not ok: ${title} had not ended after ${minutes} minutes\n`;
      output += words;
      held += words;
      end(child);
    }, minutes * 60_000);
    // What a part has left behind may hold its output open.
    child.once('exit', () => end(child));
    child.once('close', (status) => {
      clearTimeout(limit);
      children.delete(child);
      show();
      resolve({ status: status ?? 1, output, seconds: (Date.now() - start) / 1000 });
    });
  });
}

/** @type {Map<Part, End>} */
const ended = new Map();

/**
 * Run parts, each one after the part that its `after` names.
 * @param {Part[]} waiting
 * @param {number} atOnce - maximum number of parts that run at the same time, except those that wait
 */
async function runParts(waiting, atOnce) {
  /** @type {Set<Promise<void>>} */
  const running = new Set();
  let busy = 0;
  const mayStart = (/** @type {Part} */ { after, waits }) =>
    (waits || busy < atOnce) && (!after || [...ended.keys()].some(({ title }) => title === after));
  while (waiting.length + running.size > 0) {
    const next = waiting.find(mayStart);
    if (next) {
      waiting = waiting.filter((part) => part !== next);
      const cores = next.waits ? 0 : 1;
      busy += cores;
      const run = runPart(next).then((end) => {
        ended.set(next, end);
        running.delete(run);
        busy -= cores;
      });
      running.add(run);
    } else await Promise.race(running);
  }
}

// Parts without such a browser mostly use one thread: run two at a time.
await runParts(
  parts.filter(({ browser }) => !browser),
  2,
);
await runParts(
  parts.filter(({ browser }) => browser),
  1,
);

let passed = 0;
let failed = 0;
/** @type {string[]} */
const summary = [];
for (const part of parts) {
  const { title, counts } = part;
  const { status, output, seconds } = /** @type {NonNullable<ReturnType<typeof ended.get>>} */ (ended.get(part));
  const found = counts ? [...output.matchAll(/^(\d+) passed, (\d+) failed$/gm)].at(-1) : undefined;
  const partPassed = found ? Number(found[1]) : Number(!counts && status === 0);
  // A part with an exit code other than 0 has failed, whatever it counted; so has a part that should count but printed no numbers.
  const partFailed = Math.max(found ? Number(found[2]) : 0, Number(status !== 0 || (counts && !found)));
  passed += partPassed;
  failed += partFailed;
  const reported = partFailed > 0 ? failures : /^.*second try: .*$/gm;
  const named = [...output.matchAll(reported)].map(([line]) => `\n        ${line}`).join('');
  summary.push(
    `${partFailed > 0 ? 'FAILED' : 'ok    '}  ${title}: ${partPassed} passed, ${partFailed} failed (${seconds.toFixed(1)} s)${named}`,
  );
}
console.log(`\n=== Summary ===\n${summary.join('\n')}\n`);
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
