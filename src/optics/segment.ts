import { lookUpRoot } from './substep-table.ts';
import type { SubstepTable } from './substep-table.ts';
import type { Premultiplied } from './transfer-function.ts';

/** A step is cut into so many parts at most, each end a sample of its own. */
export const maxSubsteps = 8;

/**
 * Parts of a step on which everything is seen. Where the opacity of a voxel is w, its cube root times this makes the
 * error least for the samples taken: the error of a part grows with w and the square of its length.
 */
export const substepsPerRoot = 28;

/**
 * Into how many parts a step is cut: the more, the more may be seen on it. That is asked of the values around those at its
 * ends, and over the length of a voxel and not of the step, so that the answer tends to one limit as steps get shorter
 * and the order of convergence stays.
 * @param visible - share of what is here that reaches the eye
 */
export function countSubsteps(table: SubstepTable, ends: readonly [number, number], visible: number): number {
  const substeps = Math.ceil(substepsPerRoot * lookUpRoot(table, ends) * Math.sqrt(visible));
  return Math.min(maxSubsteps, Math.max(1, substeps));
}

/**
 * What a length of constant mean emission and extinction emits and hides.
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

/** Put a sample behind what has been gathered so far. */
export function composite(accumulated: Premultiplied, behind: Premultiplied): void {
  const visible = 1 - accumulated[3];
  for (let c = 0; c < 4; c++) accumulated[c] += visible * behind[c];
}
