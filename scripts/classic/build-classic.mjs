// The package as classic scripts: volume-view.iife.js, and beside it the folder classic with what few pages need.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../shared-data.mjs';

const ENTRY = './entry.js';

/** What of the entry is the package's, and not what its parts need of it. */
const PUBLIC = /^(?!injectScript$|scriptUrl$).{3,}$/;

/** As the bundler writes `import('…')`, imports and exports. */
const IMPORTED = /Promise\.resolve\(\)\.then\(\(\)=>require\(([`"'])(\.\/[\w.-]+\.js)\1\)\)/g;
const NEEDED = /\brequire\((?=[`"']\.\/[\w.-]+\.js[`"']\))/g;
const EXPORTED = /(?<![\w$.{])exports(?=\.[\w$]+=|,)/g;

/**
 * @param {readonly import('vite').Rolldown.OutputChunk[]} chunks - CommonJS, all in one folder, the entry being entry.js
 * @param {string} dist - where they go
 */
export function writeClassic(chunks, dist) {
  mkdirSync(join(dist, 'classic'), { recursive: true });
  const entry = chunks.find(({ isEntry }) => isEntry);
  if (entry?.fileName !== 'entry.js') throw new Error('expected one entry, entry.js');
  for (const chunk of chunks) if (chunk !== entry) writeFileSync(join(dist, 'classic', chunk.fileName), writePart(chunk));
  const loader = readFileSync(join(projectRoot, 'scripts/classic/loader.js'), 'utf8').replace(/^\s*\/\/.*\n|^\s*\/\*\*.*\*\/\n/gm, '');
  const names = entry.exports.filter((name) => PUBLIC.test(name));
  const text = `var VolumeView=function(){"use strict";
const PART_NEEDS=${JSON.stringify(listNeeds(chunks, entry))};
${loader}modules["${ENTRY}"]={};
(${writeFactory(entry)})(need,load,modules["${ENTRY}"]);
var all=need("${ENTRY}"),shown={};
for(const name of ${JSON.stringify(names)})Object.defineProperty(shown,name,{enumerable:true,get:()=>all[name]});
return shown}();
`;
  writeFileSync(join(dist, 'volume-view.iife.js'), text);
}

/** A script that gives its part to the list. @param {import('vite').Rolldown.OutputChunk} chunk */
function writePart(chunk) {
  return `(globalThis.volumeViewParts??={})["./${chunk.fileName}"]=${writeFactory(chunk)};\n`;
}

/** @param {import('vite').Rolldown.OutputChunk} chunk */
function writeFactory({ code, fileName }) {
  const asked = code.replace(IMPORTED, (_, quote, name) => `load(${quote}${name}${quote})`).replace(NEEDED, 'need(').replace(EXPORTED, 'own');
  const left = /.{40}(?<![\w$.{])(?:(?:require|import)\(|exports\b).{40}/.exec(asked);
  if (left) throw new Error(`${fileName} imports or exports in a way that is not known here: ${left[0]}`);
  return `function(need,load,own){"use strict";${asked.trim()}\n}`;
}

/**
 * What each part that is asked for needs at once beside itself and the entry, directly or not.
 * @param {readonly import('vite').Rolldown.OutputChunk[]} chunks
 * @param {import('vite').Rolldown.OutputChunk} entry
 */
function listNeeds(chunks, entry) {
  const byName = new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
  /** @type {Record<string, string[]>} */
  const needs = {};
  for (const target of new Set(chunks.flatMap(({ dynamicImports }) => dynamicImports))) {
    const all = new Set([target]);
    for (const name of all) for (const imported of byName.get(name)?.imports ?? []) if (imported !== entry.fileName) all.add(imported);
    all.delete(target);
    if (all.size > 0) needs[`./${target}`] = [...all].map((name) => `./${name}`);
  }
  return needs;
}
