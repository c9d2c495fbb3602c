import type { Surface, SurfacePart } from './surface.ts';
import { sidesOf } from './world-cut.ts';
import type { HalfWorld, WorldCut } from './world-cut.ts';

/** x, y and z of a point, its normal, and its colour if it has one. */
type Corner = readonly number[];

/** A flat and convex polygon, its corners in order. */
type Polygon = readonly Corner[];

/**
 * Bits of a vertex's code. Each of the first six is set if the vertex lies at or beyond one side of the removed box;
 * each of the others if it lies outside of one of the halves that are kept.
 */
const boxBits = 0b111111;
const keptFrom = 6;

/** The number of halves that a code has bits for. A volume is cut by 18 at most: six planes, a box, and the region. */
export const maxHalves = 32 - keptFrom;

/** Maximum number of vertices that 16-bit indices can address. */
const maxVertices = 65_535;

/** One code for each vertex of a part. */
const codes = new Uint32Array(65_536);

/**
 * Cuts a surface. Triangles that cross a cut are divided, with normals and colours interpolated along their edges, in
 * float64. All others, and the vertices of their parts, stay the same arrays. Two triangles that share an edge get the
 * same point on it.
 * @param cut - at most `maxHalves`; a NaN, a normal of length zero and a box without a volume cut nothing
 * @returns the surface itself if nothing of it is cut away, null if all of it is. The box around it stays that of the
 * whole surface
 * Source: Sutherland and Hodgman, *Reentrant Polygon Clipping*, 1974
 */
export function cutSurface(surface: Surface, cut: WorldCut): Surface | null {
  const cutter = new Cutter(cut);
  const parts = surface.parts.flatMap((part) => cutter.cut(part));
  if (parts.length === surface.parts.length && parts.every((part, i) => part === surface.parts[i])) return surface;
  return parts.length === 0
    ? null
    : { ...surface, parts, triangles: parts.reduce((sum, { indices }) => sum + indices.length / 3, 0) };
}

class Cutter {
  readonly #kept: readonly HalfWorld[];
  /** The halves whose intersection is the removed box. */
  readonly #sides: readonly HalfWorld[];
  /** Indices of the triangles that are not divided; as long as those of the largest part. */
  #whole = new Uint16Array(0);

  constructor({ kept, removed }: WorldCut) {
    this.#kept = kept
      .filter(({ normal, at }) => !Number.isNaN(at) && normal.every(Number.isFinite) && normal.some((x) => x !== 0))
      .slice(0, maxHalves);
    this.#sides = removed?.every(([low, high]) => high > low) ? sidesOf([removed]) : [];
  }

