// What editors and frameworks are told of the tags is what the elements themselves observe.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { projectRoot } from '../../scripts/shared-data.mjs';

const tags = readdirSync(join(projectRoot, 'components')).filter(
  (name) => name !== 'internal' && existsSync(join(projectRoot, 'components', name, 'define.ts')),
);

/** @param {string} path */
const read = (path) => readFileSync(join(projectRoot, path), 'utf8');
/** @param {string} path */
const readJson = (path) => JSON.parse(read(path));

/**
 * The attributes of an element by its class, with the name of the property that each is.
 * @param {string} tag
 * @returns {Promise<Map<string, string>>}
 */
async function listAttributes(tag) {
  const module = await import(pathToFileURL(join(projectRoot, `dist/esm/components/${tag}/${tag}.js`)).href);
  const element = Object.values(module).find((one) => one.observedAttributes); // Which makes Lit gather them.
  /** @type {Map<string, string>} */
  const attributes = new Map(
    [...element.elementProperties]
      .filter(([, { attribute }]) => typeof attribute === 'string')
      .map(([name, { attribute }]) => [attribute, name]),
  );
  // A step also has attributes of the view, without properties for them.
  if (tag === 'volume-step') for (const name of await listStepAttributes()) attributes.set(name, name);
  return attributes;
}

/** @returns {Promise<readonly string[]>} */
async function listStepAttributes() {
  const path = join(projectRoot, 'dist/esm/src/viewer/tours/step-attributes.js');
  return (await import(pathToFileURL(path).href)).stepAttributes;
}

/** @returns {Promise<string>} how many there are */
export async function checkTagData() {
  /** @typedef {{ name: string, description?: string, attributes: { name: string, description?: string }[] }} Tag */
  /** @type {Record<string, Tag[]>} */
  const lists = {
    'vscode.html-custom-data.json': readJson('vscode.html-custom-data.json').tags,
    'web-types.json': readJson('web-types.json').contributions.html.elements,
  };
  const types = { react: read('dist/types/react.d.ts'), vue: read('dist/types/vue.d.ts') };
  let count = 0;
  for (const tag of tags) {
    const attributes = await listAttributes(tag);
    count += attributes.size;
    for (const [file, list] of Object.entries(lists)) {
      assert.deepEqual(new Set(list.map(({ name }) => name)), new Set(tags), file);
      const reported = list.find(({ name }) => name === tag);
      assert.ok(reported?.description, `${file} describes <${tag}>`);
      assert.deepEqual(
        new Set(reported.attributes.map(({ name }) => name)),
        new Set(attributes.keys()),
        `${file}: <${tag}>`,
      );
      for (const { name, description } of reported.attributes)
        assert.ok(description, `${file} describes ${name} of <${tag}>`);
    }
    for (const [name, text] of Object.entries(types)) {
      const className = tag.replace(/(^|-)(.)/g, (_, __, letter) => letter.toUpperCase());
      const from = text.indexOf(`interface ${className}Props `);
      const own = text.slice(from, text.indexOf('\n}', from));
      assert.ok(from > 0 && text.includes(`'${tag}':`), `the types for ${name} have <${tag}>`);
      for (const [attribute, property] of attributes) {
        for (const key of new Set([attribute, property]))
          assert.match(own, new RegExp(`^ *'?${key}'?\\?:`, 'm'), `the types for ${name}: ${key} of <${tag}>`);
      }
    }
  }
  return `${count} attributes`;
}
