// Which voxels hang together: runs of them along rows, joined where they touch.
import type { Vector3 } from './matrix.ts';

/** A run takes 12 bytes, so these are 192 MiB. A volume of as many runs is noise, of which no part is the largest in any useful sense. */
export const maxRuns = 2 ** 24;

/** Parts of less than this share of the largest one are hidden. */
export const keptShare = 0.1;

/** What was found of the parts of a volume. */
export interface SmallParts {
  /** Parts that are hidden, and their voxels. */
  readonly parts: number;
  readonly voxels: number;
  /** Calls back for each of their runs: indices of the first voxel, and of the one behind the last. */
  visit(visitor: (first: number, end: number) => void): void;
}

/**
 * The parts of a volume that touch neither the largest one nor another of at least `keptShare` of its voxels. Voxels touch by their faces, not by edges
 * and corners. Source: Rosenfeld and Pfaltz 1966, on runs; union-find with halved paths.
 * @param counts - whether a voxel belongs to any part, by its index, i fastest
 * @returns null where there are more than `most` runs
 */
export function findSmallParts(
  [nx, ny, nz]: Vector3,
  counts: (voxel: number) => boolean,
  max = maxRuns,
): SmallParts | null {
  const rows = ny * nz;
  const begins = new Int32Array(rows + 1);
  for (let row = 0; row < rows; row++) {
    begins[row + 1] = begins[row] + countRuns(row * nx, nx, counts);
    if (begins[row + 1] > max) return null;
  }
  const total = begins[rows];
  const runs: Runs = { firsts: new Int32Array(total), ends: new Int32Array(total), parents: new Int32Array(total) };
  for (let row = 0; row < rows; row++) {
    fillRuns(runs, begins[row], { first: row * nx, end: (row + 1) * nx }, counts);
    if (row % ny > 0) joinRows(runs, begins, row, { before: row - 1, apart: nx });
    if (row >= ny) joinRows(runs, begins, row, { before: row - ny, apart: nx * ny });
  }
  return chooseSmall(runs);
}

/** `parents` of a run: a run of the same part, before it; its own index where there is none. */
interface Runs {
  readonly firsts: Int32Array;
  readonly ends: Int32Array;
  readonly parents: Int32Array;
}

function countRuns(first: number, length: number, counts: (voxel: number) => boolean): number {
  let found = 0;
  for (let voxel = first, was = false; voxel < first + length; voxel++) {
    const is = counts(voxel);
    if (is && !was) found++;
    was = is;
  }
  return found;
}

function fillRuns(
  { firsts, ends, parents }: Runs,
  at: number,
  { first, end }: { readonly first: number; readonly end: number },
  counts: (voxel: number) => boolean,
): void {
  let run = at - 1;
  for (let voxel = first, was = false; voxel < end; voxel++) {
    const is = counts(voxel);
    if (is && !was) {
      run++;
      firsts[run] = voxel;
      parents[run] = run;
    }
    if (is) ends[run] = voxel + 1;
    was = is;
  }
}

/** Join the runs of a row with those of one before it that they touch. @param apart - voxels from one row to the other */
function joinRows(
  { firsts, ends, parents }: Runs,
  begins: Int32Array,
  row: number,
  { before, apart }: { readonly before: number; readonly apart: number },
): void {
  let [a, b] = [begins[before], begins[row]];
  while (a < begins[before + 1] && b < begins[row + 1]) {
    if (firsts[a] + apart < ends[b] && firsts[b] < ends[a] + apart) join(parents, a, b);
    if (ends[a] + apart < ends[b]) a++;
    else b++;
  }
}

function join(parents: Int32Array, a: number, b: number): void {
  const [x, y] = [rootOf(parents, a), rootOf(parents, b)];
  if (x < y) parents[y] = x;
  else parents[x] = y;
}

function rootOf(parents: Int32Array, run: number): number {
  let at = run;
  while (parents[at] !== at) at = parents[at] = parents[parents[at]];
  return at;
}

function chooseSmall({ firsts, ends, parents }: Runs): SmallParts {
  const sizes = new Float64Array(parents.length);
  let largest = 0;
  for (let run = 0; run < parents.length; run++) {
    const root = rootOf(parents, run);
    sizes[root] += ends[run] - firsts[run];
    if (sizes[root] > largest) largest = sizes[root];
  }
  const isSmall = (run: number): boolean => sizes[rootOf(parents, run)] < keptShare * largest;
  let [parts, voxels] = [0, 0];
  for (let run = 0; run < parents.length; run++) {
    if (parents[run] !== run || !isSmall(run)) continue;
    parts++;
    voxels += sizes[run];
  }
  return {
    parts,
    voxels,
    visit: (visitor) => {
      for (let run = 0; run < parents.length; run++) if (isSmall(run)) visitor(firsts[run], ends[run]);
    },
  };
}
