import { allSubsteps } from '../optics/substeps.ts';
import type { Substeps } from '../optics/substeps.ts';
import { allRays } from './sampling-outcome.ts';
import type { SamplingOutcome } from './sampling-outcome.ts';
import type { TimeModel } from './time-model.ts';

/** How the error of a picture depends on what is spent on it, in 1/255 RMS. */
export interface ErrorModel {
  /** Error of the sampling: at `steps` it is `error`, and it falls with the power `order` of the steps. */
  readonly steps: number;
  readonly error: number;
  readonly order: number;
  /** Error of a picture with half as many pixels along each axis, enlarged again. */
  readonly atHalf: number;
  /** What adaptive sampling does to a picture at full size, and at a half and a quarter of it along each axis. */
  readonly sampling: readonly (readonly SamplingOutcome[])[];
}

/** What is drawn in one frame. */
export interface FramePlan {
  /** Pixels along an axis, as a share of the full picture's. */
  readonly scale: number;
  readonly steps: number;
  readonly substeps: Substeps;
  readonly sampling: SamplingOutcome;
}

/** Before anything was measured: pictures at 64 steps and at half their size that are off by a little. */
export const unknownErrors: ErrorModel = { steps: 64, error: 6, order: 1.5, atHalf: 4, sampling: [] };

/** Scales that are tried, from all pixels down. */
const scales = [1, 0.85, 0.7, 0.6, 0.5, 0.42, 0.35, 0.3, 0.25] as const;

/** Scales that only a large picture gets, and only if there is no time for more: edges show stairs. */
const smallScales = [0.25, 0.2, 0.16, 0.125] as const;

/** A frame may take this many times the planned time before a smaller one of these scales is drawn. */
const slack = 1.2;

/** Fewer steps than this show bands instead of a volume. */
const minSteps = 12;

/** A picture keeps as many pixels as a square with such sides has. */
const minPixels = 112 ** 2;

/** Fewer rays than this share of the full picture's pixels show blots: those of the smallest of these pictures. */
const minRays = scales[scales.length - 1] ** 2;

/** Another scale than the last frame's must reduce the error to this share: pictures that change size distract. */
const worthChanging = 0.85;

/** The sampling error with so many steps. */
export function errorOfSteps(model: ErrorModel, steps: number): number {
  return model.error * (model.steps / steps) ** model.order;
}

/** Error of steps, scale and interpolation together. */
export function errorOfPlan(model: ErrorModel, { scale, steps, sampling }: FramePlan): number {
  return Math.hypot(errorOfSteps(model, steps), model.atHalf * (1 / scale - 1), sampling.error);
}

/** What interpolating a pixel, and finding out whether it needs a ray, costs: steps of a ray. */
export const stepsPerProbe = 3;

/** What a ray costs besides its steps. */
export const stepsPerRay = 4;

/** Pixels times steps that a plan takes. @param pixels - of the full picture */
export function workOfPlan({ scale, steps, sampling }: FramePlan, pixels: number): number {
  return pixels * scale ** 2 * stepsPerPixel(steps, sampling);
}

function costOf({ cost, share }: SamplingOutcome): number {
  return cost ?? share;
}

function stepsPerPixel(steps: number, sampling: SamplingOutcome): number {
  return costOf(sampling) * (steps + stepsPerRay) + (sampling.maxCurvature > 0 ? stepsPerProbe : 0);
}

/** If there is no time for anything better: as many pixels as possible with the minimum of steps, then as many steps as possible. */
function cheapestPlan(time: TimeModel, full: Full, { budgetMs, last }: Budget): FramePlan {
  const fewest = Math.min(minSteps, full.steps);
  const planOf = (scale: number, steps = fewest): FramePlan => ({ scale, steps, substeps: allSubsteps, sampling: allRays });
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
  return Math.min(full.steps, Math.floor(each / costOf(sampling) - stepsPerRay));
}

/** What adaptive sampling does to a picture of a scale, as predicted for the nearest scale that was tested. */
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
  /** The frame before; its size is kept if that costs little. */
  readonly last?: FramePlan;
}

/** The steps and the size with the smallest error that a frame's time allows. */
export function planFrame(time: TimeModel, error: ErrorModel, full: Full, budget: Budget): FramePlan {
  const { budgetMs, last } = budget;
  const fitting = scales
    .flatMap((scale) => outcomesAt(error, scale).map((sampling): FramePlan => ({ scale, sampling, substeps: allSubsteps, steps: maxSteps(time, full, { scale, sampling, budgetMs }) })))
    .filter(({ scale, sampling, steps }) => steps >= Math.min(minSteps, full.steps) && scale ** 2 * sampling.share >= minRays);
  if (fitting.length === 0) return cheapestPlan(time, full, budget);
  const errorOf = (plan: FramePlan): number => errorOfPlan(error, plan);
  const best = fitting.reduce((a, b) => (errorOf(b) < errorOf(a) ? b : a));
  const likeLast = last ? fitting.filter(({ scale }) => scale === last.scale) : [];
  const same = likeLast.length > 0 ? likeLast.reduce((a, b) => (errorOf(b) < errorOf(a) ? b : a)) : null;
  return same && errorOf(best) > worthChanging * errorOf(same) ? same : best;
}
