import { maxSubsteps, substepsPerRoot, substepTableSize } from '../transfer/substep-limits.ts';
import type { SubstepTable } from '../transfer/substep-table.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

export { maxSubsteps, substepsPerRoot } from '../transfer/substep-limits.ts';

/**
 * The number of substeps of a step: more if more may be visible on it. It depends on the values around those at the
 * ends of the step, and on the length of a voxel, not of the step. So it has a limit as steps get shorter, and the order of
 * convergence does not change.
 * @param visible - share of the light from here that reaches the eye
 */
export function countSubsteps(table: SubstepTable, ends: readonly [number, number], visible: number): number {
  const substeps = Math.ceil(substepsPerRoot * lookUpRoot(table, ends) * Math.sqrt(visible));
  return Math.min(maxSubsteps, Math.max(1, substeps));
}

/** Cube root of the largest opacity that a voxel may have between two data values. */
export function lookUpRoot({ texels, low, high }: SubstepTable, [a, b]: readonly [number, number]): number {
  const { columns, rows } = substepTableSize;
  const shareOf = (value: number): number => Math.min(1, Math.max(0, (value - low) / (high - low)));
  const start = shareOf(Math.min(a, b));
  const end = shareOf(Math.max(a, b));
  const column = Math.round(0.5 * (start + end) * (columns - 1));
  const row = Math.round(Math.sqrt(end - start) * (rows - 1));
  return texels[row * columns + column] / 255;
}

/**
 * The light and the opacity of a length with constant mean emission and extinction.
 * @param mean - extinction times colour, and extinction, per reference length
 * @param ratio - length / reference length, times the opacity factor
 */
export function attenuate(mean: Premultiplied, ratio: number): Premultiplied {
  const depth = mean[3] * ratio;
  if (!(depth > 0)) return [0, 0, 0, 0];
  const alpha = -Math.expm1(-depth);
  const toLight = alpha / mean[3];
  return [mean[0] * toLight, mean[1] * toLight, mean[2] * toLight, alpha];
}

/** Composites a sample behind everything gathered so far. */
export function composite(accumulated: Premultiplied, behind: Premultiplied): void {
  const visible = 1 - accumulated[3];
  for (let c = 0; c < 4; c++) accumulated[c] += visible * behind[c];
}
