import { checkCounts, corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';
import { wholeList } from './number-list.ts';
import type { NumberList } from './number-list.ts';
import { readPlyHeader } from './ply-header.ts';
import type { PlyElement, PlyHeader, PlyProperty } from './ply-header.ts';
import { binaryNumbers, textNumbers } from './ply-numbers.ts';
import type { NextNumber } from './ply-numbers.ts';
import { readSpace } from './space-comment.ts';

/** Maximum number of corners of a face. */
const maxCorners = 1000;

/** The properties of a vertex that are kept, by name. */
const kept = { positions: ['x', 'y', 'z'], normals: ['nx', 'ny', 'nz'], colors: ['red', 'green', 'blue'] } as const;

/** The largest value of colours of these types; colours of float types are shares already. */
const whites: Readonly<Record<string, number>> = { uchar: 255, uint8: 255, ushort: 65535, uint16: 65535 };

/**
 * Reads a PLY, as text or binary in either byte order. Faces of more than three corners become fans of triangles; other
 * elements are skipped.
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function readPly(bytes: Uint8Array): Mesh {
  const header = readPlyHeader(bytes);
  const [vertices, faces] = ['vertex', 'face'].map((name) => header.elements.find((element) => element.name === name));
  if (!vertices || !faces?.count)
    throw corrupt('PLY', 'has no faces (a cloud of points, maybe); expected the elements "vertex" and "face"');
  checkCounts('PLY', vertices.count, faces.count);
  checkRoom(bytes, header);
  const next =
    header.form === 'ascii'
      ? textNumbers(bytes, header.length)
      : binaryNumbers(bytes, header.length, header.form === 'binary_little_endian');
  let [data, indices]: [Pick<Mesh, keyof typeof kept> | null, Mesh['indices'] | null] = [null, null];
  for (const element of header.elements) {
    if (element === vertices) data = readVertices(element, next);
    else if (element === faces) indices = readFaces(element, next);
    else skip(element, next);
    if (data && indices) break;
  }
  return {
    ...data!,
    indices: indices!,
    space: readSpace(header.comments),
    format: 'PLY',
    ...listLeft(header.elements, data!.colors ? null : faces),
  };
}

/** Elements that are a part of the shape, or colour it. */
const shapes: Readonly<Record<string, string>> = {
  edge: 'edges',
  tristrips: 'strips of triangles',
  material: 'materials',
};

/** @param faces - where vertices have no colours, and these may */
function listLeft(elements: readonly PlyElement[], faces: PlyElement | null): Pick<Mesh, 'left'> {
  const others = elements
    .filter(({ name, count }) => Object.hasOwn(shapes, name) && count > 0)
    .map(({ name, count }) => `${count.toLocaleString('en')} ${shapes[name]}`);
  if (faces?.properties.some(({ name }) => name === 'red')) others.push('colours of faces');
  return others.length > 0 ? { left: [`not shown: ${others.join(', ')}`] } : {};
}

/** Refuses a file that is too short for its own counts, before memory is allocated. */
function checkRoom(bytes: Uint8Array, { elements, form, length }: PlyHeader): void {
  const smallest = form === 'ascii' ? 2 : 1;
  const minBytes = elements.reduce((sum, { count, properties }) => sum + count * properties.length * smallest, 0);
  if (minBytes - 1 > bytes.length - length)
    throw corrupt(
      'PLY',
      `ends early: it has ${bytes.length.toLocaleString('en')} bytes; expected at least ${(length + minBytes).toLocaleString('en')}`,
    );
}

function readVertices({ count, properties }: PlyElement, next: NextNumber): Pick<Mesh, keyof typeof kept> {
  const names = properties.map(({ name }) => name);
  const has = (wanted: readonly string[]): boolean =>
    wanted.every((name) => properties[names.indexOf(name)]?.countType === null);
  if (!has(kept.positions)) throw corrupt('PLY', 'has vertices without x, y and z');
  const room = (wanted: readonly string[]): Float32Array<ArrayBuffer> | null =>
    has(wanted) ? new Float32Array(3 * count) : null;
  const arrays = { positions: room(kept.positions), normals: room(kept.normals), colors: room(kept.colors) };
  const targets = properties.map((property) => targetOf(property, arrays));
  for (let vertex = 0; vertex < count; vertex++) {
    for (let i = 0; i < properties.length; i++) {
      const target = targets[i];
      if (!target) skipProperty(properties[i], next);
      else target.array[3 * vertex + target.axis] = next(properties[i].type) / target.white;
    }
  }
  return { ...arrays, positions: arrays.positions! };
}

function targetOf(
  { name, type }: PlyProperty,
  arrays: Record<keyof typeof kept, Float32Array | null>,
): { array: Float32Array; axis: number; white: number } | null {
  for (const kind of Object.keys(kept) as (keyof typeof kept)[]) {
    const axis = (kept[kind] as readonly string[]).indexOf(name);
    const array = arrays[kind];
    if (axis >= 0 && array) return { array, axis, white: kind === 'colors' ? (whites[type] ?? 1) : 1 };
  }
  return null;
}

function readFaces({ count, properties }: PlyElement, next: NextNumber): Mesh['indices'] {
  const corners = properties.find(({ name, countType }) => countType && /^vertex_(indices|index)$/.test(name));
  if (!corners) throw corrupt('PLY', 'has faces without "vertex_indices"');
  const indices = wholeList();
  for (let face = 0; face < count; face++) {
    for (const property of properties) {
      if (property === corners) readFace(property, next, indices);
      else skipProperty(property, next);
    }
  }
  return indices.take();
}

function readFace(
  { type, countType }: PlyProperty,
  next: NextNumber,
  indices: NumberList<Uint32Array<ArrayBuffer>>,
): void {
  const corners = next(countType!);
  if (!(corners >= 3 && corners <= maxCorners))
    throw corrupt('PLY', `has a face of ${corners} corners; expected 3 to ${maxCorners}`);
  const first = cornerOf(next(type));
  let last = cornerOf(next(type));
  for (let corner = 2; corner < corners; corner++) {
    const one = cornerOf(next(type));
    indices.push(first);
    indices.push(last);
    indices.push((last = one));
  }
  checkCounts('PLY', 0, indices.length / 3);
}

/** A list of unsigned integers would turn -1 into a large number, and a fraction into 0. */
function cornerOf(number: number): number {
  if (!Number.isSafeInteger(number) || number < 0 || number >= 2 ** 32)
    throw corrupt('PLY', `has a face with the corner ${number}; expected numbers of vertices`);
  return number;
}

function skip({ count, properties }: PlyElement, next: NextNumber): void {
  if (properties.length === 0) return;
  for (let i = 0; i < count; i++) for (const property of properties) skipProperty(property, next);
}

function skipProperty({ type, countType }: PlyProperty, next: NextNumber): void {
  const count = countType ? next(countType) : 1;
  if (!(count >= 0)) throw corrupt('PLY', `has a list of ${count} numbers`);
  for (let i = 0; i < count; i++) next(type);
}
