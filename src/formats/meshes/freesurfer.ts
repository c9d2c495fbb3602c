// FreeSurfer's surfaces (lh.pial, rh.white). Loaded with the first of them. Source: nibabel 5.4, `freesurfer/io.py`; FreeSurfer, utils/mrisurf_io.cpp
import type { Vector3 } from '../../volume/matrix.ts';
import { checkCounts, corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';

const format = 'FreeSurfer surface';

/** Two lines say who wrote it. */
const longestLines = 4096;

/** What follows the triangles: whether places are those of the scanner, and the volume that the surface was made in. */
const [realTag, volumeTag] = [2, 20];

/** Bytes of what is said of that volume. */
const volumeBytes = 4096;

/** @throws {VolumeViewError} `format/corrupt`, `format/too-large` */
export function readFreeSurfer(bytes: Uint8Array): Mesh {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const first = bytes.indexOf(10, 3) + 1;
  const start = first > 0 ? bytes.indexOf(10, first) + 1 : 0;
  if (!(start > 0 && start < longestLines && start + 8 <= bytes.length))
    throw corrupt(format, 'lacks the lines at its start');
  const [vertices, triangles] = [view.getInt32(start), view.getInt32(start + 4)];
  checkCounts(format, vertices, triangles);
  const end = start + 8 + 12 * (vertices + triangles);
  if (end > bytes.length)
    throw corrupt(
      format,
      `ends early: it has ${bytes.length.toLocaleString('en')} bytes; expected at least ${end.toLocaleString('en')}`,
    );
  const positions = new Float32Array(3 * vertices);
  for (let i = 0, at = start + 8; i < positions.length; i++, at += 4) positions[i] = view.getFloat32(at);
  const indices = new Uint32Array(3 * triangles);
  for (let i = 0, at = start + 8 + 12 * vertices; i < indices.length; i++, at += 4) indices[i] = view.getUint32(at);
  const isPlaced = moveToScanner(positions, bytes.subarray(end));
  return {
    positions,
    normals: null,
    indices,
    colors: null,
    space: null,
    format,
    ...(isPlaced ? {} : { left: ['the volume that it was made in is not said: it may lie some millimetres off'] }),
  };
}

/**
 * From the middle of a volume, along the axes of a coronal scan, to millimetres of the scanner, as `mris_convert --to-scanner` does.
 * @returns whether the file says that volume
 */
function moveToScanner(positions: Float32Array, rest: Uint8Array): boolean {
  const view = new DataView(rest.buffer, rest.byteOffset, rest.length);
  const tagAt = (at: number): number => (at + 4 <= rest.length ? view.getInt32(at) : 0);
  const isReal = tagAt(0) === realTag;
  if (isReal && tagAt(4) === 1) return true;
  const start = isReal ? 8 : 0;
  if (tagAt(start) !== volumeTag) return false;
  const text = new TextDecoder('latin1').decode(rest.subarray(start + 4, start + 4 + volumeBytes));
  const read = (name: string): Vector3 => {
    const [, line = ''] = new RegExp(`^${name}\\s*=(.*)$`, 'm').exec(text) ?? [];
    return line.trim().split(/\s+/).slice(0, 3).map(Number) as unknown as Vector3;
  };
  const [x, y, z, center] = ['xras', 'yras', 'zras', 'cras'].map(read);
  const isKnown = [x, y, z, center].every((one) => one.length === 3 && one.every(Number.isFinite));
  if (!/^valid\s*=\s*1\b/m.test(text) || !isKnown) return false;
  for (let i = 0; i < positions.length; i += 3) {
    const [a, b, c] = positions.subarray(i, i + 3);
    for (let axis = 0; axis < 3; axis++) positions[i + axis] = b * z[axis] - a * x[axis] - c * y[axis] + center[axis];
  }
  return true;
}
