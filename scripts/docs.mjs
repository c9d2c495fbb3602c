// `npm run docs` writes docs/reference.md and the pages in docs/reference, one for each element. The text comes from the comments of the
// elements, from the types of their events and properties, and from the error codes. It also writes the map of the code, docs/develop/rooms.md
// (map-rooms.mjs), the table of elements that a lesson may have, the traits of the widget for notebooks, and the
// attributes and words of the plugin for WordPress. `--check` fails if a page is out of date, missing or no longer needed.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { mapRooms } from './map-rooms.mjs';
import { projectRoot } from './shared-data.mjs';
import { templateFile, writeTemplate } from './wordpress-words.mjs';
import { traitsFile, writeTraits } from './write-python-traits.mjs';
import { readElements } from './write-tag-data.mjs';
import { writeWordPressBlock } from './write-wordpress-block.mjs';

/** @typedef {Record<string, any>} Entry - of the custom-elements manifest */

const folder = join(projectRoot, 'docs');
const note = 'Written by `npm run docs` from the comments in the source; edit them, not this file.';

/** @param {unknown} value */
const cell = (value) => (typeof value === 'string' ? value : '').replace(/\s+/g, ' ').replaceAll('|', '\\|').trim();
/** Code in one line, also where the formatter wrapped it. @param {unknown} value */
function code(value) {
  const text = cell(value)
    .replace(/^\\\| /, '')
    .replaceAll('; }', ' }')
    .replaceAll(', ]', ']')
    .replaceAll('[ ', '[');
  return text ? `\`${text}\`` : '';
}

/** A type as code, with a link to its fields if the page of types has them. @param {unknown} type */
function linkType(type) {
  const name = details.find((one) => new RegExp(`\\b${one}\\b`).test(cell(type)));
  return name ? `[${code(type)}](types.md#${name.toLowerCase()})` : code(type);
}

/**
 * A table with a heading, or an empty text where there are no rows.
 * @param {string} title
 * @param {string[]} heads
 * @param {string[][]} rows
 */
function writeTable(title, heads, rows) {
  if (rows.length === 0) return '';
  const line = (/** @type {string[]} */ cells) => `| ${cells.join(' | ')} |`;
  return [`## ${title}`, '', line(heads), line(heads.map(() => '---')), ...rows.map(line), '', ''].join('\n');
}

/** @param {Entry} method - its name, parameters and descriptions */
function describeMethod(method) {
  /** @type {Entry[]} */
  const parameters = method.parameters ?? [];
  const said = parameters
    .filter(({ description }) => cell(description))
    .map(({ name, description }) => `${code(name)}: ${cell(description)}.`.replace(/\.\.$/, '.'));
  return [
    code(`${method.name}(${parameters.map(({ name }) => name).join(', ')})`),
    linkType(method.return?.type?.text),
    [cell(method.description), ...said].join(' '),
  ];
}

/** Which events bubble; a comment says so of those that do. @param {Entry[]} events */
function describeBubbling(events = []) {
  const bubbling = events.filter((one) => /\bit bubbles\b/.test(one.description)).length;
  if (events.length === 0 || events.length === bubbling) return '';
  return bubbling > 0 ? 'The other events do not bubble.\n\n' : 'These events do not bubble.\n\n';
}

