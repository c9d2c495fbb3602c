import { finestSpacing } from '../../volume/grid.ts';
import type { LabelCells } from '../../volume/label-cells.ts';
import type { LabelStyle } from '../../volume/labels.ts';
import type { Macrocells } from '../../volume/macrocells.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { SeenVolume } from './cell-detail.ts';
import { emission } from '../transfer/emission.ts';
import { rangeEmission } from '../transfer/emission-range.ts';

/** The appearance of the labels in each macrocell. */
export interface CellAppearances {
  /** The largest factor of the extinction; 0 if all labels are hidden. */
  readonly max: Float32Array;
  /** The largest difference between the factors of extinction, or between the factors of extinction times a colour. */
  readonly spread: Float32Array;
  /** The groups of the labels that are not hidden: one bit each. */
  readonly groups: Uint8Array;
}

/** @param styles - by label number */
export function appearanceOfCells({ starts, numbers }: LabelCells, styles: readonly LabelStyle[]): CellAppearances {
  const factors = styles.map(({ color, opacityFactor }) => [
    opacityFactor,
    ...color.map((channel) => channel * opacityFactor),
  ]);
  const max = new Float32Array(starts.length - 1);
  const spread = new Float32Array(starts.length - 1);
  const groups = new Uint8Array(starts.length - 1);
  for (let cell = 0; cell < max.length; cell++) {
    const [low, high] = [
      [Infinity, Infinity, Infinity, Infinity],
      [0, 0, 0, 0],
    ];
    for (let at = starts[cell]; at < starts[cell + 1]; at++) {
      const one = factors[numbers[at]];
      if (one[0] > 0) groups[cell] |= 1 << (styles[numbers[at]].group ?? 0);
      for (let c = 0; c < 4; c++) {
        if (one[c] < low[c]) low[c] = one[c];
        if (one[c] > high[c]) high[c] = one[c];
      }
    }
    max[cell] = high[0];
    for (let c = 0; c < 4; c++) spread[cell] = Math.max(spread[cell], high[c] - low[c]);
  }
  return { max, spread, groups };
}

/**
 * The same for smaller macrocells, as those of bricks: each has what the cell has in which it lies.
 * @param labels - voxels of the labels along each axis, and of their cells along each edge
 */
export function divideAppearances(
  whole: CellAppearances,
  labels: { readonly dimensions: Vector3; readonly size: number },
  { dimensions: cells, size }: Pick<Macrocells, 'dimensions' | 'size'>,
): CellAppearances {
  if (size === labels.size) return whole;
  const { max, spread, groups } = whole;
  const [lx, ly] = labels.dimensions.map((n) => Math.ceil(n / labels.size));
  const large = (n: number): number => Math.floor((n * size) / labels.size);
  const from = new Uint32Array(cells[0] * cells[1] * cells[2]);
  for (let z = 0, at = 0; z < cells[2]; z++)
    for (let y = 0; y < cells[1]; y++)
      for (let x = 0; x < cells[0]; x++, at++) from[at] = large(x) + lx * (large(y) + ly * large(z));
  return {
    max: Float32Array.from(from, (cell) => max[cell]),
    spread: Float32Array.from(from, (cell) => spread[cell]),
    groups: Uint8Array.from(from, (cell) => groups[cell]),
  };
}

/**
 * If h samples per voxel are taken, the length of a way through a label is uncertain by up to 1 / h voxel: that part may
 * have the style of the neighbouring label. Its standard deviation is half of that, and its mean is 0.
 */
const unknown = { among: 1, offLine: 0.5 } as const;

/** The optical depth that could be missed in a cell when labels are included: see `SeenVolume`. */
export function labelledDetail(
  { max, spread, groups }: CellAppearances,
  { volume, transferFunction, functions = [], opticalScale }: Omit<SeenVolume, 'cells' | 'more'>,
): NonNullable<SeenVolume['more']> {
  const {
    macrocells: { low, high },
    slope,
    intercept,
    grid,
  } = volume;
  const all = [transferFunction, ...functions];
  const ranges = all.map((one) => rangeEmission(one));
  const length = finestSpacing(grid) * opticalScale;
  return (cell, depthIn, kind) => {
    const present = all.map((_, group) => group).filter((group) => groups[cell] & (1 << group));
    if (present.length === 0) return 0;
    const missed = max[cell] * Math.max(...present.map((group) => depthIn(ranges[group])));
    // Between two functions, the whole emission of either may differ.
    const differs = present.length > 1 ? max[cell] : spread[cell];
    if (!(differs > 0)) return missed;
    const ends = [slope * low[cell] + intercept, slope * high[cell] + intercept];
    const [from, to] = [Math.min(...ends), Math.max(...ends)];
    // An upper bound: the emission at one of the ends, plus the largest change of emission between them.
    const largestOf = (group: number): number =>
      Math.min(...ends.map((value) => Math.max(...emission(all[group], value)))) +
      ranges[group].among(from, to, to - from);
    return missed + unknown[kind] * differs * Math.max(...present.map(largestOf)) * length;
  };
}
