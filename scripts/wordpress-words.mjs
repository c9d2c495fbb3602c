// The words of the plugin for WordPress: `npm run docs` writes its template for translators (.pot) from the calls of __() and block.json, and
// build-wordpress.mjs makes of each translation (.po) what WordPress reads (.mo, and .json for the editor's script).
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';
import { pluginFolder } from './write-wordpress-block.mjs';

const root = join(projectRoot, pluginFolder);

/** Where the template is in the project. */
export const templateFile = `${pluginFolder}/languages/volume-view.pot`;

/** The only script with words. */
export const editorScript = 'block/editor.js';

/** @typedef {{ text: string, context: string, note: string, places: string[] }} Sentence */

const string = `'((?:[^'\\\\]|\\\\.)*)'|"((?:[^"\\\\]|\\\\.)*)"`;
const calls = new RegExp(
  `(?:/\\* translators: (.*?) \\*/\\s*(?:return )?(?:sprintf\\(\\s*)?)?(?<![\\w$>])(?:__|_e|_x|esc_html__|esc_attr__|esc_html_e|esc_attr_e|esc_html_x)\\(\\s*(?:${string})\\s*(?:,\\s*(?:${string})\\s*)?(?:,\\s*(?:${string})\\s*)?,?\\s*\\)`,
  'g',
);

/** @param {string} text - inside quotes */
const unquote = (text) => text.replace(/\\(.)/g, '$1');

/** Files of the plugin that may have words. */
export function listSources() {
  const names = readdirSync(root, { recursive: true, encoding: 'utf8' })
    .map((name) => name.replaceAll('\\', '/'))
    .filter((name) => /\.php$|^block\/.*\.js$/.test(name) && !name.startsWith('element/'));
  names.sort();
  return names;
}

