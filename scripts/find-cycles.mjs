// Finds files that import each other in a cycle. Imports and exports of types count, and so does `import('…')`, in code and in types.
// oxlint's import/no-cycle finds only static imports.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { listImports } from './list-imports.mjs';
import { resolveOwn } from './own-imports.mjs';

/**
 * The files of a list that a file imports.
 * @param {string} file - absolute
 * @param {ReadonlySet<string>} files - absolute
 */
function listTargets(file, files) {
  const found = listImports(file, readFileSync(file, 'utf8')).map(({ value }) => resolveOwn(value, file) ?? '');
  return found.filter((path) => files.has(path));
}

/**
 * One cycle for each group of files that import each other: the shortest path from one of them back to itself.
 * @param {readonly string[]} paths - files of code
 * @returns {string[][]} cycles of absolute paths, each path only once; empty where there is no cycle
 */
export function findCycles(paths) {
  const files = new Set(paths.map((path) => resolve(path)));
  const graph = new Map([...files].map((file) => [file, listTargets(file, files)]));
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
