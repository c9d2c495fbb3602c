// Draws solids into a grid of voxels with smooth edges, like the partial volumes of a scanner.

/** @typedef {[number, number, number]} Point - world units */
/** @typedef {(x: number, y: number, z: number) => number} Distance - world units, below 0 inside */

/** Numbers from 0 up to 1, the same in every run (mulberry32). @param {number} seed */
export function seededRandom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Distance to an ellipsoid, accurate enough near its surface. @param {Point} center @param {Point} radii @returns {Distance} */
export function ellipsoid([cx, cy, cz], [rx, ry, rz]) {
  return (x, y, z) => {
    const [a, b, c] = [(x - cx) / rx, (y - cy) / ry, (z - cz) / rz];
    const k = Math.hypot(a, b, c);
    return k === 0 ? -Math.min(rx, ry, rz) : (k * (k - 1)) / Math.hypot(a / rx, b / ry, c / rz);
  };
}

/** Distance to a rod with round ends whose radius changes along it. @param {Point} from @param {Point} to @param {number} r0 @param {number} r1 @returns {Distance} */
export function rod(from, to, r0, r1 = r0) {
  const d = to.map((v, i) => v - from[i]);
  const square = d[0] ** 2 + d[1] ** 2 + d[2] ** 2 || 1;
  return (x, y, z) => {
    const p = [x - from[0], y - from[1], z - from[2]];
    const t = Math.min(1, Math.max(0, (p[0] * d[0] + p[1] * d[1] + p[2] * d[2]) / square));
    return Math.hypot(p[0] - t * d[0], p[1] - t * d[1], p[2] - t * d[2]) - (r0 + t * (r1 - r0));
  };
}

export class Painter {
  /**
   * @param {Point} dimensions - voxels
   * @param {Point} spacing - world units
   * @param {Point} origin - world place of the first voxel's centre
   * @param {number} background
   */
  constructor(dimensions, spacing, origin, background) {
    this.dimensions = dimensions;
    this.spacing = spacing;
    this.origin = origin;
    this.values = new Float32Array(dimensions[0] * dimensions[1] * dimensions[2]).fill(background);
  }

  /**
   * Fill a solid; it replaces the present values.
   * @param {Distance} distance
   * @param {number} value
   * @param {[Point, Point]} [box] - world corners of a box that contains the solid; the whole grid where absent
   */
  fill(distance, value, box) {
    const range = [0, 1, 2].map((axis) => {
      const at = (/** @type {number} */ world) => (world - this.origin[axis]) / this.spacing[axis];
      const last = this.dimensions[axis] - 1;
      return box
        ? [Math.max(0, Math.floor(at(box[0][axis])) - 1), Math.min(last, Math.ceil(at(box[1][axis])) + 1)]
        : [0, last];
    });
    const edge = Math.max(...this.spacing);
    this.each(range, (index, x, y, z) => {
      const share = Math.min(1, Math.max(0, 0.5 - distance(x, y, z) / edge));
      if (share > 0) this.values[index] += share * (value - this.values[index]);
    });
  }

  /** @param {Point} center @param {Point} radii @param {number} value */
  ellipsoid(center, radii, value) {
    this.fill(ellipsoid(center, radii), value, [
      [center[0] - radii[0], center[1] - radii[1], center[2] - radii[2]],
      [center[0] + radii[0], center[1] + radii[1], center[2] + radii[2]],
    ]);
  }

  /**
   * A tube through points; its radius changes from the first value to the last.
   * @param {Point[]} points
   * @param {[number, number]} radii
   * @param {number} value
   */
  tube(points, [first, last], value) {
    for (let i = 0; i + 1 < points.length; i++) {
      const at = (/** @type {number} */ n) => first + ((last - first) * n) / (points.length - 1);
      const max = Math.max(first, last);
      const bound = (/** @type {(a: number, b: number) => number} */ pick, /** @type {number} */ pad) =>
        /** @type {Point} */ (points[i].map((v, axis) => pick(v, points[i + 1][axis]) + pad));
      this.fill(rod(points[i], points[i + 1], at(i), at(i + 1)), value, [bound(Math.min, -max), bound(Math.max, max)]);
    }
  }

  /** @param {number[][]} range @param {(index: number, x: number, y: number, z: number) => void} visit */
  each(range, visit) {
    const [nx, ny] = this.dimensions;
    for (let k = range[2][0]; k <= range[2][1]; k++) {
      for (let j = range[1][0]; j <= range[1][1]; j++) {
        for (let i = range[0][0]; i <= range[0][1]; i++) {
          const [x, y, z] = [i, j, k].map((n, axis) => this.origin[axis] + n * this.spacing[axis]);
          visit((k * ny + j) * nx + i, x, y, z);
        }
      }
    }
  }

  /** Visit every voxel. @param {(index: number, x: number, y: number, z: number) => void} visit */
  all(visit) {
    this.each(
      this.dimensions.map((n) => [0, n - 1]),
      visit,
    );
  }
}
