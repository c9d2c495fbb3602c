// The rule of the architecture as a lint rule: which module may import which. Dynamic imports and import types count too;
// `no-restricted-imports` does not check these.
import { relative, sep } from 'node:path';
import { resolveOwn } from './own-imports.mjs';
import { projectRoot } from './shared-data.mjs';

/**
 * Each module, and the modules that it may import from, in addition to itself. `viewer/model` means that folder only.
 * @type {Record<string, string[]>}
 */
export const MAY_IMPORT = {
  core: [],
  page: ['core'],
  messages: ['core'],
  volume: ['core'],
  optics: ['core', 'volume'],
  bricks: ['core', 'volume', 'optics'],
  radar: ['core', 'volume', 'optics'],
  quality: ['core', 'volume', 'optics'],
  formats: ['core', 'volume', 'optics', 'bricks', 'radar'],
  sources: ['core', 'formats'],
  worker: ['core', 'page', 'volume', 'optics', 'bricks', 'radar', 'formats', 'sources'],
  prepare: ['core', 'volume', 'optics', 'bricks', 'radar', 'quality', 'formats', 'sources', 'viewer'],
  packages: ['core', 'sources', 'prepare', 'index'],
  renderer: ['core', 'volume', 'optics', 'bricks', 'quality', 'shaders'],
  'radar/gpu': ['core', 'volume', 'optics', 'radar', 'renderer', 'shaders'],
  'x3d/nodes': ['core', 'page', 'volume', 'optics', 'formats', 'worker', 'viewer/model'],
  x3d: ['core', 'page', 'volume', 'optics', 'radar', 'renderer'],
  panes: ['core', 'page', 'volume', 'optics', 'bricks'],
  editor: ['core', 'page', 'volume', 'optics', 'messages'],
  viewer: [
    'core',
    'page',
    'volume',
    'optics',
    'bricks',
    'radar',
    'quality',
    'formats',
    'sources',
    'worker',
    'renderer',
    'x3d/nodes',
    'panes',
    'messages',
  ],
  components: [
    'core',
    'page',
    'volume',
    'optics',
    'radar',
    'quality',
    'formats',
    'worker',
    'renderer',
    'radar/gpu',
    'x3d',
    'viewer',
    'editor',
    'panes',
    'messages',
  ],
  index: ['core', 'optics', 'quality', 'viewer', 'messages', 'components'],
  classic: ['page', 'index'],
  demos: [
    'core',
    'volume',
    'optics',
    'radar',
    'quality',
    'formats',
    'worker',
    'renderer',
    'radar/gpu',
    'x3d',
    'viewer',
    'components',
    'index',
  ],
};

/**
 * The folders of a module, in their order: a file may import from its own folder and from the folders before it. `.` means the files
 * in the module itself.
 * @type {Record<string, string[]>}
 */
export const FOLDERS = {
  optics: ['transfer', 'rays', 'attachments', 'cells', 'surfaces', '.'],
  formats: [
    'base',
    'codecs',
    'appearance',
    'series',
    'grid-files',
    'hdf5',
    'minc',
    'netcdf',
    'raw',
    'radar',
    'images',
    'video',
    'manifest',
    'nifti',
    'nrrd',
    'metaimage',
    'mgh',
    'dicom',
    'analyze',
    'afni',
    'npy',
    'mrc',
    'tiff',
    'zarr',
    'packed',
    'vti',
    'meshes',
    'terrain',
    'label-tables',
    '.',
  ],
  renderer: ['device', 'textures', 'probes', 'ray', 'passes', 'ray/modules', 'ray/styles', 'layers', 'pictures', '.'],
  viewer: [
    'model',
    'camera',
    'appearance',
    'cuts',
    'overlays',
    'scenes',
    'loading',
    'frames',
    'view',
    'picking',
    'attachments',
    'tools',
    'notes',
    'tours',
    'questions',
    'links',
    'compare',
    'session',
  ],
};

/**
 * Packages that only some modules may import.
 * @type {Record<string, string[]>}
 */