/** @param {Entry} element - a declaration with a tagName */
function describeElement(element) {
  const open = (/** @type {Entry} */ member) => !member.privacy || member.privacy === 'public';
  /** @type {Entry[]} */
  const members = (element.members ?? []).filter(
    (/** @type {Entry} */ one) => open(one) && !one.static && isOwn(one) && one.description,
  );
  const named = (/** @type {Entry[] | undefined} */ list) =>
    (list ?? []).map((one) => [code(one.name) || '(default)', cell(one.description)]);
  return [
    `# \`<${element.tagName}>\`\n\n${(element.description ?? '').trim()}\n\n`,
    `Guide: ${linkGuides(element, '../')}. [All elements](../reference.md).\n\n`,
    writeTable(
      'Attributes',
      ['attribute', 'property', 'type', 'default', 'meaning'],
      (element.attributes ?? []).map((/** @type {Entry} */ one) => {
        const initial = element.members?.find((/** @type {Entry} */ member) => member.name === one.fieldName)?.default;
        return [code(one.name), code(one.fieldName), code(one.type?.text), code(initial), cell(one.description)];
      }),
    ),
    element.attributes ? howAttributesHold : '',
    writeTable(
      'Read-only properties',
      ['property', 'type', 'meaning'],
      members
        .filter((one) => one.kind === 'field' && !one.attribute)
        .map((one) => [code(one.name), linkType(one.type?.text), cell(one.description)]),
    ),
    writeTable(
      'Methods',
      ['method', 'returns', 'meaning'],
      members.filter((one) => one.kind === 'method').map(describeMethod),
    ),
    writeTable(
      'Events',
      ['event', 'type', 'meaning'],
      (element.events ?? []).map((/** @type {Entry} */ one) => [
        code(one.name),
        linkType(one.type?.text),
        cell(one.description),
      ]),
    ),
    describeBubbling(element.events),
    writeTable('Slots', ['slot', 'content'], named(element.slots)),
    writeTable('CSS parts', ['part', 'meaning'], named(element.cssParts)),
    writeTable('CSS custom properties', ['property', 'meaning'], named(element.cssProperties)),
  ].join('');
}

/** Whether a member is in the class of the element, or in a part of that class with a file of its own. @param {Entry} member */
function isOwn({ inheritedFrom }) {
  return !inheritedFrom || inheritedFrom.name.endsWith('Members');
}

const howAttributesHold = `Setting a property writes its attribute at once; reading it reads the attribute. It is null (or false) if the attribute is absent, which means
the default, or cannot be read. Scripts may also set the text that would stand in HTML.\n\n`;

/** The text of a comment without its asterisks. @param {string | undefined} comment */
const plain = (comment) => cell((comment ?? '').replace(/^\s*\* ?/gm, ''));

/**
 * The fields of an interface with their comments. The manifest contains classes only, so we need this small reader. It
 * depends on the formatting of this project: a closing brace in the first column ends an interface.
 * @param {string} name
 */
function describeInterface(name) {
  const pattern = new RegExp(
    `(?:/\\*\\*((?:(?!\\*/)[\\s\\S])*)\\*/\\s*)?export interface ${name}(?: extends (\\w+))? \\{\\n([\\s\\S]*?)\\n\\}`,
  );
  for (const text of sources) {
    const found = pattern.exec(text);
    if (!found) continue;
    // A field ends where the next line has the indentation of a field, or where the interface ends.
    const fields = [
      ...found[3].matchAll(
        /(?:\/\*\*((?:(?!\*\/)[\s\S])*)\*\/\s*)?^ {2}readonly (\w+)(\??):\s([\s\S]+?);(?=\n {2}(?:\/|readonly )|\n\n|$(?![\s\S]))/gm,
      ),
    ];
    const rows = fields.map(([, comment, field, optional, type]) => [
      code(field + optional),
      type.includes(name) ? code(type) : linkType(type),
      plain(comment),
    ]);
    const more = found[2] ? `All fields of ${linkType(found[2])}, and:` : '';
    return writeTable(name, ['field', 'type', 'meaning'], rows).replace(
      '\n\n',
      `\n\n${[plain(found[1]), more].filter(Boolean).join(' ')}\n\n`,
    );
  }
  throw new Error(`docs: no interface ${name}`);
}

/** The codes of errors with their comments. */
function describeErrors() {
  const text = readFileSync(join(projectRoot, 'src/core/errors.ts'), 'utf8');
  return writeTable(
    'Codes',
    ['code', 'meaning'],
    [...text.matchAll(/\/\*\*([^/]*?)\*\/\s*\| '([^']+)'/g)].map(([, comment, name]) => [code(name), plain(comment)]),
  );
}

/** Source texts of the interfaces in the reference. */
const sourceFiles = ['components', 'src/viewer', 'src/quality', 'src/optics', 'src/volume', 'src/editor'].flatMap(
  (folder) =>
    readdirSync(join(projectRoot, folder), { recursive: true, encoding: 'utf8' })
      .filter((name) => name.endsWith('.ts'))
      .map((name) => join(projectRoot, folder, name)),
);
sourceFiles.sort();
const sources = sourceFiles.map((file) => readFileSync(file, 'utf8'));

