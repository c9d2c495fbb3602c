import { checkCounts, corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';
import { floatList, wholeList } from './number-list.ts';
import { readSpace } from './space-comment.ts';
import { TextScanner } from './text-scanner.ts';

/** Whether a text is an OBJ: its first lines that are not comments begin with keywords of that format. */
export function isObj(text: string): boolean {
  const lines = text
    .split(/\r?\n/)
    .slice(0, -1)
    .filter((line) => !/^\s*(#.*)?$/.test(line));
  return (
    lines.length > 0 &&
    /^\s*(v|vn|vt|vp|f|o|g|s|mtllib|usemtl)\s/.test(lines[0]) &&
    lines.every((line) => /^\s*[a-z_]+(\s|$)/i.test(line))
  );
}

/** The parts of an OBJ that have been read. */
class Reading {
  readonly places = floatList();
  readonly colors = floatList();
  readonly normals = floatList();
  /** Of each corner of a triangle. */
  readonly corners = wholeList();
  /** The normal of each corner, counted from 1; 0 for none. */
  readonly cornerNormals = wholeList();
  space: Mesh['space'] = null;
  /** The words that begin lines which are no surface's, or name what colours it. */
  readonly others = new Set<string>();
}

/** What lines are of which nothing is shown. */
const leftOut: Readonly<Record<string, string>> = {
  usemtl: 'materials',
  map_Kd: 'materials',
  l: 'lines',
  p: 'points',
  curv: 'curves',
  curv2: 'curves',
  surf: 'free-form surfaces',
};

/**
 * Reads the faces of an OBJ: positions, normals, and colours that follow positions. Faces of more than three corners
 * become fans of triangles. Materials, textures, lines, points and curves are left out.
 * Source: *Advanced Visualizer Manual*, Wavefront, appendix B1
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function readObj(bytes: Uint8Array): Mesh {
  const scanner = new TextScanner(bytes);
  const reading = new Reading();
  for (; !scanner.isAtEnd; scanner.nextLine()) {
    const word = scanner.word();
    if (word === 'v') readVertex(scanner, reading);
    else if (word === 'vn') readNormal(scanner, reading);
    else if (word === 'f') readFace(scanner, reading);
    else if (Object.hasOwn(leftOut, word)) reading.others.add(leftOut[word]);
    else if (word.startsWith('#')) reading.space ??= readSpace(scanner.rest());
  }
  return join(reading);
}

function readVertex(scanner: TextScanner, { places, colors }: Reading): void {
  const numbers: number[] = [];
  for (let number = scanner.number(); !Number.isNaN(number) && numbers.length < 8; number = scanner.number())
    numbers.push(number);
  if (numbers.length < 3) throw corrupt('OBJ', `has no vertex of three numbers in line ${scanner.line}`);
  for (let i = 0; i < 3; i++) places.push(numbers[i]);
  // After the position comes its weight, or its colour, or both.
  const color = numbers.length >= 6 ? numbers.slice(-3) : null;
  if (color && colors.length === places.length - 3) color.forEach((channel) => colors.push(channel));
  checkCounts('OBJ', places.length / 3, 0);
}

function readNormal(scanner: TextScanner, { normals }: Reading): void {
  for (let i = 0; i < 3; i++) normals.push(scanner.number());
  checkCounts('OBJ', normals.length / 3, 0);
}

function readFace(scanner: TextScanner, { places, normals, corners, cornerNormals }: Reading): void {
  const counts = [places.length / 3, normals.length / 3];
  let [first, firstNormal, last, lastNormal, count] = [0, 0, 0, 0, 0];
  for (let word = scanner.word(); word !== '' && !word.startsWith('#'); word = scanner.word(), count++) {
    const [place, , normal] = word.split('/');
    const corner = indexOf(place, counts[0]);
    const cornerNormal = normal ? indexOf(normal, counts[1]) + 1 : 0;
    if (corner < 0 || cornerNormal < 0 || Number.isNaN(corner + cornerNormal))
      throw corrupt(
        'OBJ',
        `got "${word.slice(0, 40)}" in a face in line ${scanner.line}; expected numbers of vertices, of which there are ${counts[0].toLocaleString('en')} before it, and of normals`,
      );
    if (count === 0) [first, firstNormal] = [corner, cornerNormal];
    else if (count > 1) {
      [first, last, corner].forEach((one) => corners.push(one));
      [firstNormal, lastNormal, cornerNormal].forEach((one) => cornerNormals.push(one));
    }
    [last, lastNormal] = [corner, cornerNormal];
    checkCounts('OBJ', 0, corners.length / 3);
  }
  if (count < 3) throw corrupt('OBJ', `has a face of ${count} corners in line ${scanner.line}; expected three or more`);
}

/** An index from 0. Negative indices count back from the last. @returns NaN if the text is not an index */
function indexOf(text: string, count: number): number {
  const number = /^-?\d+$/.test(text) ? Number(text) : Number.NaN;
  const index = number < 0 ? count + number : number - 1;
  return index >= 0 && index < count ? index : Number.NaN;
}

/** A vertex for each pair of place and normal that faces name. */
function join({ places, colors, normals, corners, cornerNormals, space, others }: Reading): Mesh {
  const hasColors = colors.length === places.length && colors.length > 0;
  const base = {
    space,
    format: 'OBJ',
    ...(others.size > 0 ? { left: [`its ${[...others].join(', ')} are not shown`] } : {}),
  };
  const every = cornerNormals.take();
  if (every.length === 0 || every.includes(0))
    return {
      ...base,
      positions: places.take(),
      normals: null,
      indices: corners.take(),
      colors: hasColors ? colors.take() : null,
    };
  const [ownPlaces, ownNormals, ownColors] = [0, 1, 2].map(() => floatList());
  const found = new Map<number, number>();
  const indices = corners.take();
  const stride = normals.length / 3 + 1;
  for (let i = 0; i < indices.length; i++) {
    const [place, normal] = [indices[i], every[i] - 1];
    const key = place * stride + normal;
    let vertex = found.get(key);
    if (vertex === undefined) {
      found.set(key, (vertex = found.size));
      for (let axis = 0; axis < 3; axis++) {
        ownPlaces.push(places.at(3 * place + axis));
        ownNormals.push(normals.at(3 * normal + axis));
        if (hasColors) ownColors.push(colors.at(3 * place + axis));
      }
    }
    indices[i] = vertex;
  }
  return {
    ...base,
    positions: ownPlaces.take(),
    normals: ownNormals.take(),
    indices,
    colors: hasColors ? ownColors.take() : null,
  };
}
