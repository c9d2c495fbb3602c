// Builds the package, in three forms from one source:
//   dist/esm/**              unbundled modules with bare imports, for bundlers and Node
//   dist/volume-view.js      one module (plus lazy chunks) for a page without a bundler
//   dist/volume-legend.js .. each companion alone, for such a page too; volume-view.js itself fetches those that a page needs
//   dist/volume-view.iife.js a classic script, for file:// pages and sandboxed iframes, where modules are blocked
//   dist/classic/**          the parts of the classic script that few pages need
//   dist/embed.html          a page with one volume, for iframes
//   dist/from-disk.html      a page that makes a page with a volume inside, which then works from disk
//   dist/volume-view.css     the box of the element before its script has loaded
// It also writes the types, the decode worker, x3dom as a classic script, and the licences of the bundled packages.
import { spawnSync } from 'node:child_process';
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { join, posix } from 'node:path';
import { build } from 'vite';
import { buildPrepare } from '../packages/prepare/build.mjs';
import { adaptForBundlers, adaptModules, WORKER_MARK, withoutRareParts, X3DOM_MARK } from './adapt-modules.mjs';
import { AT_ONCE, atOnce } from './at-once.mjs';
import { writeClassic } from './classic/build-classic.mjs';
import { projectRoot } from './shared-data.mjs';
import { escapeToAscii } from './strip-sources.mjs';
import { writeTagData } from './write-tag-data.mjs';

/** The folder that pages are served from. */
const served = join(projectRoot, 'dist');
/**
 * The build is first written to this folder: a page of `dist` that is open during a build finds its files until all new files are there.
 */
const dist = join(projectRoot, `dist-next-${process.pid}`);
const main = join(projectRoot, 'src/index.ts');
/** Every element is a folder of components with a file that defines the element. */
const folders = readdirSync(join(projectRoot, 'components'));
folders.sort();
const companions = folders.filter(
  (name) =>
    !['internal', 'volume-view'].includes(name) && existsSync(join(projectRoot, 'components', name, 'define.ts')),
);
const definitions = ['volume-view', ...companions].map((name) => join(projectRoot, `components/${name}/define.ts`));
const worker = join(projectRoot, 'src/worker/decode-worker.ts');

// In the modules for bundlers, these files are in dist itself. Where a bundler leaves the expression unchanged, it then names a file next
// to the bundle, and not one some folders above.
const attachedParts = ['create-worker', 'x3dom-url', 'x3dom-beside-page'];
const withoutUrl = join(projectRoot, 'src/x3d/x3dom-beside-page.ts'); // For Parcel.

/** A chunk that defines an element is called after it. @param {{ facadeModuleId: string | null, name: string }} chunk */
function nameChunk({ facadeModuleId, name }) {
  const element = /components[\\/]([\w-]+)[\\/]define\.ts$/.exec(facadeModuleId ?? '')?.[1];
  return `chunks/${element ?? name}-[hash].js`;
}

/**
 * One run of vite's library mode.
 * @param {object} options
 * @param {string | string[]} options.entry
 * @param {'es' | 'iife' | 'cjs'} options.format
 * @param {import('vite').Rolldown.OutputOptions} [options.output]
 * @param {import('vite').BuildOptions} [options.extra]
 * @param {{ usual: string, all: string }} [options.workerTexts]
 * @param {import('vite').Plugin[]} [options.plugins]
 */
async function bundle({ entry, format, output, extra, workerTexts, plugins = [] }) {
  /** @type {import('vite').InlineConfig} */
  const config = {
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'warn',
    plugins: [...plugins, adaptModules({ workerTexts })],
    build: {
      outDir: dist,
      emptyOutDir: false,
      target: 'es2022',
      minify: true,
      sourcemap: false,
      lib: { entry, formats: [format], name: 'VolumeView' },
      // Vite does not remove white space in ES libraries; these files are for browsers, so they are minified fully.
      rolldownOptions: { preserveEntrySignatures: 'allow-extension', output: { minify: true, ...output } },
      ...extra,
    },
  };
  return build(config);
}

