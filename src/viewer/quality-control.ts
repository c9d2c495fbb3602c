import { chooseSteps } from '../quality/choose-steps.ts';
import { estimateError } from '../quality/error-estimate.ts';
import type { PictureError } from '../quality/error-estimate.ts';
import { planFrame, unknownErrors, workOfPlan } from '../quality/plan-frame.ts';
import type { ErrorModel, FramePlan } from '../quality/plan-frame.ts';
import { SteadyTime } from '../quality/steady-time.ts';
import { autoSteps } from '../quality/steps.ts';
import { allRays, chooseAtRest, predictSampling } from '../quality/adaptive-sampling.ts';
import type { SamplingOutcome } from '../quality/adaptive-sampling.ts';
import { FrameTimer } from '../quality/time-model.ts';
import { maxSteps } from '../renderer/ray/compose-ray.ts';
import type { GridFrame } from '../volume/grid.ts';
import { errorAtHalf, ErrorProbe, pickProbed } from './measure-quality.ts';
import type { ProbedPictures } from './measure-quality.ts';
import type { Scene, Size } from './scene.ts';

/** What an author asks of pictures. */
export interface QualityTargets {
  /** Steps along the longest ray; auto leaves them to the control. */
  readonly steps: number | 'auto';
  /** Root mean square error that a picture at rest may have, in 1/255. */
  readonly maxError: number;
  /** Frames a second while something moves. */
  readonly targetFps: number;
}

export const defaultTargets: QualityTargets = { steps: 'auto', maxError: 1, targetFps: 30 };

/** Measuring an error takes pictures with four times the steps. */
const maxMeasured = maxSteps / 4;

/**
 * Of one step a voxel, the least share: a step is cut into eight substeps where something may be seen on it, and what is
 * smaller than its distance to the next could be missed by all rays that are probed.
 */
const minShare = 1 / 16;

/** Of a frame's time, the share that is planned for: what is left is for the page and for frames that take longer. */
const planned = 0.85;

/** Frames' times that a picture at rest may take at once. */
const worthPieces = 3;

/** Rows that a piece has at least: what a piece takes besides is not to be the most of it. */
const minRows = 16;

/** The first picture, of which nothing is known yet: small, to tell what larger ones take. */
export const firstFrame: FramePlan = { scale: 0.125, steps: 64, sampling: allRays };

/** Rounding to 8 bits leaves this much: RMS, 1/255. */
const rounding = 1 / Math.sqrt(12);

/** A picture at rest may exceed the target by this factor before it is drawn again. */
const slack = 1.05;

/** Strides between pixels for which the outcome of adaptive sampling is predicted: of pictures at full size, half and a quarter. */
const foretold: readonly number[] = [1, 2, 4];

/**
 * How many steps, pixels and rays a picture gets, and what error it then has. A model of time, and one of error, are fitted
 * to what is drawn and measured (see docs/maths.md); while something moves the least error within a frame's time is
 * taken, at rest the least work that keeps the target for the error.
 */
export class QualityControl {
  #targets = defaultTargets;
  /** Chosen for the scene as it stands by probing its error; null where it was not probed yet. */
  #chosen: Omit<FramePlan, 'scale'> | null = null;
  #error: PictureError | null = null;
  /** The rays that were probed with the chosen steps, so that they need not be cast again. */
  #probed: ProbedPictures | null = null;
  #errors: ErrorModel = unknownErrors;
  /** The outcomes of adaptive sampling were predicted for another transfer function. */
  #samplingIsStale = false;
  /** Error that adaptive sampling left, over the predicted one. */
  #worse = 1;
  readonly #timer = new FrameTimer();
  readonly #steady = new SteadyTime();
  #last: FramePlan | undefined;

