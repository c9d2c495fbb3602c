// Plugins of the bundler for the few differences between the modules of the source and those of the package's builds.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';
import { escapeToAscii, stripCss, stripGlsl } from './strip-sources.mjs';

const main = join(projectRoot, 'src/index.ts');

// The source names the files of the worker and of x3dom at the addresses of the development servers. In dist they are in other folders, but
// the text `new URL('…', import.meta.url)` must stay exactly like this, as the bundlers of the package's users look for it. Vite would
// resolve (and inline) such an expression itself. So vite gets a mark, and we replace the mark in its output.
const WORKER_EXPRESSION = `new URL('./decode-worker.ts', import.meta.url)`;
export const WORKER_MARK = '__VOLUME_VIEW_DECODE_WORKER__';
const X3DOM_EXPRESSION = `new URL('../../node_modules/x3dom/x3dom.js', import.meta.url)`;
export const X3DOM_MARK = '__VOLUME_VIEW_X3DOM_URL__';
const SCRIPT_URL_MODULE = 'virtual:script-url';

// An image or a form with the name "currentScript" hides document.currentScript, whatever its src. So we read the property of the
// prototype. It has a value only while the script runs.
const SCRIPT_URL_CODE = `
const script = Reflect.get(Document.prototype, 'currentScript', document);
export const scriptUrl = (script instanceof HTMLScriptElement && script.src) || Reflect.get(Node.prototype, 'baseURI', document);`;

/**
 * The differences in the modules for bundlers: x3dom and the worker are included as texts too, which are loaded where a bundler has not
 * copied their files, and culori is included, since not every bundler finds its exports.
 * @param {{ worker: string, x3dom: string, cssColor: string }} texts
 * @returns {import('vite').Plugin}
 */
export function adaptForBundlers({ worker, x3dom, cssColor }) {
  const at = (/** @type {string} */ name) => join(projectRoot, 'src', name);
  /** @type {Record<string, string>} */
  const modules = {
    [at('worker/worker-as-text.ts')]: `export const text = ${JSON.stringify(worker)};`,
    [at('x3d/x3dom-as-text.ts')]: `
import { injectText } from './inject-text.ts';
const text = ${JSON.stringify(x3dom)};
export const injectOwnText = (url, inject) => injectText(text, url, inject);`,
    [at('worker/worker-source.ts')]: `
export const listWorkerTexts = () => [async () => (await import('./worker-as-text.ts')).text];
export const isTextSurer = (url) => !url || url.endsWith('/decode-worker.js');`,
    [at('x3d/x3dom-source.ts')]:
      `export const injectOwnText = async (url, inject) => (await import('./x3dom-as-text.ts')).injectOwnText(url, inject);`,
    [at('optics/transfer/css-color.ts')]: cssColor,
  };
  return {
    name: 'volume-view-adapt-for-bundlers',
    enforce: 'pre',
    resolveId: (id, importer) =>
      Object.keys(modules).find((path) => importer && path === join(importer, '..', id)) ?? null,
    load: (id) => modules[id] ?? null,
  };
}

/** For the classic script: a worker with the readers that pages usually need, and one with all readers. */
const WORKER_TEXTS = { usual: 'virtual:usual-worker', all: 'virtual:whole-worker' };

// The name of the file decides which of them is used first; a file that the first one can't read goes to the other one.
const CLASSIC_WORKER_SOURCE = `
const usual = async () => (await import('${WORKER_TEXTS.usual}')).text;
const all = async () => (await import('${WORKER_TEXTS.all}')).text;
export const listWorkerTexts = (url) => (/^(data|blob):|\\.(nii|img|hdr)(\\.gz)?([?#]|$)/i.test(url) ? [usual, all] : [all]);
export const isTextSurer = () => false;`;

/**
 * The few modules that differ between the source and dist.
 * @param {{ workerTexts?: { usual: string, all: string } }} options - workerTexts: for the classic script
 * @returns {import('vite').Plugin}
 */
export function adaptModules({ workerTexts }) {
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
      if (isClassic && id.endsWith('/src/worker/worker-source.ts')) return CLASSIC_WORKER_SOURCE;
      if (isClassic && id === `\0${WORKER_TEXTS.usual}`)
        return `export const text = ${JSON.stringify(workerTexts.usual)};`;
      if (isClassic && id === `\0${WORKER_TEXTS.all}`) return `export const text = ${JSON.stringify(workerTexts.all)};`;
      return null;
    },
    generateBundle(_, files) {
      for (const file of Object.values(files)) if (file.type === 'chunk') file.code = escapeToAscii(file.code);
    },
    transform(code, id) {
      if (id.endsWith('-styles.ts')) return { code: stripCss(code), map: null };
      // It runs before any part that is loaded later.
      if (id === main && isClassic)
        return {
          code: `export { scriptUrl } from '${SCRIPT_URL_MODULE}';\nexport { injectScript } from './page/inject-script.ts';\n${code}`,
          map: null,
        };
      if (id.endsWith('/src/worker/create-worker.ts'))
        return replaceUrl(code, WORKER_EXPRESSION, WORKER_MARK, 'decode-worker.js');
      if (id.endsWith('/src/x3d/x3dom-url.ts')) return replaceUrl(code, X3DOM_EXPRESSION, X3DOM_MARK, 'x3dom.js');
      return null;
    },
  };
}

/** The modules that a worker for usual NIfTI files loads on demand. */
const USUAL_PARTS =
  /\/(nifti|nifti-rare-headers|unusual-appearance|check-geometry|explain-failure|foreign-formats|fetch-again|reduce)\.ts$/;

/**
 * A worker for usual NIfTI files: it leaves out the modules of all other formats, and importing them fails.
 * @type {import('vite').Plugin}
 */
export const withoutRareParts = {
  name: 'volume-view-without-rare-parts',
  enforce: 'pre',
  resolveDynamicImport: (id) => (typeof id === 'string' && !USUAL_PARTS.test(id) ? '\0left-out' : null),
  load: (id) => (id === '\0left-out' ? 'throw new Error("left out of this worker");' : null),
};
