// The package, in three shapes from one source:
//   dist/esm/**              unbundled modules with bare imports, for bundlers and Node
//   dist/volume-view.js      one module (plus lazy chunks) for a page without a bundler
//   dist/volume-legend.js .. each companion alone, for such a page too; volume-view.js fetches what a page needs by itself
//   dist/volume-view.iife.js a classic script, for file:// pages and sandboxed frames, where modules are blocked, and beside it
//   dist/classic/**          what of it few pages need
//   dist/embed.html          a page with one volume, for frames
// and beside them the types, the decode worker, x3dom as a classic script, and the licences of what is bundled.
import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { build } from 'vite';
import { AT_ONCE, atOnce } from './at-once.mjs';
import { writeClassic } from './classic/build-classic.mjs';
import { projectRoot } from './shared-data.mjs';
import { escapeToAscii, stripCss, stripGlsl } from './strip-sources.mjs';
import { writeTagData } from './write-tag-data.mjs';

const dist = join(projectRoot, 'dist');
const main = join(projectRoot, 'src/index.ts');
const companions = ['volume-clip', 'volume-label', 'volume-label-list', 'volume-labels', 'volume-legend', 'volume-measure', 'volume-readout', 'volume-slice', 'volume-slice-view', 'volume-surface', 'volume-terrain', 'volume-timeline', 'volume-transfer-function'];
const definitions = ['volume-view', ...companions].map((name) => join(projectRoot, `components/define/${name}.ts`));
const radarTool = join(projectRoot, 'src/formats/radar/radar-mosaic-tool.ts'); // scripts/write-polar-mosaic.mjs loads it.
const worker = join(projectRoot, 'src/formats/decode-worker.ts');

// The source names the worker and x3dom as the development servers find them. In dist they lie elsewhere, and must
// still read `new URL('…', import.meta.url)` to the letter, because consumers' bundlers look for just that text.
// Vite would resolve (and inline) such an expression itself, so it sees a mark, which is replaced in what it wrote.
const WORKER_EXPRESSION = `new URL('./decode-worker.ts', import.meta.url)`;
const WORKER_MARK = '__VOLUME_VIEW_DECODE_WORKER__';
const X3DOM_EXPRESSION = `new URL('../../node_modules/x3dom/x3dom.js', import.meta.url)`;
const X3DOM_MARK = '__VOLUME_VIEW_X3DOM_URL__';
// Of the modules for bundlers these lie in dist itself. A bundler that leaves the expression as it is makes it mean a file
// beside the bundle, and not some folders above.
const besideParts = ['create-worker', 'x3dom-url', 'x3dom-beside-page'];
const withoutUrl = join(projectRoot, 'src/x3d/x3dom-beside-page.ts'); // Parcel's.
const SCRIPT_URL_MODULE = 'virtual:script-url';

// An image or a form that is called "currentScript" is document.currentScript, whatever its src: so the property itself is
// asked. It is known only while the script runs.
const SCRIPT_URL_CODE = `
const script = Reflect.get(Document.prototype, 'currentScript', document);
export const scriptUrl = (script instanceof HTMLScriptElement && script.src) || Reflect.get(Node.prototype, 'baseURI', document);`;

/**
 * What differs in the modules for bundlers: x3dom and the worker are texts too, which are loaded where a bundler has left their files
 * behind, and culori is inside, since not every bundler finds what it exports.
 * @param {{ worker: string, x3dom: string, cssColor: string }} texts
 * @returns {import('vite').Plugin}
 */
function adaptForBundlers({ worker, x3dom, cssColor }) {
  const at = (/** @type {string} */ name) => join(projectRoot, 'src', name);
  /** @type {Record<string, string>} */
  const modules = {
    [at('formats/worker-as-text.ts')]: `export const text = ${JSON.stringify(worker)};`,
    [at('x3d/x3dom-as-text.ts')]: `
import { injectText } from './inject-text.ts';
const text = ${JSON.stringify(x3dom)};
export const injectOwnText = (url, inject) => injectText(text, url, inject);`,
    [at('formats/worker-source.ts')]: `
export const listWorkerTexts = () => [async () => (await import('./worker-as-text.ts')).text];
export const isTextSurer = (url) => !url || url.endsWith('/decode-worker.js');`,
    [at('x3d/x3dom-source.ts')]: `export const injectOwnText = async (url, inject) => (await import('./x3dom-as-text.ts')).injectOwnText(url, inject);`,
    [at('optics/css-color.ts')]: cssColor,
  };
  return {
    name: 'volume-view-adapt-for-bundlers',
    enforce: 'pre',
    resolveId: (id, importer) => Object.keys(modules).find((path) => importer && path === join(importer, '..', id)) ?? null,
    load: (id) => modules[id] ?? null,
  };
}

/** Of the classic script: a worker with the readers that most pages need, and one with all. */
const WORKER_TEXTS = { usual: 'virtual:usual-worker', all: 'virtual:whole-worker' };

