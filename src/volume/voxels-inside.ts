import type { CartesianGrid } from './grid.ts';
import { invertAffine, transformPoint } from './matrix.ts';
import type { Matrix4, Vector3 } from './matrix.ts';
import type { IndexedSamples } from './index-numbers.ts';
import { boundsOf, contains, cutLine } from './solid.ts';
import type { Solid } from './solid.ts';
import { Tally } from './statistics.ts';
import type { Statistics } from './statistics.ts';
import type { VolumeData } from './volume.ts';

/** The parts of a volume that are needed. */
type Block = Pick<VolumeData, 'samples' | 'slope' | 'intercept' | 'ids' | 'indexed'> & { readonly grid: CartesianGrid };

/** The eight corners of a voxel, from its centre, in voxels. */
const voxelCorners = [0, 1, 2, 3, 4, 5, 6, 7].map((c): Vector3 => [
  (c & 1) - 0.5,
  ((c >> 1) & 1) - 0.5,
  (c >> 2) - 0.5,
]);

/** Tolerance: corners on the surface count as inside in spite of rounding. */
const rounding = 1e-6;

/**
 * Statistics of the voxels whose centres are inside a solid of the world, on any affine grid. Each step of the
 * generator is a row of slices, so that the caller may pause in between.
 */
export function* sumUpVoxels(
  {
    grid,
    samples,
    slope,
    intercept,
    ids,
    indexed = ids && { samples: samples as IndexedSamples['samples'], ids },
  }: Block,
  solid: Solid,
): Generator<void, Statistics> {
  const {
    dimensions: [columns, rows],
    indexToWorld,
  } = grid;
  const [low, high] = rangeOf(grid, boundsOf(solid));
  const tally = new Tally();
  tally.addCut(0);
  for (let k = low[2]; k <= high[2]; k++) {
    for (let j = low[1]; j <= high[1]; j++) {
      const run = findRun(indexToWorld, solid, [j, k], [low[0], high[0]]);
      if (!run) continue;
      const row = columns * (j + rows * k);
      const [first, end] = [row + run[0], row + run[1] + 1];
      // The file's own whole numbers, if the samples round them or index them.
      if (indexed)
        tally.add(
          Array.from(indexed.samples.subarray(first, end), (place, i) =>
            Number.isNaN(samples[first + i]) ? NaN : indexed.ids[place],
          ),
          0,
          end - first,
        );
      else tally.add(samples, first, end);
      tally.addCut(run[1] - run[0] + 1 - countWhole(indexToWorld, solid, [j, k], run));
    }
    yield;
  }
  return tally.finish(indexed ? { slope: 1, intercept: 0 } : { slope, intercept });
}

/** First and last index along each axis that can be inside a box of the world. */
function rangeOf(
  { dimensions, indexToWorld }: CartesianGrid,
  [low, high]: readonly [Vector3, Vector3],
): readonly [low: number[], high: number[]] {
  const toIndex = invertAffine(indexToWorld)!; // The inverse exists: it was checked when the volume was loaded.
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((c) =>
    transformPoint(toIndex, [c & 1 ? high[0] : low[0], c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2]]),
  );
  const along = (axis: number): number[] => corners.map((corner) => corner[axis]);
  return [
    [0, 1, 2].map((axis) => Math.max(0, Math.ceil(Math.min(...along(axis)) - rounding))),
    [0, 1, 2].map((axis) => Math.min(dimensions[axis] - 1, Math.floor(Math.max(...along(axis)) + rounding))),
  ];
}

const axisOf = (m: Matrix4): Vector3 => [m[0], m[4], m[8]];

/** First and last voxel of a row whose centres are inside. A solid is convex, so all between them are inside too. */
function findRun(
  m: Matrix4,
  solid: Solid,
  [j, k]: readonly [number, number],
  [low, high]: readonly [number, number],
): readonly [number, number] | null {
  const cut = cutLine(solid, transformPoint(m, [0, j, k]), axisOf(m));
  if (!cut) return null;
  let [first, last] = [Math.max(low, Math.ceil(cut[0] - rounding)), Math.min(high, Math.floor(cut[1] + rounding))];
  while (first <= last && !contains(solid, transformPoint(m, [first, j, k]))) first++;
  while (first <= last && !contains(solid, transformPoint(m, [last, j, k]))) last--;
  return first <= last ? [first, last] : null;
}

/** How many voxels of a run have all their corners inside, and so lie inside entirely. */
function countWhole(
  m: Matrix4,
  solid: Solid,
  [j, k]: readonly [number, number],
  run: readonly [number, number],
): number {
  let [first, last] = run;
  for (const [x, y, z] of voxelCorners) {
    const cut = cutLine(solid, transformPoint(m, [x, j + y, k + z]), axisOf(m));
    if (!cut) return 0;
    first = Math.max(first, Math.ceil(cut[0] - rounding));
    last = Math.min(last, Math.floor(cut[1] + rounding));
  }
  return Math.max(0, last - first + 1);
}
