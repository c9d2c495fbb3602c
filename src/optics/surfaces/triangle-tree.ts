import type { SurfacePart } from '../../volume/surface.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** A ray in the world, of any length per t. */
export interface WorldRay {
  readonly origin: Vector3;
  readonly direction: Vector3;
}

/** A box with at most this many triangles is not cut further. */
const fewest = 4;

/**
 * The triangles of a part of a surface, in boxes within boxes, so that a ray has to test only a few. In float64.
 * Source: Kay and Kajiya, *Ray Tracing Complex Scenes*, 1986
 */
export class TriangleTree {
  readonly #order: Uint32Array;
  /** Six numbers per box: its lowest and its highest corner. */
  readonly #bounds: Float64Array;
  /** Per box: the number of the first of its two boxes, or -1 minus the index of its first triangle. */
  readonly #firsts: Int32Array;
  readonly #counts: Int32Array;
  #boxes = 0;

  constructor(readonly part: Pick<SurfacePart, 'positions' | 'indices'>) {
    const triangles = part.indices.length / 3;
    this.#order = Uint32Array.from({ length: triangles }, (_, i) => i);
    const max = Math.max(1, 2 * triangles);
    [this.#bounds, this.#firsts, this.#counts] = [new Float64Array(6 * max), new Int32Array(max), new Int32Array(max)];
    this.#boxes = 1;
    const open: [box: number, from: number, to: number][] = [[0, 0, triangles]];
    for (let next = open.pop(); next; next = open.pop()) open.push(...this.#cut(...next));
  }

  /**
   * All places at which a ray meets triangles, nearest first.
   * @param from - the smallest t
   */
  meet({ origin, direction }: WorldRay, from: number): Float64Array {
    const found: number[] = [];
    const inverse = direction.map((x) => 1 / x);
    const open = [0];
    for (let box = open.pop(); box !== undefined; box = open.pop()) {
      if (!this.#crosses(box, origin, inverse, from)) continue;
      const first = this.#firsts[box];
      if (first > 0) open.push(first, first + 1);
      else
        for (let i = 0; i < this.#counts[box]; i++)
          this.#meetTriangle(this.#order[-1 - first + i], { origin, direction }, from, found);
    }
    const sorted = Float64Array.from(found);
    sorted.sort();
    return sorted;
  }

  /** @returns the boxes to cut next */
  #cut(box: number, from: number, to: number): [number, number, number][] {
    const bounds = this.#bounds
      .subarray(6 * box, 6 * box + 6)
      .fill(Infinity, 0, 3)
      .fill(-Infinity, 3);
    const middles = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (let i = from; i < to; i++) {
      for (let axis = 0; axis < 3; axis++) {
        const [a, b, c] = this.#corners(this.#order[i], axis);
        bounds[axis] = Math.min(bounds[axis], a, b, c);
        bounds[axis + 3] = Math.max(bounds[axis + 3], a, b, c);
        const middle = a + b + c;
        middles[axis] = Math.min(middles[axis], middle);
        middles[axis + 3] = Math.max(middles[axis + 3], middle);
      }
    }
    const sizes = [0, 1, 2].map((axis) => middles[axis + 3] - middles[axis]);
    const axis = sizes.indexOf(Math.max(...sizes));
    if (to - from <= fewest || !(sizes[axis] > 0)) {
      this.#firsts[box] = -1 - from;
      this.#counts[box] = to - from;
      return [];
    }
    const middle = (middles[axis] + middles[axis + 3]) / 2;
    let [low, high] = [from, to];
    while (low < high) {
      const [a, b, c] = this.#corners(this.#order[low], axis);
      if (a + b + c < middle) low++;
      else [this.#order[low], this.#order[high]] = [this.#order[--high], this.#order[low]];
    }
    if (low === from || low === to) low = (from + to) >> 1; // Only because of rounding.
    const first = this.#boxes;
    this.#firsts[box] = first;
    this.#boxes += 2;
    return [
      [first, from, low],
      [first + 1, low, to],
    ];
  }

  #corners(triangle: number, axis: number): [number, number, number] {
    const { positions, indices } = this.part;
    return [
      positions[3 * indices[3 * triangle] + axis],
      positions[3 * indices[3 * triangle + 1] + axis],
      positions[3 * indices[3 * triangle + 2] + axis],
    ];
  }

  #crosses(box: number, origin: Vector3, inverse: readonly number[], from: number): boolean {
    let [entry, exit] = [from, Infinity];
    for (let axis = 0; axis < 3; axis++) {
      const [low, high] = [this.#bounds[6 * box + axis], this.#bounds[6 * box + axis + 3]];
      if (!Number.isFinite(inverse[axis])) {
        if (origin[axis] < low || origin[axis] > high) return false;
        continue;
      }
      const [a, b] = [(low - origin[axis]) * inverse[axis], (high - origin[axis]) * inverse[axis]];
      entry = Math.max(entry, Math.min(a, b));
      exit = Math.min(exit, Math.max(a, b));
    }
    return entry <= exit * (1 + slack) + slack;
  }

  /** Meets both sides. Source: Möller and Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, 1997 */
  #meetTriangle(triangle: number, { origin, direction: [dx, dy, dz] }: WorldRay, from: number, found: number[]): void {
    const [[ax, bx, cx], [ay, by, cy], [az, bz, cz]] = [0, 1, 2].map((axis) => this.#corners(triangle, axis));
    const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
    const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const size = ux * px + uy * py + uz * pz;
    if (size === 0) return;
    const [sx, sy, sz] = [origin[0] - ax, origin[1] - ay, origin[2] - az];
    const u = (sx * px + sy * py + sz * pz) / size;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const v = (dx * qx + dy * qy + dz * qz) / size;
    const t = (vx * qx + vy * qy + vz * qz) / size;
    if (u >= -slack && v >= -slack && u + v <= 1 + slack && t >= from) found.push(t);
  }
}

/** Larger than rounding errors, so that no ray passes between two triangles. */
const slack = 1e-9;