// Which of them comes first the file's name tells; what the first can not read it leaves to the next.
const CLASSIC_WORKER_SOURCE = `
const usual = async () => (await import('${WORKER_TEXTS.usual}')).text;
const all = async () => (await import('${WORKER_TEXTS.all}')).text;
export const listWorkerTexts = (url) => (/^(data|blob):|\\.(nii|img|hdr)(\\.gz)?([?#]|$)/i.test(url) ? [usual, all] : [all]);
export const isTextSurer = () => false;`;

/**
 * The few modules that differ between source and dist.
 * @param {{ workerTexts?: { usual: string, all: string } }} options - workerTexts: for the classic script
 * @returns {import('vite').Plugin}
 */
function adaptModules({ workerTexts }) {
  const isClassic = workerTexts !== undefined;
  /** @type {(code: string, expression: string, mark: string, name: string) => string | null} */
  const replaceUrl = (code, expression, mark, name) => {
    if (!code.includes(expression)) throw new Error(`expected exactly: ${expression}`);
    if (!isClassic) return code.replace(expression, mark);
    return `import { scriptUrl } from '${SCRIPT_URL_MODULE}';\n${code.replace(expression, `new URL('${name}', scriptUrl)`)}`;
  };
  return {
    name: 'volume-view-adapt-modules',
    enforce: 'pre',
    resolveId: (id) => ([SCRIPT_URL_MODULE, ...Object.values(WORKER_TEXTS)].includes(id) ? `\0${id}` : null),
    load(id) {
      if (id.endsWith('.glsl?raw')) {
        return `export default ${JSON.stringify(stripGlsl(readFileSync(id.replace('?raw', ''), 'utf8')))};`;
      }
      if (id === `\0${SCRIPT_URL_MODULE}`) return SCRIPT_URL_CODE;
      if (isClassic && id.endsWith('/src/formats/worker-source.ts')) return CLASSIC_WORKER_SOURCE;
      if (isClassic && id === `\0${WORKER_TEXTS.usual}`) return `export const text = ${JSON.stringify(workerTexts.usual)};`;
      if (isClassic && id === `\0${WORKER_TEXTS.all}`) return `export const text = ${JSON.stringify(workerTexts.all)};`;
      return null;
    },
    generateBundle(_, files) {
      for (const file of Object.values(files)) if (file.type === 'chunk') file.code = escapeToAscii(file.code);
    },
    transform(code, id) {
      // Twins are named for tests. What computes them on the CPU is a part of its own, for those who point at something.
      if (/\/src\/(renderer\/ray\/modules|radar\/gpu)\//.test(id)) return { code: code.replace(/^export \{ ?\w+ as twin ?\} from .*$/gm, ''), map: null };
      if (id.endsWith('-styles.ts')) return { code: stripCss(code), map: null };
      // It runs before any lazy part does.
      if (id === main && isClassic) return { code: `export { scriptUrl } from '${SCRIPT_URL_MODULE}';\nexport { injectScript } from './inject-script.ts';\n${code}`, map: null };
      if (id.endsWith('/src/formats/create-worker.ts')) return replaceUrl(code, WORKER_EXPRESSION, WORKER_MARK, 'decode-worker.js');
      if (id.endsWith('/src/x3d/x3dom-url.ts')) return replaceUrl(code, X3DOM_EXPRESSION, X3DOM_MARK, 'x3dom.js');
      return null;
    },
  };
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
      // Vite leaves the white space of ES libraries alone; these files are for browsers, so they are minified whole.
      rolldownOptions: { preserveEntrySignatures: 'allow-extension', output: { minify: true, ...output } },
      ...extra,
    },
  };
  return build(config);
}

/**
 * A file with all that it imports, as one text.
 * @param {string} entry
 * @param {'es' | 'iife'} format - iife is a classic script
 * @param {import('vite').Plugin[]} [plugins]
 */
async function buildText(entry, format, plugins) {
  const result = await bundle({ entry, format, plugins, extra: { write: false } });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return output[0].code;
}

/** What a worker for usual NIfTI files loads when it is needed. */
const USUAL_PARTS = /\/(nifti|nifti-rare-headers|unusual-look|check-geometry|explain-failure|foreign-formats|fetch-again)\.ts$/;

/**
 * A worker for usual NIfTI files: all that other formats need is left out, and asked for in vain.
 * @type {import('vite').Plugin}
 */
const withoutRareParts = {
  name: 'volume-view-without-rare-parts',
  enforce: 'pre',
  resolveDynamicImport: (id) => (typeof id === 'string' && !USUAL_PARTS.test(id) ? '\0left-out' : null),
  load: (id) => (id === '\0left-out' ? 'throw new Error("left out of this worker");' : null),
};

/** @param {string} workerSource - the worker's text as one classic script */
async function buildUnbundled(workerSource) {
  // Bare imports stay, but for the compiler's own helper of decorators, which no consumer has.
  const isBare = (/** @type {string} */ id) => !/^([./\0]|@oxc-project\/runtime)/.test(id) && !id.startsWith(projectRoot);
  await bundle({
    entry: [main, ...definitions, radarTool, withoutUrl],
    format: 'es',
    plugins: [adaptForBundlers({ worker: workerSource, x3dom: readX3dom(), cssColor: await buildText(join(projectRoot, 'src/optics/css-color.ts'), 'es') })],
    extra: {
      minify: false,
      rolldownOptions: {
        external: isBare,
        output: {
          preserveModules: true,
          preserveModulesRoot: projectRoot,
          entryFileNames: ({ name }) => (besideParts.includes(posix.basename(name)) ? `${posix.basename(name)}.js` : 'esm/[name].js'),
        },
      },
    },
  });
}

