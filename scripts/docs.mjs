// `npm run docs` writes docs/reference.md from the class comments of the elements; `--check` fails where it is stale.
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
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

/** @param {Entry} element - a declaration with a tagName */
function describeElement(element) {
  const open = (/** @type {Entry} */ member) => !member.privacy || member.privacy === 'public';
  /** @type {Entry[]} */
  const members = (element.members ?? []).filter((/** @type {Entry} */ one) => open(one) && !one.static && !one.inheritedFrom && one.description);
  const named = (/** @type {Entry[] | undefined} */ list) => (list ?? []).map((one) => [code(one.name) || '(default)', cell(one.description)]);
  return [
    `## \`<${element.tagName}>\`\n\n${(element.description ?? '').trim()}\n\n`,
    writeTable('Attributes', ['attribute', 'type', 'default', 'meaning'],
      (element.attributes ?? []).map((/** @type {Entry} */ one) => [code(one.name), code(one.type?.text), code(one.default), cell(one.description)])),
    writeTable('Properties', ['property', 'type', 'meaning'],
      members.filter((one) => one.kind === 'field').map((one) => [code(one.name), code(one.type?.text), cell(one.description)])),
    writeTable('Methods', ['method', 'returns', 'meaning'],
      members.filter((one) => one.kind === 'method').map((one) => [
        code(`${one.name}(${(one.parameters ?? []).map((/** @type {Entry} */ parameter) => parameter.name).join(', ')})`),
        code(one.return?.type?.text), cell(one.description)])),
    writeTable('Events', ['event', 'type', 'meaning'],
      (element.events ?? []).map((/** @type {Entry} */ one) => [code(one.name), code(one.type?.text), cell(one.description)])),
    writeTable('Slots', ['slot', 'content'], named(element.slots)),
    writeTable('CSS parts', ['part', 'meaning'], named(element.cssParts)),
    writeTable('CSS custom properties', ['property', 'meaning'], named(element.cssProperties)),
  ].join('');
}

const cem = join(projectRoot, 'node_modules/@custom-elements-manifest/analyzer/cem.js');
spawnSync(process.execPath, [cem, 'analyze', '--config', 'custom-elements-manifest.config.mjs', '--quiet'], { cwd: projectRoot });
const { modules } = JSON.parse(readFileSync(join(projectRoot, 'custom-elements.json'), 'utf8'));
/** @type {Entry[]} */
const elements = modules.flatMap((/** @type {Entry} */ module) => module.declarations).filter((/** @type {Entry} */ one) => one.tagName);
const text = `# Reference\n\nWritten by \`npm run docs\` from the comments in \`components/\`; edit them, not this file.\n\n${elements.map(describeElement).join('')}`.trimEnd();

if (!process.argv.includes('--check')) {
  writeFileSync(target, `${text}\n`);
} else if (!existsSync(target) || readFileSync(target, 'utf8') !== `${text}\n`) {
  console.log('docs/reference.md is not what the code says. Run: npm run docs');
  process.exitCode = 1;
}
