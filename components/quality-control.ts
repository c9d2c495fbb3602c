import { chooseSteps } from '../src/quality/choose-steps.ts';
import { estimateError } from '../src/quality/error-estimate.ts';
import type { PictureError } from '../src/quality/error-estimate.ts';
import { planFrame, unknownErrors, workOfPlan } from '../src/quality/plan-frame.ts';
import type { ErrorModel, FramePlan } from '../src/quality/plan-frame.ts';
import { SteadyTime } from '../src/quality/steady-time.ts';
import { autoSteps } from '../src/quality/steps.ts';
import { allRays, chooseAtRest, foretellThinning } from '../src/quality/thinning.ts';
import type { ThinningOutcome } from '../src/quality/thinning.ts';
import { FrameTimer } from '../src/quality/time-model.ts';
import { maxSteps } from '../src/shader/compose.ts';
import type { CartesianGrid } from '../src/volume/grid.ts';
import type { VolumeScene } from '../src/x3d/scene.ts';
import type { Size } from '../src/x3d/pass-drawing.ts';
import { errorAtHalf, ErrorProbe, pickProbed } from './measure-quality.ts';
import type { ProbedPictures } from './measure-quality.ts';

/** What an author wishes of pictures. */
export interface QualityWishes {
  /** Steps along the longest ray; auto leaves them to the control. */
  readonly steps: number | 'auto';
  /** Root mean square error that a picture at rest may have, in 1/255. */
  readonly maxError: number;
  /** Frames a second while something moves. */
  readonly targetFps: number;
}

export const defaultWishes: QualityWishes = { steps: 'auto', maxError: 1, targetFps: 30 };

/** Measuring an error takes pictures with four times the steps. */
const mostMeasured = maxSteps / 4;

/**
 * Of one step a voxel, the least share: a step is cut into eight parts where something may be seen on it, and what is
 * smaller than its distance to the next could be missed by all rays that are looked at.
 */
const leastShare = 1 / 16;

/** Of a frame's time, the share that is planned for: what is left is for the page and for frames that take longer. */
const planned = 0.85;

/** Frames' times that a picture at rest may take at once. */
const worthPieces = 3;

/** Rows that a piece has at least: what a piece takes besides is not to be the most of it. */
const fewestRows = 16;

/** The first picture, of which nothing is known yet: small, to tell what larger ones take. */
export const firstLook: FramePlan = { scale: 0.125, steps: 64, thinning: allRays };

/** Rounding to 8 bits leaves this much: RMS, 1/255. */
const rounding = 1 / Math.sqrt(12);

/** What a picture at rest may be off by more than was wished before it is drawn again. */
const slack = 1.05;

/** Strides between pixels for which it is foretold what thinning does: of pictures at full size, half and a quarter. */
const foretold: readonly number[] = [1, 2, 4];

/**
 * How many steps, pixels and rays a picture gets, and what error it then has. A model of time, and one of error, are fitted
 * to what is drawn and measured (see docs/maths.md); while something moves the least error within a frame's time is
 * taken, at rest the least work that keeps the error wished for.
 */
export class QualityControl {
  #wishes = defaultWishes;
  /** Chosen for the scene as it stands by looking at its error; null where nobody looked yet. */
  #chosen: Omit<FramePlan, 'scale'> | null = null;
  #error: PictureError | null = null;
  /** The rays that were looked at with the chosen steps, so that they need not be cast again. */
  #probed: ProbedPictures | null = null;
  #errors: ErrorModel = unknownErrors;
  /** What thinning does was foretold of another transfer function. */
  #thinningIsStale = false;
  /** Error that thinning left, over the one foretold. */
  #worse = 1;
  readonly #timer = new FrameTimer();
  readonly #steady = new SteadyTime();
  #last: FramePlan | undefined;

