// Builds the package, in three forms from one source:
//   dist/esm/**              unbundled modules with bare imports, for bundlers and Node
//   dist/volume-view.js      one module (plus lazy chunks) for a page without a bundler
//   dist/volume-legend.js .. each companion alone, for such a page too; volume-view.js itself fetches those that a page needs
//   dist/volume-view.iife.js a classic script, for file:// pages and sandboxed iframes, where modules are blocked
//   dist/classic/**          the parts of the classic script that few pages need
//   dist/embed.html          a page with one volume or a lesson, for iframes; embed-parent.js is for the page around them
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
import { join } from 'node:path';
import { build, defaultClientConditions, normalizePath } from 'vite';
import { AT_ONCE, atOnce } from './at-once.mjs';
import { buildPrepare } from './build-prepare.mjs';
import { exportText, leaveOutNode, makeCodecModules, provideBuilt, stripTexts } from './build-plugins.mjs';
import { buildStudio } from './build-studio.mjs';
import { writeClassic } from './classic/build-classic.mjs';
import { projectRoot } from './shared-data.mjs';
import { licencesOfPackages } from './licence-texts.mjs';
import { listImports } from './list-imports.mjs';
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
/** A file of the project, as the bundler names it. @param {string} path */
const pathOf = (path) => normalizePath(join(projectRoot, path));
const pathOfDefinition = (/** @type {string} */ name) => pathOf(`components/${name}/define.ts`);
const definitions = ['volume-view', ...companions].map(pathOfDefinition);
const worker = join(projectRoot, 'src/worker/decode-worker.ts');

/**
 * In the modules for bundlers, these files are in dist itself: they name a file next to them. Where a bundler leaves the expression
 * unchanged, it then names a file next to the bundle, and not one some folders above.
 */
const besideBundle = {
  'create-worker': pathOf('src/worker/create-worker-dist.ts'),
  'x3dom-url': pathOf('src/x3d/x3dom-url-dist.ts'),
  'x3dom-beside-page': pathOf('src/x3d/x3dom-beside-page.ts'), // For Parcel.
};

