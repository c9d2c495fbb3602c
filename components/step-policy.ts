import { chooseSteps } from '../src/quality/choose-steps.ts';
import type { PictureError } from '../src/quality/error-estimate.ts';
import { autoSteps, movingSteps } from '../src/quality/steps.ts';
import { maxSteps } from '../src/shader/compose.ts';
import type { Volume } from '../src/volume/volume.ts';
import type { VolumeScene } from '../src/x3d/scene.ts';
import { measureError } from './measure-quality.ts';

/** A moving picture should take this long, ms. */
const movingBudgetMs = 30;

/** Measuring an error takes pictures with four times the steps. */
const mostMeasured = maxSteps / 4;

/** How many steps a picture gets, and what error it then has. */
export class StepPolicy {
  #wish: number | 'auto' = 'auto';
  #maxError: number | null = null;
  /** Chosen for the scene as it stands by looking at its error; null where nobody looked yet. */
  #chosen: number | null = null;
  #error: PictureError | null = null;
  #lastMoving = { steps: 64, frameMs: 0 };

  /**
   * @param steps - samples along the longest ray, or auto
   * @param maxError - with auto: as few steps as keep this root mean square error, in 1/255
   * @returns whether this changes anything
   */
  set(steps: number | 'auto', maxError: number | null): boolean {
    const changes = steps !== this.#wish || maxError !== this.#maxError;
    this.#wish = steps;
    this.#maxError = maxError;
    return changes;
  }

  /** The error of the last picture at rest; null where nothing is known of the scene as it stands. */
  get error(): PictureError | null {
    return this.#error;
  }

  /** Something changed that pictures depend on: what was chosen and measured holds no more. */
  forget(): void {
    this.#chosen = null;
    this.#error = null;
  }

  /** Steps of a picture at rest. */
  still(volume: Volume): number {
    if (this.#wish !== 'auto') return this.#wish;
    return this.#chosen ?? autoSteps(volume);
  }

  /** Steps of a picture that will be replaced by the next one at once. */
  moving(volume: Volume): number {
    return this.#wish === 'auto' ? movingSteps(this.#lastMoving, movingBudgetMs, this.still(volume)) : this.#wish;
  }

  /** Learn from how long a moving picture took. */
  tookMoving(steps: number, frameMs: number): void {
    this.#lastMoving = { steps, frameMs };
  }

  /**
   * Look at the error of a picture at rest that has just been drawn.
   * @returns whether it should be drawn again, with other steps
   */
  look(scene: VolumeScene, volume: Volume, steps: number): boolean {
    if (steps > mostMeasured) return false;
    if (this.#wish !== 'auto' || this.#maxError === null || this.#chosen !== null) {
      this.#error = this.#error ?? measureError(scene, volume, steps);
      return false;
    }
    const first = measureError(scene, volume, steps);
    if (!first) return false;
    const measure = (n: number) => (n === steps ? first : measureError(scene, volume, n)!);
    const choice = chooseSteps(measure, this.#maxError, { begin: steps, most: mostMeasured });
    this.#chosen = choice.steps;
    this.#error = choice.estimate;
    return choice.steps !== steps;
  }
}
