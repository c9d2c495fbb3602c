import type { Substeps } from '../optics/cells/substeps.ts';
import type { SamplingOutcome } from './sampling-outcome.ts';

/** How the error of a picture depends on the work spent on it, in 1/255 RMS. */
export interface ErrorModel {
  /** Error of the sampling: `error` at `steps` steps. It falls with the power `order` of the steps. */
  readonly steps: number;
  readonly error: number;
  readonly order: number;
  /** Error of a picture with half as many pixels along each axis, after it is enlarged again. */
  readonly atHalf: number;
  /** The effect of adaptive sampling on a picture at full size, and at a half and a quarter of it along each axis. */
  readonly sampling: readonly (readonly SamplingOutcome[])[];
}

/** How well one frame is drawn: its pixels, steps and rays. The plan of a frame (viewer/model/frame-plan.ts) is made from it. */
export interface FrameQuality {
  /** Number of pixels along an axis, as a share of the full picture's. */
  readonly scale: number;
  readonly steps: number;
  readonly substeps: Substeps;
  readonly sampling: SamplingOutcome;
  /** At iso-surfaces, pixels with more curvature than this get several rays, in 1/255; absent if all pixels get one. */
  readonly edgeCurvature?: number;
}

/** Assumed before anything is measured: errors of pictures with 64 steps and at half size. */
export const unknownErrors: ErrorModel = { steps: 64, error: 6, order: 1.5, atHalf: 4, sampling: [] };

/** The cost of interpolating a pixel and of testing whether it needs a ray, in steps of a ray. */
export const stepsPerProbe = 3;

/** The cost of a ray in addition to its steps, in steps. */
export const stepsPerRay = 4;

/** The work of a frame: pixels times steps. @param pixels - of the full picture */
export function workOfFrame({ scale, steps, sampling }: FrameQuality, pixels: number): number {
  return pixels * scale ** 2 * stepsPerPixel(steps, sampling);
}

export function costOf({ cost, share }: SamplingOutcome): number {
  return cost ?? share;
}

function stepsPerPixel(steps: number, sampling: SamplingOutcome): number {
  return costOf(sampling) * (steps + stepsPerRay) + (sampling.maxCurvature > 0 ? stepsPerProbe : 0);
}