/**
 * A file with all its imports, as one text.
 * @param {string} entry
 * @param {'es' | 'iife'} format - iife is a classic script
 * @param {import('vite').Plugin[]} [plugins]
 */
async function buildText(entry, format, plugins) {
  const result = await bundle({ entry, format, plugins, extra: { write: false } });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return output[0].code;
}

/** @param {string} workerSource - the worker's text as one classic script */
async function buildUnbundled(workerSource) {
  // Bare imports stay, except for the compiler's own helper for decorators, which users of the package do not have.
  const isBare = (/** @type {string} */ id) =>
    !/^([./\0]|@oxc-project\/runtime)/.test(id) && !id.startsWith(projectRoot);
  await bundle({
    entry: [main, ...definitions, withoutUrl],
    format: 'es',
    plugins: [
      adaptForBundlers({
        worker: workerSource,
        x3dom: readX3dom(),
        cssColor: await buildText(join(projectRoot, 'src/optics/transfer/css-color.ts'), 'es'),
      }),
    ],
    extra: {
      minify: false,
      rolldownOptions: {
        external: isBare,
        output: {
          preserveModules: true,
          preserveModulesRoot: projectRoot,
          entryFileNames: ({ name }) =>
            attachedParts.includes(posix.basename(name)) ? `${posix.basename(name)}.js` : 'esm/[name].js',
        },
      },
    },
  });
}

/** @param {string} folder @param {RegExp} pattern @returns {string[]} absolute paths */
function listFiles(folder, pattern) {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile() && pattern.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name));
}

/** Replace the marks by the real addresses. */
function replaceMarks() {
  let workers = 0;
  for (const file of listFiles(dist, /\.js$/)) {
    const code = readFileSync(file, 'utf8');
    if (!code.includes(WORKER_MARK) && !code.includes(X3DOM_MARK)) continue;
    if (code.includes(WORKER_MARK)) workers += 1;
    if (join(file, '..') !== dist)
      throw new Error(`${file} starts a worker or x3dom; expected only files in dist itself to do so`);
    const done = code
      .replaceAll(WORKER_MARK, `new URL('./decode-worker.js', import.meta.url)`)
      .replaceAll(X3DOM_MARK, `new URL('./x3dom.js', import.meta.url)`);
    writeFileSync(file, done);
  }
  if (workers < 2)
    throw new Error(`the decode worker is started by ${workers} files in dist; expected 2 (esm and volume-view.js)`);
}

/** Run a program of a development dependency. @param {string} script - below node_modules @param {string[]} args */
function runTool(script, args) {
  const tool = join(projectRoot, 'node_modules', script);
  const { status } = spawnSync(process.execPath, [tool, ...args], {
    cwd: projectRoot,
    stdio: ['ignore', 'inherit', 'inherit'],
  });
  if (status !== 0) throw new Error(`${script} ${args.join(' ')} ended with ${status}`);
}

function buildManifest() {
  runTool('@custom-elements-manifest/analyzer/cem.js', [
    'analyze',
    '--config',
    'custom-elements-manifest.config.mjs',
    '--quiet',
  ]);
}

