import { VolumeViewError } from '../../core/errors.ts';

/** Triangles of a surface at most: more than a picture has pixels. */
export const maxTriangles = 5_000_000;

/** Vertices at most, which a file of separate triangles has three times as many of. */
const maxVertices = 3 * maxTriangles;

/** Bytes of a file at most. */
export const maxMeshBytes = 2 ** 29;

/** Places farther out than this are no place. */
export const farthest = 1e9;

/**
 * Before there is room for them.
 * @param vertices - as many as a file says it has
 * @throws {VolumeViewError} `format/too-large`, `format/corrupt`
 */
export function checkCounts(format: string, vertices: number, triangles: number): void {
  for (const count of [vertices, triangles]) {
    if (!Number.isSafeInteger(count) || count < 0) throw corrupt(format, `says that it has ${count} parts; expected whole numbers`);
  }
  refuseMany(format, triangles, maxTriangles, 'triangles');
  refuseMany(format, vertices, maxVertices, 'vertices');
}

function refuseMany(format: string, count: number, most: number, what: string): void {
  if (count <= most) return;
  throw new VolumeViewError('format/too-large', `the ${format} has ${count.toLocaleString('en')} ${what} or more; expected at most ${most.toLocaleString('en')}. Make a copy with fewer triangles ("decimate" in MeshLab, Blender or 3D Slicer)`);
}

/** @param what - is wrong with it, as in "ends early" */
export function corrupt(format: string, what: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `the ${format} ${what}. Fetch the file again, or write it again`);
}
