// Surfaces of glTF files: loaded with the first of them.
import { VolumeViewError } from '../../core/errors.ts';
import { determinant } from '../../volume/determinant.ts';
import { cross, dot, transformPoint } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { numbersReader } from './gltf-numbers.ts';
import type { Numbers } from './gltf-numbers.ts';
import { format, listOf, listPrimitives } from './gltf-scene.ts';
import type { Json, Primitive } from './gltf-scene.ts';
import { corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';

/** Required extensions that can be ignored here, because they concern materials and light, or numbers of few bits. */
const harmless = /^(KHR_mesh_quantization|(KHR|EXT)_(materials|texture|lights)_.*)$/;

/**
 * Reads the triangles of a glTF's scene: a `.glb`, or a `.gltf` that contains its data. A colour is the vertex colour
 * times the material's. Textures, bones, animations, points and lines are left out.
 * Source: *glTF 2.0 Specification*, Khronos Group
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export function readGltf(bytes: Uint8Array<ArrayBuffer>): Mesh {
  const { json, chunk } = isBinary(bytes) ? splitGlb(bytes) : { json: parseJson(bytes), chunk: null };
  checkNeeds(json);
  const left = listLeft(json);
  return { ...join(listPrimitives(json), numbersReader(json, chunk)), ...(left.length > 0 ? { left } : {}) };
}

/** What of a file is not in its triangles, and would be seen. */
function listLeft(json: Json): string[] {
  const hasTexture = (material: Json): boolean => JSON.stringify(material).includes('"baseColorTexture"');
  const hasOthers = listOf(json, 'meshes').some((mesh) =>
    listOf(mesh, 'primitives').some(({ mode }) => typeof mode === 'number' && mode < 4),
  );
  const scenes = listOf(json, 'scenes').length;
  const left = [
    listOf(json, 'materials').some(hasTexture) ? 'its pictures (textures)' : '',
    hasOthers ? 'its points and lines' : '',
    listOf(json, 'skins').length > 0 ? 'what its bones do' : '',
    listOf(json, 'animations').length > 0 ? 'its animations' : '',
    scenes > 1 ? `${scenes - 1} of its ${scenes} scenes` : '',
  ].filter(Boolean);
  return left.length > 0 ? [`not shown: ${left.join(', ')}`] : [];
}

/** Binary files begin with "glTF", JSON with "{". */
function isBinary(bytes: Uint8Array): boolean {
  return bytes[0] === 0x67;
}

/** @throws {VolumeViewError} `format/corrupt` */
function parseJson(bytes: Uint8Array): Json {
  try {
    const json = JSON.parse(new TextDecoder().decode(bytes)) as unknown;
    if (typeof json === 'object' && json !== null) return json as Json;
  } catch {} // The error below explains it.
  throw corrupt(format, 'has no JSON that can be read');
}

/**
 * The two parts of a `.glb`: its JSON and its binary chunk. @throws {VolumeViewError} `format/corrupt`,
 * `format/unsupported`
 */
function splitGlb(bytes: Uint8Array<ArrayBuffer>): {
  readonly json: Json;
  readonly chunk: Uint8Array<ArrayBuffer> | null;
} {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  if (bytes.length < 20) throw corrupt(format, 'ends in its header');
  const version = view.getUint32(4, true);
  if (version !== 2) throw unsupported(`is of version ${version}`, 'version 2.0');
  const chunkAt = (at: number): Uint8Array<ArrayBuffer> | null => {
    if (at + 8 > bytes.length) return null;
    const end = at + 8 + view.getUint32(at, true);
    if (end > bytes.length)
      throw corrupt(
        format,
        `ends early: it has ${bytes.length.toLocaleString('en')} bytes; expected at least ${end.toLocaleString('en')}`,
      );
    return bytes.subarray(at + 8, end);
  };
  const first = chunkAt(12)!;
  return { json: parseJson(first), chunk: chunkAt(20 + first.length) };
}

/** @throws {VolumeViewError} `format/unsupported` if a file requires an extension that is not supported */
function checkNeeds(json: Json): void {
  const { version } = (json['asset'] ?? {}) as Json;
  if (!String(version).startsWith('2.'))
    throw unsupported(`is of version ${String(version).slice(0, 20)}`, 'version 2.0');
  const needs = [json['extensionsRequired'] ?? []]
    .flat()
    .map(String)
    .filter((name) => !harmless.test(name));
  if (needs.length > 0)
    throw unsupported(
      `is packed or extended by ${needs.join(', ').slice(0, 200)}`,
      'plain data: write it again without compression',
    );
  const other = listOf(json, 'buffers')
    .map(({ uri }) => uri)
    .find((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
  if (other !== undefined)
    throw unsupported(
      `has its data in another file, "${(other as string).slice(0, 80)}"`,
      'one file: write it as .glb',
    );
}

function unsupported(what: string, expected: string): VolumeViewError {
  return new VolumeViewError('format/unsupported', `the glTF ${what}; expected ${expected}`);
}

/** Joins all triangles into one mesh. */
function join(primitives: readonly Primitive[], read: (index: number) => Numbers): Mesh {
  const known = new Map<number, Numbers>();
  const numbers = (index: number): Numbers => {
    const found = known.get(index) ?? read(index);
    known.set(index, found);
    return found;
  };
  const places = primitives.map(({ position }) => vectors(numbers(position)));
  const total = places.reduce((sum, { count }) => sum + count, 0);
  const hasNormals = primitives.every(({ normal }, i) => normal !== null && numbers(normal).count === places[i].count);
  const hasColors = primitives.some(({ color, light }) => color !== null || light.some((share) => share !== 1));
  const positions = new Float32Array(3 * total);
  const [normals, colors] = [hasNormals, hasColors].map((has) => (has ? new Float32Array(3 * total) : null));
  const corners: Uint32Array[] = [];
  let first = 0;
  primitives.forEach((primitive, i) => {
    const { count } = places[i];
    addVectors(places[i], positions, first, (p) => transformPoint(primitive.toScene, p));
    if (normals) addVectors(vectors(numbers(primitive.normal!)), normals, first, normalsBy(primitive.toScene));
    if (colors)
      addColors(primitive, primitive.color === null ? null : numbers(primitive.color), colors, [first, count]);
    corners.push(cornersOf(primitive, primitive.indices === null ? null : numbers(primitive.indices), first, count));
    first += count;
  });
  const indices = new Uint32Array(corners.reduce((sum, { length }) => sum + length, 0));
  corners.reduce((at, part) => (indices.set(part, at), at + part.length), 0);
  return { positions, normals, indices, colors, space: 'gltf', format };
}

/** @throws {VolumeViewError} `format/corrupt` */
function vectors(numbers: Numbers): Numbers {
  if (numbers.size !== 3) throw corrupt(format, `has places or normals of ${numbers.size} numbers; expected 3`);
  return numbers;
}

function addVectors(
  { count, values }: Numbers,
  into: Float32Array,
  first: number,
  map: (vector: Vector3) => Vector3,
): void {
  for (let i = 0; i < count; i++) into.set(map([values[3 * i], values[3 * i + 1], values[3 * i + 2]]), 3 * (first + i));
}

/**
 * Transforms normals so that they stay perpendicular to their planes: by the matrix of cofactors, which is the inverse
 * transpose times the determinant, with the sign changed if that is negative.
 */
function normalsBy(m: Matrix4): (normal: Vector3) => Vector3 {
  const rows = [0, 4, 8].map((i): Vector3 => [m[i], m[i + 1], m[i + 2]]);
  const [a, b, c] = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
  const side = determinant(m) < 0 ? -1 : 1;
  return (n) => [side * dot(a, n), side * dot(b, n), side * dot(c, n)];
}

function addColors(
  { light }: Primitive,
  numbers: Numbers | null,
  into: Float32Array,
  [first, count]: readonly [number, number],
): void {
  for (let i = 0; i < count; i++) {
    for (let c = 0; c < 3; c++) {
      const share = numbers && i < numbers.count && c < numbers.size ? numbers.values[i * numbers.size + c] : 1;
      into[3 * (first + i) + c] = toScreen(Math.min(1, Math.max(0, light[c] * share)));
    }
  }
}

/** From linear light to sRGB. Source: IEC 61966-2-1 (sRGB) */
function toScreen(light: number): number {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
}

/** Corners of triangles, as vertex indices of the whole mesh. */
function cornersOf(
  { mode, toScene }: Primitive,
  numbers: Numbers | null,
  first: number,
  vertices: number,
): Uint32Array {
  const count = numbers ? numbers.count : vertices;
  const at = (i: number): number => {
    const vertex = numbers ? numbers.values[i * numbers.size] : i;
    if (!(vertex >= 0 && vertex < vertices))
      throw corrupt(format, `has a triangle with the vertex ${vertex}; expected numbers from 0 to ${vertices - 1}`);
    return first + vertex;
  };
  const triangles = mode === 4 ? Math.floor(count / 3) : Math.max(0, count - 2);
  const corners = new Uint32Array(3 * triangles);
  const isMirrored = determinant(toScene) < 0;
  for (let t = 0; t < triangles; t++) {
    const [a, b, c] =
      mode === 4
        ? [3 * t, 3 * t + 1, 3 * t + 2]
        : mode === 6
          ? [0, t + 1, t + 2]
          : [t, t + 1 + (t % 2), t + 2 - (t % 2)];
    corners.set(isMirrored ? [at(a), at(c), at(b)] : [at(a), at(b), at(c)], 3 * t);
  }
  return corners;
}