const details = [
  'VolumeInfo',
  'ChannelInfo',
  'VolumePick',
  'VolumePosition',
  'EarthPlace',
  'PickedSurface',
  'RadarPlace',
  'RadarGate',
  'Histogram',
  'VolumeOptics',
  'Stop',
  'TransferFunctionDetail',
  'RenderStats',
  'PictureError',
  'PictureCheck',
  'CameraState',
  'Camera',
  'CameraChangeDetail',
  'Orbit',
  'MeasureResult',
  'Statistics',
  'SliceCursorDetail',
  'StepChangeDetail',
  'AnswerDetail',
  'LayerLook',
  'VolumeSurfaceInfo',
  'VolumeTerrainInfo',
  'TimeChangeDetail',
  'ProgressDetail',
  'ErrorDetail',
];

const cem = join(projectRoot, 'node_modules/@custom-elements-manifest/analyzer/cem.js');
spawnSync(process.execPath, [cem, 'analyze', '--config', 'custom-elements-manifest.config.mjs', '--quiet'], {
  cwd: projectRoot,
});
const { modules } = JSON.parse(readFileSync(join(projectRoot, 'custom-elements.json'), 'utf8'));
/** @type {Entry[]} */
const all = modules
  .flatMap((/** @type {Entry} */ module) => module.declarations)
  .filter((/** @type {Entry} */ one) => one.tagName);
// <volume-view> first, then its companions by their names.
all.sort((one, other) => one.tagName.localeCompare(other.tagName));
const elements = [
  ...all.filter((one) => one.tagName === 'volume-view'),
  ...all.filter((one) => one.tagName !== 'volume-view'),
];

/** The pages that explain how to use each element. @type {Record<string, readonly [title: string, page: string][]>} */
const guides = {
  'volume-view': [
    ['Data', 'guide/data.md'],
    ['Looks and presets', 'guide/looks.md'],
    ['Transfer functions', 'guide/transfer-functions.md'],
    ['Camera', 'guide/camera.md'],
  ],
  'volume-clip': [['Cutting', 'guide/cutting.md']],
  'volume-label': [['Labels', 'guide/labels.md']],
  'volume-label-list': [['Labels', 'guide/labels.md']],
  'volume-labels': [['Labels', 'guide/labels.md']],
  'volume-layer': [['Layers', 'guide/layers.md']],
  'volume-legend': [['Companions', 'guide/companions.md#volume-legend']],
  'volume-measure': [['Measuring', 'guide/measuring.md']],
  'volume-note': [['Notes', 'guide/notes.md']],
  'volume-question': [['Questions', 'guide/questions.md']],
  'volume-readout': [['Pointing', 'guide/pointing.md']],
  'volume-slice': [['Slices', 'guide/slices.md']],
  'volume-slice-view': [['Slices', 'guide/slices.md']],
  'volume-compare': [['Compare two volumes', 'guide/compare.md']],
  'volume-drop': [['Files of a reader', 'guide/open-files.md']],
  'volume-series': [['Files of a reader', 'guide/open-files.md']],
  'volume-step': [
    ['Write a lesson', 'guide/lesson.md'],
    ['Tours', 'guide/tours.md'],
  ],
  'volume-surface': [['Surfaces and terrain', 'guide/surfaces.md']],
  'volume-terrain': [['Surfaces and terrain', 'guide/surfaces.md']],
  'volume-timeline': [['Scans in time', 'guide/scans-in-time.md']],
  'volume-tour': [
    ['Write a lesson', 'guide/lesson.md'],
    ['Tours', 'guide/tours.md'],
  ],
  'volume-transfer-function': [['Companions', 'guide/companions.md#volume-transfer-function']],
  'volume-workspace': [['Companions', 'guide/companions.md']],
};

/** @param {Entry} element @param {string} path - from the page to docs */
function linkGuides({ tagName }, path) {
  if (!guides[tagName]) throw new Error(`docs: no guide is named for <${tagName}>, see guides in scripts/docs.mjs`);
  return guides[tagName].map(([title, page]) => `[${title}](${path}${page})`).join(', ');
}

