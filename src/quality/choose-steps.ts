import type { ErrorEstimate } from './error-estimate.ts';

/** A number of steps and the error that it has. */
export interface StepChoice {
  readonly steps: number;
  readonly estimate: ErrorEstimate;
}

/** Probes that a choice may take: each costs a few hundredths of a frame. */
const looks = 6;

/** Aim a little below `maxError`, so that one more probe is seldom needed. */
const aim = 0.85;

/** If this share of the steps could be enough, another probe is worth it. */
const worthwhile = 0.8;

/**
 * The smallest number of steps whose picture keeps an error, from estimates and their order of convergence:
 * error = c * steps^-order.
 * @param measure - the estimate for a number of steps
 * @param maxError - root mean square, in 1/255
 * @param limits - where to begin, and the minimum and maximum number of steps
 * @returns the smallest number probed that keeps it; if even the maximum does not, the one with the smallest error
 */
export function chooseSteps(
  measure: (steps: number) => ErrorEstimate,
  maxError: number,
  limits: { readonly begin: number; readonly least: number; readonly most: number },
): StepChoice {
  let best: StepChoice | null = null;
  let steps = Math.min(limits.most, Math.max(limits.least, Math.round(limits.begin)));
  const seen = new Set<number>();
  for (let look = 0; look < looks && !seen.has(steps); look++) {
    seen.add(steps);
    const choice = { steps, estimate: measure(steps) };
    best = better(best, choice, maxError);
    const next = Math.max(limits.least, predict(choice, maxError, limits.most));
    const enough = choice.estimate.rms <= maxError;
    if (enough && next > steps * worthwhile) break;
    steps = next;
  }
  return best!;
}

function better(best: StepChoice | null, choice: StepChoice, maxError: number): StepChoice {
  if (!best) return choice;
  const keeps = choice.estimate.rms <= maxError;
  const kept = best.estimate.rms <= maxError;
  if (keeps !== kept) return keeps ? choice : best;
  if (keeps) return choice.steps < best.steps ? choice : best;
  return choice.estimate.rms < best.estimate.rms ? choice : best;
}

/** Steps at which the error should be just below the target. Rounding to 8 bits stays the same with any number of steps. */
function predict({ steps, estimate }: StepChoice, maxError: number, most: number): number {
  const rounding = Math.max(0, estimate.rms ** 2 - estimate.discretization ** 2);
  const target = Math.sqrt(Math.max((0.1 * maxError) ** 2, (aim * maxError) ** 2 - rounding));
  const factor = (estimate.discretization / target) ** (1 / estimate.order);
  // Far from the target the order is not yet that of the limit, so the change is bounded.
  return Math.min(most, Math.max(1, Math.ceil(steps * Math.min(4, Math.max(0.25, factor)))));
}
