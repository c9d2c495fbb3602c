import { viewMatrix } from '../../optics/rays/camera.ts';
import type { Camera } from '../../optics/rays/camera.ts';
import { transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { View } from '../model/scene.ts';

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

/** Device coordinates of a place, -1..1 inside the picture, and its distance in front of the eye. */
export function projectInView({ view, projection: p }: View, at: Vector3): { x: number; y: number; depth: number } {
  const eye = transformPoint(view, at);
  const [x, y, w] = [0, 4, 12].map((row) => p[row] * eye[0] + p[row + 1] * eye[1] + p[row + 2] * eye[2] + p[row + 3]);
  return { x: x / w, y: y / w, depth: -eye[2] };
}
