import { spacingOf } from '../../volume/grid.ts';
import { multiply, scaleAndTranslate, subtract, transformPoint } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';

/**
 * Gives an affine's axes other lengths. Their directions and the middle of the volume stay.
 * @param spacing - world length of one voxel step along i, j and k
 */
export function respace(indexToWorld: Matrix4, dimensions: Vector3, spacing: Vector3): Matrix4 {
  const own = spacingOf(indexToWorld);
  const ratio: Vector3 = [spacing[0] / own[0], spacing[1] / own[1], spacing[2] / own[2]];
  const middle: Vector3 = [(dimensions[0] - 1) / 2, (dimensions[1] - 1) / 2, (dimensions[2] - 1) / 2];
  const scaled = multiply(indexToWorld, scaleAndTranslate(ratio, [0, 0, 0]));
  const shift = subtract(transformPoint(indexToWorld, middle), transformPoint(scaled, middle));
  return multiply(scaleAndTranslate([1, 1, 1], shift), scaled);
}