const OWNED_PACKAGES = { lit: ['components', 'packages'], x3dom: ['x3d'], '@shoelace-style': ['messages'] };

/** Modules in the folder of another module. */
const NESTED = ['radar/gpu', 'x3d/nodes'];

/**
 * The module of a file, and its folder there; undefined for files outside all modules (tests, scripts).
 * @param {string} file - absolute
 */
function findPlace(file) {
  const parts = relative(projectRoot, file).split(sep);
  if (parts[0] === 'src') parts.shift();
  const nested = NESTED.find((name) => parts.slice(0, 2).join('/') === name);
  const folder = parts.slice(nested ? 2 : 1, -1).join('/') || '.';
  return { name: nested ?? parts[0].replace(/\.ts$/, ''), folder };
}

/**
 * The error of an import between two folders of the same module, or null.
 * @param {string} name - of the module @param {string} from @param {string} to - folders
 * @param {{ isType: boolean, isDefinition: boolean }} what - isDefinition: it imports a file that defines an element
 */
function findBackArrow(name, from, to, { isType, isDefinition }) {
  if (from === to) return null;
  if (name === 'components') {
    // An element is a folder of its own. Code for several elements is in internal; an element may import from another one only types, and
    // the file that defines it.
    if (isType || to === 'internal' || isDefinition) return null;
    return `components/${from} may not import from components/${to}; it may from: internal, what defines elements, and types from all`;
  }
  const order = FOLDERS[name];
  if (!order) return null;
  const [here, there] = [from, to].map((folder) => order.indexOf(folder));
  if (here >= 0 && there >= 0 && there < here) return null;
  if (here < 0 || there < 0)
    return `${name}/${here < 0 ? from : to} is not among the folders of ${name}: add it to FOLDERS`;
  return `${name}/${from} may not import from ${name}/${to}; it may from: ${order.slice(0, here).join(', ') || 'nowhere'}`;
}

// oxlint passes ESTree nodes; it has no public types with a stable name for them, so we use `any`.