/** Calls that translate, in a file; each has its words and its text domain. @param {string} name */
export function listCalls(name) {
  const text = readFileSync(join(root, name), 'utf8');
  return [...text.matchAll(calls)].map(({ 0: call, 1: note = '', index, ...found }) => {
    const strings = [2, 4, 6].map((i) => found[i] ?? found[i + 1]).filter((one) => one !== undefined);
    const hasContext = /_x\(/.test(call);
    return {
      text: unquote(strings[0]),
      context: hasContext ? unquote(strings[1] ?? '') : '',
      domain: strings[hasContext ? 2 : 1] ?? '',
      note,
      place: `${name}:${text.slice(0, index).split('\n').length}`,
    };
  });
}

/** All sentences, in the order of the files. @returns {Sentence[]} */
export function listSentences() {
  /** @type {Map<string, Sentence>} */
  const all = new Map();
  const add = (/** @type {{ text: string, context?: string, note?: string, place: string }} */ one) => {
    const { text, context = '', note = '', place } = one;
    const key = `${context}\u0004${text}`;
    const present = all.get(key) ?? { text, context, note, places: [] };
    present.places.push(place);
    all.set(key, present);
  };
  const head = readFileSync(join(root, 'volume-view.php'), 'utf8');
  for (const field of ['Plugin Name', 'Description', 'Author'])
    add({ text: new RegExp(`\\* ${field}:\\s+(.*)`).exec(head)?.[1] ?? '', place: 'volume-view.php' });
  const block = JSON.parse(readFileSync(join(root, 'block/block.json'), 'utf8'));
  add({ text: block.title, context: 'block title', place: 'block/block.json' });
  add({ text: block.description, context: 'block description', place: 'block/block.json' });
  for (const text of block.keywords) add({ text, context: 'block keyword', place: 'block/block.json' });
  for (const name of listSources()) for (const call of listCalls(name)) add(call);
  return [...all.values()];
}

/** @param {string} text */
const quote = (text) => JSON.stringify(text);

/** The template, without a date: the same words are the same bytes. */
export function writeTemplate() {
  const entries = listSentences().map(({ text, context, note, places }) =>
    [
      ...(note ? [`#. translators: ${note}`] : []),
      // Without the numbers of lines: a change above must not change the template.
      `#: ${[...new Set(places.map((place) => place.replace(/:\d+$/, '')))].join(' ')}`,
      ...(context ? [`msgctxt ${quote(context)}`] : []),
      `msgid ${quote(text)}`,
      'msgstr ""',
    ].join('\n'),
  );
  return `# Copyright (C) The volume-view authors
# This file is distributed under the MIT licence.
msgid ""
msgstr ""
"Project-Id-Version: Volume View\\n"
"MIME-Version: 1.0\\n"
"Content-Type: text/plain; charset=UTF-8\\n"
"Content-Transfer-Encoding: 8bit\\n"
"X-Domain: volume-view\\n"

${entries.join('\n\n')}
`;
}

/**
 * Reads a translation. Of gettext's format it knows what the template has: no plurals.
 * @param {string} text - of a .po file
 * @returns {Map<string, string>} translations by `context\u0004text`, or the text alone
 */
export function readTranslation(text) {
  /** @type {Map<string, string>} */
  const all = new Map();
  for (const entry of text.split(/\n\s*\n/)) {
    /** @type {Record<string, string>} */
    const fields = {};
    let field = '';
    for (const line of entry.split('\n')) {
      const found = /^(?:(msgctxt|msgid|msgstr) )?(".*")$/.exec(line.trim());
      if (!found) continue;
      field = found[1] ?? field;
      fields[field] = (fields[field] ?? '') + JSON.parse(found[2]);
    }
    if (fields.msgid === undefined || !fields.msgstr) continue;
    all.set(fields.msgctxt === undefined ? fields.msgid : `${fields.msgctxt}\u0004${fields.msgid}`, fields.msgstr);
  }
  return all;
}

/**
 * A catalogue of gettext: a head, two tables with length and place of each text, and the texts, sorted.
 * @param {Map<string, string>} translations
 */
export function writeCatalogue(translations) {
  const pairs = [...translations].map((pair) => pair.map((text) => Buffer.from(text)));
  pairs.sort(([one], [other]) => Buffer.compare(one, other));
  const tables = Buffer.alloc(28 + pairs.length * 16);
  [0x950412de, 0, pairs.length, 28, 28 + pairs.length * 8, 0, 28 + pairs.length * 16].forEach((value, i) =>
    tables.writeUInt32LE(value, i * 4),
  );
  /** @type {Buffer[]} */
  const texts = [];
  let place = tables.length;
  for (const column of [0, 1])
    pairs.forEach((pair, i) => {
      const at = 28 + (column * pairs.length + i) * 8;
      tables.writeUInt32LE(pair[column].length, at);
      tables.writeUInt32LE(place, at + 4);
      texts.push(pair[column], Buffer.of(0));
      place += pair[column].length + 1;
    });
  return Buffer.concat([tables, ...texts]);
}

/**
 * The words of the editor's script, as WordPress reads them for scripts.
 * @param {Map<string, string>} translations
 * @param {string} language
 */
export function writeScriptWords(translations, language) {
  const used = new Set(listCalls(editorScript).map(({ text }) => text));
  const words = [...translations].filter(([text]) => used.has(text)).map(([text, said]) => [text, [said]]);
  return JSON.stringify({
    domain: 'messages',
    locale_data: { messages: { '': { domain: 'messages', lang: language }, ...Object.fromEntries(words) } },
  });
}

/** The translations, by their languages. @returns {Map<string, Map<string, string>>} */
export function readTranslations() {
  const folder = join(root, 'languages');
  return new Map(
    readdirSync(folder)
      .map((name) => /^volume-view-(\w+)\.po$/.exec(name)?.[1])
      .filter((language) => language !== undefined)
      .map((language) => [language, readTranslation(readFileSync(join(folder, `volume-view-${language}.po`), 'utf8'))]),
  );
}
