import { keptError } from './error-estimate.ts';
import type { ErrorEstimate } from './error-estimate.ts';
import type { Level } from './levels.ts';

/** A level and the error that it leaves. */
export interface LevelChoice {
  readonly level: Level;
  readonly estimate: ErrorEstimate;
  /** Whether the error is kept. */
  readonly isKept: boolean;
}

/** By no more than this does the next level divide the error: levels are left out only where they could not be enough. */
const bestStep = 4;

/** A level that leaves more than this of the last one's error gains nothing: it has to be finer otherwise. */
const worthwhile = 0.85;

/** Where the few worst pixels are as wrong as can be, at any level, the mean still tells which is better. */
function isWorthwhile(next: ErrorEstimate, last: ErrorEstimate): boolean {
  return keptError(next) < worthwhile * keptError(last) || next.rms < worthwhile * last.rms;
}

/** The next level that is finer otherwise than the ones before: more substeps where there are some, else more steps. @returns -1 where there is none */
function findFinerOtherwise(levels: readonly Level[], i: number): number {
  const cut = levels.findIndex(({ substeps }) => substeps > levels[i].substeps);
  return cut >= 0 ? cut : levels.findIndex(({ steps, substeps }) => substeps === levels[i].substeps && steps > levels[i].steps);
}

/**
 * The first level that keeps an error; where none does, the first of those with nearly the smallest. It depends on the
 * levels and their errors alone, so that the same view has the same picture whatever was seen before.
 * @param measure - the estimate for a level; null where it is not wanted any more
 * @param maxError - as `keptError` has it, 1/255
 * @returns null where it was given up
 */
export async function chooseLevel(
  levels: readonly Level[], measure: (level: Level) => Promise<ErrorEstimate | null>, maxError: number,
): Promise<LevelChoice | null> {
  let best: { level: Level; estimate: ErrorEstimate } | null = null;
  for (let i = 0; i < levels.length; ) {
    const estimate = await measure(levels[i]);
    if (!estimate) return null;
    const error = keptError(estimate);
    if (error <= maxError) return { level: levels[i], estimate, isKept: true };
    const isBetter = !best || isWorthwhile(estimate, best.estimate);
    if (isBetter) best = { level: levels[i], estimate };
    const ahead = Math.max(1, Math.floor(Math.log(error / maxError) / Math.log(bestStep)));
    const next = isBetter ? i + ahead : findFinerOtherwise(levels, i);
    if (next < 0 || i === levels.length - 1) break;
    i = Math.min(levels.length - 1, next);
  }
  return { ...best!, isKept: false };
}
