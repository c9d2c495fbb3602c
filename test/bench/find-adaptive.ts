import type { StudyGl } from '../../demos/accuracy/study-gl.ts';
import type { StudyPicture } from '../../demos/accuracy/study-gl.ts';
import { stepsOfLimit } from '../../demos/accuracy/study.ts';
import { raysOfLattice } from '../../src/optics/rays.ts';
import type { PixelLattice } from '../../src/optics/rays.ts';
import { allRays, chooseAtRest, predictSampling } from '../../src/quality/adaptive-sampling.ts';
import type { SamplingOutcome } from '../../src/quality/adaptive-sampling.ts';
import type { FoundSteps } from './find-steps.ts';

/** A picture that keeps an error with adaptive ray sampling. */
export interface FoundAdaptive extends FoundSteps {
  readonly sampling: SamplingOutcome;
}

/** What is drawn but for its number of steps. */
export type Drawn = Omit<StudyPicture, 'steps'>;

/** Of a whole picture, the pixels whose errors are measured: one in a few, by an odd distance, so that all lattices have their turn. */
export function errorLattice(size: number, errorSize: number): PixelLattice {
  const least = Math.max(1, Math.ceil(size / errorSize));
  const stride = least + ((least + 1) % 2);
  const first = (stride - 1) / 2;
  const pixels = Math.floor((size - 1 - first) / stride) + 1;
  return { stride, first: [first, first], width: pixels, height: pixels };
}

/** Pixels of a lattice out of a whole picture. */
export function pickLattice(picture: ArrayLike<number>, size: number, { stride, first, width, height }: PixelLattice): Float32Array {
  const picked = new Float32Array(4 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = 4 * ((first[1] + y * stride) * size + first[0] + x * stride);
      for (let c = 0; c < 4; c++) picked[4 * (y * width + x) + c] = picture[from + c];
    }
  }
  return picked;
}

/** Draws pictures with adaptive ray sampling, chosen as the element does, and measures their errors against the scene's limit. */
export class AdaptiveErrors {
  readonly #lattice: PixelLattice;
  #limit: Float32Array | null = null;
  #outcomes: readonly SamplingOutcome[] | null = null;

  constructor(readonly gl: StudyGl, readonly drawn: Drawn, readonly size: number, errorSize: number) {
    this.#lattice = errorLattice(size, errorSize);
  }

  /**
   * The smallest number of steps that keeps an error with adaptive sampling, from the number that is enough without it.
   * @param counts - numbers of steps to try, rising
   * @returns null where none of a few do: then all rays are cast
   */
  async find(target: number, enough: FoundSteps, counts: readonly number[]): Promise<FoundAdaptive> {
    this.#outcomes ??= await this.#foretell(enough.steps);
    for (let below = Infinity; ; ) {
      const sampling = chooseAtRest(this.#outcomes, target, usualOrder, { below });
      if (sampling === allRays) return { ...enough, sampling };
      for (const steps of counts.filter((n) => n >= enough.steps).slice(0, tries)) {
        const error = await this.#errorOf({ ...this.drawn, steps, maxCurvature: sampling.maxCurvature });
        if (error <= target) return { steps, error, sampling };
      }
      below = sampling.maxCurvature / 2;
    }
  }

  /** As the element does it, from a picture with all its rays. */
  async #foretell(steps: number): Promise<SamplingOutcome[]> {
    const floats = await this.gl.draw({ ...this.drawn, steps }, this.size, new AbortController().signal);
    return predictSampling({ data: Uint8Array.from(floats, (x) => Math.round(x * 255)), width: this.size, height: this.size });
  }

  async #errorOf(picture: StudyPicture): Promise<number> {
    const { signal } = new AbortController();
    const whole = { width: this.size, height: this.size };
    const rays = raysOfLattice(picture.rays, whole, this.#lattice);
    const { width } = this.#lattice;
    const steps = stepsOfLimit(picture.volume);
    this.#limit ??= await this.gl.draw({ ...this.drawn, rays, steps, maxSubsteps: 1 }, width, signal);
    const shown = pickLattice(await this.gl.draw(picture, this.size, signal), this.size, this.#lattice);
    return rms(shown, this.#limit);
  }
}

/** With which errors fall with steps; the element measures it. */
export const usualOrder = 1.8;

/** After so many increases of the steps by a tenth, the curvature limit must be smaller. */
export const tries = 5;

/** RMS difference, 1/255. */
function rms(a: Float32Array, b: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] - b[i]) ** 2;
  return 255 * Math.sqrt(sum / a.length);
}
