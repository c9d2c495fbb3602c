import { VolumeViewError } from '../../core/errors.ts';
import { corrupt, farthest } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';

/**
 * Checks a mesh. Returns it without triangles that have two equal corners, and without invalid normals and colours.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported` if a triangle refers to a vertex that does not
 * exist, or whose position is not finite, or if there are no triangles
 */
export function checkMesh(mesh: Mesh): Mesh {
  const { positions, indices, format } = mesh;
  const vertices = positions.length / 3;
  let kept = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i], indices[i + 1], indices[i + 2]];
    if (!(Math.max(a, b, c) < vertices))
      throw corrupt(
        format,
        `has a triangle with the vertex ${Math.max(a, b, c)}; expected numbers from 0 to ${vertices - 1}`,
      );
    checkPlace(mesh, a);
    checkPlace(mesh, b);
    checkPlace(mesh, c);
    if (a === b || b === c || c === a) continue;
    indices[kept++] = a;
    indices[kept++] = b;
    indices[kept++] = c;
  }
  if (kept === 0)
    throw new VolumeViewError(
      'format/unsupported',
      `the ${format} has no triangles; expected a surface, and not points or lines`,
    );
  return {
    ...mesh,
    indices: indices.slice(0, kept),
    normals: normalize(mesh.normals),
    colors: mesh.colors?.every((share) => share >= 0 && share <= 1) ? mesh.colors : null,
  };
}

function checkPlace({ positions, format }: Mesh, vertex: number): void {
  for (let i = 3 * vertex; i < 3 * vertex + 3; i++) {
    if (!(Math.abs(positions[i]) <= farthest))
      throw corrupt(
        format,
        `has a vertex, number ${vertex.toLocaleString('en')}, at ${[...positions.subarray(3 * vertex, 3 * vertex + 3)].join(', ')}; expected finite numbers`,
      );
  }
}

/** @returns null if one of them has no direction */
function normalize(normals: Mesh['normals']): Mesh['normals'] {
  if (!normals) return null;
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    if (!(length > 0) || length === Infinity) return null;
    for (let axis = 0; axis < 3; axis++) normals[i + axis] /= length;
  }
  return normals;
}
