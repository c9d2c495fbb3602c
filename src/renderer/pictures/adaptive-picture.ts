import type { Gl } from '../device/device.ts';
import type { CoarsePictures } from './adaptive-provider.ts';
import { bytesAttachment, DrawTarget } from '../device/draw-target.ts';
import type { Pass, Size } from '../passes/pass-drawing.ts';

/** Lattices drawn before the picture, of every fourth and of every second pixel. */
const strides = [4, 2] as const;

/** A lattice reaches beyond the last pixel, so that this one lies between two of it. */
function halve(pixels: number): number {
  return Math.floor(pixels / 2) + 1;
}

/** The coarser pictures that a picture with adaptive ray sampling is drawn from. */
export class AdaptivePicture implements CoarsePictures {
  readonly #targets: readonly DrawTarget[];

  constructor(gl: Gl) {
    this.#targets = strides.map(() => new DrawTarget(gl, [bytesAttachment(gl, 'uHalfPicture')]));
  }

  /** What to draw, one after the other, for a picture of a size. @param target - of the picture itself */
  passes({ width, height }: Size, target: DrawTarget): Pass[] {
    const [quarter, half] = this.#targets;
    const halfSize = { width: halve(width), height: halve(height) };
    const quarterSize = { width: halve(halfSize.width), height: halve(halfSize.height) };
    half.resize(halfSize.width, halfSize.height);
    quarter.resize(quarterSize.width, quarterSize.height);
    return [
      { stride: 4, first: [0, 0], ...quarterSize, target: quarter, half: null, isCoarse: true },
      { stride: 2, first: [0, 0], ...halfSize, target: half, half: quarter, isCoarse: true },
      { stride: 1, first: [0, 0], width, height, target, half },
    ];
  }

  dispose(): void {
    for (const target of this.#targets) target.dispose();
  }
}
