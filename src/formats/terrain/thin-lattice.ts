import { noHeight } from './hgt.ts';
import type { Lattice } from './lattice.ts';

/**
 * For each point of a lattice: the error of heights, in metres, if triangles are not split there or below it. Infinity
 * if a triangle would cover points without heights.
 * Source: Evans, Kirkpatrick and Townsend, *Right-Triangulated Irregular Networks*, Algorithmica 30, 2001; computed
 * level by level, the finest one first
 */
export function latticeErrors({ size, heights }: Lattice): Float32Array {
  const errors = new Float32Array(size * size);
  const own = (at: number, a: number, b: number): number => {
    const voids = Number(heights[at] === noHeight) + Number(heights[a] === noHeight) + Number(heights[b] === noHeight);
    if (voids > 0) return voids === 3 ? 0 : Infinity;
    return Math.abs(heights[at] - (heights[a] + heights[b]) / 2);
  };
  const raise = (at: number, x: number, y: number): void => {
    if (x >= 0 && y >= 0 && x < size && y < size) errors[at] = Math.max(errors[at], errors[y * size + x]);
  };
  for (let half = 1; half < size - 1; half *= 2) {
    // Middles of sides: the triangles there are split into those whose long sides have their middles half as far away.
    for (let y = 0; y < size; y += half) {
      for (let x = (y / half) % 2 ? 0 : half; x < size; x += 2 * half) {
        const at = y * size + x;
        const step = (y / half) % 2 ? half * size : half;
        errors[at] = own(at, at - step, at + step);
        const quarter = half / 2;
        if (half > 1) for (const [dx, dy] of diagonals) raise(at, x + dx * quarter, y + dy * quarter);
      }
    }
    // Middles of squares, whose diagonal runs from the middle of the square that they are a quarter of.
    for (let y = half; y < size; y += 2 * half) {
      for (let x = half; x < size; x += 2 * half) {
        const at = y * size + x;
        const isFalling = ((x - half) / (2 * half)) % 2 === ((y - half) / (2 * half)) % 2;
        const step = isFalling ? half * (size + 1) : half * (size - 1);
        errors[at] = own(at, at - step, at + step);
        for (const [dx, dy] of sides) raise(at, x + dx * half, y + dy * half);
      }
    }
  }
  return errors;
}

const diagonals = [
  [-1, -1],
  [1, -1],
  [-1, 1],
  [1, 1],
] as const;
const sides = [
  [-1, 0],
  [1, 0],
  [0, -1],
  [0, 1],
] as const;

/**
 * Receives the corners of each triangle, as indices in the lattice, counterclockwise seen from above with the first row
 * in the north.
 */
type TriangleListener = (a: number, b: number, c: number) => void;

/** Cuts a lattice into triangles whose error is at most `error`. Triangles with a corner without height are left out. */
export function eachTriangle(
  { size, heights }: Lattice,
  errors: Float32Array,
  error: number,
  onTriangle: TriangleListener,
): void {
  const split = (a: number, b: number, c: number): void => {
    const middle = (a + b) / 2;
    const leg = Math.abs(a - c);
    if (leg !== 1 && leg !== size && errors[middle] > error) {
      split(c, a, middle);
      split(b, c, middle);
      return;
    }
    if (heights[a] !== noHeight && heights[b] !== noHeight && heights[c] !== noHeight) onTriangle(a, b, c);
  };
  const [last, end] = [size - 1, size * size - 1];
  split(0, end, last);
  split(end, 0, end - last);
}

/**
 * The smallest error, metres, with which a lattice becomes at most so many triangles.
 * @returns null if there are always more
 */
export function findError(lattice: Lattice, errors: Float32Array, maxTriangles: number): number | null {
  const isFew = (error: number): boolean => {
    let count = 0;
    eachTriangle(lattice, errors, error, () => count++);
    return count <= maxTriangles;
  };
  let [low, high] = [0.5, 8192];
  if (isFew(low)) return low;
  if (!isFew(high)) return null;
  while (high / low > 1.05) {
    const middle = Math.sqrt(low * high);
    if (isFew(middle)) high = middle;
    else low = middle;
  }
  return high;
}
