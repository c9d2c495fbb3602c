// What coarse bricks do to rays that show their first local extreme: hidden values are drawn at random, and each time it is looked where the ray would end.
import type { Found, Look, Spread, Step } from './extreme-steps.ts';

/** So often are the hidden values of a ray drawn. */
const trials = 8;

/** Values of one step that are drawn at most. */
const mostDraws = 4;

/** Where a ray ends. */
export interface RayEnd {
  readonly value: number;
  /** Undefined where it met no data. */
  readonly step: Step | undefined;
}

/** Looks for the first local maximum from a value on, or the largest of all where none reaches it. Twin of `seekExtreme`. */
class EndFinder implements RayEnd {
  value = -Infinity;
  step: Step | undefined = undefined;

  constructor(readonly threshold: number) {}

  /** @returns whether the ray has ended before this value; -Infinity for no data */
  meet(value: number, step: Step): boolean {
    if (this.value >= this.threshold && value < this.value && value > -Infinity) return true;
    if (value > this.value) [this.value, this.step] = [value, step];
    return false;
  }
}

/** Where a ray ends by what is shown. */
export function firstShown(steps: readonly Step[], threshold: number): RayEnd {
  const end = new EndFinder(threshold);
  steps.some((step) => end.meet(step.value, step));
  return end;
}

/**
 * What is expected of a ray that shows its first maximum from the threshold on. The same ray gives the same.
 * @param shown - from `firstShown`
 * @param number - of the ray: others have other hidden values
 */
export function weighFirst(
  steps: readonly Step[],
  { threshold, shown, number }: { readonly threshold: number; readonly shown: RayEnd; readonly number: number },
  lookOf: Look,
): Found {
  const looksNow = lookOf(shown.value);
  const isSeen = looksNow[3] > 0;
  const difference = (value: number): number => lookOf(value).reduce((sum, x, c) => sum + (x - looksNow[c]) ** 2, 0);
  const energies = new Map<number, number>();
  const without = new Map<number, number>();
  let [energy, cover] = [0, 0];
  /** It is due to the step where the ray ends; or, if that is known, to the one where it seems to. */
  const give = (into: Map<number, number>, { step, value }: RayEnd, hasSpread: (step: Step) => boolean): number => {
    const share = value === shown.value ? 0 : difference(value) / trials;
    const due = step && hasSpread(step) ? step : shown.step;
    if (due && share > 0) into.set(due.cell, (into.get(due.cell) ?? 0) + share);
    return share;
  };
  for (let trial = 0; trial < trials; trial++) {
    const seed = trials * number + trial + 1;
    const now = draw(steps, threshold, seed, (step) => step.now);
    energy += give(energies, now, (step) => step.now !== null);
    cover += isSeen ? 1 / trials : lookOf(now.value)[3] / trials;
    if (steps.every((step) => step.without === step.now)) continue;
    give(
      without,
      draw(steps, threshold, seed, (step) => step.without),
      (step) => step.without !== null,
    );
  }
  const cells = new Map<number, Step[]>();
  for (const step of steps) {
    const own = cells.get(step.cell);
    if (own) own.push(step);
    else cells.set(step.cell, [step]);
  }
  return {
    energy,
    cover,
    cells: [...cells].map(([cell, own]) => ({
      steps: own,
      energy: energies.get(cell) ?? 0,
      loss: Math.max(0, (without.get(cell) ?? 0) - (energies.get(cell) ?? 0)),
    })),
  };
}

/** Draws the hidden values of a ray until it ends. */
function draw(
  steps: readonly Step[],
  threshold: number,
  seed: number,
  spreadOf: (step: Step) => Spread | null,
): RayEnd {
  const random = randomNumbers(seed);
  const kept = { box: 0, peak: 0, isPeak: false };
  const end = new EndFinder(threshold);
  for (const step of steps) {
    const spread = spreadOf(step);
    const count = spread ? Math.min(mostDraws, Math.max(1, Math.round(spread.peakDraws))) : 1;
    const [ofBox, ofPeak] = spread ? [spread.draws / count, spread.peakDraws / count] : [0, 0];
    for (let n = 0; n < count; n++) {
      // Neighbours go together where a step is shorter than what is hidden.
      if (spread && random() < ofBox) kept.box = 2 * random() - 1;
      if (spread && random() < ofPeak) {
        kept.isPeak = random() < 1 - (1 - spread.peaks) ** Math.max(1, ofPeak);
        kept.peak = random() * random();
      }
      const one = spread ? valueIn(spread, step.value, kept) : step.value;
      if (end.meet(one, step)) return end;
    }
  }
  return end;
}

/** The share t of a peak's height is exceeded with the probability 1 - t + t ln t, as by the product of two even numbers. */
function valueIn(
  { low, high, center, width, max }: Spread,
  shown: number,
  { box, peak, isPeak }: { readonly box: number; readonly peak: number; readonly isPeak: boolean },
): number {
  if (shown === -Infinity && !isPeak) return -Infinity;
  return Math.min(high, Math.max(low, center + (isPeak ? peak * max : box * width)));
}

/** Even numbers from 0 to 1. Source: Park and Miller 1988, the minimal standard generator. */
function randomNumbers(seed: number): () => number {
  let state = seed * 7919;
  return () => (state = (state * 48271) % 0x7fffffff) / 0x7fffffff;
}
