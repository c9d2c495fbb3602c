import { VolumeViewError } from '../../core/errors.ts';

/** Maximum number of triangles of a surface: more than a picture has pixels. */
export const maxTriangles = 5_000_000;

/** Maximum number of vertices: in a file of separate triangles, there are three times as many as triangles. */
const maxVertices = 3 * maxTriangles;

/** Maximum bytes of a file. */
export const maxMeshBytes = 2 ** 29;

/** Coordinates larger than this are invalid. */
export const farthest = 1e9;

/**
 * Call this before memory is allocated.
 * @param vertices - the number in the file's header
 * @throws {VolumeViewError} `format/too-large`, `format/corrupt`
 */
export function checkCounts(format: string, vertices: number, triangles: number): void {
  for (const count of [vertices, triangles]) {
    if (!Number.isSafeInteger(count) || count < 0)
      throw corrupt(format, `says that it has ${count} parts; expected whole numbers`);
  }
  refuseMany(format, triangles, maxTriangles, 'triangles');
  refuseMany(format, vertices, maxVertices, 'vertices');
}

function refuseMany(format: string, count: number, max: number, what: string): void {
  if (count <= max) return;
  throw new VolumeViewError(
    'format/too-large',
    `the ${format} has ${count.toLocaleString('en')} ${what} or more; expected at most ${max.toLocaleString('en')}. Make a copy with fewer triangles ("decimate" in MeshLab, Blender or 3D Slicer)`,
  );
}

/** @param what - is wrong with it, for example "ends early" */
export function corrupt(format: string, what: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `the ${format} ${what}. Fetch the file again, or write it again`);
}
