import { wholeSteps } from '../optics/cells/substeps.ts';
import { costOf, stepsPerProbe, stepsPerRay } from './frame-plan.ts';
import type { ErrorModel, FramePlan } from './frame-plan.ts';
import { allRays } from './sampling-outcome.ts';
import type { SamplingOutcome } from './sampling-outcome.ts';
import type { TimeModel } from './time-model.ts';

/** Scales that are tried, from all pixels down. Below a quarter only a large picture gets them, with a ray for each pixel. */
const scales = [1, 0.85, 0.7, 0.6, 0.5, 0.42, 0.35, 0.3, 0.25, 0.2, 0.16, 0.125, 0.11, 0.1] as const;

/** Fewer steps than this miss what is thin: ribs break off, and silhouettes have steps. */
const minSteps = 60;

/** The size of the last frame is kept down to so many, so that a little less time does not change it. */
const keptSteps = 45;

/** If there is no time for so many with pixels enough: fewer steps than this show bands instead of a volume. */
const fewestSteps = 30;

/** A picture at such a scale keeps as many pixels as a square with such sides has. */
const minPixels = 80 ** 2;

/** Fewer rays than this share of the full picture's pixels show blots. */
const minRays = 1 / 16;

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

/** Pixels times steps that there is time for, and no less than the fewest steps for 128 x 128 pixels, or for a part of them. */
function affordableWork({ a, b }: TimeModel, { pixels, steps }: Full, budgetMs: number): number {
  const fewest = Math.min(pixels / 16, Math.max(pixels / 64, 128 ** 2));
  return Math.max(fewest * (Math.min(fewestSteps, steps) + stepsPerRay), (budgetMs - a) / b);
}

/** As many steps as so much work allows, and no more than a picture at rest has. */
function maxSteps(work: number, full: Full, { scale, sampling }: { scale: number; sampling: SamplingOutcome }): number {
  const each = work / (full.pixels * scale ** 2) - (sampling.maxCurvature > 0 ? stepsPerProbe : 0);
  return Math.min(full.steps, Math.floor(each / costOf(sampling) - stepsPerRay + 1e-9)); // A whole number stays one.
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
export function planFrame(time: TimeModel, error: ErrorModel, full: Full, { budgetMs, last }: Budget): FramePlan {
  const work = affordableWork(time, full, budgetMs);
  const all = scales
    .flatMap((scale) => outcomesAt(error, scale).map((sampling): FramePlan => ({ scale, sampling, substeps: wholeSteps, steps: maxSteps(work, full, { scale, sampling }) })))
    .filter(({ scale, sampling }) => scale ** 2 * sampling.share >= minRays || (sampling === allRays && scale ** 2 * full.pixels >= minPixels));
  all.sort((one, other) => errorOfPlan(error, one) - errorOfPlan(error, other));
  const find = (least: number, scale?: number): FramePlan | undefined => all.find((plan) => plan.steps >= Math.min(least, full.steps) && (scale === undefined || plan.scale === scale));
  const best = find(minSteps) ?? find(fewestSteps)!; // A quarter of the pixels along each axis, or a small scale, is always among them.
  const same = last && find(keptSteps, last.scale);
  return same && errorOfPlan(error, best) > worthChanging * errorOfPlan(error, same) ? same : best;
}
