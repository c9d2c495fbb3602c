import type { ProjectionKind } from '../optics/rays/ray-style.ts';
import { cutToVoxels } from '../optics/rays/voxel-planes.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { linearSampler, nearestSampler } from './sample-at.ts';
import type { SampledBlock } from './sample-at.ts';

/**
 * The stored value that a slab shows for a line through voxels that begins at an index. NaN if there are no data on the
 * line.
 */
export type MergeLine = (x: number, y: number, z: number) => number;

/** How lines are merged. */
export interface LineMerging {
  /** Direction and length of each line, in voxels. */
  readonly way: Vector3;
  readonly kind: ProjectionKind;
  /** Whether each point has the value of the nearest voxel. */
  readonly isNearest: boolean;
}

/** A change along an axis of less than this many voxels over the whole line is rounding. */
const drift = 1e-9;

/** Number of points of a piece that are sampled if a voxel next to it has no data: there values are not a cubic. */
const looks = 5;

/**
 * The largest, the smallest or the mean value of all points of a line. Between planes of voxels' centres a tri-linear
 * value is a cubic of the length, whose extremes and mean are known: the result has no sampling error. Nearest values
 * change at the planes between voxels.
 */
export function lineMerger(block: SampledBlock, { way, kind, isNearest }: LineMerging): MergeLine {
  const { dimensions } = block;
  const piece = isNearest ? nearestPiece(block, kind) : linearPiece(block, kind);
  const shift = isNearest ? 0.5 : 0;
  const axes = [0, 1, 2].filter((axis) => Math.abs(way[axis]) >= drift);
  const next = [0, 0, 0]; // The share of the line at which it meets the next plane of each axis,
  const plane = [0, 0, 0]; // and that plane.
  return (...from) => {
    const inside = cutToVoxels(from, way, dimensions);
    if (!inside) return NaN;
    const [begin, end] = inside;
    for (const axis of axes) {
      const at = from[axis] + begin * way[axis] - shift;
      plane[axis] = way[axis] > 0 ? Math.floor(at) + 1 : Math.ceil(at) - 1;
      next[axis] = (plane[axis] + shift - from[axis]) / way[axis];
    }
    piece.begin(from, way);
    let at = begin;
    while (at < end) {
      let to = end;
      for (const axis of axes) if (next[axis] < to) to = next[axis];
      if (to > at) piece.add(at, to);
      for (const axis of axes) {
        if (next[axis] > to) continue;
        plane[axis] += way[axis] > 0 ? 1 : -1;
        next[axis] = (plane[axis] + shift - from[axis]) / way[axis];
      }
      at = to;
    }
    if (begin === end) piece.add(begin, end);
    return piece.end();
  };
}

/** Receives the pieces of one line after the other. */
interface Pieces {
  begin(from: Vector3, way: Vector3): void;
  /** @param at, to - shares of the line */
  add(at: number, to: number): void;
  end(): number;
}

/** The result for the part of a line that was processed so far. */
class Found {
  #value = 0;
  #weight = 0;

  constructor(readonly kind: ProjectionKind) {}

  clear(): void {
    this.#value = this.kind === 'average' ? 0 : this.kind === 'max' ? -Infinity : Infinity;
    this.#weight = 0;
  }

