import { findDetail } from '../optics/cells/cell-detail.ts';
import type { SeenVolume } from '../optics/cells/cell-detail.ts';
import { allSubsteps } from '../optics/cells/substeps.ts';
import { maxSubsteps } from '../optics/transfer/substep-limits.ts';
import type { StepCode, Substeps } from '../optics/cells/substeps.ts';
import { maxAutoSteps } from './steps.ts';

/** How finely the rays of a picture are sampled. */
export interface Level {
  /** Number of steps along the longest ray. */
  readonly steps: number;
  /** The largest number of substeps that a step is cut into where much may be visible. */
  readonly substeps: number;
}

/**
 * Steps as a multiple of one per voxel, and the largest number of substeps of each. Steps are cut by the samples at their ends only if two
 * and four times as many steps are not enough: more steps take less time and leave smaller errors, see docs/numbers/benchmark.md.
 */
const shares: readonly (readonly [number, number])[] = [
  [1, 1],
  [2, 1],
  [4, 1],
  [1, maxSubsteps],
  [2, maxSubsteps],
  [4, maxSubsteps],
];

/** A volume with few voxels has one more level, as long as it needs no more steps than large volumes have at the level before. */
const finest = { share: 8, max: 2048 } as const;

/**
 * The levels from which one is chosen for a picture at rest, from the coarsest on. Each takes a sample in every voxel: else all rays
 * would miss small things alike, and no probe could show that.
 * @param oneAVoxel - number of steps along the longest ray with one per voxel
 * @param cutsSteps - whether substeps make any difference
 */
export function listLevels(oneAVoxel: number, cutsSteps = true): Level[] {
  const all = finest.share * oneAVoxel <= finest.max ? [...shares, [finest.share, maxSubsteps] as const] : shares;
  const levels = all.map(([share, substeps]) => ({
    steps: Math.min(maxAutoSteps, Math.ceil(oneAVoxel * share)),
    substeps: cutsSteps ? substeps : 1,
  }));
  return levels.filter(
    ({ steps, substeps }, i) => levels.findIndex((one) => one.steps === steps && one.substeps === substeps) === i,
  );
}

/** By the bound, a single thing may lose this many times `max-error`. Real losses are far below the bound: see docs/numbers/accuracy.md. */
const lostPerError = 10;

/**
 * How the steps of a level are cut: by the level's substeps and, in cells where a thing could be lost, as finely as needed.
 * @param oneAVoxel - number of steps along the longest ray with one per voxel; it may be above the largest number allowed
 * @param maxError - 1/255
 */
export function cutSteps({ steps, substeps }: Level, oneAVoxel: number, maxError: number): Substeps {
  return { max: substeps, voxelsPerStep: oneAVoxel / steps, mayLose: (lostPerError * maxError) / 255, findDetail };
}

/** How the steps of a picture at rest are cut, and those of the finer pictures that it is compared with. */
export interface LevelCuts {
  readonly own: (level: Level) => Substeps;
  readonly reference: (level: Level) => Substeps;
}

/** The error by which the steps of a reference are cut, where the author requires none. */
const usualError = 1;

const findLong = (seen: SeenVolume, mayLose: number): Uint8Array => findDetail(seen, mayLose, true);

/** From this error on, 1/255, steps may be longer than a voxel: below, there are hardly any cells that allow it. */
const longFrom = 2;

/**
 * The one place where `max-error` says how steps are cut.
 * @param oneAVoxel - as for `cutSteps`
 * @param maxError - 1/255; null where the author gives the steps: then only the values at their ends cut them
 * @param long - for steps that are longer than a voxel; they are not cut by the values at their ends
 */
export function cutsOfLevels(oneAVoxel: number, maxError: number | null, long?: StepCode): LevelCuts {
  const reference = (level: Level): Substeps => ({
    ...cutSteps(level, oneAVoxel, maxError ?? usualError),
    ...(long && level.substeps === 1 && (maxError ?? 0) >= longFrom ? { long, findDetail: findLong } : {}),
  });
  return { own: maxError === null ? ({ substeps }) => ({ ...allSubsteps, max: substeps }) : reference, reference };
}