function buildTypes() {
  runTool('typescript/bin/tsc', ['-p', 'tsconfig.build.json', '--outDir', join(dist, 'types')]);
  // tsc keeps `./x.ts` in declarations; users without allowImportingTsExtensions need `./x.js`.
  for (const file of listFiles(join(dist, 'types'), /\.d\.ts$/)) {
    const text = readFileSync(file, 'utf8');
    writeFileSync(file, text.replace(/((?:from|import)\s*\(?\s*['"]\.{1,2}\/[^'"]*)\.ts(['"])/g, '$1.js$2'));
  }
}

/** Write the licence texts of all packages that are part of dist. */
function writeLicences() {
  /** @type {Map<string, string>} */
  const texts = new Map();
  /** @param {string} name */
  const visit = (name) => {
    if (texts.has(name)) return;
    const folder = join(projectRoot, 'node_modules', name);
    if (!existsSync(folder)) return; // optional, or nested under its only user
    const manifest = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find((one) => /^licen[cs]e(\.|$)/i.test(one));
    const text = file ? readFileSync(join(folder, file), 'utf8').trim() : `Licensed under: ${manifest.license}`;
    texts.set(name, `${name} ${manifest.version} (${manifest.license})\n\n${text}`);
    Object.keys(manifest.dependencies ?? {}).forEach(visit);
  };
  const manifest = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));
  [...Object.keys(manifest.dependencies), 'culori'].forEach(visit);
  const rule = `\n\n${'-'.repeat(78)}\n\n`;
  writeFileSync(join(dist, 'THIRD-PARTY-LICENSES.txt'), `${[...texts.values()].join(rule)}\n`);
}

function readX3dom() {
  const note =
    '/*! X3DOM, (C) 2009 Fraunhofer IGD, Darmstadt, Germany; dual licensed under MIT and GPL; unchanged below. */\n';
  const text = readFileSync(join(projectRoot, 'node_modules/x3dom/x3dom.js'), 'utf8');
  return note + escapeToAscii(text);
}

/** Copy the page for iframes, the page that makes pages for the disk, and the style sheet for pages whose script is late. */
function copyPages() {
  for (const name of [
    'embed.html',
    'embed.css',
    'embed.js',
    'from-disk.html',
    'from-disk.css',
    'from-disk.js',
    'volume-view.css',
  ])
    copyFileSync(join(projectRoot, 'scripts/zip', name), join(dist, name));
}

/** Put the new build in the place of the old one, with two renames: files are missing only for a moment between them. */
function replaceServed() {
  const old = `${dist}-old`;
  if (existsSync(served)) renameSync(served, old);
  renameSync(dist, served);
  rmSync(old, { recursive: true, force: true });
}

// If a build fails, it removes its own files, and the old build stays in its place.
process.on('exit', () => rmSync(dist, { recursive: true, force: true }));
rmSync(dist, { recursive: true, force: true });
mkdirSync(dist, { recursive: true });
const workerSource = await buildText(worker, 'iife');
await buildUnbundled(workerSource);
await bundle({
  entry: main,
  format: 'es',
  output: { entryFileNames: 'volume-view.js', chunkFileNames: nameChunk, ...AT_ONCE },
});
for (const name of companions) {
  const entry = join(projectRoot, `components/${name}/define.ts`);
  await bundle({ entry, format: 'es', output: { entryFileNames: `${name}.js`, chunkFileNames: nameChunk } });
}
// The modules that every reader of a grid needs are one file, too.
const gridSamples = {
  name: 'grid-samples',
  test: /src.(formats.base.(number-types|count-sample-bytes|list-left|piece-reader|place-volume|respace|store-samples)|volume.detail-offset)\.ts$/,
};
await bundle({
  entry: worker,
  format: 'es',
  output: {
    entryFileNames: 'decode-worker.js',
    chunkFileNames: 'chunks/worker-[name]-[hash].js',
    codeSplitting: { groups: [atOnce, gridSamples] },
  },
});
replaceMarks();
const classic = await bundle({
  entry: main,
  format: 'cjs',
  output: { entryFileNames: 'entry.js', chunkFileNames: '[name]-[hash].js', ...AT_ONCE },
  extra: { write: false },
  workerTexts: { usual: await buildText(worker, 'iife', [withoutRareParts]), all: workerSource },
});
writeClassic(
  /** @type {import('vite').Rolldown.RolldownOutput[]} */ (classic)[0].output.filter((one) => one.type === 'chunk'),
  dist,
);
buildTypes();
buildManifest();
writeTagData(dist);
writeFileSync(join(dist, 'x3dom.js'), readX3dom());
copyPages();
writeLicences();
replaceServed();
await buildPrepare();
console.log('dist/ is built');
