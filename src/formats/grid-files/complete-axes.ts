import { invertAffine, cross, length, normalize } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { corruptFile } from '../base/file-problem.ts';

/**
 * Voxel index to world, from the world step along each axis. An axis that a line or a flat image lacks is made
 * perpendicular to the others, one world unit long.
 * @param steps - one to three
 * @param origin - centre of the first voxel
 * @throws {VolumeViewError} `format/corrupt` if they do not span a volume
 */
export function completeAxes(what: string, steps: readonly Vector3[], origin: Vector3): Matrix4 {
  const [a, b = findUpright(a), c = normalize(cross(a, b))] = steps;
  const affine = [a[0], b[0], c[0], origin[0], a[1], b[1], c[1], origin[1], a[2], b[2], c[2], origin[2], 0, 0, 0, 1];
  if (affine.every(Number.isFinite) && invertAffine(affine)) return affine;
  throw corruptFile(
    what,
    `got the axes ${steps.map((step) => `(${step.join(', ')})`).join(' ')}; expected finite lengths above 0, and directions that do not lie in one plane`,
  );
}

/** A direction perpendicular to a line; along a world axis if the line is. */
function findUpright(a: Vector3): Vector3 {
  const along: Vector3 = Math.abs(a[1]) < 0.5 * length(a) ? [0, 1, 0] : [0, 0, 1];
  return normalize(cross(cross(a, along), a));
}