  /** @param weight - the length of line that has the value; extremes ignore it */
  take(value: number, weight: number): void {
    if (Number.isNaN(value)) return;
    if (this.kind === 'max') this.#value = Math.max(this.#value, value);
    else if (this.kind === 'min') this.#value = Math.min(this.#value, value);
    else {
      this.#weight += weight;
      // A running mean: the mean of a constant is the constant, to the last bit.
      if (weight > 0) this.#value += (value - this.#value) * (weight / this.#weight);
      else if (this.#weight === 0) this.#value = value;
    }
  }

  /** Whether values between these two can change the result. */
  isOfUse(low: number, high: number): boolean {
    return this.kind === 'average' || (this.kind === 'max' ? high > this.#value : low < this.#value);
  }

  get value(): number {
    const isEmpty = this.kind === 'average' ? !(this.#weight > 0) : !Number.isFinite(this.#value);
    return isEmpty ? NaN : this.#value;
  }
}

function nearestPiece(block: SampledBlock, kind: ProjectionKind): Pieces {
  const sampleAt = nearestSampler(block);
  const found = new Found(kind);
  let [x, y, z, dx, dy, dz] = [0, 0, 0, 0, 0, 0];
  return {
    begin: (from, way) => {
      found.clear();
      [[x, y, z], [dx, dy, dz]] = [from, way];
    },
    add: (at, to) => {
      const middle = (at + to) / 2;
      found.take(sampleAt(x + middle * dx, y + middle * dy, z + middle * dz), to - at);
    },
    end: () => found.value,
  };
}

function linearPiece(block: SampledBlock, kind: ProjectionKind): Pieces {
  const {
    samples,
    dimensions: [nx, ny, nz],
  } = block;
  const [lastX, lastY, lastZ] = [nx - 1, ny - 1, nz - 1];
  const slice = nx * ny;
  const sampleAt = linearSampler(block);
  const found = new Found(kind);
  let [x, y, z, dx, dy, dz] = [0, 0, 0, 0, 0, 0];

  /** Samples a piece if a voxel of its cell has no data. */
  const appearance = (at: number, to: number): void => {
    for (let i = 0; i < looks; i++) {
      const share = at + (i * (to - at)) / (looks - 1);
      found.take(
        sampleAt(x + share * dx, y + share * dy, z + share * dz),
        i === 0 || i === looks - 1 ? (to - at) / 2 : to - at,
      );
    }
  };

  return {
    begin: (from, way) => {
      found.clear();
      [[x, y, z], [dx, dy, dz]] = [from, way];
    },
    add: (at, to) => {
      const middle = (at + to) / 2;
      const span = to - at;
      const [mx, my, mz] = [x + middle * dx, y + middle * dy, z + middle * dz];
      const i = mx <= 0 ? 0 : mx >= lastX ? lastX : Math.floor(mx);
      const j = my <= 0 ? 0 : my >= lastY ? lastY : Math.floor(my);
      const k = mz <= 0 ? 0 : mz >= lastZ ? lastZ : Math.floor(mz);
      const right = i < lastX && mx > 0 ? 1 : 0;
      const up = j < lastY && my > 0 ? nx : 0;
      const back = k < lastZ && mz > 0 ? slice : 0;
      const corner = i + nx * j + slice * k;
      const a = samples[corner];
      const b = samples[corner + right];
      const c = samples[corner + up];
      const d = samples[corner + up + right];
      const e = samples[corner + back];
      const f = samples[corner + back + right];
      const g = samples[corner + back + up];
      const h = samples[corner + back + up + right];
      if (block.hasNoData && !Number.isFinite(a + b + c + d + e + f + g + h)) return appearance(at, to);
      if (!found.isOfUse(Math.min(a, b, c, d, e, f, g, h), Math.max(a, b, c, d, e, f, g, h))) return;
      // Along the piece, with s from 0 to 1, each coordinate between two voxels is p + q s. If there is only one voxel,
      // the value is constant.
      const px = right ? x + at * dx - i : 0;
      const qx = right ? span * dx : 0;
      const py = up ? y + at * dy - j : 0;
      const qy = up ? span * dy : 0;
      const pz = back ? z + at * dz - k : 0;
      const qz = back ? span * dz : 0;
      // Two rows in the near plane of the cell and two in the far one give a straight line each; these give two
      // parabolas, and these their cubic.
      const near0 = a + px * (b - a);
      const near1 = qx * (b - a);
      const nearUp0 = c + px * (d - c) - near0;
      const nearUp1 = qx * (d - c) - near1;
      const n0 = near0 + py * nearUp0;
      const n1 = near1 + py * nearUp1 + qy * nearUp0;
      const n2 = qy * nearUp1;
      const far0 = e + px * (f - e);
      const far1 = qx * (f - e);
      const farUp0 = g + px * (h - g) - far0;
      const farUp1 = qx * (h - g) - far1;
      const f0 = far0 + py * farUp0 - n0;
      const f1 = far1 + py * farUp1 + qy * farUp0 - n1;
      const f2 = qy * farUp1 - n2;
      const start = n0 + pz * f0;
      const linear = n1 + pz * f1 + qz * f0;
      const square = n2 + pz * f2 + qz * f1;
      const cube = qz * f2;
      if (kind === 'average') return found.take(start + linear / 2 + square / 3 + cube / 4, span);
      found.take(start, 0);
      found.take(start + linear + square + cube, 0);
      // Both turning points are used: one that is not an extreme of the wanted kind does no harm.
      const inner = square * square - 3 * cube * linear;
      if (!(inner > 0)) return;
      const root = Math.sqrt(inner);
      const larger = square > 0 ? -square - root : root - square;
      for (const turn of [linear / larger, larger / (3 * cube)])
        if (turn > 0 && turn < 1) found.take(start + turn * (linear + turn * (square + turn * cube)), 0);
    },
    end: () => found.value,
  };
}
