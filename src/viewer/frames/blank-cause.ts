import { evaluate } from '../../optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Cuts } from '../cuts/shown-cuts.ts';
import type { ViewLabels } from '../model/view-labels.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** Why nothing of a volume is visible. */
export type BlankCause =
  | { readonly cause: 'noData' | 'transparent' | 'labels' | 'cut' | 'sight' | 'faint' | 'noEchoes' }
  | { readonly cause: 'values'; readonly low: number; readonly high: number }
  | { readonly cause: 'weakEchoes'; readonly value: number };

/** Facts about a picture in which nothing is visible. */
export interface BlankFacts {
  readonly volume: Pick<Volume, 'grid' | 'range' | 'histogram'>;
  readonly optics: Pick<VolumeOptics, 'transferFunction' | 'opacityFactor' | 'surfaces' | 'patches'>;
  readonly cuts: Pick<Cuts, 'region' | 'slices' | 'cuts'>;
  readonly labels: ViewLabels | null;
  /** Whether a macrocell in which something may be visible is in front of the camera; null where no macrocell has anything visible. */
  readonly inSight: boolean | null;
  /** Whether a person, or a script, has moved the camera. */
  readonly isMoved: boolean;
  /** The largest opacity of the picture, 0..1. */
  readonly alpha: number;
}

/** The likely cause; null where the page, or a person, wants it so. */
export function findBlankCause({
  volume: { grid, range, histogram },
  optics,
  cuts,
  labels,
  inSight,
  isMoved,
  alpha,
}: BlankFacts): BlankCause | null {
  const { transferFunction, opacityFactor, surfaces, patches } = optics;
  const [low, high] = range;
  if (opacityFactor === 0) return null;
  const isRadar = grid.kind === 'polar';
  if (histogram.counts.every((count) => count === 0)) return { cause: isRadar ? 'noEchoes' : 'noData' };
  if (
    labels &&
    (labels.shown?.styles ?? transferFunction.map(({ opacity }) => ({ opacityFactor: opacity }))).every(
      (style) => style.opacityFactor === 0,
    )
  )
    return { cause: 'labels' };
  // With surfaces, or with values and their gradients, the picture does not depend on the transfer function alone.
  if (!surfaces && !patches) {
    const begin = firstOpaque(transferFunction);
    if (begin === null) return { cause: 'transparent' };
    if (largestIn(transferFunction, low, high) === 0)
      return isRadar && high < begin ? { cause: 'weakEchoes', value: begin } : { cause: 'values', low, high };
  }
  if (inSight === null) return { cause: 'values', low, high };
  if (!inSight) return isMoved ? null : { cause: 'sight' };
  // If the cause is a cut, nothing at all is left.
  const isCut = cuts.region !== null || cuts.slices.length > 0 || cuts.cuts.length > 0;
  if (isCut && alpha === 0) return { cause: 'cut' };
  return isMoved && alpha === 0 ? null : { cause: 'faint' };
}

/** The value from which values are opaque; null where none is. */
function firstOpaque(transferFunction: TransferFunction): number | null {
  const first = transferFunction.findIndex(({ opacity }) => opacity > 0);
  if (first < 0) return null;
  return first === 0 ? -Infinity : transferFunction[first - 1].value;
}

/** The largest opacity in a range of values. */
function largestIn(transferFunction: TransferFunction, low: number, high: number): number {
  const within = transferFunction.filter(({ value }) => value >= low && value <= high).map(({ opacity }) => opacity);
  return Math.max(...[low, high].map((value) => evaluate(transferFunction, value)[3]), ...within);
}
