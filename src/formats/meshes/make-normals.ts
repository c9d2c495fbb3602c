import type { Mesh } from './mesh.ts';

/** Faces that meet at a sharper angle than this keep their edge, degrees; others look round. */
const sharp = 60;

/** Vertices of more triangles than this are treated as round: to find their edges would take long. */
const maxFaces = 256;

/**
 * Adds normals to a mesh: the means of the faces around each vertex, weighted by area. A vertex on an edge becomes
 * several.
 * @param crease - degrees; 180 for no edges
 */
export function makeNormals(mesh: Mesh, crease = sharp): Mesh & { readonly normals: Float32Array<ArrayBuffer> } {
  const { positions, indices, colors } = mesh;
  const faces = faceNormals(positions, indices);
  const { firsts, corners } = cornersOf(indices, positions.length / 3);
  const origins = new Uint32Array(indices.length); // There are at most as many vertices as corners.
  const sums = new Float32Array(3 * indices.length);
  const renamed = new Uint32Array(indices.length);
  const creaseCosine = Math.cos((crease * Math.PI) / 180);
  let count = 0;
  for (let vertex = 0; vertex + 1 < firsts.length; vertex++) {
    const [from, to] = [firsts[vertex], firsts[vertex + 1]];
    const first = count;
    const hasEdges = crease < 180 && to - from <= maxFaces;
    for (let i = from; i < to; i++) {
      const face = Math.floor(corners[i] / 3);
      let group = first;
      if (hasEdges) while (group < count && cosineOf(sums, group, faces, face) < creaseCosine) group++;
      if (group === count) origins[count++] = vertex;
      for (let axis = 0; axis < 3; axis++) sums[3 * group + axis] += faces[3 * face + axis];
      renamed[corners[i]] = group;
    }
  }
  return {
    ...mesh,
    positions: pick(positions, origins, count),
    colors: colors && pick(colors, origins, count),
    normals: unit(sums.slice(0, 3 * count)),
    indices: renamed,
  };
}

/** Normals of the faces; their length is twice the face's area. */
function faceNormals(positions: Float32Array, indices: Uint32Array): Float32Array {
  const normals = new Float32Array(indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    const [ux, uy, uz] = [
      positions[b] - positions[a],
      positions[b + 1] - positions[a + 1],
      positions[b + 2] - positions[a + 2],
    ];
    const [vx, vy, vz] = [
      positions[c] - positions[a],
      positions[c + 1] - positions[a + 1],
      positions[c + 2] - positions[a + 2],
    ];
    normals[i] = uy * vz - uz * vy;
    normals[i + 1] = uz * vx - ux * vz;
    normals[i + 2] = ux * vy - uy * vx;
  }
  return normals;
}

/** The corners at each vertex, one vertex after the other, and the index at which those of each vertex begin. */
function cornersOf(indices: Uint32Array, vertices: number): { firsts: Uint32Array; corners: Uint32Array } {
  const firsts = new Uint32Array(vertices + 1);
  for (const vertex of indices) firsts[vertex + 1]++;
  for (let vertex = 0; vertex < vertices; vertex++) firsts[vertex + 1] += firsts[vertex];
  const next = firsts.slice();
  const corners = new Uint32Array(indices.length);
  indices.forEach((vertex, corner) => (corners[next[vertex]++] = corner));
  return { firsts, corners };
}

/** Cosine of the angle between a group's normal and a face's; 1 if either has no direction. */
function cosineOf(sums: Float32Array, group: number, faces: Float32Array, face: number): number {
  const [a, b] = [3 * group, 3 * face];
  const [sx, sy, sz, fx, fy, fz] = [sums[a], sums[a + 1], sums[a + 2], faces[b], faces[b + 1], faces[b + 2]];
  const lengths = Math.sqrt((sx * sx + sy * sy + sz * sz) * (fx * fx + fy * fy + fz * fz));
  return lengths > 0 ? (sx * fx + sy * fy + sz * fz) / lengths : 1;
}

function pick(numbers: Float32Array, origins: Uint32Array, count: number): Float32Array<ArrayBuffer> {
  const picked = new Float32Array(3 * count);
  for (let i = 0; i < count; i++)
    for (let axis = 0; axis < 3; axis++) picked[3 * i + axis] = numbers[3 * origins[i] + axis];
  return picked;
}

function unit(sums: Float32Array<ArrayBuffer>): Float32Array<ArrayBuffer> {
  for (let i = 0; i < sums.length; i += 3) {
    const length = Math.hypot(sums[i], sums[i + 1], sums[i + 2]);
    // The direction is arbitrary for faces that have no area, or that cancel each other.
    if (length > 0) for (let axis = 0; axis < 3; axis++) sums[i + axis] /= length;
    else sums.set([0, 0, 1], i);
  }
  return sums;
}