const oneWay = {
  meta: { type: 'problem', schema: [] },
  /** @param {any} context */
  create(context) {
    const file = context.filename;
    const { name: own, folder } = findPlace(file);
    const allowed = MAY_IMPORT[own];
    if (!allowed) return {};
    /** @param {any} source - the string literal, or null for an export without one @param {boolean} isType */
    const check = (source, isType = false) => {
      if (typeof source?.value !== 'string') return;
      const name = source.value;
      const path = resolveOwn(name, file);
      if (path) {
        const target = findPlace(path);
        if (
          target.name !== own &&
          !allowed.includes(target.name) &&
          !allowed.includes(`${target.name}/${target.folder}`)
        ) {
          context.report({
            node: source,
            message: `${own} may not import from ${target.name}; it may from: ${allowed.join(', ') || 'nowhere'}`,
          });
        }
        const problem =
          target.name === own &&
          findBackArrow(own, folder, target.folder, { isType, isDefinition: name.endsWith('/define.ts') });
        if (problem) context.report({ node: source, message: problem });
        return;
      }
      const owners = OWNED_PACKAGES[name.replace(/^@lit\//, 'lit/').split('/')[0]];
      if (owners && !owners.includes(own)) {
        context.report({ node: source, message: `only ${owners.join(' and ')} may import ${name}` });
      }
    };
    return {
      ImportDeclaration: (/** @type {any} */ node) => check(node.source, node.importKind === 'type'),
      ExportNamedDeclaration: (/** @type {any} */ node) => check(node.source, node.exportKind === 'type'),
      ExportAllDeclaration: (/** @type {any} */ node) => check(node.source),
      ImportExpression: (/** @type {any} */ node) => check(node.source),
      TSImportType: (/** @type {any} */ node) => check(node.source ?? node.argument?.literal ?? node.argument, true),
    };
  },
};

/** A name for private use within one object. x3dom's own fields have such names too, and all of them are used in src/x3d. */
const PRIVATE = /^_[a-z]/;

/**
 * Names that begin with an underscore may be read only through `this`. Other code joins the view through its socket, or asks the socket.
 */
const ownPrivates = {
  meta: { type: 'problem', schema: [] },
  /** @param {any} context */
  create(context) {
    const { name } = findPlace(context.filename);
    if (!MAY_IMPORT[name] || name === 'x3d') return {};
    /** @param {any} node @param {any} key - of a member */
    const check = (node, key) => {
      if (key?.type === 'Identifier' && PRIVATE.test(key.name)) {
        context.report({
          node,
          message: `${key.name} is private to its object; a view is joined and asked by socketOf(element), see src/viewer/model/view-socket.ts`,
        });
      }
    };
    return {
      MemberExpression: (/** @type {any} */ node) =>
        node.computed || node.object.type === 'ThisExpression' || check(node, node.property),
      ObjectPattern: (/** @type {any} */ node) =>
        node.properties.forEach((/** @type {any} */ one) => one.computed || check(one, one.key)),
      TSPropertySignature: (/** @type {any} */ node) => check(node, node.key),
      TSMethodSignature: (/** @type {any} */ node) => check(node, node.key),
    };
  },
};

/** A file with more imports than this does several things, or joins what a module is made of. */
const MAX_IMPORTS = 20;

/** The roots of modules, which join their parts, and may import from more files. */
const ROOTS = [
  'components/volume-slice-view/volume-slice-view.ts', // the element: its file, its view, its picture, its marks
  'demos/accuracy/study-gl.ts', // draws pictures of the study without a view: it joins the renderer's parts itself
  'src/renderer/layers/volume-layer.ts', // all that draws one volume
  'src/viewer/view/viewer.ts', // camera, frames, quality and scene of a view
  'src/x3d/scene.ts', // x3dom's scene: its canvas, camera, lights, shapes and layers
];

const fewImports = {
  meta: { type: 'problem', schema: [] },
  create: (/** @type {any} */ context) => ({
    /** @param {any} node */
    Program(node) {
      const file = relative(projectRoot, context.filename).split(sep).join('/');
      if (!MAY_IMPORT[findPlace(context.filename).name] || ROOTS.includes(file)) return;
      const sources = new Set(node.body.map((/** @type {any} */ one) => one.source?.value).filter(Boolean));
      if (sources.size > MAX_IMPORTS) {
        context.report({
          node: node.body[0],
          message: `${file} imports from ${sources.size} files; at most ${MAX_IMPORTS} are allowed: divide it, or add it to ROOTS if it joins the parts of a module`,
        });
      }
    },
  }),
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

/** Attributes whose text people read, or screen readers read aloud. */
const SPOKEN =
  /\b(?:aria-(?:label|description|valuetext|roledescription|placeholder)|title|alt|placeholder)="([^"]*)"/g;

/** Texts for people belong in src/messages, where they can be translated; a template contains none. */
const noLiteralWords = {
  meta: { type: 'problem', schema: [] },
  create: (/** @type {any} */ context) => ({
    /** @param {any} node */
    'TaggedTemplateExpression[tag.name=/^(html|svg)$/]'(node) {
      const text = node.quasi.quasis.map((/** @type {any} */ part) => part.value.raw).join('\0');
      const spoken = [...text.matchAll(SPOKEN)].map(([, value]) => value);
      const shown = text.replace(/<!--[\s\S]*?-->|<\/?[a-z][^>]*>|&\w+;/gi, ' ');
      const word = [...spoken, shown].map((part) => /\p{L}[\p{L} ]*/u.exec(part)?.[0]).find(Boolean);
      if (word)
        context.report({
          node,
          message: `a template says "${word.trim()}"; words that a person reads are messages of src/messages`,
        });
    },
  }),
};

export default {
  meta: { name: 'modules' },
  rules: {
    'one-way': oneWay,
    'few-imports': fewImports,
    'reexports-only': reexportsOnly,
    'own-privates': ownPrivates,
    'no-unfinished': noUnfinished,
    'no-literal-words': noLiteralWords,
  },
};
