// Packs the plugin for WordPress, packages/wordpress, with the built element into one file, to upload under Plugins, Add New. `npm run build`
// comes before. `--out FILE` names it. The same files always give the same bytes.
import { createHash } from 'node:crypto';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { zipSync } from 'fflate';
import { projectRoot } from './shared-data.mjs';
import { readTranslations, writeCatalogue, writeScriptWords } from './wordpress-words.mjs';
import { pluginFolder } from './write-wordpress-block.mjs';

const dist = join(projectRoot, 'dist');

/** What of dist a post loads: the modules, and the classic script for the editor. */
const isOfElement = (/** @type {string} */ name) =>
  /^(?:volume-[\w-]+(?:\.iife)?\.js|volume-view\.css|decode-worker\.js|x3dom\.js|THIRD-PARTY-LICENSES\.txt)$|^(?:chunks|classic)\//.test(
    name,
  );

/** @param {string} folder @returns {[name: string, bytes: Buffer][]} sorted by name */
function readFolder(folder) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .map(
      (path) => /** @type {[string, Buffer]} */ ([relative(folder, path).replaceAll('\\', '/'), readFileSync(path)]),
    );
  files.sort(([one], [other]) => (one < other ? -1 : 1));
  return files;
}

/** The files of the plugin, by their paths in its folder. @returns {Map<string, Buffer>} */
export function gatherPlugin() {
  /** @type {Map<string, Buffer>} */
  const files = new Map(readFolder(join(projectRoot, pluginFolder)));
  files.set('LICENSE', readFileSync(join(projectRoot, 'LICENSE')));
  for (const [language, words] of readTranslations()) {
    files.set(`languages/volume-view-${language}.mo`, writeCatalogue(words));
    files.set(
      `languages/volume-view-${language}-volume-view-block.json`,
      Buffer.from(writeScriptWords(words, language)),
    );
  }
  if (!existsSync(join(dist, 'volume-view.js'))) return files;
  const element = readFolder(dist).filter(([name]) => isOfElement(name));
  const hash = createHash('sha256');
  for (const [name, bytes] of element) hash.update(`${name}\0${bytes.length}\0`).update(bytes);
  const folder = hash.digest('hex').slice(0, 12);
  for (const [name, bytes] of element) files.set(`element/${folder}/${name}`, bytes);
  files.set(
    'element/folder.php',
    Buffer.from(`<?php\n// The folder of this build.\ndefined( 'ABSPATH' ) || exit;\nreturn '${folder}';\n`),
  );
  return files;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  if (!existsSync(join(dist, 'volume-view.js'))) throw new Error('there is no element in dist: run npm run build');
  const { version } = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));
  const { values } = parseArgs({
    options: { out: { type: 'string', default: join(projectRoot, `volume-view-wordpress-${version}.zip`) } },
  });
  const files = gatherPlugin();
  const packed = zipSync(
    Object.fromEntries(
      [...files].map(([name, bytes]) => [`volume-view/${name}`, [bytes, { level: 9, mtime: new Date(1980, 0, 2) }]]),
    ),
  );
  writeFileSync(resolve(values.out), packed);
  console.log(`${values.out}: ${files.size} files, ${(packed.length / 1e6).toFixed(1)} MB`);
}
