import type { Substeps } from '../optics/cells/substeps.ts';
import { maxSubsteps } from '../optics/transfer/substep-limits.ts';
import type { Level, LevelCuts } from './levels.ts';

/**
 * Steps of levels with samples in only some of the voxels, as a share of one per voxel. With less than `fewest` steps, a picture shows bands
 * instead of a volume.
 */
const coarse = { shares: [1 / 8, 1 / 6, 1 / 4, 1 / 3, 1 / 2, 1 / Math.SQRT2], fewest: 30 } as const;

/** These levels: they are tried first where small things may be lost. @param oneAVoxel - as for `listLevels` */
export function listCoarseLevels(oneAVoxel: number): Level[] {
  return coarse.shares
    .map((share) => ({ steps: Math.ceil(share * oneAVoxel), substeps: 1 }))
    .filter(({ steps }) => steps >= coarse.fewest);
}

/** How steps of these levels are cut: not at all, so that small things may be lost. @param usual - how those of other levels are */
export function cutsOfCoarse({ reference }: LevelCuts): LevelCuts {
  const own = (level: Level): Substeps => ({ ...reference(level), voxelsPerStep: 2 ** -maxSubsteps });
  return { own, reference };
}
