import type { Gl } from '../device/device.ts';
import type { DrawTarget } from '../device/draw-target.ts';
import type { Pass, Size } from '../passes/pass-drawing.ts';

/** The coarser pictures that a picture with adaptive ray sampling is drawn from. */
export interface CoarsePictures {
  /** What to draw, one after the other, for a picture of a size. @param target - of the picture itself */
  passes(size: Size, target: DrawTarget): Pass[];
  dispose(): void;
}

/** Makes them. It comes with what plans pictures in motion: those before have all their rays. */
export let makeCoarsePictures: ((gl: Gl) => CoarsePictures) | null = null;

export function provideCoarsePictures(make: (gl: Gl) => CoarsePictures): void {
  makeCoarsePictures = make;
}