/** The first sentence of a description. @param {Entry} element */
const summarise = ({ description }) => /^.*?\.(?= |$)/.exec(cell(description))?.[0] ?? cell(description);

/** Pages by their paths in docs. @type {Map<string, string>} */
const pages = new Map([
  [
    'reference.md',
    [
      `# Reference\n\n${note}\n\n`,
      writeTable(
        'Elements',
        ['element', 'what it is', 'guide'],
        elements.map((element) => [
          `[\`<${element.tagName}>\`](reference/${element.tagName}.md)`,
          summarise(element),
          linkGuides(element, ''),
        ]),
      ),
      '## Further pages\n\n- [Types](reference/types.md): the fields of what events and properties carry\n- [Error codes](reference/error-codes.md)\n',
    ].join(''),
  ],
  ...elements.map((element) => /** @type {const} */ ([`reference/${element.tagName}.md`, describeElement(element)])),
  [
    'reference/types.md',
    `# Types of events and properties\n\n[All elements](../reference.md).\n\n${details.map(describeInterface).join('')}`,
  ],
  [
    'reference/error-codes.md',
    `# Error codes\n\nThey stay the same from version to version. How errors are shown: [Errors](../guide/errors.md). [All elements](../reference.md).\n\n${describeErrors()}`,
  ],
]);
pages.set(
  'develop/rooms.md',
  mapRooms(elements.map((element) => ({ name: element.tagName, summary: summarise(element) }))),
);
const notes = (/** @type {string} */ text) =>
  text.includes('Written by `npm run docs`') ? text : `${text.trimEnd()}\n\n*${note}*\n`;
const wanted = new Map([...pages].map(([path, text]) => [path, `${notes(text).trimEnd()}\n`]));
const present = [
  'reference.md',
  'develop/rooms.md',
  ...readdirSync(mkdirs(join(folder, 'reference'))).map((name) => `reference/${name}`),
];
const leftOver = present.filter((path) => !wanted.has(path));

/** @param {string} path - of a folder, which is created if it does not exist @returns {string} the same path */
function mkdirs(path) {
  mkdirSync(path, { recursive: true });
  return path;
}

/** The elements and attributes that a lesson may have, for the package that writes lessons; relative to docs. */
const tablePath = '../packages/lesson-writers/src/volume-elements.ts';
const rows = readElements().map(({ tagName, attributes = [] }) => {
  const value = `'${attributes.map((/** @type {Entry} */ one) => one.name).join(' ')}',`;
  const line = `  '${tagName}': ${value}`;
  return `${line.length > 120 ? `  '${tagName}':\n    ${value}` : line}\n`; // As the formatter writes it.
});
rows.sort();
wanted.set(
  tablePath,
  `// ${note}

/** The attributes of each element, separated by blanks. */
export const volumeElements: Readonly<Record<string, string>> = {
${rows.join('')}};
`,
);
const traitsPath = `../${traitsFile}`;
wanted.set(traitsPath, writeTraits());
const ofWordPress = writeWordPressBlock();
for (const [path, text] of ofWordPress) wanted.set(`../${path}`, text);
const generated = [tablePath, traitsPath, ...[...ofWordPress.keys(), templateFile].map((path) => `../${path}`)];
present.push(...generated.filter((path) => existsSync(join(folder, path))));

if (!process.argv.includes('--check')) {
  for (const [path, text] of wanted) writeFileSync(join(folder, path), text);
  // The words of the plugin are read from its files, some of which were just written.
  writeFileSync(join(projectRoot, templateFile), writeTemplate());
  for (const path of leftOver) rmSync(join(folder, path));
} else {
  wanted.set(`../${templateFile}`, writeTemplate());
  const stale = [...wanted]
    .filter(([path, text]) => !present.includes(path) || readFileSync(join(folder, path), 'utf8') !== text)
    .map(([path]) => path);
  for (const path of [...stale, ...leftOver]) console.log(`docs/${path} is not what the code says. Run: npm run docs`);
  process.exitCode = stale.length + leftOver.length > 0 ? 1 : 0;
}
