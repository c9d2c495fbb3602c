import { wholeSteps } from '../optics/cells/substeps.ts';
import type { Substeps } from '../optics/cells/substeps.ts';
import { maxSubsteps } from '../optics/transfer/substep-limits.ts';
import type { Level, LevelCuts } from './levels.ts';

/**
 * Steps of levels with samples in only some of the voxels, as a share of one per voxel. With less than `fewest` steps, a picture shows bands
 * instead of a volume.
 */
const coarse = { shares: [1 / 8, 1 / 6, 1 / 4, 1 / 3, 1 / 2, 1 / Math.SQRT2], fewest: 30 } as const;

/** These levels, and one step per voxel: they are tried first where small things may be lost. @param oneAVoxel - as for `listLevels` */
export function listCoarseLevels(oneAVoxel: number): Level[] {
  return [...coarse.shares, 1]
    .map((share) => ({ steps: Math.ceil(share * oneAVoxel), substeps: 1 }))
    .filter(({ steps }, i) => steps >= coarse.fewest || i === coarse.shares.length);
}

/** How steps of these levels are cut: nowhere, so that small things may be lost. So they need neither the cells' detail nor another program. */
export const uncut: Substeps = { ...wholeSteps, voxelsPerStep: 2 ** -maxSubsteps };

/** The same for all levels. */
export const cutNowhere: LevelCuts = { own: () => uncut, reference: () => uncut };

/**
 * The first of some levels that passes, found by halves: finer levels pass where coarser ones do.
 * @param levels - from the coarsest on
 * @param measure - null where it can't be measured, or is no longer needed
 * @returns null where none passes
 */
export async function findFirst<T>(
  levels: readonly Level[],
  measure: (level: Level) => Promise<T | null>,
  passes: (measured: T) => boolean,
): Promise<{ readonly level: Level; readonly measured: T } | null> {
  let found: { readonly level: Level; readonly measured: T } | null = null;
  for (let [from, to] = [0, levels.length]; from < to;) {
    const middle = (from + to) >> 1;
    const measured = await measure(levels[middle]);
    if (measured === null) return null;
    if (passes(measured)) [found, to] = [{ level: levels[middle], measured }, middle];
    else from = middle + 1;
  }
  return found;
}
