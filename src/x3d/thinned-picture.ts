import type { PixelLattice } from '../optics/rays.ts';
import type { Gl } from './device.ts';
import { bytesAttachment, DrawTarget } from './draw-target.ts';
import type { Uniforms } from './uniforms.ts';

/** Pixels across and down. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Drawing all pixels of one lattice: those that the lattice before tells enough of are interpolated, others get rays. */
export interface Pass extends PixelLattice {
  /** What it is drawn into; null for the canvas. */
  readonly target: DrawTarget | null;
  /** The lattice before; null for the first, in which all pixels get rays. */
  readonly half: DrawTarget | null;
}

/** Lattices drawn before the picture, of every fourth and of every second pixel. */
const strides = [4, 2] as const;

/** A lattice reaches beyond the last pixel, so that this one lies between two of it. */
function halve(pixels: number): number {
  return Math.floor(pixels / 2) + 1;
}

/** The coarser pictures that a picture with thinned rays is drawn from. */
export class ThinnedPicture {
  readonly #targets: ReadonlyMap<number, DrawTarget>;

  constructor(gl: Gl) {
    this.#targets = new Map(strides.map((stride) => [stride, new DrawTarget(gl, [bytesAttachment(gl, 'uHalfPicture')])]));
  }

  /** What to draw, one after the other, for a picture of a size. @param target - of the picture itself; null for the canvas */
  passes({ width, height }: Size, target: DrawTarget | null): Pass[] {
    const [quarter, half] = strides.map((stride) => this.#targets.get(stride)!);
    const halfSize = { width: halve(width), height: halve(height) };
    const quarterSize = { width: halve(halfSize.width), height: halve(halfSize.height) };
    half.resize(halfSize.width, halfSize.height);
    quarter.resize(quarterSize.width, quarterSize.height);
    return [
      { stride: 4, first: 0, ...quarterSize, target: quarter, half: null },
      { stride: 2, first: 0, ...halfSize, target: half, half: quarter },
      { stride: 1, first: 0, width, height, target, half },
    ];
  }

  /** A picture is read even where no pixel is interpolated; any but the one that is drawn into. */
  spare(target: DrawTarget | null): DrawTarget {
    const spare = [...this.#targets.values()].find((one) => one !== target)!;
    if (spare.width === 0) spare.resize(1, 1);
    return spare;
  }

  dispose(): void {
    for (const target of this.#targets.values()) target.dispose();
  }
}

/** What the ray-caster knows of the lattice before. @param mostBend - 1/255, see quality/thinning.ts; 0 where all get rays */
export function thinningUniforms({ width, height }: Size, mostBend: number): Uniforms {
  return { uHalfPixel: [1 / width, 1 / height], uMostBend: mostBend > 0 ? mostBend / 255 : -1 };
}
