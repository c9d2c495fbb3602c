// What an import of our own files means: './…', or '#…' in the field `imports` of package.json.
import { readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** @type {{ imports: Record<string, { default: string }> }} */
const { imports } = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));

/**
 * The file that an import names where no build asks for another one.
 * @param {string} specifier
 * @param {string} importer - absolute
 * @returns {string | null} absolute; null for a package
 */
export function resolveOwn(specifier, importer) {
  const path = specifier.replace(/\?.*$/, '');
  if (path.startsWith('.')) return resolve(dirname(importer), path);
  if (!path.startsWith('#')) return null;
  const name = Object.keys(imports).find((one) => one === path || path.startsWith(one.replace(/\*$/, '')));
  if (!name) throw new Error(`${importer} imports ${specifier}, which package.json does not name in imports`);
  return resolve(projectRoot, imports[name].default.replace('*', path.slice(name.length - 1)));
}
