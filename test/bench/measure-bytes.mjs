import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { AT_ONCE } from '../../scripts/at-once.mjs';
import { listImports } from '../../scripts/list-imports.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';

/**
 * Gzipped bytes of our own code that a page with a NIfTI file runs: with the first element, and in the worker.
 * @param {{ what: string, gzipped: number }[]} rows - of measureBytes
 */
export function sumOwnBytes(rows) {
  const gzipped = (/** @type {string} */ begin) => rows.find(({ what }) => what.startsWith(begin))?.gzipped ?? NaN;
  return gzipped('own code, with') + gzipped('decode worker, for NIfTI');
}

/**
 * Bytes of JavaScript that a cartesian page loads, by whose they are: our own modules with every import of a package
 * left out, each package as it is bundled alone, and x3dom's file.
 */
export async function measureBytes() {
  const own = await bundle(
    join(projectRoot, 'dist/esm/src/index.js'),
    (id) => !/^[./]/.test(id) && !id.startsWith(projectRoot),
  );
  const first = findEager(own);
  const eager = own.filter((chunk) => first.has(chunk.fileName)).map((chunk) => chunk.code);
  const lazy = own.filter((chunk) => !first.has(chunk.fileName)).map((chunk) => chunk.code);
  const read = (/** @type {string} */ name) => readFileSync(join(projectRoot, name), 'utf8');
  return [
    row('own code, with the first element', eager),
    row('own code, loaded when used', lazy),
    row(
      'decode worker, for NIfTI',
      readWorker((name) => /^worker-nifti-.{8}\.js$/.test(name)),
    ),
    row(
      'decode worker, for mosaics too (with fflate)',
      readWorker((name) => !/-(read-radar|read-nrrd|read-metaimage)-/.test(name)),
    ),
    row(
      'decode worker, for radar too (with fflate)',
      readWorker(() => true),
    ),
    row('fflate (in the worker)', [await bundlePackage("export { Unzlib } from 'fflate';")]),
    row('lit', [
      await bundlePackage(
        "export { html, LitElement, nothing, css } from 'lit'; export { customElement, property, query, state } from 'lit/decorators.js';",
      ),
    ]),
    row('culori (CSS colours)', [
      await bundlePackage(
        "export { converter, modeHsl, modeHwb, modeLab, modeLch, modeLrgb, modeOklab, modeOklch, modeA98, modeP3, modeProphoto, modeRec2020, modeRgb, modeXyz50, modeXyz65, parse, useMode } from 'culori/fn';",
      ),
    ]),
    row('x3dom', [read('dist/x3dom.js')]),
    ...measureClassic(),
  ];
}

/** The classic script, and beside it the worker that reads NIfTI. All but x3dom. */
export function measureClassic() {
  const folder = join(projectRoot, 'dist/classic');
  const parts = readdirSync(folder).map((name) => readFileSync(join(folder, name), 'utf8'));
  // It alone knows that something was left out of it.
  const workers = parts.filter((text) => text.includes('left out of this worker'));
  if (workers.length !== 1) throw new Error(`expected one classic worker without rare parts; found ${workers.length}`);
  return [
    row('classic script, at once', [readFileSync(join(projectRoot, 'dist/volume-view.iife.js'), 'utf8')]),
    row('classic script: the worker, for NIfTI', workers),
    row('classic script, all parts', parts),
  ];
}

/**
 * The entry and all chunks that it imports at once, directly or not: what it shares with lazy modules is in chunks of its own.
 * @param {readonly import('vite').Rolldown.OutputChunk[]} chunks
 */
function findEager(chunks) {
  const names = new Set(chunks.filter((chunk) => chunk.isEntry).map((chunk) => chunk.fileName));
  for (const name of names) {
    for (const imported of chunks.find((chunk) => chunk.fileName === name)?.imports ?? []) names.add(imported);
  }
  return names;
}

/**
 * The worker's files: its entry, what that imports, and of what it loads when it is needed what is asked for.
 * @param {(name: string) => boolean} isUsed - whether a file counts that is loaded when it is needed
 */
function readWorker(isUsed) {
  const folder = join(projectRoot, 'dist/chunks');
  const names = new Set(['../decode-worker.js']);
  for (const name of names) {
    for (const { value, isLazy } of listImports(name, readFileSync(join(folder, name), 'utf8'))) {
      const chunk = basename(value);
      if (chunk !== 'decode-worker.js' && (!isLazy || isUsed(chunk))) names.add(chunk);
    }
  }
  return [...names].map((name) => readFileSync(join(folder, name), 'utf8'));
}

/** @param {string} what @param {readonly string[]} codes */
function row(what, codes) {
  const bytes = codes.reduce((sum, code) => sum + Buffer.byteLength(code), 0);
  const gzipped = codes.reduce((sum, code) => sum + gzipSync(code, { level: 9 }).length, 0);
  return { what, bytes, gzipped };
}

/** @param {string} exports */
async function bundlePackage(exports) {
  const [chunk] = await bundle('virtual:entry', () => false, exports);
  return chunk.code;
}

/**
 * @param {string} entry
 * @param {(id: string) => boolean} external
 * @param {string} [source] - of a virtual entry
 */
async function bundle(entry, external, source) {
  const result = await build({
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'error',
    plugins: [
      {
        name: 'entry-and-addresses',
        enforce: 'pre',
        resolveId: (id) => (source !== undefined && id.endsWith(entry) ? join(projectRoot, 'virtual-entry.js') : null),
        load: (id) => (id.endsWith('/virtual-entry.js') ? source : null),
        // Vite would write x3dom and the worker into the module as data: URLs.
        transform: (code) =>
          code.replaceAll(', import.meta.url)', ', location.href)').replaceAll(',import.meta.url)', ',location.href)'),
      },
    ],
    build: {
      write: false,
      target: 'es2022',
      lib: { entry, formats: ['es'] },
      rolldownOptions: { preserveEntrySignatures: 'allow-extension', external, output: { minify: true, ...AT_ONCE } },
    },
  });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return output.filter((part) => part.type === 'chunk');
}
