// Finds files that import each other in a cycle. Imports and exports of types count, and so does `import('…')`, in code and in types.
// oxlint's import/no-cycle finds only static imports.
import { readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { parseSync } from 'vite';

const IMPORTS = new Set([
  'ImportDeclaration',
  'ExportNamedDeclaration',
  'ExportAllDeclaration',
  'ImportExpression',
  'TSImportType',
]);

/**
 * The specifiers of all imports in a node of a syntax tree and its children.
 * @param {any} node
 * @returns {string[]}
 */
function listSpecifiers(node) {
  if (node === null || typeof node !== 'object') return [];
  const own = IMPORTS.has(node.type) && typeof node.source?.value === 'string' ? [node.source.value] : [];
  return [...own, ...Object.values(node).flatMap(listSpecifiers)];
}

/**
 * The files of a list that a file imports.
 * @param {string} file - absolute
 * @param {ReadonlySet<string>} files - absolute
 */
function listImports(file, files) {
  const { program, errors } = parseSync(file, readFileSync(file, 'utf8'));
  if (errors.length > 0) throw new Error(`${file} cannot be read: ${errors[0].message}`);
  const relative = listSpecifiers(program).filter((specifier) => specifier.startsWith('.'));
  const found = relative.map((specifier) => resolve(dirname(file), specifier.replace(/\?.*$/, '')));
  return found.filter((path) => files.has(path));
}

/**
 * One cycle for each group of files that import each other: the shortest path from one of them back to itself.
 * @param {readonly string[]} paths - files of code
 * @returns {string[][]} cycles of absolute paths, each path only once; empty where there is no cycle
 */
export function findCycles(paths) {
  const files = new Set(paths.map((path) => resolve(path)));
  const graph = new Map([...files].map((file) => [file, listImports(file, files)]));
  const reported = new Set();
  const cycles = [];
  for (const file of graph.keys()) {
    const cycle = reported.has(file) ? undefined : findWayBack(file, graph);
    if (!cycle) continue;
    cycles.push(cycle);
    for (const one of cycle) reported.add(one);
  }
  return cycles;
}

/**
 * @param {string} start
 * @param {ReadonlyMap<string, readonly string[]>} graph
 * @returns {string[] | undefined} the files of the shortest cycle through `start`, in the order of their imports
 */
function findWayBack(start, graph) {
  /** @type {Map<string, string>} */
  const from = new Map();
  const queue = [start];
  for (const file of queue) {
    for (const next of graph.get(file) ?? []) {
      if (next === start) {
        const ring = [file];
        while (ring[0] !== start) ring.unshift(/** @type {string} */ (from.get(ring[0])));
        return ring;
      }
      if (from.has(next)) continue;
      from.set(next, file);
      queue.push(next);
    }
  }
  return undefined;
}
