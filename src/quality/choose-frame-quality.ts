import { wholeSteps } from '../optics/cells/substeps.ts';
import { costOf, stepsPerProbe, stepsPerRay } from './frame-quality.ts';
import type { ErrorModel, FrameQuality } from './frame-quality.ts';
import { allRays } from './sampling-outcome.ts';
import type { SamplingOutcome } from './sampling-outcome.ts';
import type { TimeModel } from './time-model.ts';

/** Scales to try, from the full size down. Below a quarter, only a large picture gets them, with a ray for each pixel. */
const scales = [1, 0.85, 0.7, 0.6, 0.5, 0.42, 0.35, 0.3, 0.25, 0.2, 0.16, 0.125, 0.11, 0.1] as const;

/** With fewer steps, thin things are missed: ribs break off, and silhouettes have steps. */
const minSteps = 60;

/** The last frame's size is kept as long as it allows this many steps, so that a little less time does not change the size. */
const keptSteps = 45;

/** Used if there is no time for `minSteps` with enough pixels. With fewer steps than this, a picture shows bands instead of a volume. */
const fewestSteps = 30;

/** A picture with a ray for each pixel must have at least as many pixels as this square. */
const minPixels = 80 ** 2;

/** With fewer rays than this share of the full picture's pixels, a picture has blots. */
const minRays = 1 / 16;

/** Another scale than the last frame's is used only if it reduces the error to this share: pictures that change size distract. */
const worthChanging = 0.85;

/** The sampling error with a number of steps. */
export function errorOfSteps(model: ErrorModel, steps: number): number {
  return model.error * (model.steps / steps) ** model.order;
}

/** The error of steps, scale and interpolation together. */
export function errorOfFrame(model: ErrorModel, { scale, steps, sampling }: FrameQuality): number {
  return Math.hypot(errorOfSteps(model, steps), model.atHalf * (1 / scale - 1), sampling.error);
}

/** Pixels times steps for which there is time; at least the fewest steps for 128 x 128 pixels, or for a part of a smaller picture. */
function affordableWork({ a, b }: TimeModel, { pixels, steps }: Full, budgetMs: number): number {
  const fewest = Math.min(pixels / 16, Math.max(pixels / 64, 128 ** 2));
  return Math.max(fewest * (Math.min(fewestSteps, steps) + stepsPerRay), (budgetMs - a) / b);
}

/** The largest number of steps for an amount of work; at most that of a picture at rest. */
function maxSteps(work: number, full: Full, { scale, sampling }: { scale: number; sampling: SamplingOutcome }): number {
  const each = work / (full.pixels * scale ** 2) - (sampling.maxCurvature > 0 ? stepsPerProbe : 0);
  return Math.min(full.steps, Math.floor(each / costOf(sampling) - stepsPerRay + 1e-9)); // The 1e-9: a whole number stays the same.
}

/** The outcomes of adaptive sampling for a picture at a scale, as predicted for the nearest scale that was tested. */
function outcomesAt({ sampling }: ErrorModel, scale: number): readonly SamplingOutcome[] {
  const halvings = Math.round(-Math.log2(scale));
  return [allRays, ...(sampling[Math.min(halvings, sampling.length - 1)] ?? [])];
}

/** The picture at full size. */
export interface Full {
  readonly pixels: number;
  /** Steps of the picture at rest: no plan takes more. */
  readonly steps: number;
}

/** The limits of a frame. */
export interface Budget {
  readonly budgetMs: number;
  /** The frame before. Its size is kept if that costs little. */
  readonly last?: FrameQuality;
}

/** Finds the number of steps and the size with the smallest error within a frame's time. */
export function chooseFrameQuality(
  time: TimeModel,
  error: ErrorModel,
  full: Full,
  { budgetMs, last }: Budget,
): FrameQuality {
  const work = affordableWork(time, full, budgetMs);
  const all = scales
    .flatMap((scale) =>
      outcomesAt(error, scale).map((sampling): FrameQuality => ({
        scale,
        sampling,
        substeps: wholeSteps,
        steps: maxSteps(work, full, { scale, sampling }),
      })),
    )
    .filter(
      ({ scale, sampling }) =>
        scale ** 2 * sampling.share >= minRays || (sampling === allRays && scale ** 2 * full.pixels >= minPixels),
    );
  all.sort((one, other) => errorOfFrame(error, one) - errorOfFrame(error, other));
  const find = (min: number, scale?: number): FrameQuality | undefined =>
    all.find((plan) => plan.steps >= Math.min(min, full.steps) && (scale === undefined || plan.scale === scale));
  const best = find(minSteps) ?? find(fewestSteps)!; // A quarter of the pixels along each axis, or a small scale, always passes.
  const same = last && find(keptSteps, last.scale);
  return same && errorOfFrame(error, best) > worthChanging * errorOfFrame(error, same) ? same : best;
}
