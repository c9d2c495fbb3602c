import type { Pixels } from '../optics/rays/between-pixels.ts';
import type { SurfaceLattice } from '../renderer/ray/ray-module.ts';
import { readPicture } from '../renderer/device/read-picture.ts';
import { castableRays } from '../renderer/pictures/volume-pictures.ts';
import type { Cast, VolumePictures } from '../renderer/pictures/volume-pictures.ts';

/** The picture to which adaptive ray sampling would be applied. */
export interface VolumePicture {
  /** The volume alone, with all rays: premultiplied, bottom row first. */
  readonly picture: Pixels;
  /**
   * The effect of shapes on the quads of a lattice with a stride, see optics/rays/depth-jumps.ts. @returns a function
   * that reads it, before others are drawn
   */
  readonly startJumps: (stride: number, isCoarse: boolean) => () => Pixels;
}

/**
 * Reads the volume's part of a picture that contains shapes.
 * @param cast - how it was drawn
 * @param pictures - what has drawn it
 * @param aside - runs code outside of x3dom's own drawing
 */
export function readVolume(
  { view, picture, depths, stepLength }: Cast,
  { gl, layer, gathered }: VolumePictures,
  aside: <T>(work: () => T) => T,
): VolumePicture {
  return {
    picture: aside(() => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, gathered!.framebuffer);
      return readPicture(gl, gathered!);
    }),
    startJumps: (stride, isCoarse) =>
      aside(() => {
        const [width, height] = [picture.width, picture.height].map((pixels) => Math.ceil(pixels / stride));
        const lattice: SurfaceLattice = { stride, first: [0, 0], width, height, half: true, isCoarse };
        layer.inputs(castableRays(layer, view), {
          depths: depths!,
          projection: view.projection,
          picture,
          lattice,
          stepLength,
        });
        return () => aside(() => layer.surfacesModule!.readJumps());
      }),
  };
}
