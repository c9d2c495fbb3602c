import { VolumeViewError } from '../../core/errors.ts';
import { identity, multiply } from '../../volume/matrix.ts';
import type { Matrix4 } from '../../volume/matrix.ts';
import { checkCounts, corrupt } from './mesh-limits.ts';

/** The format's name in messages. */
export const format = 'glTF';

/** An object of a file; its fields are not checked yet. */
export type Json = Readonly<Record<string, unknown>>;

/** Triangles of a scene, and their place. */
export interface Primitive {
  /** From the mesh's own coordinates to the scene's. */
  readonly toScene: Matrix4;
  readonly mode: Mode;
  /** Indices of accessors. */
  readonly position: number;
  readonly normal: number | null;
  readonly color: number | null;
  readonly indices: number | null;
  /** The material's base colour, linear: red, green and blue. */
  readonly light: readonly number[];
}

/** How corners follow one another: three for each triangle, a strip, or a fan. */
export type Mode = 4 | 5 | 6;

/** Maximum number of nodes of a scene. */
const maxNodes = 100_000;

const isObject = (x: unknown): x is Json => typeof x === 'object' && x !== null && !Array.isArray(x);

/** A list of objects of the JSON. @throws {VolumeViewError} `format/corrupt` */
export function listOf(json: Json, name: string): readonly Json[] {
  const list = json[name] ?? [];
  if (!Array.isArray(list) || !list.every(isObject)) throw corrupt(format, `has "${name}" that are no list of objects`);
  return list;
}

/**
 * Lists the triangles of the default scene, each mesh once for each node that uses it. They are counted before memory
 * is allocated.
 * Source: *glTF 2.0 Specification*, Khronos Group, sections 3.5 to 3.7
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, `format/unsupported`
 */
export function listPrimitives(json: Json): readonly Primitive[] {
  const [nodes, meshes, scenes] = ['nodes', 'meshes', 'scenes'].map((name) => listOf(json, name));
  const children = nodes.map((node) => numbersOf(node, 'children', nodes.length));
  const inner = new Set(children.flat());
  const scene = scenes[Number(json['scene'] ?? 0)];
  const roots = scene ? numbersOf(scene, 'nodes', nodes.length) : nodes.map((_, i) => i).filter((i) => !inner.has(i));
  const waiting = roots.map((node) => ({ node, toScene: identity }));
  const seen = new Set<number>();
  const found: Primitive[] = [];
  const counts = { vertices: 0, triangles: 0 };
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const { node: index } = next;
    if (seen.has(index)) throw corrupt(format, `has the node ${index} in two places, or within itself`);
    seen.add(index);
    if (seen.size > maxNodes)
      throw new VolumeViewError(
        'format/too-large',
        `the glTF has more than ${maxNodes.toLocaleString('en')} nodes; expected fewer. Join its parts into one mesh`,
      );
    const node = nodes[index];
    const toScene = multiply(next.toScene, matrixOf(node));
    for (const child of children[index]) waiting.push({ node: child, toScene });
    if (node['mesh'] !== undefined) found.push(...primitivesOf(json, meshes[Number(node['mesh'])], toScene, counts));
  }
  return found;
}

function primitivesOf(
  json: Json,
  mesh: Json | undefined,
  toScene: Matrix4,
  counts: { vertices: number; triangles: number },
): Primitive[] {
  if (!mesh) throw corrupt(format, 'has a node whose mesh is missing');
  const accessors = listOf(json, 'accessors');
  const accessor = (value: unknown): number | null => {
    if (value === undefined) return null;
    if (!accessors[Number(value)])
      throw corrupt(
        format,
        `names an accessor, ${JSON.stringify(value).slice(0, 20)}, that is not one of its ${accessors.length}`,
      );
    return Number(value);
  };
  const found: Primitive[] = [];
  for (const primitive of listOf(mesh, 'primitives')) {
    const mode = primitive['mode'] ?? 4;
    const attributes = isObject(primitive['attributes']) ? primitive['attributes'] : {};
    const position = accessor(attributes['POSITION']);
    // Points and lines are not surfaces.
    if (position === null || (mode !== 4 && mode !== 5 && mode !== 6)) continue;
    const indices = accessor(primitive['indices']);
    const [vertices, corners] = [position, indices ?? position].map((index) => Number(accessors[index]['count']));
    counts.vertices += vertices;
    counts.triangles += mode === 4 ? Math.floor(corners / 3) : Math.max(0, corners - 2);
    checkCounts(format, counts.vertices, counts.triangles);
    found.push({
      toScene,
      mode,
      position,
      normal: accessor(attributes['NORMAL']),
      color: accessor(attributes['COLOR_0']),
      indices,
      light: lightOf(json, primitive['material']),
    });
  }
  return found;
}

/** Textures and transparency are ignored. */
function lightOf(json: Json, index: unknown): readonly number[] {
  const material = index === undefined ? {} : (listOf(json, 'materials')[Number(index)] ?? {});
  const matter = material['pbrMetallicRoughness'];
  const factor = isObject(matter) ? matter['baseColorFactor'] : null;
  const isColor =
    Array.isArray(factor) && factor.slice(0, 3).every((share) => typeof share === 'number' && share >= 0 && share <= 1);
  return isColor && factor.length >= 3 ? (factor.slice(0, 3) as number[]) : [1, 1, 1];
}

function matrixOf(node: Json): Matrix4 {
  if (node['matrix'] !== undefined) {
    const columns = fieldOf(node, 'matrix', identity);
    return Array.from({ length: 16 }, (_, i) => columns[4 * (i % 4) + Math.floor(i / 4)]);
  }
  const [x, y, z, w] = fieldOf(node, 'rotation', [0, 0, 0, 1]);
  const [a, b, c] = fieldOf(node, 'scale', [1, 1, 1]);
  const [right, up, out] = fieldOf(node, 'translation', [0, 0, 0]);
  // The matrix of a unit quaternion.
  return [
    a * (1 - 2 * (y * y + z * z)),
    b * 2 * (x * y - z * w),
    c * 2 * (x * z + y * w),
    right,
    a * 2 * (x * y + z * w),
    b * (1 - 2 * (x * x + z * z)),
    c * 2 * (y * z - x * w),
    up,
    a * 2 * (x * z - y * w),
    b * 2 * (y * z + x * w),
    c * (1 - 2 * (x * x + y * y)),
    out,
    0,
    0,
    0,
    1,
  ];
}

function fieldOf(node: Json, name: string, usual: readonly number[]): readonly number[] {
  const value = node[name] ?? usual;
  if (!Array.isArray(value) || value.length !== usual.length || !value.every(Number.isFinite))
    throw corrupt(format, `has a node whose ${name} is not ${usual.length} finite numbers`);
  return value as readonly number[];
}

function numbersOf(json: Json, name: string, count: number): readonly number[] {
  const list = json[name] ?? [];
  const isIndex = (x: unknown): boolean => Number.isInteger(x) && (x as number) >= 0 && (x as number) < count;
  if (!Array.isArray(list) || !list.every(isIndex))
    throw corrupt(format, `has "${name}" that are not numbers of its ${count} nodes`);
  return list as readonly number[];
}
