import type { Gl } from '../device/device.ts';
import type { CoarsePictures } from './adaptive-provider.ts';
import { bytesAttachment, DrawTarget } from '../device/draw-target.ts';
import { BetweenDrawing } from '../passes/between-drawing.ts';
import type { HalfPicture, Pass, Size } from '../passes/pass-drawing.ts';

/** Strides of the lattices that are drawn before the picture: every fourth pixel, then every second pixel. */
const strides = [4, 2] as const;

/** A lattice reaches beyond the last pixel of the picture, so that this pixel lies between two pixels of the lattice. */
function halve(pixels: number): number {
  return Math.floor(pixels / 2) + 1;
}

/** The coarser pictures from which a picture with adaptive ray sampling is drawn. */
export class AdaptivePicture implements CoarsePictures {
  readonly #targets: readonly DrawTarget[];
  readonly #between: BetweenDrawing;

  constructor(gl: Gl) {
    this.#between = new BetweenDrawing(gl);
    this.#targets = strides.map(() => new DrawTarget(gl, [bytesAttachment(gl, 'uHalfPicture')]));
  }

  /** The passes for a picture of a given size, in the order of drawing. @param target - the target of the picture itself */
  passes({ width, height }: Size, target: DrawTarget): Pass[] {
    const [quarter, half] = this.#targets;
    const halfSize = { width: halve(width), height: halve(height) };
    const quarterSize = { width: halve(halfSize.width), height: halve(halfSize.height) };
    half.resize(halfSize.width, halfSize.height);
    quarter.resize(quarterSize.width, quarterSize.height);
    return [
      { stride: 4, first: [0, 0], ...quarterSize, target: quarter, half: null, isCoarse: true },
      { stride: 2, first: [0, 0], ...halfSize, target: half, half: this.#from(quarter), isCoarse: true },
      { stride: 1, first: [0, 0], width, height, target, half: this.#from(half) },
    ];
  }

  #from(half: DrawTarget): HalfPicture {
    return { draw: (...drawn) => this.#between.draw(half, ...drawn) };
  }

  dispose(): void {
    this.#between.dispose();
    for (const target of this.#targets) target.dispose();
  }
}
