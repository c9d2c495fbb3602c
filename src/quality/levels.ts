import { findDetail } from '../optics/cells/cell-detail.ts';
import { maxSubsteps } from '../optics/transfer/substep-limits.ts';
import type { Substeps } from '../optics/cells/substeps.ts';
import { maxAutoSteps } from './steps.ts';

/** How finely the rays of a picture are sampled. */
export interface Level {
  /** Along the longest ray. */
  readonly steps: number;
  /** The most that a step is cut into where much may be seen on it. */
  readonly substeps: number;
}

/**
 * Steps as a multiple of one a voxel, and the most substeps of each. Steps are cut by what is at their ends only where twice and four times as many are
 * not enough: these take less time and leave less, see docs/benchmark.md.
 */
const shares: readonly (readonly [number, number])[] = [[1, 1], [2, 1], [4, 1], [1, maxSubsteps], [2, maxSubsteps], [4, maxSubsteps]];

/** Where voxels are few there is one more level: no more steps than pictures of large volumes have at the one before. */
const finest = { share: 8, most: 2048 } as const;

/**
 * The levels that a picture at rest is chosen from, from the coarsest on. None crosses a voxel without a sample: what is
 * small would be missed by all rays alike, and no probe of them could tell.
 * @param oneAVoxel - steps along the longest ray of one a voxel
 * @param cutsSteps - whether substeps make any difference
 */
export function listLevels(oneAVoxel: number, cutsSteps = true): Level[] {
  const all = finest.share * oneAVoxel <= finest.most ? [...shares, [finest.share, maxSubsteps] as const] : shares;
  const levels = all.map(([share, substeps]) => ({ steps: Math.min(maxAutoSteps, Math.ceil(oneAVoxel * share)), substeps: cutsSteps ? substeps : 1 }));
  return levels.filter(({ steps, substeps }, i) => levels.findIndex((one) => one.steps === steps && one.substeps === substeps) === i);
}

/** Of a single thing so many times `max-error` may be lost by the bound, which is far from reached: see docs/accuracy.md. */
const lostPerError = 10;

/**
 * How the steps of a level are cut: as it says, and cells in which a thing could be lost as finely as it takes.
 * @param oneAVoxel - steps along the longest ray of one a voxel, more than there may be among them
 * @param maxError - 1/255
 */
export function cutSteps({ steps, substeps }: Level, oneAVoxel: number, maxError: number): Substeps {
  return { most: substeps, voxelsPerStep: oneAVoxel / steps, mayLose: (lostPerError * maxError) / 255, findDetail };
}
