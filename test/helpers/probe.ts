import type { PixelLattice } from '../../src/optics/rays/rays.ts';
import type { Size } from '../../src/viewer/model/scene.ts';
import type { VolumeScene } from '../../src/x3d/scene.ts';

/**
 * Draw the volume of a scene's last picture at a lattice of its rays, in floats, with several step lengths (in world units).
 * @returns for each step length RGBA, premultiplied, 0..1, bottom row first; null if the device can't draw floats
 */
export function probe(
  scene: VolumeScene,
  stepLengths: readonly number[],
  lattice: PixelLattice,
  picture: Size,
): Float32Array[] | null {
  const pictures = stepLengths.map((stepLength) => scene.startProbe({ stepLength }, lattice, picture)?.() ?? null);
  return pictures.includes(null) ? null : (pictures as Float32Array[]);
}
