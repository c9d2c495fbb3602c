import { viewMatrix } from '../../optics/rays/camera.ts';
import type { Camera } from '../../optics/rays/camera.ts';
import { transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/**
 * Where a camera shows a place of the world.
 * @param size - of the picture, CSS pixels
 * @returns CSS pixels from its left and top edge; null for a place behind the eye
 */
export function projectPlace(
  camera: Camera,
  world: Vector3,
  { width, height }: { readonly width: number; readonly height: number },
): readonly [x: number, y: number] | null {
  const [x, y, z] = transformPoint(viewMatrix(camera), world);
  if (!(z < 0)) return null;
  const reach = height / 2 / Math.tan(camera.fieldOfView / 2) / -z;
  return [width / 2 + reach * x, height / 2 - reach * y];
}
