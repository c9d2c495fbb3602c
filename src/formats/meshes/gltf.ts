// Surfaces of glTF files: loaded with the first of them.
import { ColorUtils, WebIO } from '@gltf-transform/core';
import type { Accessor, JSONDocument, vec3 } from '@gltf-transform/core';
import { VolumeViewError } from '../../errors.ts';
import { cross, determinant, dot, transformPoint } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { format, listOf, listPrimitives } from './gltf-scene.ts';
import type { Json, Primitive } from './gltf-scene.ts';
import { corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';

/** What a file may need and we do without, as it is of matter and light, or as the library knows it. */
const harmless = /^(KHR_mesh_quantization|(KHR|EXT)_(materials|texture|lights)_.*)$/;

/** A list that is not needed takes this place. */
const nothing = { componentType: 5121, count: 1, type: 'SCALAR' };

/**
 * Read the triangles of a glTF's scene: a `.glb`, or a `.gltf` that holds its data. Colours are those of the vertices times that of the material. Pictures,
 * bones, animations, points and lines are left out.
 * Source: *glTF 2.0 Specification*, Khronos Group
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export async function readGltf(bytes: Uint8Array<ArrayBuffer>): Promise<Mesh> {
  const io = new WebIO();
  try {
    const file = await parse(io, bytes);
    const { json } = file;
    checkNeeds(json);
    const primitives = listPrimitives(json);
    const needed = new Set(primitives.flatMap(({ position, normal, color, indices }) => [position, normal, color, indices]));
    const accessors = listOf(json, 'accessors').map((accessor, i) => (needed.has(i) ? accessor : nothing));
    const [bufferViews, buffers] = ['bufferViews', 'buffers'].map((name) => listOf(json, name));
    const data = await io.readJSON({ json: { asset: { version: '2.0' }, accessors, bufferViews, buffers } as unknown as JSONDocument['json'], resources: file.resources });
    return join(primitives, data.getRoot().listAccessors());
  } catch (cause) {
    if (cause instanceof VolumeViewError) throw cause;
    throw corrupt(format, `can not be read (${String(cause instanceof Error ? cause.message : cause).slice(0, 200)})`);
  }
}

async function parse(io: WebIO, bytes: Uint8Array<ArrayBuffer>): Promise<Pick<JSONDocument, 'resources'> & { json: Json }> {
  const isBinary = bytes[0] === 0x67; // "g" of "glTF", where JSON has a "{"
  return isBinary ? ((await io.binaryToJSON(bytes)) as unknown as Pick<JSONDocument, 'resources'> & { json: Json }) : { json: JSON.parse(new TextDecoder().decode(bytes)) as Json, resources: {} };
}

/** @throws {VolumeViewError} `format/unsupported` where a file needs what is not here */
function checkNeeds(json: Json): void {
  const { version } = (json['asset'] ?? {}) as Json;
  if (!String(version).startsWith('2.')) throw unsupported(`is of version ${String(version).slice(0, 20)}`, 'version 2.0');
  const needs = [json['extensionsRequired'] ?? []].flat().map(String).filter((name) => !harmless.test(name));
  if (needs.length > 0) throw unsupported(`is packed or extended by ${needs.join(', ').slice(0, 200)}`, 'plain data: write it again without compression');
  const other = listOf(json, 'buffers').map(({ uri }) => uri).find((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
  if (other !== undefined) throw unsupported(`has its data in another file, "${(other as string).slice(0, 80)}"`, 'one file: write it as .glb');
}

function unsupported(what: string, expected: string): VolumeViewError {
  return new VolumeViewError('format/unsupported', `the glTF ${what}; expected ${expected}`);
}

/** All in one mesh. */
function join(primitives: readonly Primitive[], accessors: readonly Accessor[]): Mesh {
  const total = primitives.reduce((sum, { position }) => sum + accessors[position].getCount(), 0);
  const hasNormals = primitives.every(({ normal, position }) => normal !== null && accessors[normal].getCount() === accessors[position].getCount());
  const hasColors = primitives.some(({ color, light }) => color !== null || light.some((share) => share !== 1));
  const [positions, normals, colors] = [true, hasNormals, hasColors].map((has) => (has ? new Float32Array(3 * total) : null));
  const corners: Uint32Array[] = [];
  let first = 0;
  for (const primitive of primitives) {
    const place = accessors[primitive.position];
    addVertices(place, positions!, first, (p) => transformPoint(primitive.toScene, p));
    if (normals) addVertices(accessors[primitive.normal!], normals, first, normalsBy(primitive.toScene));
    if (colors) addColors(primitive, accessors, colors, [first, place.getCount()]);
    corners.push(cornersOf(primitive, primitive.indices === null ? null : accessors[primitive.indices], first, place.getCount()));
    first += place.getCount();
  }
  const indices = new Uint32Array(corners.reduce((sum, { length }) => sum + length, 0));
  corners.reduce((at, part) => (indices.set(part, at), at + part.length), 0);
  return { positions: positions!, normals, indices, colors, space: 'gltf', format };
}

function addVertices(accessor: Accessor, into: Float32Array, first: number, map: (vector: Vector3) => Vector3): void {
  const element: number[] = [0, 0, 0];
  for (let i = 0; i < accessor.getCount(); i++) into.set(map(accessor.getElement(i, element) as unknown as Vector3), 3 * (first + i));
}

/** Planes stay planes: the matrix of cofactors, which is the inverse transpose times the determinant; turned back where that is negative. */
function normalsBy(m: Matrix4): (normal: Vector3) => Vector3 {
  const rows = [0, 4, 8].map((i): Vector3 => [m[i], m[i + 1], m[i + 2]]);
  const [a, b, c] = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
  const side = determinant(m) < 0 ? -1 : 1;
  return (n) => [side * dot(a, n), side * dot(b, n), side * dot(c, n)];
}

function addColors({ color, light }: Primitive, accessors: readonly Accessor[], into: Float32Array, [first, count]: readonly [number, number]): void {
  const accessor = color === null ? null : accessors[color];
  const element: number[] = [1, 1, 1];
  for (let i = 0; i < count; i++) {
    if (accessor && i < accessor.getCount()) accessor.getElement(i, element);
    const [red, green, blue] = light.map((share, channel) => Math.min(1, Math.max(0, share * element[channel])));
    into.set(ColorUtils.convertLinearToSRGB<vec3>([red, green, blue], [0, 0, 0]), 3 * (first + i));
  }
}

/** Corners of triangles, numbered in the whole mesh. */
function cornersOf({ mode, toScene }: Primitive, accessor: Accessor | null, first: number, vertices: number): Uint32Array {
  const count = accessor ? accessor.getCount() : vertices;
  const at = (i: number): number => {
    const vertex = accessor ? accessor.getScalar(i) : i;
    if (!(vertex < vertices)) throw corrupt(format, `has a triangle with the vertex ${vertex}; expected numbers from 0 to ${vertices - 1}`);
    return first + vertex;
  };
  const triangles = mode === 4 ? Math.floor(count / 3) : Math.max(0, count - 2);
  const corners = new Uint32Array(3 * triangles);
  const isMirrored = determinant(toScene) < 0;
  for (let t = 0; t < triangles; t++) {
    const [a, b, c] = mode === 4 ? [3 * t, 3 * t + 1, 3 * t + 2] : mode === 6 ? [0, t + 1, t + 2] : [t, t + 1 + (t % 2), t + 2 - (t % 2)];
    corners.set(isMirrored ? [at(a), at(c), at(b)] : [at(a), at(b), at(c)], 3 * t);
  }
  return corners;
}
