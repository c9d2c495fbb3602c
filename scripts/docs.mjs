// `npm run docs` writes docs/reference.md from the comments of the elements, of what their events carry and of the
// error codes; `--check` fails where it is stale.
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** @typedef {Record<string, any>} Entry - of the custom-elements manifest */

const target = join(projectRoot, 'docs/reference.md');

/** @param {unknown} value */
const cell = (value) => (typeof value === 'string' ? value : '').replace(/\s+/g, ' ').replaceAll('|', '\\|').trim();
/** @param {unknown} value */
const code = (value) => (cell(value) ? `\`${cell(value)}\`` : '');

/**
 * A table with a heading, or nothing where there are no rows.
 * @param {string} title
 * @param {string[]} heads
 * @param {string[][]} rows
 */
function writeTable(title, heads, rows) {
  if (rows.length === 0) return '';
  const line = (/** @type {string[]} */ cells) => `| ${cells.join(' | ')} |`;
  return [`### ${title}`, '', line(heads), line(heads.map(() => '---')), ...rows.map(line), '', ''].join('\n');
}

/** @param {Entry} method - its name and parameters, and what is said of them */
function describeMethod(method) {
  /** @type {Entry[]} */
  const parameters = method.parameters ?? [];
  const said = parameters.map(({ description }) => cell(description)).filter(Boolean);
  return [
    code(`${method.name}(${parameters.map(({ name }) => name).join(', ')})`),
    code(method.return?.type?.text),
    [cell(method.description), ...said].join(' '),
  ];
}

/** @param {Entry} element - a declaration with a tagName */
function describeElement(element) {
  const open = (/** @type {Entry} */ member) => !member.privacy || member.privacy === 'public';
  /** @type {Entry[]} */
  const members = (element.members ?? []).filter((/** @type {Entry} */ one) => open(one) && !one.static && isOwn(one) && one.description);
  const named = (/** @type {Entry[] | undefined} */ list) => (list ?? []).map((one) => [code(one.name) || '(default)', cell(one.description)]);
  return [
    `## \`<${element.tagName}>\`\n\n${(element.description ?? '').trim()}\n\n`,
    writeTable('Attributes', ['attribute', 'property', 'type', 'default', 'meaning'],
      (element.attributes ?? []).map((/** @type {Entry} */ one) => {
        const initial = element.members?.find((/** @type {Entry} */ member) => member.name === one.fieldName)?.default;
        return [code(one.name), code(one.fieldName), code(one.type?.text), code(initial), cell(one.description)];
      })),
    element.attributes ? howAttributesHold : '',
    writeTable('Further properties, to be read', ['property', 'type', 'meaning'],
      members.filter((one) => one.kind === 'field' && !one.attribute).map((one) => [code(one.name), code(one.type?.text), cell(one.description)])),
    writeTable('Methods', ['method', 'returns', 'meaning'], members.filter((one) => one.kind === 'method').map(describeMethod)),
    writeTable('Events', ['event', 'type', 'meaning'],
      (element.events ?? []).map((/** @type {Entry} */ one) => [code(one.name), code(one.type?.text), cell(one.description)])),
    element.events ? 'None of them bubbles.\n\n' : '',
    writeTable('Slots', ['slot', 'content'], named(element.slots)),
    writeTable('CSS parts', ['part', 'meaning'], named(element.cssParts)),
    writeTable('CSS custom properties', ['property', 'meaning'], named(element.cssProperties)),
  ].join('');
}

/** Members of the element's class, or of the part of it that is a file of its own. @param {Entry} member */
function isOwn({ inheritedFrom }) {
  return !inheritedFrom || inheritedFrom.name.endsWith('Members');
}

const howAttributesHold = `To set a property writes its attribute at once, and to read it reads the attribute. It is null (or false) where the
attribute is absent, which means the default, or where it cannot be read. Scripts may set a text too, as it stands in HTML.\n\n`;

/** The text of a comment without its stars. @param {string | undefined} comment */
const plain = (comment) => cell((comment ?? '').replace(/^\s*\* ?/gm, ''));

/**
 * The fields of an interface with their comments. The manifest knows classes only, hence this small reader, which
 * trusts the formatting of this project: a closing brace in the first column ends an interface.
 * @param {string} name
 */
function describeInterface(name) {
  const pattern = new RegExp(`(?:/\\*\\*((?:(?!\\*/)[\\s\\S])*)\\*/\\s*)?export interface ${name}(?: extends \\w+)? \\{\\n([\\s\\S]*?)\\n\\}`);
  for (const text of sources) {
    const found = pattern.exec(text);
    if (!found) continue;
    const fields = [...found[2].matchAll(/(?:\/\*\*([\s\S]*?)\*\/\s*)?^ {2}readonly (\w+)(\??): (.+);$/gm)];
    const rows = fields.map(([, comment, field, optional, type]) => [code(field + optional), code(type), plain(comment)]);
    return writeTable(name, ['field', 'type', 'meaning'], rows).replace('\n\n', `\n\n${plain(found[1])}\n\n`);
  }
  throw new Error(`docs: no interface ${name}`);
}

/** The codes of errors with their comments. */
function describeErrors() {
  const text = readFileSync(join(projectRoot, 'src/errors.ts'), 'utf8');
  return writeTable('Error codes', ['code', 'meaning'],
    [...text.matchAll(/\/\*\*([^/]*?)\*\/\s*\| '([^']+)'/g)].map(([, comment, name]) => [code(name), plain(comment)]));
}

/** Sources of the interfaces that the reference speaks of. */
const sources = ['components', 'src/viewer', 'src/quality', 'src/optics', 'src/volume', 'src/editor']
  .flatMap((folder) => readdirSync(join(projectRoot, folder)).filter((name) => name.endsWith('.ts')).map((name) => join(projectRoot, folder, name)))
  .map((file) => readFileSync(file, 'utf8'));

const details = ['VolumeInfo', 'VolumePick', 'RadarPlace', 'RadarGate', 'Histogram', 'VolumeOptics', 'Stop', 'TransferFunctionDetail', 'RenderStats', 'PictureError', 'CameraChangeDetail', 'Orbit', 'TimeChangeDetail', 'ProgressDetail', 'ErrorDetail'];

const cem = join(projectRoot, 'node_modules/@custom-elements-manifest/analyzer/cem.js');
spawnSync(process.execPath, [cem, 'analyze', '--config', 'custom-elements-manifest.config.mjs', '--quiet'], { cwd: projectRoot });
const { modules } = JSON.parse(readFileSync(join(projectRoot, 'custom-elements.json'), 'utf8'));
/** @type {Entry[]} */
const all = modules.flatMap((/** @type {Entry} */ module) => module.declarations).filter((/** @type {Entry} */ one) => one.tagName);
// <volume-view> first, then its companions.
const elements = [...all.filter((one) => one.tagName === 'volume-view'), ...all.filter((one) => one.tagName !== 'volume-view')];
const text = `# Reference\n\nWritten by \`npm run docs\` from the comments in the source; edit them, not this file.\n\n${elements.map(describeElement).join('')}## What events and properties carry\n\n${details.map(describeInterface).join('')}## Errors\n\n${describeErrors()}`.trimEnd();

if (!process.argv.includes('--check')) {
  writeFileSync(target, `${text}\n`);
} else if (!existsSync(target) || readFileSync(target, 'utf8') !== `${text}\n`) {
  console.log('docs/reference.md is not what the code says. Run: npm run docs');
  process.exitCode = 1;
}
