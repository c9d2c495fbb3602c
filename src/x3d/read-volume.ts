import type { Pixels } from '../optics/rays/between-pixels.ts';
import type { SurfaceLattice } from '../renderer/ray/ray-module.ts';
import { readPicture } from '../renderer/device/read-picture.ts';
import { castableRays } from '../renderer/pictures/volume-pictures.ts';
import type { Cast, VolumePictures } from '../renderer/pictures/volume-pictures.ts';

/** What adaptive ray sampling would be done to. */
export interface VolumePicture {
  /** Of the volume alone, with all rays: premultiplied, bottom row first. */
  readonly picture: Pixels;
  /** What shapes do to the quads of a lattice of a stride, see optics/rays/depth-jumps.ts. @returns reads it, before others are drawn */
  readonly startJumps: (stride: number, isCoarse: boolean) => () => Pixels;
}

/**
 * The volume's part of a picture that shapes stand in.
 * @param cast - how it was drawn; pictures - what has drawn it
 * @param aside - does what x3dom is not to know of
 */
export function readVolume({ view, picture, depths, stepLength }: Cast, { gl, layer, gathered }: VolumePictures, aside: <T>(work: () => T) => T): VolumePicture {
  return {
    picture: aside(() => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, gathered!.framebuffer);
      return readPicture(gl, gathered!);
    }),
    startJumps: (stride, isCoarse) => aside(() => {
      const [width, height] = [picture.width, picture.height].map((pixels) => Math.ceil(pixels / stride));
      const lattice: SurfaceLattice = { stride, first: [0, 0], width, height, half: true, isCoarse };
      layer.inputs(castableRays(layer, view), { depths: depths!, projection: view.projection, picture, lattice, stepLength });
      return () => aside(() => layer.surfacesModule!.readJumps());
    }),
  };
}
