// The attributes of <volume-view> as the plugin for WordPress has them, from the custom-elements manifest: the table for PHP, what the editor says
// of each of them, and block.json. `npm run docs` writes them.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';
import { readElements } from './write-tag-data.mjs';

/** @typedef {{ name: string, kind: string, values: string[], description: string }} Row */

/** Where the plugin is in the project. */
export const pluginFolder = 'packages/wordpress/volume-view';

/** Attributes that the plugin does not have, each with its reason. */
export const leftAttributes = {
  authoring: 'it is for the author of a page, while the page is written',
  crossorigin: 'an author who may write no HTML could send cookies of readers to a server',
  crosshair: 'it needs panes of slices, which a post does not have',
  cursor: 'it needs panes of slices, which a post does not have',
  'link-state': 'it needs an id that stays the same',
};

/** Elements below the picture, by the words that the address of the page for frames has for them, too. */
export const companions = { legend: 'volume-legend', readout: 'volume-readout', timeline: 'volume-timeline' };

/** @param {string} path @param {RegExp} pattern @returns {string[]} the words in quotes of the part that the pattern finds */
function readWords(path, pattern) {
  const part = pattern.exec(readFileSync(join(projectRoot, path), 'utf8'))?.[1];
  if (!part) throw new Error(`${path} has no list as ${pattern}`);
  return [...part.matchAll(/'([^']+)'/g)].map(([, word]) => word);
}

/** Words that an attribute takes though its type is a text. @returns {Record<string, string[]>} */
function readNamed() {
  const presets = 'src/optics/transfer/preset-names.ts';
  return {
    look: readWords('src/viewer/appearance/named-looks.ts', /\bct: \[([^\]]+)\]/),
    'transfer-function': [
      ...readWords(presets, /writtenPresets = \[([^\]]+)\]/),
      ...readWords(presets, /colorTables = \[([^\]]+)\]/),
    ],
  };
}

/** @param {string} name @param {string} type */
function kindOf(name, type) {
  if (name === 'src') return 'addresses';
  if (name === 'poster') return 'address';
  if (type === 'boolean') return 'flag';
  if (/\bboolean\b/.test(type)) return 'flag-or-text';
  return /^(?:'[^']+' \| )+null$/.test(type) ? 'choice' : 'text';
}

/** @returns {Row[]} */
export function readRows() {
  const view = readElements().find(({ tagName }) => tagName === 'volume-view');
  const named = readNamed();
  return (view?.attributes ?? [])
    .filter((/** @type {{ name: string }} */ { name }) => !Object.hasOwn(leftAttributes, name))
    .map((/** @type {Record<string, any>} */ { name, type, description = '' }) => {
      const kind = kindOf(name, type?.text ?? '');
      const own = kind === 'choice' ? [...type.text.matchAll(/'([^']+)'/g)].map(([, word]) => word) : [];
      return { name, kind, values: named[name] ?? own, description: description.replace(/\s+/g, ' ').trim() };
    });
}

/** @param {string} text */
const quote = (text) => `'${text.replaceAll('\\', '\\\\').replaceAll("'", "\\'")}'`;

/** Lines `'name' => value,` whose arrows stand below each other. @param {[string, string][]} pairs */
function align(pairs) {
  const width = Math.max(...pairs.map(([name]) => name.length));
  return pairs.map(([name, value]) => `\t\t${quote(name)}${' '.repeat(width - name.length)} => ${value},`).join('\n');
}

/** @param {string} what @param {string} name @param {string} returns @param {string} body */
const phpFile = (what, name, returns, body) => `<?php
/**
 * ${what}
 *
 * Written by \`npm run docs\` of the project of the element; edit the element, not this file.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * ${what}
 *
 * @return ${returns}
 */
function ${name}() {
	return array(
${body}
	);
}
`;

/** @param {Row[]} rows */
function writeTable(rows) {
  return phpFile(
    'The attributes of the element that a post may have, each with its kind: flag, flag-or-text, text, choice, address, or addresses.',
    'volume_view_attributes',
    'array<string, string> Kinds by names.',
    align(rows.map(({ name, kind }) => [name, quote(kind)])),
  );
}

/** @param {Row[]} rows */
function writeChoices(rows) {
  return phpFile(
    'Words that attributes take, for the side panel of the editor.',
    'volume_view_choices',
    'array<string, string[]> By the names of attributes.',
    align(
      rows
        .filter(({ values }) => values.length > 0)
        .map(({ name, values }) => [name, `array( ${values.map(quote).join(', ')} )`]),
    ),
  );
}

/** @param {Row[]} rows */
function writeDescriptions(rows) {
  return phpFile(
    'What the attributes mean, for the side panel of the editor.',
    'volume_view_descriptions',
    'array<string, string> By the names of attributes.',
    align(rows.map(({ name, description }) => [name, `__( ${quote(description)}, 'volume-view' )`])),
  );
}

/** @param {Row[]} rows */
function writeBlock(rows) {
  const { version } = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));
  const flag = { type: 'boolean', default: false };
  const text = { type: 'string', default: '' };
  return `${JSON.stringify(
    {
      $schema: 'https://schemas.wp.org/trunk/block.json',
      apiVersion: 3,
      name: 'volume-view/volume',
      version,
      title: 'Volume',
      category: 'media',
      icon: 'visibility',
      description: 'A CT, an MRI or a weather radar that readers can turn.',
      keywords: ['CT', 'MRI', 'radar', '3D'],
      textdomain: 'volume-view',
      attributes: {
        ...Object.fromEntries(rows.map(({ name, kind }) => [name, kind === 'flag' ? flag : text])),
        ...Object.fromEntries(Object.keys(companions).map((name) => [name, flag])),
        caption: text,
      },
      supports: { align: ['wide', 'full'], html: false },
      example: { attributes: {} },
      editorScript: 'volume-view-block',
    },
    null,
    2,
  )}\n`;
}

/** The files by their paths in the project. @returns {Map<string, string>} */
export function writeWordPressBlock() {
  const rows = readRows();
  return new Map([
    [`${pluginFolder}/includes/attributes.php`, writeTable(rows)],
    [`${pluginFolder}/includes/choices.php`, writeChoices(rows)],
    [`${pluginFolder}/includes/descriptions.php`, writeDescriptions(rows)],
    [`${pluginFolder}/block/block.json`, writeBlock(rows)],
  ]);
}
