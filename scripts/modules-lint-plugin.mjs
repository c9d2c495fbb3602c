// The architecture's rule as a lint rule: who may import what. Dynamic imports and import types count too, which is
// why this is not `no-restricted-imports`.
import { dirname, relative, resolve, sep } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/**
 * Each module, and the modules it may import from besides itself. `errors` is open to all.
 * @type {Record<string, string[]>}
 */
const MAY_IMPORT = {
  errors: [],
  'load-part': ['errors'],
  'trust': [],
  unclosed: [],
  'page-children': [],
  'pointer-place': [],
  waiting: [],
  'inject-script': ['trust'],
  words: ['errors'],
  volume: ['errors'],
  optics: ['errors', 'waiting', 'volume'],
  radar: ['errors', 'volume', 'optics'],
  quality: ['errors', 'waiting', 'volume', 'optics'],
  formats: ['errors', 'load-part', 'trust', 'volume', 'optics', 'radar'],
  renderer: ['errors', 'load-part', 'volume', 'optics', 'quality', 'shaders'],
  'radar/gpu': ['errors', 'volume', 'optics', 'radar', 'renderer', 'shaders'],
  x3d: ['errors', 'page-children', 'trust', 'unclosed', 'volume', 'optics', 'radar', 'renderer'],
  viewer: ['errors', 'page-children', 'pointer-place', 'waiting', 'load-part', 'unclosed', 'volume', 'optics', 'radar', 'quality', 'formats', 'renderer', 'panes', 'words'],
  editor: ['errors', 'pointer-place', 'volume', 'optics', 'words'],
  panes: ['errors', 'pointer-place', 'volume', 'optics'],
  components: ['errors', 'page-children', 'pointer-place', 'volume', 'optics', 'radar', 'quality', 'formats', 'renderer', 'radar/gpu', 'x3d', 'viewer', 'editor', 'panes', 'words'],
  index: ['errors', 'optics', 'quality', 'viewer', 'words', 'components'],
  demos: ['errors', 'volume', 'optics', 'radar', 'quality', 'formats', 'renderer', 'radar/gpu', 'x3d', 'viewer', 'components', 'index'],
};

/**
 * Packages that one module alone knows.
 * @type {Record<string, string>}
 */
const OWNED_PACKAGES = { lit: 'components', x3dom: 'x3d', '@shoelace-style': 'words' };

/**
 * The module of a file, or undefined for files outside of all (tests, scripts).
 * @param {string} file - absolute
 */
function findModule(file) {
  const [top, second, third] = relative(projectRoot, file).split(sep);
  if (top !== 'src') return top;
  return second === 'radar' && third === 'gpu' ? 'radar/gpu' : second?.replace(/\.ts$/, '');
}

// oxlint hands over ESTree nodes; its own types for them are not public under a stable name, hence `any`.

const oneWay = {
  meta: { type: 'problem', schema: [] },
  /** @param {any} context */
  create(context) {
    const file = context.filename;
    const own = findModule(file);
    const allowed = MAY_IMPORT[own];
    if (!allowed) return {};
    /** @param {any} source - the string literal, or null for an export without one */
    const check = (source) => {
      if (typeof source?.value !== 'string') return;
      const name = source.value;
      if (name.startsWith('.')) {
        const target = findModule(resolve(dirname(file), name.replace(/\?.*$/, '')));
        if (target !== own && !allowed.includes(target)) {
          context.report({ node: source, message: `${own} may not import from ${target}; it may from: ${allowed.join(', ') || 'nowhere'}` });
        }
        return;
      }
      const owner = OWNED_PACKAGES[name.replace(/^@lit\//, 'lit/').split('/')[0]];
      if (owner && owner !== own) {
        context.report({ node: source, message: `only ${owner} may import ${name}` });
      }
    };
    return {
      ImportDeclaration: (/** @type {any} */ node) => check(node.source),
      ExportNamedDeclaration: (/** @type {any} */ node) => check(node.source),
      ExportAllDeclaration: (/** @type {any} */ node) => check(node.source),
      ImportExpression: (/** @type {any} */ node) => check(node.source),
      TSImportType: (/** @type {any} */ node) => check(node.source ?? node.argument?.literal ?? node.argument),
    };
  },
};

const reexportsOnly = {
  meta: { type: 'problem', schema: [] },
  create: (/** @type {any} */ context) => ({
    /** @param {any} node */
    Program(node) {
      for (const statement of node.body) {
        const moves = statement.type === 'ExportAllDeclaration' || statement.type === 'ImportDeclaration';
        if (moves || (statement.type === 'ExportNamedDeclaration' && statement.source)) continue;
        context.report({ node: statement, message: 'src/index.ts holds re-exports only' });
      }
    },
  }),
};

const noUnfinished = {
  meta: { type: 'problem', schema: [] },
  create: (/** @type {any} */ context) => ({
    Program() {
      for (const comment of context.sourceCode.getAllComments()) {
        const marker = /\b(TO-?DO|FIX-?ME|XX-?X)\b/.exec(comment.value)?.[0];
        if (marker) context.report({ node: comment, message: `unfinished work is marked: ${marker}` });
      }
    },
    /** @param {any} node */
    'MemberExpression[property.name=/^(only|skip)$/][object.name=/^(it|test|describe|suite)$/]'(node) {
      context.report({ node, message: 'a focused or skipped test' });
    },
  }),
};

/** Attributes whose text is read by people, or to them. */
const SPOKEN = /\b(?:aria-(?:label|description|valuetext|roledescription|placeholder)|title|alt|placeholder)="([^"]*)"/g;

/** Words of people stand in src/messages, where there may be other languages; a template has none. */
const noLiteralWords = {
  meta: { type: 'problem', schema: [] },
  create: (/** @type {any} */ context) => ({
    /** @param {any} node */
    'TaggedTemplateExpression[tag.name=/^(html|svg)$/]'(node) {
      const text = node.quasi.quasis.map((/** @type {any} */ part) => part.value.raw).join('\0');
      const spoken = [...text.matchAll(SPOKEN)].map(([, value]) => value);
      const shown = text.replace(/<!--[\s\S]*?-->|<\/?[a-z][^>]*>|&\w+;/gi, ' ');
      const word = [...spoken, shown].map((part) => /\p{L}[\p{L} ]*/u.exec(part)?.[0]).find(Boolean);
      if (word) context.report({ node, message: `a template says "${word.trim()}"; words that a person reads are terms of src/messages` });
    },
  }),
};

export default {
  meta: { name: 'modules' },
  rules: { 'one-way': oneWay, 'reexports-only': reexportsOnly, 'no-unfinished': noUnfinished, 'no-literal-words': noLiteralWords },
};
