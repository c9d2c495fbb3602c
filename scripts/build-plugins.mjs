// Plugins of the bundler. What differs between the source and the builds is in files of src, which the field `imports` of package.json
// names for each condition (`#worker-texts` and others).
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';
import { shortenGlsl } from './shorten-glsl.mjs';
import { escapeToAscii, stripCss, stripGlsl } from './strip-sources.mjs';

/** Shaders and style sheets without what only their readers need, and scripts in ASCII. */
export const stripTexts = /** @type {import('vite').Plugin} */ ({
  name: 'volume-view-strip-texts',
  enforce: 'pre',
  load: (id) =>
    id.endsWith('.glsl?raw')
      ? `export default ${JSON.stringify(shortenGlsl(stripGlsl(readFileSync(id.replace('?raw', ''), 'utf8'))))};`
      : null,
  transform: (code, id) => (id.endsWith('-styles.ts') ? { code: stripCss(code), map: null } : null),
  generateBundle(_, files) {
    for (const file of Object.values(files)) if (file.type === 'chunk') file.code = escapeToAscii(file.code);
  },
});

/** A module that exports a text. @param {string} text */
export const exportText = (text) => `export const text = ${JSON.stringify(text)};`;

/**
 * Modules that the build makes: types/built.d.ts.
 * @param {Record<string, string>} modules - their code, by the names that are imported, like `built:worker`
 * @returns {import('vite').Plugin}
 */
export function provideBuilt(modules) {
  /** They get paths, as dist/esm has a file for each module. @type {Map<string, string>} */
  const codes = new Map();
  for (const [name, code] of Object.entries(modules)) codes.set(pathOf(name), code);
  return {
    name: 'volume-view-built',
    enforce: 'pre',
    resolveId: (id) => (id in modules ? pathOf(id) : null),
    load: (id) => codes.get(id) ?? null,
  };
}

/** The name of a module that the build makes, like `built:worker`; other names for other modules. @param {string} id - its path */
export const nameBuilt = (id) =>
  id
    .slice(join(projectRoot, 'src', '/').length)
    .replace('/', ':')
    .replace(/\.js$/, '');

/** @param {string} name - of a module that the build makes */
const pathOf = (name) => join(projectRoot, 'src', `${name.replace(':', '/')}.js`);

/**
 * OpenJPEG and CharLS, made by Emscripten, as modules: as CommonJS, its bundler's helpers for that would be part of every page. It looks whether it runs
 * in Node, and would then ask for files; here it never does, as it is given its bytes, and some bundlers refuse its questions.
 */
export const makeCodecModules = /** @type {import('vite').Plugin} */ ({
  name: 'volume-view-codecs',
  enforce: 'pre',
  transform(code, id) {
    const [, name] = (/\/codec-(openjpeg|charls)\//.test(id) && /^\s*var (\w+) = /.exec(code)) || [];
    if (!name) return null;
    const unused = 'var process, require, module, exports, define, __filename, __dirname;';
    return { code: `${unused}${code}\nexport default ${name};`, map: null };
  },
});

/**
 * mediabunny without its part for Node, which names a module of Node: for that one a bundler puts its helpers for CommonJS into every page.
 */
export const leaveOutNode = /** @type {import('vite').Plugin} */ ({
  name: 'volume-view-without-node',
  enforce: 'pre',
  resolveId: (id, importer) =>
    id === './node.js' && /[\\/]mediabunny[\\/]/.test(importer ?? '') ? '\0mediabunny-without-node' : null,
  load: (id) => (id === '\0mediabunny-without-node' ? 'export const fs = null;' : null),
});
