import { finestSpacing } from '../volume/grid.ts';
import type { LabelCells } from '../volume/label-cells.ts';
import type { LabelStyle } from '../volume/labels.ts';
import type { SeenVolume } from './cell-detail.ts';
import { emission } from './emission.ts';
import { rangeEmission } from './emission-range.ts';

/** What the labels of each macrocell look like. */
export interface CellLooks {
  /** The largest factor of the extinction; 0 where all are hidden. */
  readonly most: Float32Array;
  /** By how much the factors of extinction, and of extinction times a colour, differ at the most. */
  readonly spread: Float32Array;
}

/** @param styles - of all numbers */
export function lookOfCells({ starts, numbers }: LabelCells, styles: readonly LabelStyle[]): CellLooks {
  const factors = styles.map(({ color, opacityFactor }) => [opacityFactor, ...color.map((channel) => channel * opacityFactor)]);
  const most = new Float32Array(starts.length - 1);
  const spread = new Float32Array(starts.length - 1);
  for (let cell = 0; cell < most.length; cell++) {
    const [low, high] = [[Infinity, Infinity, Infinity, Infinity], [0, 0, 0, 0]];
    for (let at = starts[cell]; at < starts[cell + 1]; at++) {
      const one = factors[numbers[at]];
      for (let c = 0; c < 4; c++) {
        if (one[c] < low[c]) low[c] = one[c];
        if (one[c] > high[c]) high[c] = one[c];
      }
    }
    most[cell] = high[0];
    for (let c = 0; c < 4; c++) spread[cell] = Math.max(spread[cell], high[c] - low[c]);
  }
  return { most, spread };
}

/**
 * Of a way through a label that is known by samples of which h lie on a voxel, up to 1 / h is not known: that much of a voxel may
 * look like the label beside it. Its standard deviation is half of that, and its mean is 0.
 */
const unknown = { among: 1, offLine: 0.5 } as const;

/** What labels make of the optical depth that could be missed in a cell: see `SeenVolume`. */
export function labelledDetail({ most, spread }: CellLooks, { volume, transferFunction, opticalScale }: Omit<SeenVolume, 'cells' | 'more'>): NonNullable<SeenVolume['more']> {
  const { macrocells: { low, high }, slope, intercept, grid } = volume;
  const range = rangeEmission(transferFunction);
  const length = finestSpacing(grid) * opticalScale;
  return (cell, depth, kind) => {
    const missed = most[cell] * depth;
    if (!(spread[cell] > 0)) return missed;
    const ends = [slope * low[cell] + intercept, slope * high[cell] + intercept];
    const [from, to] = [Math.min(...ends), Math.max(...ends)];
    // No more than what is at one of the ends, and how much there is between them.
    const largest = Math.min(...ends.map((value) => Math.max(...emission(transferFunction, value)))) + range.among(from, to, to - from);
    return missed + unknown[kind] * spread[cell] * largest * length;
  };
}
