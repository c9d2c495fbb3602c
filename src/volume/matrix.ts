/** Three numbers: x, y, z or i, j, k. */
export type Vector3 = readonly [number, number, number];

/** Sixteen numbers, row-major; the last row is 0 0 0 1 for affine maps. */
export type Matrix4 = readonly number[];

export const identity: Matrix4 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Product a * b: b is applied first, then a. */
export function multiply(a: Matrix4, b: Matrix4): Matrix4 {
  const product: number[] = [];
  for (let row = 0; row < 4; row++) {
    for (let column = 0; column < 4; column++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[row * 4 + k] * b[k * 4 + column];
      product.push(sum);
    }
  }
  return product;
}

/** Maps a point through an affine matrix. */
export function transformPoint(m: Matrix4, p: Vector3): Vector3 {
  const d = transformDirection(m, p);
  return [d[0] + m[3], d[1] + m[7], d[2] + m[11]];
}

/** Maps a direction (no translation) through an affine matrix. */
export function transformDirection(m: Matrix4, d: Vector3): Vector3 {
  return [
    m[0] * d[0] + m[1] * d[1] + m[2] * d[2],
    m[4] * d[0] + m[5] * d[1] + m[6] * d[2],
    m[8] * d[0] + m[9] * d[1] + m[10] * d[2],
  ];
}

/** Scales, then translates: the affine map x -> scale * x + offset, per axis. */
export function scaleAndTranslate(scale: Vector3, offset: Vector3): Matrix4 {
  return [scale[0], 0, 0, offset[0], 0, scale[1], 0, offset[1], 0, 0, scale[2], offset[2], 0, 0, 0, 1];
}

/**
 * Inverse of an affine matrix, by cofactors of its columns scaled to unit length, so that spacings of 1e-9 or 1e9 do
 * not under- or overflow.
 * @returns null if the matrix is singular
 */
export function invertAffine(m: Matrix4): Matrix4 | null {
  const columns = [0, 1, 2].map((c): Vector3 => [m[c], m[4 + c], m[8 + c]]);
  const lengths = columns.map(length);
  if (lengths.some((l) => !(l > 0 && Number.isFinite(l)))) return null;
  const [a, b, c] = columns.map((column, i) => scale(column, 1 / lengths[i]));
  const volume = dot(a, cross(b, c));
  if (Math.abs(volume) < 1e-12) return null;
  const rows = [cross(b, c), cross(c, a), cross(a, b)].map((row, i) => scale(row, 1 / (volume * lengths[i])));
  const origin: Vector3 = [m[3], m[7], m[11]];
  return [...rows.flatMap((row) => [...row, -dot(row, origin)]), 0, 0, 0, 1];
}

export function add(a: Vector3, b: Vector3): Vector3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Vector3, b: Vector3): Vector3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scale(a: Vector3, factor: number): Vector3 {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function dot(a: Vector3, b: Vector3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector3, b: Vector3): Vector3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function length(a: Vector3): number {
  return Math.hypot(a[0], a[1], a[2]);
}

export function normalize(a: Vector3): Vector3 {
  return scale(a, 1 / length(a));
}
