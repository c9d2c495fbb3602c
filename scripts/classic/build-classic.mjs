// Builds the package as classic scripts: volume-view.iife.js, and next to it the folder classic with the parts that few pages need.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { minifySync } from 'vite';
import { projectRoot } from '../shared-data.mjs';
import { nameBuilt } from '../build-plugins.mjs';
import { escapeToAscii } from '../strip-sources.mjs';

/**
 * @param {string} dist - the folder for the files
 * @param {Readonly<Record<string, string>>} workers - texts of workers, by the modules that have them, in the order in which a page tries them
 * @param {(output: import('vite').Rolldown.OutputOptions) => Promise<readonly import('vite').Rolldown.OutputChunk[]>} bundle - builds
 * src/classic.ts as CommonJS, with these options
 */
export async function writeClassic(dist, workers, bundle) {
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
    const worker = chunk.moduleIds.map(nameBuilt).find((name) => name in workers);
    const text = worker === undefined ? writePart(key, writeFactory(chunk)) : writeWorker(key, workers[worker]);
    writeFileSync(join(dist, `classic/${key}.js`), minify(text));
  }
  const loader = readFileSync(join(projectRoot, 'scripts/classic/loader.js'), 'utf8');
  const [entry] = chunks.filter(({ isEntry }) => isEntry);
  const workerParts = Object.keys(workers).map(
    (name) => chunks.find(({ moduleIds }) => moduleIds.map(nameBuilt).includes(name))?.fileName,
  );
  const text = `var VolumeView=function(){"use strict";
const VERSION="${version}",PART_NEEDS=${listNeeds(chunks, entry.fileName)},WORKER_PARTS=[${workerParts.join()}];
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

/** The script of a part. @param {string} key @param {string} factory */
const writePart = (key, factory) => `(globalThis.volumeViewParts??={})["${key}"]=${factory};`;

/**
 * The script of a part that has the text of a worker. The same file is the worker, where a page may start one from a file.
 * @param {string} key @param {string} text
 */
const writeWorker = (key, text) =>
  `{const w=function(){${text}};${writePart(key, 'function(r,e){e.text="("+w+")()"}')}self.document||w()}`;

/** A part as a function, with what CommonJS defines in a file. @param {import('vite').Rolldown.OutputChunk} chunk */
function writeFactory({ code }) {
  return `function(require,exports){"use strict";${code}\n}`;
}

/**
 * Code of a text: the parts that each part imports, but those that others of them import. The entry is not among them. Parts are separated by commas; each has the rising
 * numbers of others, each as the gap to the one before: letters are digits to the base of 26, and the last one is a small letter. A list of numbers would be 440 bytes longer, packed.
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
    needs[Number(fileName)] = numbers.map((number, n) => writeGap(number - (numbers[n - 1] ?? 0))).join('');
  }
  return JSON.stringify(needs.join());
}

/** @param {number} gap */
function writeGap(gap) {
  const letter = (/** @type {number} */ digit) => String.fromCodePoint(97 + digit);
  let text = letter(gap % 26);
  for (let rest = Math.floor(gap / 26); rest > 0; rest = Math.floor(rest / 26))
    text = letter(rest % 26).toUpperCase() + text;
  return text;
}
