/** A cubic, given by its values at 0, 1, 2 and 3. */
export type CubicValues = readonly [number, number, number, number];

/** f(u) = start + linear u + square u^2 + cube u^3. */
interface Cubic {
  readonly start: number;
  readonly linear: number;
  readonly square: number;
  readonly cube: number;
}

/** By Newton's forward differences. */
function cubicOf([a, b, c, d]: CubicValues): Cubic {
  const [first, second, third] = [b - a, c - 2 * b + a, d - a + 3 * (b - c)];
  return { start: a, linear: first - second / 2 + third / 3, square: (second - third) / 2, cube: third / 6 };
}

/**
 * Where a cubic has its local maximum or, with sign -1, its local minimum: at most one of each. NaN if it has none.
 * Twin: shaders/chunks/field/cubic.glsl
 */
export function turnOfCubic(values: CubicValues, sign: 1 | -1): number {
  const { linear: c, square: b, cube } = cubicOf(values);
  const a = 3 * cube;
  const inner = b * b - a * c;
  if (!(inner > 0)) return NaN;
  // Of the two roots of a u^2 + 2 b u + c, the one where the slope falls (or, with sign -1, rises). Each case uses the form
  // that loses no digits.
  const root = sign * Math.sqrt(inner);
  return sign * b <= 0 ? c / (root - b) : (-b - root) / a;
}

/**
 * The two inner Bernstein coefficients of a cubic. Between its ends the cubic stays between the smallest and the largest of its values at
 * both ends and of these two.
 */
export function innerBounds([a, b, c, d]: CubicValues): [number, number] {
  return [(-5 * a + 18 * b - 9 * c + 2 * d) / 6, (2 * a - 9 * b + 18 * c - 5 * d) / 6];
}

/** The value of a cubic at a place. */
export function cubicAt(values: CubicValues, u: number): number {
  const { start, linear, square, cube } = cubicOf(values);
  return start + u * (linear + u * (square + u * cube));
}
