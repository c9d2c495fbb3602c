import type { Substeps } from '../optics/cells/substeps.ts';
import type { SamplingOutcome } from './sampling-outcome.ts';

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
  /** At surfaces of values, pixels with more curvature than this get several rays, 1/255; absent where all get one. */
  readonly edgeCurvature?: number;
}

/** Before anything was measured: pictures at 64 steps and at half their size that are off by a little. */
export const unknownErrors: ErrorModel = { steps: 64, error: 6, order: 1.5, atHalf: 4, sampling: [] };

/** What interpolating a pixel, and finding out whether it needs a ray, costs: steps of a ray. */
export const stepsPerProbe = 3;

/** What a ray costs besides its steps. */
export const stepsPerRay = 4;

/** Pixels times steps that a plan takes. @param pixels - of the full picture */
export function workOfPlan({ scale, steps, sampling }: FramePlan, pixels: number): number {
  return pixels * scale ** 2 * stepsPerPixel(steps, sampling);
}

export function costOf({ cost, share }: SamplingOutcome): number {
  return cost ?? share;
}

function stepsPerPixel(steps: number, sampling: SamplingOutcome): number {
  return costOf(sampling) * (steps + stepsPerRay) + (sampling.maxCurvature > 0 ? stepsPerProbe : 0);
}