  /** @returns whether this changes anything */
  set(wishes: QualityWishes): boolean {
    const changes = JSON.stringify(wishes) !== JSON.stringify(this.#wishes);
    this.#wishes = wishes;
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

  /** What is seen of the volume changed: where its picture is smooth has to be looked at again. */
  forgetLooks(): void {
    this.forget();
    this.#thinningIsStale = true;
  }

  /** The volume changed: nothing is known of the times either. */
  forgetAll(): void {
    this.forgetLooks();
    this.#errors = unknownErrors;
    this.#timer.forget();
    this.#last = undefined;
  }

  /** What a picture at rest gets, as far as it is known. */
  still(grid: CartesianGrid): FramePlan {
    const { steps } = this.#wishes;
    if (steps !== 'auto') return { scale: 1, steps, thinning: allRays };
    if (this.#chosen) return { scale: 1, ...this.#chosen };
    return { scale: 1, steps: Math.min(autoSteps(grid), this.#guess()), thinning: this.#thinningAtRest() };
  }

  /** Whether the steps of a picture at rest are still to be found out by drawing and looking. */
  get undecided(): boolean {
    return this.#wishes.steps === 'auto' && this.#chosen === null;
  }

  /** What a picture gets that will be replaced by the next one at once. */
  moving(grid: CartesianGrid, pixels: number): FramePlan {
    const { steps, targetFps } = this.#wishes;
    if (steps !== 'auto') return this.still(grid);
    const { model } = this.#timer;
    const full = { pixels, steps: this.still(grid).steps };
    if (!model) return { ...firstLook, steps: Math.min(full.steps, firstLook.steps) };
    this.#last = planFrame(model, this.#errors, full, { budgetMs: (planned * 1000) / targetFps, last: this.#last });
    return this.#last;
  }

  /**
   * Rows of the pieces in which a picture at rest is drawn, so that each is within a frame's time.
   * @returns null where the whole is drawn in little more than that
   */
  rowsOfPieces({ width, height }: Size, plan: FramePlan): number | null {
    const { model } = this.#timer;
    const budget = (planned * 1000) / this.#wishes.targetFps;
    if (!model || this.#wishes.steps !== 'auto') return null;
    if (model.a + model.b * workOfPlan(plan, width * height) <= worthPieces * budget) return null;
    return Math.max(fewestRows, Math.floor(Math.max(0, budget - model.a) / (model.b * workOfPlan(plan, width))));
  }

  /** Learn from how long a picture took, and how much of that was the GPU's time, where that is known. @param pixels - of the full picture */
  took(plan: FramePlan, pixels: number, ms: number, gpuMs: number | null = null): void {
    this.#timer.add({ work: workOfPlan(plan, pixels), ms: this.#steady.of(ms, gpuMs) });
  }

  /** Whether nothing is known yet of what pictures take. */
  get untimed(): boolean {
    return this.#wishes.steps === 'auto' && this.#timer.model === null;
  }

  /**
   * Look at the error of a picture at rest that has just been drawn.
   * @param size - pixels across and down of the picture in full
   * @returns whether it should be drawn again, with other steps or more pixels
   */
  look(scene: VolumeScene, grid: CartesianGrid, plan: FramePlan, size: Size): boolean {
    if (plan.steps > mostMeasured) return false;
    const probe = new ErrorProbe(scene, grid, size);
    if (this.undecided) this.#choose(probe, plan.steps, autoSteps(grid));
    const wished = this.still(grid);
    if (plan.scale !== 1 || plan.steps !== wished.steps || plan.thinning.mostBend !== wished.thinning.mostBend) return true;
    if (this.#wishes.steps === 'auto') this.#learnFrom(scene);
    if (plan.thinning.mostBend === 0) {
      const pictures = this.#error ? null : (this.#probed ?? probe.lookTwice(plan.steps));
      if (pictures) this.#error = estimateError(pictures);
      return false;
    }
    return this.#checkThinning(this.#probed ?? probe.lookTwice(plan.steps), plan, pickProbed(scene.readPicture()));
  }

  /**
   * The fewest steps that seem to keep the wish are also those that happen to suit the rays that were looked at, so others
   * are looked at too. A device that can't measure errors gets one step a voxel.
   */
  #choose(probe: ErrorProbe, steps: number, oneAVoxel: number): void {
    if (!probe.look(steps, 0)) {
      this.#chosen = { steps: oneAVoxel, thinning: allRays };
      return;
    }
    const thinning = this.#thinningAtRest();
    const limits = { least: Math.ceil(oneAVoxel * leastShare), most: mostMeasured };
    const wish = Math.sqrt(Math.max(0, this.#wishes.maxError ** 2 - thinning.error ** 2));
    const seeming = chooseSteps((n) => estimateError(probe.look(n, 0)!), wish, { ...limits, begin: steps }).steps;
    const choice = chooseSteps((n) => estimateError(probe.lookTwice(n)!), wish, { ...limits, least: seeming, begin: seeming });
    const { discretization, order } = choice.estimate;
    this.#probed = probe.lookTwice(choice.steps);
    this.#chosen = { steps: choice.steps, thinning };
    if (thinning.mostBend === 0) this.#error = choice.estimate;
    this.#errors = { ...this.#errors, steps: choice.steps, error: Math.max(0.01, discretization), order };
  }

  /**
   * How the rays of a picture at rest are thinned. All are cast where it is not known yet what thinning does.
   * @param below - it has to let the picture bend less than this, 1/255
   */
  #thinningAtRest(below = Infinity): ThinningOutcome {
    if (this.#thinningIsStale) return allRays;
    const outcomes = this.#errors.thinning[0] ?? [];
    return chooseAtRest(outcomes, this.#wishes.maxError, this.#errors.order, { worse: this.#worse, below });
  }

  /** A picture at full size, all of whose rays were cast, tells what fewer pixels and fewer rays would do. */
  #learnFrom(scene: VolumeScene): void {
    if (this.#chosen!.thinning.mostBend > 0) return;
    const picture = scene.readPicture();
    const thinning = scene.thinnable ? foretold.map((stride) => foretellThinning(picture, stride)) : [];
    this.#errors = { ...this.#errors, atHalf: Math.max(0.1, errorAtHalf(picture)), thinning };
    this.#thinningIsStale = false;
    this.#worse = 1;
  }

  /**
   * Hold a thinned picture against rays of its own.
   * @param shown - its bytes at the pixels of the rays that were looked at
   * @returns whether it is off by too much: then the next one gets more rays
   */
  #checkThinning(pictures: ProbedPictures | null, { thinning, steps }: FramePlan, shown: readonly number[]): boolean {
    if (!pictures) return false;
    const estimate = estimateError(pictures, shown);
    const left = Math.sqrt(Math.max(0, estimate.rms ** 2 - estimate.discretization ** 2 - rounding ** 2));
    this.#worse = Math.max(1, (left / thinning.error) * this.#worse);
    const isKept = estimate.rms <= slack * this.#wishes.maxError;
    this.#error = isKept ? estimate : null;
    if (isKept) return false;
    const less = this.#thinningAtRest(thinning.mostBend / 2);
    this.#thinningIsStale = less.mostBend === 0;
    this.#chosen = { steps, thinning: less };
    return true;
  }

  /** Steps that kept the error wished for when that was last looked at. */
  #guess(): number {
    const { steps, error, order } = this.#errors;
    return Math.max(8, Math.ceil(steps * (error / this.#wishes.maxError) ** (1 / order)));
  }
}
