import { chooseSteps } from '../src/quality/choose-steps.ts';
import type { ErrorEstimate, PictureError } from '../src/quality/error-estimate.ts';
import { planFrame, unknownErrors } from '../src/quality/plan-frame.ts';
import type { ErrorModel, FramePlan } from '../src/quality/plan-frame.ts';
import { SteadyTime } from '../src/quality/steady-time.ts';
import { autoSteps } from '../src/quality/steps.ts';
import { FrameTimer } from '../src/quality/time-model.ts';
import { maxSteps } from '../src/shader/compose.ts';
import type { CartesianGrid } from '../src/volume/grid.ts';
import type { VolumeScene } from '../src/x3d/scene.ts';
import { errorAtHalf, measureError } from './measure-quality.ts';

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
const leastShare = 1 / 8;

/** Of a frame's time, the share that is planned for: what is left is for the page and for frames that take longer. */
const planned = 0.85;

/** Frames' times that a picture at rest may take at once. */
const worthPieces = 3;

/** Rows that a piece has at least: what a piece takes besides is not to be the most of it. */
const fewestRows = 16;

/** The first picture, of which nothing is known yet: small, to tell what larger ones take. */
export const firstLook: FramePlan = { scale: 0.125, steps: 64 };

/**
 * How many steps and pixels a picture gets, and what error it then has. A model of time, T = a + b * pixels * steps, and one
 * of error, c * steps^-order and the loss of fewer pixels, are fitted to what is drawn and measured; while something moves
 * the least error within a frame's time is taken, at rest the fewest steps that keep the error wished for.
 */
export class QualityControl {
  #wishes = defaultWishes;
  /** Chosen for the scene as it stands by looking at its error; null where nobody looked yet. */
  #chosen: number | null = null;
  #error: PictureError | null = null;
  #errors: ErrorModel = unknownErrors;
  #knowsHalf = false;
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
  }

  /** The volume or its looks changed: nothing is known of the times either. */
  forgetAll(): void {
    this.forget();
    this.#errors = unknownErrors;
    this.#knowsHalf = false;
    this.#timer.forget();
    this.#last = undefined;
  }

  /** Steps of a picture at rest, as far as they are known. */
  still(grid: CartesianGrid): number {
    const { steps } = this.#wishes;
    if (steps !== 'auto') return steps;
    return this.#chosen ?? Math.min(autoSteps(grid), this.#guess());
  }

  /** Whether the steps of a picture at rest are still to be found out by drawing and looking. */
  get undecided(): boolean {
    return this.#wishes.steps === 'auto' && this.#chosen === null;
  }

  /** What a picture gets that will be replaced by the next one at once. */
  moving(grid: CartesianGrid, pixels: number): FramePlan {
    const { steps, targetFps } = this.#wishes;
    if (steps !== 'auto') return { scale: 1, steps };
    const { model } = this.#timer;
    const full = { pixels, steps: this.still(grid) };
    if (!model) return { scale: firstLook.scale, steps: Math.min(full.steps, firstLook.steps) };
    this.#last = planFrame(model, this.#errors, full, { budgetMs: (planned * 1000) / targetFps, last: this.#last });
    return this.#last;
  }

  /**
   * Rows of the pieces in which a picture at rest is drawn, so that each is within a frame's time.
   * @returns null where the whole is drawn in little more than that
   */
  rowsOfPieces({ width, height }: { width: number; height: number }, steps: number): number | null {
    const { model } = this.#timer;
    const budget = (planned * 1000) / this.#wishes.targetFps;
    if (!model || this.#wishes.steps !== 'auto') return null;
    if (model.a + model.b * width * height * steps <= worthPieces * budget) return null;
    return Math.max(fewestRows, Math.floor(Math.max(0, budget - model.a) / (model.b * width * steps)));
  }

  /** Learn from how long a picture took, and how much of that was the GPU's time, where that is known. */
  took(pixels: number, steps: number, ms: number, gpuMs: number | null = null): void {
    this.#timer.add({ work: pixels * steps, ms: this.#steady.of(ms, gpuMs) });
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
  look(scene: VolumeScene, grid: CartesianGrid, { scale, steps }: FramePlan, size: { width: number; height: number }): boolean {
    if (steps > mostMeasured) return false;
    const estimate = (n: number): ErrorEstimate | null => measureError(scene, grid, n, size);
    if (!this.undecided) {
      this.#error ??= estimate(steps);
    } else {
      this.#choose(estimate(steps), steps, (n) => estimate(n)!, autoSteps(grid));
    }
    const isFinal = scale === 1 && steps === this.still(grid);
    if (isFinal && !this.#knowsHalf) {
      this.#errors = { ...this.#errors, atHalf: Math.max(0.1, errorAtHalf(scene)) };
      this.#knowsHalf = true;
    }
    return !isFinal;
  }

  /** A device that can't measure errors gets one step a voxel. */
  #choose(first: ErrorEstimate | null, steps: number, measure: (steps: number) => ErrorEstimate, oneAVoxel: number): void {
    if (!first) {
      this.#chosen = oneAVoxel;
      return;
    }
    const limits = { begin: steps, least: Math.ceil(oneAVoxel * leastShare), most: mostMeasured };
    const choice = chooseSteps((n) => (n === steps ? first : measure(n)), this.#wishes.maxError, limits);
    const { discretization, order } = choice.estimate;
    this.#chosen = choice.steps;
    this.#error = choice.estimate;
    this.#errors = { ...this.#errors, steps: choice.steps, error: Math.max(0.01, discretization), order };
  }

  /** Steps that kept the error wished for when that was last looked at. */
  #guess(): number {
    const { steps, error, order } = this.#errors;
    return Math.max(8, Math.ceil(steps * (error / this.#wishes.maxError) ** (1 / order)));
  }
}