  /** @returns whether this changes anything */
  set(targets: QualityTargets): boolean {
    const changes = JSON.stringify(targets) !== JSON.stringify(this.#targets);
    this.#targets = targets;
    if (changes) this.forget();
    return changes;
  }

  /** The error of the last picture at rest; null where nothing is known of the scene as it stands. */
  get error(): PictureError | null {
    return this.#error;
  }

  /** The view changed: what was chosen and measured holds no more, but is a good guess. */
  forget(): void {
    this.#chosen = null;
    this.#error = null;
    this.#probed = null;
  }

  /** What is seen of the volume changed: where its picture is smooth has to be found out again. */
  forgetProbes(): void {
    this.forget();
    this.#samplingIsStale = true;
  }

  /** The volume changed: nothing is known of the times either. */
  forgetAll(): void {
    this.forgetProbes();
    this.#errors = unknownErrors;
    this.#timer.forget();
    this.#last = undefined;
  }

  /** What a picture at rest gets, as far as it is known. */
  still(grid: GridFrame): FramePlan {
    const { steps } = this.#targets;
    if (steps !== 'auto') return { scale: 1, steps, sampling: allRays };
    if (this.#chosen) return { scale: 1, ...this.#chosen };
    return { scale: 1, steps: Math.min(autoSteps(grid), this.#guess()), sampling: this.#samplingAtRest() };
  }

  /** Whether the steps of a picture at rest are still to be found out by drawing and probing. */
  get undecided(): boolean {
    return this.#targets.steps === 'auto' && this.#chosen === null;
  }

  /** What a picture gets that will be replaced by the next one at once. */
  moving(grid: GridFrame, pixels: number): FramePlan {
    const { steps, targetFps } = this.#targets;
    if (steps !== 'auto') return this.still(grid);
    const { model } = this.#timer;
    const full = { pixels, steps: this.still(grid).steps };
    if (!model) return { ...firstFrame, steps: Math.min(full.steps, firstFrame.steps) };
    this.#last = planFrame(model, this.#errors, full, { budgetMs: (planned * 1000) / targetFps, last: this.#last });
    return this.#last;
  }

  /**
   * Rows of the pieces in which a picture at rest is drawn, so that each is within a frame's time.
   * @returns null where the whole is drawn in little more than that
   */
  rowsOfPieces({ width, height }: Size, plan: FramePlan): number | null {
    const { model } = this.#timer;
    const budget = (planned * 1000) / this.#targets.targetFps;
    if (!model || this.#targets.steps !== 'auto') return null;
    if (model.a + model.b * workOfPlan(plan, width * height) <= worthPieces * budget) return null;
    return Math.max(minRows, Math.floor(Math.max(0, budget - model.a) / (model.b * workOfPlan(plan, width))));
  }

  /** Learn from how long a picture took, and how much of that was the GPU's time, where that is known. @param pixels - of the full picture */
  took(plan: FramePlan, pixels: number, ms: number, gpuMs: number | null = null): void {
    this.#timer.add({ work: workOfPlan(plan, pixels), ms: this.#steady.of(ms, gpuMs) });
  }

  /** Whether nothing is known yet of what pictures take. */
  get untimed(): boolean {
    return this.#targets.steps === 'auto' && this.#timer.model === null;
  }

  /**
   * Probe the error of a picture at rest that has just been drawn.
   * @param size - pixels across and down of the picture in full
   * @returns whether it should be drawn again, with other steps or more pixels
   */
  probe(scene: Scene, grid: GridFrame, plan: FramePlan, size: Size): boolean {
    if (plan.steps > maxMeasured) return false;
    const probe = new ErrorProbe(scene, grid, size);
    if (this.undecided) this.#choose(probe, plan.steps, autoSteps(grid));
    const target = this.still(grid);
    if (plan.scale !== 1 || plan.steps !== target.steps || plan.sampling.maxCurvature !== target.sampling.maxCurvature) return true;
    if (this.#targets.steps === 'auto') this.#learnFrom(scene);
    if (plan.sampling.maxCurvature === 0) {
      const pictures = this.#error ? null : (this.#probed ?? probe.probeBoth(plan.steps));
      if (pictures) this.#error = estimateError(pictures);
      return false;
    }
    return this.#checkSampling(this.#probed ?? probe.probeBoth(plan.steps), plan, pickProbed(scene.readPicture()));
  }

  /**
   * The fewest steps that seem to keep the target are also those that happen to suit the probed rays, so others are probed
   * too. A device that can't measure errors gets one step a voxel.
   */
  #choose(probe: ErrorProbe, steps: number, oneAVoxel: number): void {
    if (!probe.probe(steps, 0)) {
      this.#chosen = { steps: oneAVoxel, sampling: allRays };
      return;
    }
    const sampling = this.#samplingAtRest();
    const limits = { least: Math.ceil(oneAVoxel * minShare), most: maxMeasured };
    const goal = Math.sqrt(Math.max(0, this.#targets.maxError ** 2 - sampling.error ** 2));
    const seeming = chooseSteps((n) => estimateError(probe.probe(n, 0)!), goal, { ...limits, begin: steps }).steps;
    const choice = chooseSteps((n) => estimateError(probe.probeBoth(n)!), goal, { ...limits, least: seeming, begin: seeming });
    const { discretization, order } = choice.estimate;
    this.#probed = probe.probeBoth(choice.steps);
    this.#chosen = { steps: choice.steps, sampling };
    if (sampling.maxCurvature === 0) this.#error = choice.estimate;
    this.#errors = { ...this.#errors, steps: choice.steps, error: Math.max(0.01, discretization), order };
  }

  /**
   * The adaptive sampling of a picture at rest. All rays are cast where its outcome is not known yet.
   * @param below - the curvature that is interpolated has to be less than this, 1/255
   */
  #samplingAtRest(below = Infinity): SamplingOutcome {
    if (this.#samplingIsStale) return allRays;
    const outcomes = this.#errors.sampling[0] ?? [];
    return chooseAtRest(outcomes, this.#targets.maxError, this.#errors.order, { worse: this.#worse, below });
  }

  /** A picture at full size, all of whose rays were cast, tells what fewer pixels and fewer rays would do. */
  #learnFrom(scene: Scene): void {
    if (this.#chosen!.sampling.maxCurvature > 0) return;
    const picture = scene.readPicture();
    const sampling = scene.adaptive ? foretold.map((stride) => predictSampling(picture, stride)) : [];
    this.#errors = { ...this.#errors, atHalf: Math.max(0.1, errorAtHalf(picture)), sampling };
    this.#samplingIsStale = false;
    this.#worse = 1;
  }

  /**
   * Compare an adaptively sampled picture with rays of its own.
   * @param shown - its bytes at the pixels of the probed rays
   * @returns whether it is off by too much: then the next one gets more rays
   */
  #checkSampling(pictures: ProbedPictures | null, { sampling, steps }: FramePlan, shown: readonly number[]): boolean {
    if (!pictures) return false;
    const estimate = estimateError(pictures, shown);
    const left = Math.sqrt(Math.max(0, estimate.rms ** 2 - estimate.discretization ** 2 - rounding ** 2));
    this.#worse = Math.max(1, (left / sampling.error) * this.#worse);
    const isKept = estimate.rms <= slack * this.#targets.maxError;
    this.#error = isKept ? estimate : null;
    if (isKept) return false;
    const less = this.#samplingAtRest(sampling.maxCurvature / 2);
    this.#samplingIsStale = less.maxCurvature === 0;
    this.#chosen = { steps, sampling: less };
    return true;
  }

  /** Steps that kept the target when the error was last probed. */
  #guess(): number {
    const { steps, error, order } = this.#errors;
    return Math.max(8, Math.ceil(steps * (error / this.#targets.maxError) ** (1 / order)));
  }
}
