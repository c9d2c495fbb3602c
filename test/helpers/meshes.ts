import { VolumeViewError } from '../../src/core/errors.ts';
import { finishMesh } from '../../src/formats/meshes/finish-mesh.ts';
import type { MeshSpace } from '../../src/formats/meshes/mesh.ts';
import { readMesh } from '../../src/formats/meshes/read-mesh.ts';
import type { Surface } from '../../src/volume/surface.ts';
import { cross, dot, length, scale, subtract } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';

/** Read the bytes of a file, and make the surface that is drawn. */
export async function surfaceOf(
  bytes: Uint8Array<ArrayBuffer> | string,
  { name = 'some.mesh', space = null }: { name?: string; space?: MeshSpace | null } = {},
): Promise<Surface> {
  return finishMesh(await readMesh(typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytes, name), space);
}

/** The error for a file, as its code and message. */
export async function refusalOf(bytes: Uint8Array<ArrayBuffer> | string, name?: string): Promise<string> {
  try {
    const { triangles } = await surfaceOf(bytes, { name });
    return `${triangles} triangles`;
  } catch (error) {
    if (!(error instanceof VolumeViewError)) throw error;
    return `${error.code}: ${error.message}`;
  }
}

/** The corners of all triangles of a surface. */
export function trianglesOf({ parts }: Pick<Surface, 'parts'>): [Vector3, Vector3, Vector3][] {
  return parts.flatMap(({ positions, indices }) =>
    Array.from(
      { length: indices.length / 3 },
      (_, triangle) =>
        [0, 1, 2].map((corner) => [
          ...positions.subarray(3 * indices[3 * triangle + corner], 3 * indices[3 * triangle + corner] + 3),
        ]) as unknown as [Vector3, Vector3, Vector3],
    ),
  );
}

/** Measure a surface; the result does not depend on the numbering of its vertices. */
export function describeSurface(surface: Surface): {
  triangles: number;
  area: number;
  volume: number;
  center: Vector3;
  bounds: readonly [Vector3, Vector3];
} {
  const all = trianglesOf(surface);
  let [area, volume] = [0, 0];
  const center: [number, number, number] = [0, 0, 0];
  for (const [a, b, c] of all) {
    area += length(cross(subtract(b, a), subtract(c, a))) / 2;
    volume += dot(a, cross(b, c)) / 6;
    for (let axis = 0; axis < 3; axis++) center[axis] += (a[axis] + b[axis] + c[axis]) / 3;
  }
  return {
    triangles: all.length,
    area,
    volume: Math.abs(volume),
    center: scale(center, 1 / all.length),
    bounds: [surface.low, surface.high],
  };
}

/** A ball as a PLY: one ring of triangles above the other. */
export function ballPly(center: Vector3, radius: number, rings = 12): string {
  const places: Vector3[] = [];
  const faces: number[][] = [];
  const around = 2 * rings;
  for (let ring = 0; ring <= rings; ring++) {
    for (let i = 0; i < around; i++) {
      const [theta, phi] = [(Math.PI * ring) / rings, (2 * Math.PI * i) / around];
      places.push([
        center[0] + radius * Math.sin(theta) * Math.cos(phi),
        center[1] + radius * Math.sin(theta) * Math.sin(phi),
        center[2] + radius * Math.cos(theta),
      ]);
      const next = ring * around + ((i + 1) % around);
      if (ring < rings) faces.push([ring * around + i, (ring + 1) * around + i, next + around, next]);
    }
  }
  return [
    'ply',
    'format ascii 1.0',
    `element vertex ${places.length}`,
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    `element face ${faces.length}`,
    'property list uchar int vertex_indices',
    'end_header',
    ...places.map((place) => place.map((x) => x.toFixed(5)).join(' ')),
    ...faces.map((face) => `4 ${face.join(' ')}`),
    '',
  ].join('\n');
}

/** An octahedron around the origin as a glTF with its data in it; metres. */
export function octahedronGltf(radius: number): string {
  const places = Float32Array.from([1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1], (x) => radius * x);
  const corners = Uint16Array.of(0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5);
  const uriOf = (numbers: ArrayBufferView<ArrayBuffer>): string =>
    `data:application/octet-stream;base64,${btoa(String.fromCharCode(...new Uint8Array(numbers.buffer)))}`;
  return JSON.stringify({
    asset: { version: '2.0' },
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 6, type: 'VEC3' },
      { bufferView: 1, componentType: 5123, count: 24, type: 'SCALAR' },
    ],
    bufferViews: [places, corners].map(({ byteLength }, buffer) => ({ buffer, byteLength })),
    buffers: [places, corners].map((numbers) => ({ byteLength: numbers.byteLength, uri: uriOf(numbers) })),
  });
}
