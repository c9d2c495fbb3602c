import type { Vector3 } from '../../volume/matrix.ts';
import type { Surface } from '../../volume/surface.ts';
import { checkMesh } from './check-mesh.ts';
import { makeNormals } from './make-normals.ts';
import type { Mesh, MeshSpace } from './mesh.ts';
import { splitMesh } from './split-mesh.ts';
import { weld } from './weld.ts';

/**
 * Makes a drawable surface of a file's mesh: checked, joined, with normals, in world coordinates and in parts.
 * @param space - the directions of its axes; null for what the file says, or else to the right, front and head
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function finishMesh(mesh: Mesh, space: MeshSpace | null): Surface {
  const checked = checkMesh(mesh);
  const { normals } = checked;
  const lit = normals ? { ...checked, normals } : makeNormals(checkMesh(weld(checked)));
  const own = space ?? mesh.space;
  if (own === 'lps') turnAround(lit);
  if (own === 'gltf') standUp(lit);
  const parts = splitMesh(lit);
  return {
    parts,
    ...boundsOf(parts.map((part) => part.positions)),
    triangles: lit.indices.length / 3,
    format: mesh.format,
    notes: mesh.left ?? [],
  };
}

/** Half a turn around the axis to the head: from left and back to right and front. */
function turnAround({ positions, normals }: Mesh): void {
  for (const numbers of [positions, normals!]) {
    for (let i = 0; i < numbers.length; i += 3) {
      numbers[i] *= -1;
      numbers[i + 1] *= -1;
    }
  }
}

/** From glTF's space (metres, y up, the subject looks to +z) to millimetres to the right, front and head. */
function standUp({ positions, normals }: Mesh): void {
  for (const [numbers, unit] of [
    [positions, 1000],
    [normals!, 1],
  ] as const) {
    for (let i = 0; i < numbers.length; i += 3) {
      const [x, y, z] = numbers.subarray(i, i + 3);
      numbers.set([-unit * x, unit * z, unit * y], i);
    }
  }
}

/** The box around some positions. */
export function boundsOf(places: readonly Float32Array[]): { low: Vector3; high: Vector3 } {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const numbers of places) {
    for (let i = 0; i < numbers.length; i++) {
      const axis = i % 3;
      if (numbers[i] < low[axis]) low[axis] = numbers[i];
      if (numbers[i] > high[axis]) high[axis] = numbers[i];
    }
  }
  return { low, high };
}
