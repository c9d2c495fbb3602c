// Builds the package as classic scripts: volume-view.iife.js, and next to it the folder classic with the parts that few pages need.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../shared-data.mjs';

/** The public exports of the entry, without those that only its parts use. */
const PUBLIC = /^(?!injectScript$|scriptUrl$).{3,}$/;

/** The code that the bundler writes for `import('…')`, for imports and for exports. */
const IMPORTED = /Promise\.resolve\(\)\.then\(\(\)=>require\(([`"'])\.\/([\w.-]+\.js)\1\)\)/g;
const NEEDED = /\brequire\(([`"'])\.\/([\w.-]+\.js)\1\)/g;
const EXPORTED = /(?<![\w$.{])exports(?=\.[\w$]+=|,)/g;

/**
 * @param {readonly import('vite').Rolldown.OutputChunk[]} found - CommonJS, all in one folder
 * @param {string} dist - the folder for the files
 */
export function writeClassic(found, dist) {
  mkdirSync(join(dist, 'classic'), { recursive: true });
  const others = found.filter(({ isEntry }) => !isEntry);
  const [entry] = found.filter(({ isEntry }) => isEntry);
  const chunks = [entry, ...others];
  const version = createHash('sha256')
    .update(chunks.map(({ code }) => code).join())
    .digest('hex')
    .slice(0, 8);
  const numbers = new Map(chunks.map(({ fileName }, i) => [fileName, i]));
  /** @param {import('vite').Rolldown.OutputChunk} chunk */
  const writePart = (chunk) =>
    `(globalThis.volumeViewParts??={})["${numbers.get(chunk.fileName)}-${version}"]=${writeFactory(chunk, numbers)};\n`;
  for (const chunk of others)
    writeFileSync(join(dist, `classic/${numbers.get(chunk.fileName)}-${version}.js`), writePart(chunk));
  const loader = readFileSync(join(projectRoot, 'scripts/classic/loader.js'), 'utf8').replace(
    /^\s*\/\/.*\n|^\s*\/\*\*.*\*\/\n|^\s+/gm,
    '',
  );
  const text = `var VolumeView=function(){"use strict";
const VERSION="${version}",PART_NEEDS=${JSON.stringify(listNeeds(chunks, numbers)).replace(/"(\d+)"/g, '$1')};
${loader}modules[0]={};
(${writeFactory(entry, numbers)})(need,load,modules[0]);
const all=need(0),shown={};
for(const name of ${JSON.stringify(entry.exports.filter((name) => PUBLIC.test(name)))})Object.defineProperty(shown,name,{enumerable:true,get:()=>all[name]});
return shown}();
`;
  writeFileSync(join(dist, 'volume-view.iife.js'), text);
}

/**
 * @param {import('vite').Rolldown.OutputChunk} chunk
 * @param {ReadonlyMap<string, number>} numbers - of all chunks, by name
 */
function writeFactory({ code, fileName }, numbers) {
  const asked = code
    .replace(IMPORTED, (_, _quote, name) => `load(${numbers.get(name)})`)
    .replace(NEEDED, (_, _quote, name) => `need(${numbers.get(name)})`)
    .replace(EXPORTED, 'own');
  const left = /.{40}(?<![\w$.{])(?:(?:require|import)\(|exports\b|need\(undefined|load\(undefined).{40}/.exec(asked);
  if (left) throw new Error(`${fileName} imports or exports in a way that is not known here: ${left[0]}`);
  return `function(need,load,own){"use strict";${asked.trim()}\n}`;
}

/**
 * The parts that each part needs at once when it is requested, directly or not, in addition to itself and the entry.
 * @param {readonly import('vite').Rolldown.OutputChunk[]} chunks - the entry first
 * @param {ReadonlyMap<string, number>} numbers
 */
function listNeeds(chunks, numbers) {
  const byName = new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
  /** @type {Record<number, number[]>} */
  const needs = {};
  for (const target of new Set(chunks.flatMap(({ dynamicImports }) => dynamicImports))) {
    const all = new Set([target]);
    for (const name of all)
      for (const imported of byName.get(name)?.imports ?? []) if (imported !== chunks[0].fileName) all.add(imported);
    all.delete(target);
    if (all.size > 0) needs[numbers.get(target) ?? NaN] = [...all].map((name) => numbers.get(name) ?? NaN);
  }
  return needs;
}
