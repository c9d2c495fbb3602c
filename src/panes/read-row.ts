import type { Vector3 } from '../volume/matrix.ts';
import type { SampleAt, SampledBlock } from './sample-at.ts';

/**
 * Reads the stored values of a row of points, from pixel to pixel; NaN where there is no value.
 * @param from - index of the first, whole numbers at voxel centres
 * @param step - to the next one, in the same measure
 * @param line - receives the values
 */
export type ReadRow = (from: Vector3, step: Vector3, line: Float64Array) => void;

/** For each axis the other two. */
const others = [
  [1, 2],
  [0, 2],
  [0, 1],
] as const;

/** A row that deviates by less than this many voxels over its whole length runs along an axis. */
const drift = 1e-12;

/** Reads the points one by one. */
export function rowOf(sampleAt: SampleAt): ReadRow {
  return ([x, y, z], [dx, dy, dz], line) => {
    for (let column = 0; column < line.length; column++)
      line[column] = sampleAt(x + column * dx, y + column * dy, z + column * dz);
  };
}

/**
 * The same as `linearSampler` at each point, up to rounding. If a row runs along an axis of the grid, the weights
 * across it are applied once for each voxel of the row, and not for each pixel. A constant stays exact.
 */
export function linearRow({ samples, dimensions, hasNoData }: SampledBlock, sampleAt: SampleAt): ReadRow {
  const onePerOne = rowOf(sampleAt);
  const strides = [1, dimensions[0], dimensions[0] * dimensions[1]];
  const weighed = new Float64Array(Math.max(...dimensions));
  return (from, step, line) => {
    const axis = hasNoData ? -1 : axisOf(step, line.length);
    if (axis < 0) return onePerOne(from, step, line);
    const [p, q] = others[axis];
    const n = dimensions[axis];
    if (!isInside(from[p], dimensions[p]) || !isInside(from[q], dimensions[q])) return void line.fill(NaN);
    const [startP, byP, shareP] = between(from[p], dimensions[p], strides[p]);
    const [startQ, byQ, shareQ] = between(from[q], dimensions[q], strides[q]);
    const [first, last] = [from[axis], from[axis] + (line.length - 1) * step[axis]];
    const lowest = voxelBelow(Math.min(first, last), n);
    const highest = Math.min(n - 1, voxelBelow(Math.max(first, last), n) + 1);
    const stride = strides[axis];
    for (let i = lowest; i <= highest; i++) {
      const at = startP + startQ + i * stride;
      const a = samples[at];
      const near = a + shareP * (samples[at + byP] - a);
      const c = samples[at + byQ];
      const far = c + shareP * (samples[at + byQ + byP] - c);
      weighed[i] = near + shareQ * (far - near);
    }
    for (let column = 0; column < line.length; column++) {
      const x = first + column * step[axis];
      if (!isInside(x, n)) {
        line[column] = NaN;
        continue;
      }
      const inside = x < 0 ? 0 : x > n - 1 ? n - 1 : x;
      const i = inside | 0;
      const a = weighed[i];
      line[column] = i < n - 1 ? a + (inside - i) * (weighed[i + 1] - a) : a;
    }
  };
}

/** The axis of the grid along which a row runs; -1 if it runs along none. */
function axisOf(step: Vector3, pixels: number): number {
  const [x, y, z] = step.map((by) => Math.abs(by) * pixels > drift);
  return Number(x) + Number(y) + Number(z) === 1 ? (x ? 0 : y ? 1 : 2) : -1;
}

/** Whether a coordinate along an axis is inside a voxel. */
function isInside(x: number, n: number): boolean {
  return x >= -0.5 && x <= n - 0.5;
}

/** The voxel at or below a coordinate along an axis, clamped to the existing ones. */
function voxelBelow(x: number, n: number): number {
  return Math.min(n - 1, Math.max(0, Math.floor(x)));
}

/**
 * The samples on both sides of a coordinate along an axis: the offset of the lower one, the distance to the upper one,
 * and the share between them.
 */
function between(x: number, n: number, stride: number): [start: number, by: number, share: number] {
  const inside = Math.min(n - 1, Math.max(0, x));
  const i = Math.floor(inside);
  return [i * stride, i < n - 1 ? stride : 0, inside - i];
}
