import { cellsAtOnce, measureMissable, readCode } from '../optics/cells/cell-detail.ts';
import type { SeenVolume } from '../optics/cells/cell-detail.ts';
import type { ProjectedRays } from '../optics/rays/ray-style.ts';
import { evaluate, largestOpacity } from '../optics/transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../optics/transfer/transfer-function.ts';
import { offLine } from '../volume/grid.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import { maxSubsteps } from '../optics/transfer/substep-limits.ts';
import { atOnce } from '../core/waiting.ts';
import type { Waiting } from '../core/waiting.ts';
import { keptError } from './error-estimate.ts';
import type { ErrorEstimate, PictureError } from './error-estimate.ts';

/** The largest error of all pixels may be this many times that of the probed ones. */
const unseen = 2;

/** A bound of this size, 0..1, covers the full range to the last byte, so nothing is known. */
const everything = 1 - 1 / 255;

/** The error that is reported for a picture. */
export interface StatedError {
  readonly error: PictureError;
  /** Whether the error is within the limit. */
  readonly isKept: boolean;
}

/**
 * The error that is reported: what the probes found and, as the largest error, what they could have missed. If no probe met the
 * volume although part of it is visible, nothing else is known: then the bound is reported as the error, and it must be within the limit.
 * @param bound - from `boundMissed`, 0..1; it holds for all views. 0 if nothing is visible
 * @param maxError - 1/255, see `keptError`
 */
export function stateError(estimate: ErrorEstimate, bound: number, maxError: number): StatedError {
  const { rms, p99, max: probed, covered, coverage } = estimate;
  const missed = 255 * bound;
  if (coverage === 0)
    return { error: { rms: missed, p99: missed, max: missed, probed: 0, rays: 0 }, isKept: missed <= maxError };
  const max = bound >= everything ? null : Math.min(255, Math.max(unseen * probed, missed + 0.5));
  return { error: { rms, p99, max, probed, rays: covered }, isKept: keptError(estimate) <= maxError };
}

/**
 * How much brighter or darker, 0..1, a single thing between two samples could make a pixel: the largest value of all cells in which
 * something is visible. It bounds what no probe has met.
 * @param samplesAVoxel - steps per voxel; below 1, a step that meets a thing also counts it as longer than it is
 * @param codes - how finely each cell is sampled, see `readCode`; if absent, no step is cut, as where the author gives the steps:
 * these are cut by the samples at their ends, which do not show what lies between
 */
export function* seekMissed(seen: SeenVolume, samplesAVoxel: number, codes: Uint8Array | null): Waiting<number> {
  // How far the colours of channels are apart where their brightness is not, is not known.
  if (seen.volume.channels && seen.cells.includes(1)) return 1;
  const missable = measureMissable(seen, 'among');
  const samplesIn = (cell: number): number => {
    if (!codes) return samplesAVoxel;
    const { samples, longer } = readCode(codes[cell]);
    return Math.max(samplesAVoxel, Math.min(samples, maxSubsteps * samplesAVoxel)) / longer;
  };
  let max = 0;
  for (let cell = 0; cell < seen.cells.length; cell++) {
    if (cell % cellsAtOnce === cellsAtOnce - 1) yield;
    if (!seen.cells[cell]) continue;
    const samples = samplesIn(cell);
    if (missable(cell, samples, true) > max) max = Math.max(max, missable(cell, samples));
  }
  return max;
}

/** The same without pauses. */
export function boundMissed(seen: SeenVolume, samplesAVoxel: number, codes: Uint8Array | null = null): number {
  return atOnce(seekMissed(seen, samplesAVoxel, codes));
}

/** The rounding error of 8 bits, 0..1. */
const rounding = 0.5 / 255;

/**
 * The largest error, 0..1, of a pixel that shows one value of its ray. Samples miss a value by at most its distance from the straight lines
 * between them, and its colour changes by at most the transfer function's change over that distance. Where the function jumps, the last
 * digits of a value decide.
 * @param samplesAVoxel - on a ray
 */
export function boundProjected(
  { volume: { macrocells, slope }, transferFunction }: SeenVolume,
  { isExact, hasValuesBetween }: ProjectedRays,
  samplesAVoxel: number,
): number {
  if (isExact && !hasValuesBetween) return rounding;
  const apart = isExact ? 0 : Math.abs(slope) * missedBetween(macrocells, samplesAVoxel, hasValuesBetween);
  return Math.max(rounding, changeWithin(transferFunction, apart));
}

/** How far a value may be from those of samples, in stored units. @param hasValuesBetween - labels have no straight lines between them */
function missedBetween({ low, high, roughness }: Macrocells, samplesAVoxel: number, hasValuesBetween: boolean): number {
  let apart = 0;
  for (let cell = 0; cell < low.length; cell++) {
    const range = high[cell] - low[cell];
    const max = hasValuesBetween ? Math.min(range, (offLine * roughness[cell]) / samplesAVoxel) : range;
    if (max > apart) apart = max;
  }
  return apart;
}

/** The largest change of a channel if the value changes by up to `apart`. The largest opacity counts as 1. */
function changeWithin(transferFunction: TransferFunction, apart: number): number {
  const largest = largestOpacity(transferFunction);
  const at = (value: number): Premultiplied => evaluate(transferFunction, value);
  // The largest change of a piecewise linear function begins or ends at a stop. A jump counts with its own value and with the value just
  // below it.
  const stops = transferFunction.map(({ value, color: [red, green, blue], opacity }) => ({
    value,
    seen: [red * opacity, green * opacity, blue * opacity, opacity] as Premultiplied,
  }));
  let change = 0;
  for (const [i, { value, seen }] of stops.entries()) {
    const others = apart > 0 ? [at(value - apart), at(value + apart)] : [];
    for (let k = i + 1; k < stops.length && stops[k].value <= value + apart; k++) others.push(stops[k].seen);
    for (const other of others) for (let c = 0; c < 4; c++) change = Math.max(change, Math.abs(other[c] - seen[c]));
  }
  return Math.min(1, change / largest);
}
