// Loaded with the first surface that needs it: no page with a volume alone does.
import type { Matrix4 } from './matrix.ts';

/** Determinant of the linear part. */
export function determinant(m: Matrix4): number {
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
}
