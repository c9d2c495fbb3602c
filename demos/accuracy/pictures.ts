import type { StudyMethod } from '../../src/renderer/study.ts';
import { fitPaperFactors } from './fit-paper.ts';
import { describePicture, setUpScene } from './scene-setup.ts';
import type { SceneSetup } from './scene-setup.ts';
import type { StudyFunction } from './scenes.ts';
import { StudyGl } from './study-gl.ts';
import type { PaperFactors } from './study-gl.ts';
import { stepsOfLimit } from './study.ts';
import { median } from './time-pictures.ts';

/** By how much differences are multiplied before they are shown. */
export const amplification = 16;

/** What the volume is seen against, red, green and blue, 0..1: dark, as in the element's own default. */
export const background = [23 / 255, 27 / 255, 34 / 255] as const;

interface Prepared {
  readonly setup: SceneSetup;
  readonly fn: StudyFunction;
  readonly limit: Float32Array;
  readonly paper: PaperFactors;
}

/** Pictures of the study as images; what they have in common is kept from one to the next. */
export class StudyPictures {
  readonly #gl = new StudyGl();
  readonly #scenes = new Map<string, SceneSetup>();
  #prepared: { readonly key: string; readonly value: Prepared } | null = null;

  /** @param size - pixels along each side */
  constructor(readonly size: number) {}

  /** A picture, the limit, and the amplified difference of the two. */
  async draw(
    { scene, fn, method, steps }: { scene: string; fn: string; method: StudyMethod; steps: number },
    signal: AbortSignal,
  ): Promise<{ picture: ImageData; limit: ImageData; difference: ImageData; floats: [Float32Array, Float32Array] }> {
    const prepared = await this.#prepare(scene, fn, signal);
    const { setup, limit, paper } = prepared;
    const picture = await this.#gl.draw(
      describePicture(setup, prepared.fn, { method, steps, paper }),
      this.size,
      signal,
    );
    return {
      picture: toImage(this.size, (at) => picture[at] + background[at % 4] * (1 - picture[at - (at % 4) + 3])),
      limit: toImage(this.size, (at) => limit[at] + background[at % 4] * (1 - limit[at - (at % 4) + 3])),
      difference: toImage(this.size, (at) => Math.abs(picture[at] - limit[at]) * amplification),
      floats: [picture, limit],
    };
  }

  /** How long a frame of it takes, ms: the median of some. */
  async time(
    { scene, fn, method, steps }: { scene: string; fn: string; method: StudyMethod; steps: number },
    signal: AbortSignal,
  ): Promise<number> {
    const { setup, fn: drawn, paper } = await this.#prepare(scene, fn, signal);
    const picture = describePicture(setup, drawn, { method, steps, paper });
    const repeat = Math.min(20, Math.ceil(10 / Math.max(0.5, this.#gl.time(picture, this.size)))); // Clocks are coarse.
    return median(Array.from({ length: 3 }, () => this.#gl.time(picture, this.size, repeat)));
  }

  dispose(): void {
    this.#gl.dispose();
  }

  async #prepare(scene: string, fnId: string, signal: AbortSignal): Promise<Prepared> {
    const key = `${scene} ${fnId}`;
    if (this.#prepared?.key === key) return this.#prepared.value;
    const setup = this.#scenes.get(scene) ?? (await setUpScene(scene, signal));
    if (!setup) throw new Error('The data of this volume are not here.');
    this.#scenes.set(scene, setup);
    const fn = setup.functions.find(({ id }) => id === fnId)!;
    const wanted = describePicture(setup, fn, { method: 'shipped', steps: stepsOfLimit(setup.volume), maxSubsteps: 1 });
    const limit = await this.#gl.draw(wanted, this.size, signal);
    const paper = await fitPaperFactors(this.#gl, wanted, setup.eightBits, signal);
    const value = { setup, fn, limit, paper };
    this.#prepared = { key, value };
    return value;
  }
}

/** Opaque bytes, top row first, of channels that are counted with the bottom row first. */
function toImage(size: number, channel: (at: number) => number): ImageData {
  const image = new ImageData(size, size);
  for (let row = 0; row < size; row++) {
    for (let i = 0; i < size * 4; i++) {
      const at = (size - 1 - row) * size * 4 + i;
      image.data[row * size * 4 + i] = i % 4 === 3 ? 255 : Math.round(channel(at) * 255);
    }
  }
  return image;
}