  /** What is left of a part: the part itself, or a part of its whole triangles and parts of the divided ones. */
  cut(part: SurfacePart): SurfacePart[] {
    const { indices } = part;
    const all = this.#encode(part.positions);
    if (this.#isWhole(all.any, all.every)) return [part];
    if (this.#isGone(all.any, all.every)) return [];
    if (this.#whole.length < indices.length) this.#whole = new Uint16Array(indices.length);
    const whole = this.#whole;
    const divided = new PartBuilder(part);
    let count = 0;
    for (let i = 0; i < indices.length; i += 3) {
      const a = indices[i];
      const b = indices[i + 1];
      const c = indices[i + 2];
      const any = codes[a] | codes[b] | codes[c];
      const every = codes[a] & codes[b] & codes[c];
      if (this.#isGone(any, every)) continue;
      if (this.#isWhole(any, every)) {
        whole[count] = a;
        whole[count + 1] = b;
        whole[count + 2] = c;
        count += 3;
      } else {
        for (const piece of this.#divide([cornerOf(part, a), cornerOf(part, b), cornerOf(part, c)], any))
          divided.add(piece);
      }
    }
    if (count === indices.length) return [part];
    return [...(count > 0 ? [{ ...part, indices: whole.slice(0, count) }] : []), ...divided.finish()];
  }

  /** Writes the codes of vertices. @returns bits that any vertex has, and bits that every one has */
  #encode(positions: Float32Array): { any: number; every: number } {
    const count = positions.length / 3;
    codes.fill(0, 0, count);
    const mark = ({ normal: [a, b, c], at }: HalfWorld, bit: number, isSide: boolean): void => {
      for (let vertex = 0, i = 0; vertex < count; vertex++, i += 3) {
        const distance = a * positions[i] + b * positions[i + 1] + c * positions[i + 2] - at;
        if (distance < 0 || (isSide && distance === 0)) codes[vertex] |= bit;
      }
    };
    this.#sides.forEach((side, i) => mark(side, 1 << i, true));
    this.#kept.forEach((half, i) => mark(half, 1 << (keptFrom + i), false));
    let [any, every] = [0, -1];
    for (let vertex = 0; vertex < count; vertex++) {
      any |= codes[vertex];
      every &= codes[vertex];
    }
    return { any, every };
  }

  /** Whether nothing is cut away of triangles whose vertices have these bits. */
  #isWhole(any: number, every: number): boolean {
    return (any & ~boxBits) === 0 && (this.#sides.length === 0 || (every & boxBits) !== 0);
  }

  /** Whether everything is cut away of them. */
  #isGone(any: number, every: number): boolean {
    return (every & ~boxBits) !== 0 || (this.#sides.length > 0 && (any & boxBits) === 0);
  }

  /** @param any - bits that any of its vertices has */
  #divide(triangle: Polygon, any: number): readonly Polygon[] {
    let left = triangle;
    for (const half of this.#kept.filter((_, i) => any & (1 << (keptFrom + i)))) [left] = divide(left, half);
    if (!hasArea(left)) return [];
    if (this.#sides.length === 0) return [left];
    // What is not in the box: beyond its first side, or else beyond its second, and so on.
    const pieces: Polygon[] = [];
    let rest = left;
    for (const side of this.#sides.filter((_, i) => any & (1 << i))) {
      const [within, beyond] = divide(rest, side);
      if (!hasArea(within)) return [left];
      if (hasArea(beyond)) pieces.push(beyond);
      rest = within;
    }
    return pieces;
  }
}

const hasArea = (polygon: Polygon): boolean => polygon.length > 2;

/** Divides a polygon by a plane. What lies on the plane is in both parts. */
function divide(polygon: Polygon, { normal: [a, b, c], at }: HalfWorld): [within: Polygon, beyond: Polygon] {
  const distances = polygon.map(([x, y, z]) => a * x + b * y + c * z - at);
  const [within, beyond]: [Corner[], Corner[]] = [[], []];
  polygon.forEach((corner, i) => {
    const next = (i + 1) % polygon.length;
    const [here, there] = [distances[i], distances[next]];
    if (here >= 0) within.push(corner);
    if (here <= 0) beyond.push(corner);
    if (!(here > 0 && there < 0) && !(here < 0 && there > 0)) return;
    // Always computed from the inside, so that both triangles of an edge get the same point, to the last digit.
    const met =
      here > 0
        ? between(corner, polygon[next], here / (here - there))
        : between(polygon[next], corner, there / (there - here));
    within.push(met);
    beyond.push(met);
  });
  return [within, beyond];
}

/** Linear, except for the normal, which keeps its length of 1. */
function between(from: Corner, to: Corner, share: number): Corner {
  const met = from.map((x, i) => x + share * (to[i] - x));
  const length = Math.hypot(met[3], met[4], met[5]);
  for (let i = 3; i < 6; i++) met[i] = length > 0 ? met[i] / length : from[i];
  return met;
}

function cornerOf({ positions, normals, colors }: SurfacePart, vertex: number): Corner {
  const i = 3 * vertex;
  const corner = [positions[i], positions[i + 1], positions[i + 2], normals[i], normals[i + 1], normals[i + 2]];
  return colors ? [...corner, colors[i], colors[i + 1], colors[i + 2]] : corner;
}

/** Makes parts of polygons. */
class PartBuilder {
  readonly #done: SurfacePart[] = [];
  #corners: Corner[] = [];
  #indices: number[] = [];

  /** @param like - a part that shows whether there are colours */
  constructor(readonly like: SurfacePart) {}

  /** Adds a polygon as a fan of triangles. */
  add(polygon: Polygon): void {
    if (this.#corners.length + polygon.length > maxVertices) this.#close();
    const first = this.#corners.length;
    this.#corners.push(...polygon);
    for (let i = 2; i < polygon.length; i++) this.#indices.push(first, first + i - 1, first + i);
  }

  finish(): readonly SurfacePart[] {
    if (this.#corners.length > 0) this.#close();
    return this.#done;
  }

  #close(): void {
    const corners = this.#corners;
    const pick = (from: number): Float32Array<ArrayBuffer> => {
      const numbers = new Float32Array(3 * corners.length);
      corners.forEach((corner, i) => numbers.set([corner[from], corner[from + 1], corner[from + 2]], 3 * i));
      return numbers;
    };
    this.#done.push({
      positions: pick(0),
      normals: pick(3),
      indices: Uint16Array.from(this.#indices),
      colors: this.like.colors && pick(6),
    });
    [this.#corners, this.#indices] = [[], []];
  }
}
