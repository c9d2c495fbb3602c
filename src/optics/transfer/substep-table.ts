import { sumUpToBeyond } from './running-integral.ts';
import type { RunningIntegral } from './running-integral.ts';
import { substepTableDomain, substepTableSize } from './substep-limits.ts';

/**
 * How much may be visible on a step, by the values at its ends. This decides how many substeps it gets. Column: the middle
 * of the two values; row: the square root of their distance, as in the pre-integration table; nearest texel.
 */
export interface SubstepTable {
  /** Shape [rows, columns]: cube root of the opacity of a voxel's length, for values around those at the ends, in 1/255. */
  readonly texels: Uint8Array<ArrayBuffer>;
  /** Data values of the centres of the first and the last column. */
  readonly low: number;
  readonly high: number;
}

/**
 * How far values on a step may lie outside of those at its ends. It is a share of the span between the ends, plus a share of
 * the transfer function's domain, because values may have extrema on the step.
 */
export const reachBeyond = { ofSpan: 0.5, ofDomain: 0.03 } as const;

/**
 * @param voxelRatio - length of a voxel / reference length, times the opacity factor
 */
export function buildSubstepTable(integral: RunningIntegral, voxelRatio: number): SubstepTable {
  const { columns, rows } = substepTableSize;
  const { cells, low, high } = integral;
  const { from, to } = substepTableDomain;
  const texels = new Uint8Array(columns * rows);
  for (let row = 0; row < rows; row++) {
    const span = (to - from) * (row / (rows - 1)) ** 2;
    const reach = span / 2 + reachBeyond.ofSpan * span + reachBeyond.ofDomain;
    for (let column = 0; column < columns; column++) {
      const middle = from + ((to - from) * column) / (columns - 1);
      const sum =
        sumUpToBeyond(integral, (middle + reach) * cells, 3) - sumUpToBeyond(integral, (middle - reach) * cells, 3);
      const depth = (sum / (2 * reach * cells)) * voxelRatio;
      texels[row * columns + column] = Math.ceil(255 * Math.cbrt(-Math.expm1(-Math.max(0, depth))));
    }
  }
  return { texels, low: low + from * (high - low), high: low + to * (high - low) };
}
