// Writes descriptions of the tags for editors and frameworks, all from the custom-elements manifest: types of JSX and Vue, and data for VS
// Code and JetBrains. scripts/build.mjs calls it.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** @typedef {Record<string, any>} Entry - of the custom-elements manifest */

/** @param {string | undefined} text */
const oneLine = (text) => (text ?? '').replace(/\s+/g, ' ').trim();
/** @param {string} text */
const comment = (text) => `/** ${oneLine(text).replaceAll('*/', '* /')} */`;

/** The elements of the manifest, each with the module that defines it. @returns {Entry[]} */
export function readElements() {
  const { modules } = JSON.parse(readFileSync(join(projectRoot, 'custom-elements.json'), 'utf8'));
  const elements = modules
    .flatMap((/** @type {Entry} */ module) =>
      module.declarations.map((/** @type {Entry} */ one) => ({ ...one, path: module.path })),
    )
    .filter((/** @type {Entry} */ one) => one.tagName);
  addStepAttributes(elements);
  return elements;
}

/** A `<volume-step>` also has the attributes of a `<volume-view>` that a step may set, but no properties for them. @param {Entry[]} elements */
function addStepAttributes(elements) {
  const [step, view] = ['volume-step', 'volume-view'].map((name) => elements.find(({ tagName }) => tagName === name));
  if (!step || !view) return;
  const text = readFileSync(join(projectRoot, 'src/viewer/tours/step-attributes.ts'), 'utf8');
  const left = [...text.slice(text.indexOf('notInSteps')).matchAll(/'([^']+)'/g)].map(([, name]) => name);
  const added = view.attributes.filter((/** @type {Entry} */ one) => !left.includes(one.name));
  step.attributes = [
    ...step.attributes,
    ...added.map((/** @type {Entry} */ one) => ({ ...one, fieldName: undefined })),
  ];
}

/** Allowed words of an attribute, where its type names them. @param {Entry} attribute */
const listValues = (attribute) => [...(attribute.type?.text ?? '').matchAll(/'([^']+)'/g)].map(([, value]) => value);

const isFlag = (/** @type {Entry} */ attribute) => attribute.type?.text === 'boolean';

/** The fields that all formats have for a tag or an attribute. @param {Entry} one */
const described = (one) => ({ name: one.name, description: oneLine(one.description) });

/** Data for VS Code (`html.customData`). @param {Entry[]} elements */
function writeVsCode(elements) {
  const tags = elements.map((element) => ({
    name: element.tagName,
    description: oneLine(element.description),
    attributes: (element.attributes ?? []).map((/** @type {Entry} */ one) => ({
      ...described(one),
      ...(isFlag(one) ? { valueSet: 'v' } : {}),
      ...(listValues(one).length > 0 ? { values: listValues(one).map((name) => ({ name })) } : {}),
    })),
  }));
  return { version: 1.1, tags };
}

/** Data for JetBrains (the field `web-types` of package.json). @param {Entry[]} elements @param {string} version */
function writeWebTypes(elements, version) {
  const named = (/** @type {Entry[] | undefined} */ list) => (list ?? []).map(described);
  const tags = elements.map((element) => ({
    name: element.tagName,
    description: oneLine(element.description),
    attributes: (element.attributes ?? []).map((/** @type {Entry} */ one) => ({
      ...described(one),
      value: isFlag(one) ? { type: 'boolean', kind: 'no-value' } : { type: oneLine(one.type?.text) },
      ...(one.default === undefined ? {} : { default: oneLine(one.default) }),
    })),
    slots: named(element.slots),
    js: {
      properties: (element.attributes ?? [])
        .filter((/** @type {Entry} */ one) => one.fieldName)
        .map((/** @type {Entry} */ one) => ({
          name: one.fieldName,
          description: oneLine(one.description),
          type: oneLine(one.type?.text),
        })),
      events: named(element.events),
    },
    css: { parts: named(element.cssParts), properties: named(element.cssProperties) },
  }));
  return {
    $schema: 'https://json.schemastore.org/web-types',
    name: 'volume-view',
    version,
    'js-types-syntax': 'typescript',
    'description-markup': 'markdown',
    contributions: { html: { elements: tags } },
  };
}

/**
 * The type for writing a property. A property accepts its text too, and one property accepts more types than it returns.
 * @param {Entry} element
 * @param {Entry} attribute
 */
function typeProperty({ name }, { fieldName }) {
  const stops = fieldName === 'transferFunction' ? ' | readonly Stop[]' : '';
  return `${name}['${fieldName}']${stops} | string`;
}

/** Properties and attributes of an element as members of an interface. @param {Entry} element */
function typeAttributes(element) {
  return (element.attributes ?? []).flatMap((/** @type {Entry} */ one) => [
    comment(one.description),
    ...(one.fieldName ? [`${one.fieldName}?: ${typeProperty(element, one)} | undefined;`] : []),
    ...(one.name === one.fieldName
      ? []
      : [`'${one.name}'?: string | number${one.fieldName ? '' : ' | boolean'} | undefined;`]),
  ]);
}

/**
 * A type with all names for which an element has its own types; some of these have other types in HTML.
 * @param {Entry} element
 * @param {string[]} events
 */