/** The packages that stay imports in the modules for bundlers. */
const packages = Object.keys(JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8')).dependencies);

/**
 * Conditions of the field `imports` in package.json. `dist`: the files of dist that are modules. `for-bundlers`: of them, those that the
 * package's users bundle. `classic`: the classic script. `usual-files`: the worker without rare parts. `without-codecs`: the worker without
 * large libraries. `as-text`: any worker that is a text.
 * @typedef {'dist' | 'for-bundlers' | 'classic' | 'usual-files' | 'without-codecs' | 'as-text'} Condition
 */

/** A chunk that defines an element is called after it. @param {{ facadeModuleId: string | null, name: string }} chunk */
function nameChunk({ facadeModuleId, name }) {
  const element = ['volume-view', ...companions].find((one) => pathOfDefinition(one) === facadeModuleId);
  return `chunks/${element ?? name}-[hash].js`;
}

/**
 * One run of vite's library mode.
 * @param {object} options
 * @param {string | string[] | Record<string, string>} options.entry
 * @param {'es' | 'iife' | 'cjs'} options.format
 * @param {import('vite').Rolldown.OutputOptions} [options.output]
 * @param {import('vite').BuildOptions} [options.extra]
 * @param {Condition[]} [options.conditions]
 * @param {Record<string, string>} [options.built] - modules that the build made before, by name
 */
async function bundle({ entry, format, output, extra, conditions = ['dist'], built = {} }) {
  /** @type {import('vite').InlineConfig} */
  const config = {
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'warn',
    resolve: { conditions: [...conditions, ...defaultClientConditions] },
    // Vite would replace an expression with the real name by an address of the source.
    define: { OWN_URL: 'import.meta.url' },
    plugins: [provideBuilt(built), stripTexts, makeCodecModules, leaveOutNode],
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
 * @param {Condition[]} [conditions]
 */
async function buildText(entry, format, conditions) {
  const result = await bundle({ entry, format, conditions, extra: { write: false } });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return output[0].code;
}

/** @param {Record<string, string>} workers - modules with a worker as one classic script: with all readers, and with their large libraries too */
async function buildUnbundled(workers) {
  await bundle({
    entry: [main, ...definitions, besideBundle['x3dom-beside-page']],
    format: 'es',
    conditions: ['dist', 'for-bundlers'],
    built: {
      ...workers,
      'built:x3dom': exportText(readX3dom()),
      'built:openjpeg-wasm': await buildText(join(projectRoot, 'src/formats/codecs/openjpeg-wasm.ts'), 'es'),
      'built:charls-wasm': await buildText(join(projectRoot, 'src/formats/codecs/charls-wasm.ts'), 'es'),
      'built:culori': await buildText(join(projectRoot, 'src/optics/transfer/culori.ts'), 'es'),
      'built:mediabunny': await buildText(join(projectRoot, 'src/formats/video/mediabunny.ts'), 'es'),
    },
    extra: {
      minify: false,
      rolldownOptions: {
        external: (id) => packages.some((name) => id === name || id.startsWith(`${name}/`)),
        output: {
          preserveModules: true,
          preserveModulesRoot: projectRoot,
          entryFileNames: ({ facadeModuleId }) =>
            `${Object.entries(besideBundle).find(([, path]) => path === facadeModuleId)?.[0] ?? 'esm/[name]'}.js`,
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
    const ends = listImports(file, text)
      .filter(({ value }) => value.startsWith('.') && value.endsWith('.ts'))
      .map(({ end }) => end - '.ts"'.length);
    ends.sort((a, b) => a - b);
    const between = [0, ...ends.map((end) => end + '.ts'.length)].map((start, i) => text.slice(start, ends[i]));
    writeFileSync(file, between.join('.js'));
  }
}

/** Write the licence texts of all packages that are part of dist. */
function writeLicences() {
  const { dependencies } = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));
  const codecs = ['@cornerstonejs/codec-openjpeg', '@cornerstonejs/codec-charls'];
  const text = licencesOfPackages([...Object.keys(dependencies), 'culori', 'mediabunny', ...codecs]);
  writeFileSync(join(dist, 'THIRD-PARTY-LICENSES.txt'), text);
}

function readX3dom() {
  const note =
    '/*! X3DOM, (C) 2009 Fraunhofer IGD, Darmstadt, Germany; dual licensed under MIT and GPL; unchanged below. */\n';
  const text = readFileSync(join(projectRoot, 'node_modules/x3dom/x3dom.js'), 'utf8');
  return note + escapeToAscii(text);
}

/** Copy the page that makes pages for the disk, and the style sheet for pages whose script is late. */
function copyPages() {
  for (const name of ['from-disk.html', 'from-disk.css', 'from-disk.js', 'volume-view.css'])
    copyFileSync(join(projectRoot, 'scripts/zip', name), join(dist, name));
}

/** The page for iframes, the script for the pages around them, and that of the library for H5P. */
async function buildEmbed() {
  const folder = join(projectRoot, 'packages/embed');
  for (const [entry, name] of [
    ['main.ts', 'embed.js'],
    ['parent.ts', 'embed-parent.js'],
    ['h5p.ts', 'h5p.js'],
  ])
    writeFileSync(join(dist, name), escapeToAscii(await buildText(join(folder, 'src', entry), 'iife')));
  for (const name of ['embed.html', 'embed.css']) copyFileSync(join(folder, name), join(dist, name));
  copyFileSync(join(projectRoot, 'packages/lesson-writers/src/lesson.css'), join(dist, 'embed-lesson.css'));
}

/** Put the new build in the place of the old one, with two renames: files are missing only for a moment between them. */
function replaceServed() {
  const old = `${dist}-old`;
  if (existsSync(served)) renameSync(served, old);
  renameSync(dist, served);
  rmSync(old, { recursive: true, force: true });
}

console.log('dist/ is being built: about a minute');
// If a build fails, it removes its own files, and the old build stays in its place.
process.on('exit', () => rmSync(dist, { recursive: true, force: true }));
rmSync(dist, { recursive: true, force: true });
mkdirSync(dist, { recursive: true });
/** The worker without rare readers, with all, and with large libraries too. */
const workerTexts = {
  'built:usual-worker': await buildText(worker, 'iife', ['as-text', 'without-codecs', 'usual-files']),
  'built:worker': await buildText(worker, 'iife', ['as-text', 'without-codecs']),
  'built:whole-worker': await buildText(worker, 'iife', ['as-text']),
};
const workers = Object.fromEntries(Object.entries(workerTexts).map(([name, text]) => [name, exportText(text)]));
await buildUnbundled(workers);
await bundle({
  entry: main,
  format: 'es',
  output: { entryFileNames: 'volume-view.js', chunkFileNames: nameChunk, ...AT_ONCE },
});
for (const name of companions) {
  await bundle({
    entry: pathOfDefinition(name),
    format: 'es',
    output: { entryFileNames: `${name}.js`, chunkFileNames: nameChunk },
  });
}
// Most readers of grids need these modules and what they import: they are one file, too.
const ofGrids = ['count-sample-bytes', 'list-left', 'piece-reader', 'place-volume', 'store-samples'].map((name) =>
  pathOf(`src/formats/base/${name}.ts`),
);
const gridSamples = { name: 'grid-samples', test: (/** @type {string} */ id) => ofGrids.includes(id) };
await bundle({
  entry: worker,
  format: 'es',
  output: {
    entryFileNames: 'decode-worker.js',
    chunkFileNames: 'chunks/worker-[name]-[hash].js',
    codeSplitting: { groups: [atOnce, gridSamples] },
  },
});
await writeClassic(dist, workerTexts, async (output) => {
  const result = await bundle({
    entry: join(projectRoot, 'src/classic.ts'),
    format: 'cjs',
    conditions: ['classic'],
    built: workers,
    output: { ...output, ...AT_ONCE },
    extra: { write: false },
  });
  const [{ output: files }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return files.filter((one) => one.type === 'chunk');
});
buildTypes();
buildManifest();
writeTagData(dist);
writeFileSync(join(dist, 'x3dom.js'), readX3dom());
copyPages();
await buildEmbed();
writeLicences();
replaceServed();
await buildPrepare();
await buildStudio();
console.log('dist/ is built');
