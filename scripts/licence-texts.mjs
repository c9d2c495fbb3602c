// The licence texts of packages whose code is part of what is built.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** These packages name their licence only, and each contains another library, whose licence is kept here. */
const containedIn = {
  '@cornerstonejs/codec-openjpeg': 'openjpeg',
  '@cornerstonejs/codec-charls': 'charls',
};

/** The name of a package, its version, and the text of its licence. @param {string} folder - with the package.json */
function licenceIn(folder) {
  const manifest = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((one) => /^licen[cs]e(\.|$)/i.test(one));
  const text = file ? readFileSync(join(folder, file), 'utf8').trim() : `Licensed under: ${manifest.license}`;
  return { manifest, text: `${manifest.name} ${manifest.version} (${manifest.license})\n\n${text}` };
}

/** One text of many. @param {Map<string, string>} texts - by package */
function joinTexts(texts) {
  for (const [name, contained] of Object.entries(containedIn)) {
    if (texts.has(name))
      texts.set(contained, readFileSync(join(projectRoot, 'scripts/licences', `${contained}.txt`), 'utf8').trim());
  }
  return `${[...texts.values()].join(`\n\n${'-'.repeat(78)}\n\n`)}\n`;
}

/** Of packages and of all that they depend on. @param {readonly string[]} names @returns {string} */
export function licencesOfPackages(names) {
  /** @type {Map<string, string>} */
  const texts = new Map();
  const visit = (/** @type {string} */ name) => {
    if (texts.has(name)) return;
    const folder = join(projectRoot, 'node_modules', name);
    if (!existsSync(folder)) return; // optional, or nested under its only user
    const { manifest, text } = licenceIn(folder);
    texts.set(name, text);
    Object.keys(manifest.dependencies ?? {}).forEach(visit);
  };
  names.forEach(visit);
  return joinTexts(texts);
}

/**
 * Of the packages from which modules were bundled.
 * @param {Iterable<string>} modules - paths of modules, or what a bundler calls them
 * @returns {string}
 */
export function licencesOfModules(modules) {
  /** @type {Set<string>} */
  const folders = new Set();
  for (const path of modules) {
    const [, folder] = /^\0?(.*[\\/]node_modules[\\/](?:@[^\\/]+[\\/])?[^\\/]+)[\\/]/.exec(path) ?? [];
    if (folder) folders.add(folder);
  }
  /** @type {Map<string, string>} */
  const texts = new Map();
  const sorted = [...folders];
  sorted.sort();
  for (const folder of sorted) {
    const { manifest, text } = licenceIn(folder);
    texts.set(manifest.name, text);
  }
  return joinTexts(texts);
}
