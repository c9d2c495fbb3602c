// The built shaders have short names inside of their functions: scripts/shorten-glsl.mjs
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { shortenGlsl } from '../../scripts/shorten-glsl.mjs';
import { stripGlsl } from '../../scripts/strip-sources.mjs';

const token = /\.?[a-z_]\w*|[\d.]+(?:e-?\d+)?|\S/gi;
const isName = (/** @type {string} */ text) => /^[a-z_]/i.test(text);

/**
 * Each shader differs from what was written in names only. In a function, each name that has changed is declared before it is used, and
 * has become one other name, which no shader has outside of functions.
 */
export function checkShortShaders() {
  const folder = join(projectRoot, 'shaders');
  const texts = readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.glsl'))
    .map((name) => stripGlsl(readFileSync(join(folder, name), 'utf8')));
  const written = texts.map(split);
  const outside = new Set(written.flatMap((functions) => functions[0].filter(isName)));
  let renamed = 0;
  for (const [i, text] of texts.entries()) {
    const short = split(shortenGlsl(text));
    assert.equal(short.length, written[i].length, 'functions');
    for (const [j, tokens] of written[i].entries()) {
      /** @type {Map<string, string>} */
      const names = new Map();
      assert.equal(short[j].length, tokens.length, tokens.join(' '));
      for (const [k, before] of tokens.entries()) {
        const after = short[j][k];
        const known = names.get(before);
        const words = `${before} became ${after} in ${tokens.join(' ')}`;
        if (isName(before)) names.set(before, known ?? after);
        assert.equal(after, isName(before) ? names.get(before) : before, words);
        if (after === before) continue;
        const declares = tokens[0] === '(' && isName(tokens[k - 1]) && tokens[k - 1] !== 'return';
        assert.ok((known ?? declares) && !outside.has(after), words);
        renamed++;
      }
      assert.equal(new Set(names.values()).size, names.size, `two names became one in ${tokens.join(' ')}`);
    }
  }
  assert.ok(renamed > 1000, `${renamed} names are shorter`);
  return `${renamed} names`;
}

/**
 * The words and signs of a text: those outside of brackets; then each function, from its parameters on, and the members of each struct.
 * @param {string} text
 */
function split(text) {
  /** @type {string[][]} */
  const parts = [[]];
  /** Opened brackets; and the part that is read. */
  let [open, inside] = [0, parts[0]];
  const tokens = text.match(token) ?? [];
  for (const [i, one] of tokens.entries()) {
    // A function begins with its parameters: `float steps(`. A layout or a macro does not.
    const begins = one === '{' || (one === '(' && isName(tokens[i - 1]) && isName(tokens[i - 2]));
    if (inside === parts[0] && begins) parts.push((inside = []));
    inside.push(one);
    if (one === '{') open++;
    if (one === '}' && --open === 0) inside = parts[0];
  }
  return parts;
}
