// The map of the code, docs/develop/rooms.md: the modules and their folders in the order that the lint rule gives them, each with the first
// sentence of its README.md. A folder without one is an error.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { FOLDERS, MAY_IMPORT } from './modules-lint-plugin.mjs';
import { projectRoot } from './shared-data.mjs';

const note =
  'Written by `npm run docs` from `scripts/modules-lint-plugin.mjs` and the README.md of each folder; edit them, not this file.';

/** The folder or file of a module. @param {string} name */
const placeOf = (name) =>
  [`src/${name}`, name, `src/${name}.ts`].find((path) => existsSync(join(projectRoot, path))) ?? name;

/** The folders below a folder that have files of code, by name. @param {string} folder */
function listFolders(folder) {
  const files = readdirSync(join(projectRoot, folder), { recursive: true, encoding: 'utf8' }).map((name) =>
    name.replaceAll('\\', '/'),
  );
  const holders = files
    .filter((name) => /\/[^/]+\.(?:ts|glsl)$/.test(name))
    .map((name) => name.slice(0, name.lastIndexOf('/')));
  const folders = [...new Set(holders)];
  folders.sort();
  return folders;
}

/** The first sentence of a folder's README.md. @param {string} folder */
function summariseFolder(folder) {
  const path = join(projectRoot, folder, 'README.md');
  const sentence = existsSync(path) && /^# .*\n\n((?:.|\n)*?\.)(?=\s|$)/.exec(readFileSync(path, 'utf8'))?.[1];
  if (!sentence)
    throw new Error(`docs: ${folder}/README.md has no sentence below its heading that says what the folder is for`);
  return sentence.replaceAll('\n', ' ').replaceAll('|', '\\|');
}

/**
 * The arrows that the others do not say: `a -> c` is left out where `a -> b` and `b -> c` are there.
 * @param {Record<string, readonly string[]>} table - what each module may import
 * @returns {(readonly [from: string, to: string])[]}
 */
export function listDirectArrows(table) {
  /** @param {string} from @param {string} to @param {Set<string>} seen @returns {boolean} */
  const reaches = (from, to, seen) =>
    (table[from] ?? []).some((next) => next === to || (!seen.has(next) && reaches(next, to, seen.add(next))));
  return Object.keys(table).flatMap((from) =>
    table[from]
      .filter((to) => !table[from].some((other) => other !== to && reaches(other, to, new Set([from]))))
      .map((to) => /** @type {const} */ ([from, to])),
  );
}

/** A drawing of all arrows. */
function drawArrows() {
  const nodes = [...new Set(Object.entries(MAY_IMPORT).flat(2))].map((name) => `  ${idOf(name)}["${name}"]`);
  return [
    '```mermaid',
    'graph TD',
    ...nodes,
    ...listDirectArrows(MAY_IMPORT).map(([from, to]) => `  ${idOf(from)} --> ${idOf(to)}`),
    '```',
  ].join('\n');
}

/** A name without what has a meaning in a drawing. @param {string} name */
const idOf = (name) => `m_${name.replace(/\W/g, '_')}`;

/** @param {string} name - of a module */
function describeModule(name) {
  const place = placeOf(name);
  const isFile = place.endsWith('.ts');
  const folders = (FOLDERS[name] ?? []).filter((folder) => folder !== '.');
  const lost = FOLDERS[name] && listFolders(place).find((folder) => !folders.includes(folder));
  if (lost) throw new Error(`docs: ${place}/${lost} is not in FOLDERS of scripts/modules-lint-plugin.mjs`);
  const rows = folders.map(
    (folder) => `| [\`${folder}\`](../../${place}/${folder}) | ${summariseFolder(`${place}/${folder}`)} |`,
  );
  return [
    `## ${name}`,
    '',
    `[\`${place}\`](../../${place}): ${isFile ? 'It only exports what other files define.' : summariseFolder(place)}`,
    '',
    `It may import from: ${MAY_IMPORT[name].map((one) => `\`${one}\``).join(', ') || 'no other module'}.`,
    '',
    ...(rows.length > 0
      ? [
          'Its folders in their order. A file imports from its own folder and from those above it; files outside these folders come last:',
          '',
          '| folder | what it is for |',
          '| --- | --- |',
          ...rows,
          '',
        ]
      : []),
  ].join('\n');
}

/**
 * @param {readonly { name: string, summary: string }[]} elements - of the package
 * @returns {string} the page
 */
export function mapRooms(elements) {
  const unknown = readdirSync(join(projectRoot, 'src'), { withFileTypes: true }).filter(
    (one) => one.isDirectory() && !MAY_IMPORT[one.name],
  );
  if (unknown.length > 0)
    throw new Error(`docs: src/${unknown[0].name} is not in MAY_IMPORT of scripts/modules-lint-plugin.mjs`);
  const rows = elements.map(({ name, summary }) => `| [\`${name}\`](../../components/${name}) | ${summary} |`);
  return [
    '# Map of the code',
    '',
    note,
    '',
    'What each module may import is below; `npm run lint` refuses any other import. The drawing has an arrow from a module to those that it imports,',
    'and leaves out the arrows that follow from others.',
    '',
    drawArrows(),
    '',
    ...Object.keys(MAY_IMPORT).map(describeModule),
    '## shaders',
    '',
    `[\`shaders\`](../../shaders): ${summariseFolder('shaders')}`,
    '',
    '| folder | what it is for |',
    '| --- | --- |',
    ...listFolders('shaders').map(
      (folder) => `| [\`${folder}\`](../../shaders/${folder}) | ${summariseFolder(`shaders/${folder}`)} |`,
    ),
    '',
    '## The elements',
    '',
    'Each is a folder of `components`. It imports from `components/internal`, and from another element only types and the file that defines it.',
    '',
    '| element | what it is |',
    '| --- | --- |',
    ...rows,
    '',
  ].join('\n');
}
