import type { Level } from '../../src/quality/levels.ts';

/** A number of steps, and the error E that it leaves, see helpers/covered-error.ts. */
export interface FoundSteps {
  readonly steps: number;
  /** The most of each; absent where there are none, or always as many as there can be. */
  readonly substeps?: number;
  readonly error: number;
}

/** Numbers of steps that are tried, each about a tenth more than the one before. */
export function listCounts(max: number, min = 6): number[] {
  const counts: number[] = [];
  for (let steps = min; steps <= max; steps = Math.max(steps + 1, Math.round(steps * 1.1))) counts.push(steps);
  return counts;
}

/** Counts that are passed over at first: each try has about twice the steps of the one before. */
const stride = 8;

/**
 * The fewest steps of a list that keep an error, and whose next do too, as one good number of steps may be luck. Found
 * by doubling, then by bisection; errors do not depend on a clock, so each is measured once.
 * @param errorOf - called with counts of the list
 * @returns null where none of the list does
 */
export async function findFewest(
  counts: readonly number[],
  target: number,
  errorOf: (steps: number) => Promise<number> | number,
): Promise<FoundSteps | null> {
  const isGood = async (i: number): Promise<boolean> => (await errorOf(counts[i])) <= target;
  const last = counts.length - 1;
  let good = 0;
  let bad = -1;
  while (!(await isGood(good))) {
    if (good === last) return null;
    bad = good;
    good = Math.min(good + stride, last);
  }
  while (good - bad > 1) {
    const middle = (good + bad) >> 1;
    if (await isGood(middle)) good = middle;
    else bad = middle;
  }
  while (good < last && !((await isGood(good)) && (await isGood(good + 1)))) good++;
  return (await isGood(good)) ? { steps: counts[good], error: await errorOf(counts[good]) } : null;
}

/** The first of the element's levels that keeps an error; null where none does. */
export async function findLevel(
  levels: readonly Level[],
  target: number,
  errorOf: (level: Level) => Promise<number> | number,
): Promise<FoundSteps | null> {
  for (const level of levels) {
    const error = await errorOf(level);
    if (error <= target) return { ...level, error };
  }
  return null;
}

/** A measurement that is made once for each thing that is asked. */
export function remember<Asked>(measure: (asked: Asked) => Promise<number>): (asked: Asked) => Promise<number> {
  const known = new Map<string, Promise<number>>();
  return (asked) => {
    const key = JSON.stringify(asked);
    let error = known.get(key);
    if (!error) known.set(key, (error = measure(asked)));
    return error;
  };
}