function listOwn(element, events) {
  const names = (element.attributes ?? []).flatMap((/** @type {Entry} */ one) => [
    `'${one.fieldName ?? one.name}'`,
    `'${one.name}'`,
  ]);
  return [...new Set([...events, ...names])].join(' | ') || 'never';
}

/** @param {Entry} element @param {(name: string) => string} nameListener */
function typeEvents(element, nameListener) {
  return (element.events ?? []).flatMap((/** @type {Entry} */ one) => [
    comment(one.description),
    `${nameListener(one.name)}?: ((event: ${one.type.text}) => void) | undefined;`,
  ]);
}

/** The file that exports each type: the path of its declarations, by its name. @returns {Map<string, string>} */
function findTypes() {
  const paths = ['components', 'src'].flatMap((folder) =>
    readdirSync(join(projectRoot, folder), { recursive: true }).map(
      (name) => `${folder}/${String(name).replaceAll('\\', '/')}`,
    ),
  );
  return new Map(
    paths
      .filter((path) => path.endsWith('.ts'))
      .flatMap((path) => {
        const text = readFileSync(join(projectRoot, path), 'utf8');
        return [...text.matchAll(/^export (?:interface|type) (\w+)/gm)].map(
          ([, name]) => /** @type {[string, string]} */ ([name, path.replace(/ts$/, 'js')]),
        );
      }),
  );
}

/** The beginning of a file of types: it imports all types that the file may use. @param {Entry[]} elements */
function importTypes(elements) {
  const types = findTypes();
  const events = elements
    .flatMap((element) => element.events ?? [])
    .flatMap((/** @type {Entry} */ one) => one.type.text.match(/\w+/g));
  const named = [...new Set(['Stop', ...events])].filter((name) => types.has(name));
  return [
    '// Written by scripts/write-tag-data.mjs from the custom-elements manifest.',
    `export * from './src/index.js';`,
    ...elements.map(({ path, name }) => `import type { ${name} } from './${path.replace(/ts$/, 'js')}';`),
    ...named.map((name) => `import type { ${name} } from './${types.get(name)}';`),
  ];
}

/** @param {string} head @param {string[]} lines */
const block = (head, lines) => [`${head} {`, ...lines.map((line) => `  ${line}`), '}', ''];

/** Listeners that React itself defines. */
const reactOnly = ['onLoad', 'onError', 'onProgress', 'onPlay', 'onPause', 'onInput', 'onChange'].map(
  (name) => `'${name}'`,
);

/** JSX as React 19 types it. @param {Entry[]} elements */
function writeReact(elements) {
  // React listens to `onload` exactly as written; its own `onLoad` and similar listeners never get an event that does not bubble.
  const props = elements.flatMap((element) => [
    '',
    ...block(
      `export interface ${element.name}Props extends Omit<HTMLAttributes<${element.name}>, ${listOwn(element, reactOnly)}>, RefAttributes<${element.name}>`,
      [...typeAttributes(element), ...typeEvents(element, (name) => `'on${name}'`)],
    ),
  ]);
  return [
    ...importTypes(elements),
    `import type { HTMLAttributes, RefAttributes } from 'react';`,
    ...props,
    ...block(
      `declare module 'react'`,
      block(
        'namespace JSX',
        block(
          'interface IntrinsicElements',
          elements.map(({ tagName, name }) => `'${tagName}': ${name}Props;`),
        ),
      ),
    ),
  ].join('\n');
}

/** The name of Vue's listener for an event: `onCameraChange` for `camera-change`. @param {string} name */
const nameVueListener = (name) =>
  `'on${name.replace(/(?:^|-)(.)/g, (_, /** @type {string} */ letter) => letter.toUpperCase())}'`;

/** The components for Vue's language tools, which look them up in templates. @param {Entry[]} elements */
function writeVue(elements) {
  const props = elements.flatMap((element) => {
    const own = listOwn(
      element,
      (element.events ?? []).map((/** @type {Entry} */ one) => nameVueListener(one.name)),
    );
    return [
      '',
      ...block(`export interface ${element.name}Props extends Omit<HTMLAttributes, ${own}>`, [
        ...typeAttributes(element),
        ...typeEvents(element, nameVueListener),
      ]),
    ];
  });
  return [
    ...importTypes(elements),
    `import type { HTMLAttributes } from 'vue';`,
    ...props,
    ...block(
      `declare module 'vue'`,
      block(
        'interface GlobalComponents',
        elements.map(({ tagName, name }) => `'${tagName}': new () => ${name} & { $props: ${name}Props };`),
      ),
    ),
  ].join('\n');
}

/** @param {string} dist - the folder of the build, absolute */
export function writeTagData(dist) {
  const elements = readElements();
  const { version } = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));
  /** @param {string} path @param {string} text */
  const write = (path, text) => writeFileSync(join(projectRoot, path), text);
  write('vscode.html-custom-data.json', `${JSON.stringify(writeVsCode(elements), null, 2)}\n`);
  write('web-types.json', `${JSON.stringify(writeWebTypes(elements, version), null, 2)}\n`);
  writeFileSync(join(dist, 'types/react.d.ts'), writeReact(elements));
  writeFileSync(join(dist, 'types/vue.d.ts'), writeVue(elements));
}
