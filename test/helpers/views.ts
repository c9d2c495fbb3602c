import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { plainOptics } from './picture.ts';
import type { View } from './picture.ts';
import { cloudCamera, cloudColors, cloudVolume } from './polar-cloud.ts';
import { syntheticVolume } from './synthetic.ts';
import type { SyntheticOptions } from './synthetic.ts';

/** A view of a whole volume, from above and from the side. */
export function viewFromAbove(volume: Volume, more: Partial<View> = {}): View {
  const diagonal = longestDiagonal(volume.grid);
  const camera = orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6);
  return { volume, camera, stepLength: diagonal / 45, ...more };
}

/** A small volume from above. */
export const smallView = (data: Partial<SyntheticOptions>, more?: Partial<View>): View =>
  viewFromAbove(syntheticVolume({ dimensions: [24, 20, 16], ...data }), more);

/** A view of the cloud that a radar sees. */
export function viewOfCloud(): View {
  const volume = cloudVolume(1);
  return {
    volume,
    camera: cloudCamera,
    stepLength: longestDiagonal(volume.grid) / 100,
    optics: { ...plainOptics, transferFunction: cloudColors, referenceLength: 3000 },
  };
}
