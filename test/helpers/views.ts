import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { View } from './picture.ts';

/** A view of a whole volume, from above and from the side. */
export function viewFromAbove(volume: Volume, more: Partial<View> = {}): View {
  const diagonal = longestDiagonal(volume.grid);
  const camera = orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6);
  return { volume, camera, stepLength: diagonal / 45, ...more };
}
