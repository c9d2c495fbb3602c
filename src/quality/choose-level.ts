import { keptError } from './error-estimate.ts';
import type { ErrorEstimate } from './error-estimate.ts';
import type { Level } from './levels.ts';

/** A level, and the error of a picture at this level. */
export interface LevelChoice {
  readonly level: Level;
  readonly estimate: ErrorEstimate;
  /** Whether the error is within the limit. */
  readonly isKept: boolean;
}

/** The next level divides the error by at most this. Levels are skipped only if they cannot be good enough. */
const bestStep = 4;

/** If a level leaves more than this share of the last level's error, it gains nothing. Then another kind of refinement is needed. */
const worthwhile = 0.85;

/** The few worst pixels may be completely wrong at any level. Then the mean error still shows which level is better. */
function isWorthwhile(next: ErrorEstimate, last: ErrorEstimate): boolean {
  return keptError(next) < worthwhile * keptError(last) || next.rms < worthwhile * last.rms;
}

/** The next level with another kind of refinement: more substeps if there are any, else more steps. @returns -1 if there is none */
function findFinerElsewhere(levels: readonly Level[], i: number): number {
  const cut = levels.findIndex(({ substeps }) => substeps > levels[i].substeps);
  return cut >= 0
    ? cut
    : levels.findIndex(({ steps, substeps }) => substeps === levels[i].substeps && steps > levels[i].steps);
}

/**
 * The first level whose error is within a limit; if there is none, the first of those with nearly the smallest error. The choice depends
 * only on the levels and their errors, so that the same view has the same picture, whatever was seen before.
 * @param measure - the estimate for a level; null if it is no longer needed
 * @param maxError - the limit of `keptError`, in 1/255
 * @returns null if the choice was given up
 */
export async function chooseLevel(
  levels: readonly Level[],
  measure: (level: Level) => Promise<ErrorEstimate | null>,
  maxError: number,
): Promise<LevelChoice | null> {
  let best: { level: Level; estimate: ErrorEstimate } | null = null;
  for (let i = 0; i < levels.length;) {
    const estimate = await measure(levels[i]);
    if (!estimate) return null;
    const error = keptError(estimate);
    if (error <= maxError) return { level: levels[i], estimate, isKept: true };
    const isBetter = !best || isWorthwhile(estimate, best.estimate);
    if (isBetter) best = { level: levels[i], estimate };
    const ahead = Math.max(1, Math.floor(Math.log(error / maxError) / Math.log(bestStep)));
    const next = isBetter ? i + ahead : findFinerElsewhere(levels, i);
    if (next < 0 || i === levels.length - 1) break;
    i = Math.min(levels.length - 1, next);
  }
  return { ...best!, isKept: false };
}
