/** A number of steps, and the error that it leaves: RMS, 1/255. */
export interface FoundSteps {
  readonly steps: number;
  readonly error: number;
}

/** Numbers of steps that are tried, each about a tenth more than the one before. */
export function listCounts(most: number): number[] {
  const counts: number[] = [];
  for (let steps = 6; steps <= most; steps = Math.max(steps + 1, Math.round(steps * 1.1))) counts.push(steps);
  return counts;
}

/** Counts that are passed over at first: each try has about twice the steps of the one before. */
const stride = 8;

/**
 * The fewest steps of a list that keep an error, and whose next do too, as one good number of steps may be luck. Found
 * by doubling, then by bisection; errors do not depend on a clock, so each is measured once.
 * @param errorOf - RMS, 1/255; called with counts of the list
 * @returns null where none of the list does
 */
export async function findFewest(
  counts: readonly number[], target: number, errorOf: (steps: number) => Promise<number> | number,
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

/** A function of a number that is asked once for each. */
export function remember(measure: (steps: number) => Promise<number>): (steps: number) => Promise<number> {
  const known = new Map<number, Promise<number>>();
  return (steps) => {
    let error = known.get(steps);
    if (!error) known.set(steps, (error = measure(steps)));
    return error;
  };
}
