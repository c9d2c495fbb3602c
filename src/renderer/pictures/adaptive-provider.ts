import type { Gl } from '../device/device.ts';
import type { DrawTarget } from '../device/draw-target.ts';
import type { Pass, Size } from '../passes/pass-drawing.ts';

/** The coarser pictures from which a picture with adaptive ray sampling is drawn. */
export interface CoarsePictures {
  /** The passes for a picture of a given size, in the order of drawing. @param target - the target of the picture itself */
  passes(size: Size, target: DrawTarget): Pass[];
  dispose(): void;
}

/** Makes the coarser pictures. The code that plans pictures in motion provides it; pictures drawn before that have all their rays. */
export let makeCoarsePictures: ((gl: Gl) => CoarsePictures) | null = null;

export function provideCoarsePictures(make: (gl: Gl) => CoarsePictures): void {
  makeCoarsePictures = make;
}