/** @param {string} folder @param {RegExp} pattern @returns {string[]} absolute paths */
function listFiles(folder, pattern) {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true });
  return entries.filter((entry) => entry.isFile() && pattern.test(entry.name)).map((entry) => join(entry.parentPath, entry.name));
}

/** Put the real addresses where the marks are. */
function replaceMarks() {
  let workers = 0;
  for (const file of listFiles(dist, /\.js$/)) {
    const code = readFileSync(file, 'utf8');
    if (!code.includes(WORKER_MARK) && !code.includes(X3DOM_MARK)) continue;
    if (code.includes(WORKER_MARK)) workers += 1;
    if (join(file, '..') !== dist) throw new Error(`${file} starts a worker or x3dom; expected only files in dist itself to do so`);
    const done = code
      .replaceAll(WORKER_MARK, `new URL('./decode-worker.js', import.meta.url)`)
      .replaceAll(X3DOM_MARK, `new URL('./x3dom.js', import.meta.url)`);
    writeFileSync(file, done);
  }
  if (workers < 2) throw new Error(`the decode worker is started by ${workers} files in dist; expected 2 (esm and volume-view.js)`);
}

/** Run a program of a development dependency. @param {string} script - below node_modules @param {string[]} args */
function runTool(script, args) {
  const tool = join(projectRoot, 'node_modules', script);
  const { status } = spawnSync(process.execPath, [tool, ...args], { cwd: projectRoot, stdio: ['ignore', 'inherit', 'inherit'] });
  if (status !== 0) throw new Error(`${script} ${args.join(' ')} ended with ${status}`);
}

function buildManifest() {
  runTool('@custom-elements-manifest/analyzer/cem.js', ['analyze', '--config', 'custom-elements-manifest.config.mjs', '--quiet']);
}

function buildTypes() {
  runTool('typescript/bin/tsc', ['-p', 'tsconfig.build.json']);
  // tsc keeps `./x.ts` in declarations; consumers without allowImportingTsExtensions need `./x.js`.
  for (const file of listFiles(join(dist, 'types'), /\.d\.ts$/)) {
    const text = readFileSync(file, 'utf8');
    writeFileSync(file, text.replace(/((?:from|import)\s*\(?\s*['"]\.{1,2}\/[^'"]*)\.ts(['"])/g, '$1.js$2'));
  }
}

/** Every package that reaches dist, with its licence text. */
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
  const note = '/*! X3DOM, (C) 2009 Fraunhofer IGD, Darmstadt, Germany; dual licensed under MIT and GPL; unchanged below. */\n';
  const text = readFileSync(join(projectRoot, 'node_modules/x3dom/x3dom.js'), 'utf8');
  return note + escapeToAscii(text);
}

/** The page for frames. */
function copyEmbed() {
  for (const name of ['embed.html', 'embed.css', 'embed.js']) copyFileSync(join(projectRoot, 'scripts/zip', name), join(dist, name));
}

rmSync(dist, { recursive: true, force: true });
mkdirSync(dist, { recursive: true });
const workerSource = await buildText(worker, 'iife');
await buildUnbundled(workerSource);
await bundle({
  entry: main,
  format: 'es',
  output: { entryFileNames: 'volume-view.js', chunkFileNames: 'chunks/[name]-[hash].js', ...AT_ONCE },
});
for (const name of companions) {
  const entry = join(projectRoot, `components/define/${name}.ts`);
  await bundle({ entry, format: 'es', output: { entryFileNames: `${name}.js`, chunkFileNames: 'chunks/[name]-[hash].js' } });
}
// What every reader of a grid needs is one file, too.
const gridSamples = { name: 'grid-samples', test: /src.(formats.(number-types|count-sample-bytes|piece-reader|place-volume|respace|store-samples)|volume.detail-offset)\.ts$/ };
await bundle({
  entry: worker,
  format: 'es',
  output: { entryFileNames: 'decode-worker.js', chunkFileNames: 'chunks/worker-[name]-[hash].js', codeSplitting: { groups: [atOnce, gridSamples] } },
});
replaceMarks();
const classic = await bundle({
  entry: main,
  format: 'cjs',
  output: { entryFileNames: 'entry.js', chunkFileNames: '[hash].js', ...AT_ONCE },
  extra: { write: false },
  workerTexts: { usual: await buildText(worker, 'iife', [withoutRareParts]), all: workerSource },
});
writeClassic(/** @type {import('vite').Rolldown.RolldownOutput[]} */ (classic)[0].output.filter((one) => one.type === 'chunk'), dist);
buildTypes();
buildManifest();
writeTagData();
writeFileSync(join(dist, 'x3dom.js'), readX3dom());
copyEmbed();
writeLicences();
console.log('dist/ is built');
