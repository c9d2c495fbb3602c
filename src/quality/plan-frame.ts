import { allRays } from './adaptive-sampling.ts';
import type { SamplingOutcome } from './adaptive-sampling.ts';
import type { TimeModel } from './time-model.ts';

/** How the error of a picture depends on what is spent on it, in 1/255 RMS. */
export interface ErrorModel {
  /** Error of the sampling: at `steps` it is `error`, and it falls with the power `order` of the steps. */
  readonly steps: number;
  readonly error: number;
  readonly order: number;
  /** Error of a picture with half as many pixels across and down, blown up again. */
  readonly atHalf: number;
  /** What thinning the rays does to a picture at full size, half of it across and down, and a quarter. */
  readonly sampling: readonly (readonly SamplingOutcome[])[];
}

/** What is drawn in one frame. */
export interface FramePlan {
  /** Pixels across, as a share of the full picture's. */
  readonly scale: number;
  readonly steps: number;
  readonly sampling: SamplingOutcome;
}

/** Before anything was measured: pictures at 64 steps and at half their size that are off by a little. */
export const unknownErrors: ErrorModel = { steps: 64, error: 6, order: 1.5, atHalf: 4, sampling: [] };

/** Shares of the pixels across that are tried, from all. */
const scales = [1, 0.85, 0.7, 0.6, 0.5, 0.42, 0.35, 0.3, 0.25] as const;

/** Shares that only a large picture gets, and only where there is no time for more: edges show steps. */
const smallScales = [0.25, 0.2, 0.16, 0.125] as const;

/** Of the time that is planned for, what a frame may take before a smaller one of these is drawn. */
const slack = 1.2;

/** Fewer steps than this show bands instead of a volume. */
const minSteps = 12;

/** A picture keeps as many pixels as a square with such sides has. */
const minPixels = 112 ** 2;

/** Fewer rays than this share of the full picture's pixels show blots: those of the smallest of these pictures. */
const minRays = scales[scales.length - 1] ** 2;

/** Another scale than the last frame's has to make the error so much less: pictures that jump in size distract. */
const worthChanging = 0.85;

/** The error of the sampling that so many steps leave. */
export function errorOfSteps(model: ErrorModel, steps: number): number {
  return model.error * (model.steps / steps) ** model.order;
}

/** Sampling, size and thinning together. */
export function errorOfPlan(model: ErrorModel, { scale, steps, sampling }: FramePlan): number {
  return Math.hypot(errorOfSteps(model, steps), model.atHalf * (1 / scale - 1), sampling.error);
}

/** What interpolating a pixel, and finding out whether it needs a ray, costs: steps of a ray. */
const stepsPerProbe = 3;

/** What a ray costs besides its steps. */
const stepsPerRay = 4;

/** Pixels times steps that a plan takes. @param pixels - of the full picture */
export function workOfPlan({ scale, steps, sampling }: FramePlan, pixels: number): number {
  return pixels * scale ** 2 * stepsPerPixel(steps, sampling);
}

function stepsPerPixel(steps: number, sampling: SamplingOutcome): number {
  return sampling.share * (steps + stepsPerRay) + (sampling.maxCurvature > 0 ? stepsPerProbe : 0);
}

/** Where there is time for nothing better: as many pixels as can be with the fewest steps, then as many steps as can be. */
function cheapestPlan(time: TimeModel, full: Full, { budgetMs, last }: Budget): FramePlan {
  const fewest = Math.min(minSteps, full.steps);
  const planOf = (scale: number, steps = fewest): FramePlan => ({ scale, steps, sampling: allRays });
  const fits = (scale: number): boolean => {
    const limit = last && scale > last.scale ? budgetMs : slack * budgetMs;
    return time.a + time.b * workOfPlan(planOf(scale), full.pixels) <= limit;
  };
  const possible = smallScales.filter((scale) => scale === smallScales[0] || scale ** 2 * full.pixels >= minPixels);
  const scale = possible.find(fits) ?? possible[possible.length - 1];
  return planOf(scale, Math.max(fewest, maxSteps(time, full, { scale, sampling: allRays, budgetMs })));
}

/** As many steps as a frame's time allows, and no more than a picture at rest has. */
function maxSteps(time: TimeModel, full: Full, { scale, sampling, budgetMs }: { scale: number; sampling: SamplingOutcome; budgetMs: number }): number {
  const each = Math.max(0, budgetMs - time.a) / time.b / (full.pixels * scale ** 2) - (sampling.maxCurvature > 0 ? stepsPerProbe : 0);
  return Math.min(full.steps, Math.floor(each / sampling.share - stepsPerRay));
}

/** What thinning does to a picture of a scale: as foretold for the nearest of those that were looked at. */
function outcomesAt({ sampling }: ErrorModel, scale: number): readonly SamplingOutcome[] {
  const halvings = Math.round(-Math.log2(scale));
  return [allRays, ...(sampling[Math.min(halvings, sampling.length - 1)] ?? [])];
}

/** The picture in full. */
export interface Full {
  readonly pixels: number;
  /** Of the picture at rest: no more is ever taken. */
  readonly steps: number;
}

/** What a frame may take. */
export interface Budget {
  readonly budgetMs: number;
  /** The frame before, whose size is kept where that costs little. */
  readonly last?: FramePlan;
}

/** The steps and the size with the least error that a frame's time allows. */
export function planFrame(time: TimeModel, error: ErrorModel, full: Full, budget: Budget): FramePlan {
  const { budgetMs, last } = budget;
  const fitting = scales
    .flatMap((scale) => outcomesAt(error, scale).map((sampling) => ({ scale, sampling, steps: maxSteps(time, full, { scale, sampling, budgetMs }) })))
    .filter(({ scale, sampling, steps }) => steps >= Math.min(minSteps, full.steps) && scale ** 2 * sampling.share >= minRays);
  if (fitting.length === 0) return cheapestPlan(time, full, budget);
  const errorOf = (plan: FramePlan): number => errorOfPlan(error, plan);
  const best = fitting.reduce((a, b) => (errorOf(b) < errorOf(a) ? b : a));
  const likeLast = last ? fitting.filter(({ scale }) => scale === last.scale) : [];
  const same = likeLast.length > 0 ? likeLast.reduce((a, b) => (errorOf(b) < errorOf(a) ? b : a)) : null;
  return same && errorOf(best) > worthChanging * errorOf(same) ? same : best;
}
