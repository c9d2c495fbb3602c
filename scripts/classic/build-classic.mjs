// Builds the package as classic scripts: volume-view.iife.js, and next to it the folder classic with the parts that few pages need.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { minifySync } from 'vite';
import { projectRoot } from '../shared-data.mjs';
import { escapeToAscii } from '../strip-sources.mjs';

/**
 * @param {string} dist - the folder for the files
 * @param {(output: import('vite').Rolldown.OutputOptions) => Promise<readonly import('vite').Rolldown.OutputChunk[]>} bundle - builds
 * src/classic.ts as CommonJS, with these options
 */
export async function writeClassic(dist, bundle) {
  /** The number of each part, by its modules. The bundler asks for a name more than once. @type {Map<string, number>} */
  const numbers = new Map();
  const numberOf = (/** @type {readonly string[]} */ moduleIds) => {
    const key = moduleIds.join();
    return numbers.get(key) ?? numbers.set(key, numbers.size + 1).size;
  };
  const chunks = await bundle({
    entryFileNames: '0',
    chunkFileNames: ({ moduleIds }) => `${numberOf(moduleIds)}`,
  });
  mkdirSync(join(dist, 'classic'), { recursive: true });
  const version = createHash('sha256')
    .update(chunks.map(({ code }) => code).join())
    .digest('hex')
    .slice(0, 8);
  for (const chunk of chunks.filter(({ isEntry }) => !isEntry)) {
    const key = `${chunk.fileName}-${version}`;
    const text = `(globalThis.volumeViewParts??={})["${key}"]=${writeFactory(chunk)};`;
    writeFileSync(join(dist, `classic/${key}.js`), minify(text));
  }
  const loader = readFileSync(join(projectRoot, 'scripts/classic/loader.js'), 'utf8');
  const [entry] = chunks.filter(({ isEntry }) => isEntry);
  const text = `var VolumeView=function(){"use strict";
const VERSION="${version}",PART_NEEDS=${listNeeds(chunks, entry.fileName)};
${loader}
run(0,${writeFactory(entry)});
return modules[0].VolumeView}();
`;
  writeFileSync(join(dist, 'volume-view.iife.js'), minify(text));
}

/** @param {string} text */
function minify(text) {
  const { code, errors } = minifySync('classic.js', text, { mangle: { toplevel: false } });
  if (errors.length > 0) throw new Error(`the classic script cannot be read: ${errors[0].message}`);
  return `${escapeToAscii(code)}\n`;
}

/** A part as a function, with what CommonJS defines in a file. @param {import('vite').Rolldown.OutputChunk} chunk */
function writeFactory({ code }) {
  return `function(require,exports){"use strict";${code}\n}`;
}

/**
 * Code of an array: the parts that each part imports, but those that others of them import. The entry is not among them.
 * @param {readonly import('vite').Rolldown.OutputChunk[]} chunks
 * @param {string} entry - its name
 */
function listNeeds(chunks, entry) {
  const byName = new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
  const importsOf = (/** @type {string} */ name) => byName.get(name)?.imports.filter((one) => one !== entry) ?? [];
  const needs = Array.from({ length: chunks.length }, () => '');
  for (const { fileName } of chunks) {
    if (fileName === entry) continue;
    const own = new Set(importsOf(fileName));
    for (const name of own) {
      const others = new Set([...own].filter((one) => one !== name).flatMap(importsOf));
      for (const one of others) importsOf(one).forEach((next) => others.add(next));
      if (others.has(name)) own.delete(name);
    }
    const numbers = [...own].map(Number);
    numbers.sort((a, b) => a - b);
    if (numbers.length > 0) needs[Number(fileName)] = JSON.stringify(numbers);
  }
  return `[${needs.join()}]`;
}
