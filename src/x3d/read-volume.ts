import type { Pixels } from '../optics/between-pixels.ts';
import type { DrawTarget } from '../renderer/draw-target.ts';
import type { ShapeDepths, SurfaceLattice } from '../renderer/ray/ray-module.ts';
import { readPicture } from '../renderer/read-picture.ts';
import type { View, VolumeLayer } from '../renderer/volume-layer.ts';
import { castableRays } from '../renderer/volume-pictures.ts';

/** What adaptive ray sampling would be done to. */
export interface VolumePicture {
  /** Of the volume alone, with all rays: premultiplied, bottom row first. */
  readonly picture: Pixels;
  /** What shapes do to the quads of a lattice of a stride, see optics/depth-jumps.ts. */
  readonly jumps: (stride: number, isCoarse: boolean) => Pixels;
}

/** A picture of a volume among shapes. */
export interface DrawnAmongShapes {
  readonly layer: VolumeLayer;
  readonly view: View;
  readonly depths: ShapeDepths;
  /** World length. */
  readonly stepLength: number;
  /** The volume's part. */
  readonly drawn: DrawTarget;
  /** Does what x3dom is not to know of. */
  readonly aside: <T>(work: () => T) => T;
}

export function readVolume({ layer, view, depths, stepLength, drawn, aside }: DrawnAmongShapes): VolumePicture {
  const { gl } = layer;
  return {
    picture: aside(() => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, drawn.framebuffer);
      return readPicture(gl, drawn);
    }),
    jumps: (stride, isCoarse) => aside(() => {
      const [width, height] = [drawn.width, drawn.height].map((pixels) => Math.ceil(pixels / stride));
      const lattice: SurfaceLattice = { stride, first: [0, 0], width, height, half: true, isCoarse };
      layer.inputs(castableRays(layer, view), { depths, projection: view.projection, picture: drawn, lattice, stepLength });
      return layer.surfacesModule!.readJumps();
    }),
  };
}
