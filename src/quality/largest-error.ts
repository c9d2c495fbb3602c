import { rangeEmission } from '../optics/emission-range.ts';
import type { TransferFunction } from '../optics/transfer-function.ts';
import { finestSpacing } from '../volume/grid.ts';
import { cellSize } from '../volume/macrocells.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { measureRoughness } from '../volume/roughness.ts';
import { isPolar } from '../volume/volume.ts';
import type { ErrorEstimate, PictureError } from './error-estimate.ts';
import type { Volume } from '../volume/volume.ts';

/** The largest error of all pixels may be so many times that of the probed ones. */
const unseen = 2;

/**
 * The error that is stated: what probes found, and as the largest, what they could have missed. Where no probe met the
 * volume although something of it can be seen, nothing else is known.
 */
export function stateError({ rms, p99, max, covered }: ErrorEstimate, seen: SeenVolume | null, samplesAVoxel: number): PictureError {
  const missed = seen ? 255 * boundMissed(seen, samplesAVoxel) : 0;
  if (covered === 0) return { rms: missed, p99: missed, max: missed };
  return { rms, p99, max: Math.min(255, Math.max(unseen * max, missed + 0.5)) };
}

/** What a volume looks like, as far as it matters to what could be missed. */
export interface SeenVolume {
  readonly volume: Volume;
  /** A byte a macrocell: 1 where something can be seen. */
  readonly cells: Uint8Array;
  /** Brightened. */
  readonly transferFunction: TransferFunction;
  /** Reference lengths per world length, times the opacity factor. */
  readonly opticalScale: number;
}

/** Voxels that a thing may be long which lies between the samples of a step: the tent that one voxel makes. */
const thingLength = 2;

/** Between samples a voxel apart the value is off the straight line between them by no more than this share of the roughness. */
const offLine = 0.7;

/** Voxels whose roughness is measured: beyond these, what a cell's range allows counts. */
const mostVoxels = 2 ** 24;

/**
 * How much brighter or darker, 0..1, a single thing between two samples could make a pixel: from how far values may be from
 * the straight line between samples, and how much the transfer function changes there. It bounds what no probe has met.
 * @param samplesAVoxel - steps along the finest axis
 */
export function boundMissed(seen: SeenVolume, samplesAVoxel: number): number {
  const { volume, cells, opticalScale } = seen;
  const range = rangeEmission(seen.transferFunction);
  const length = thingLength * finestSpacing(volume.grid) * opticalScale;
  let count = 0;
  for (const cell of cells) count += cell;
  const isMeasured = !isPolar(volume) && count * cellSize ** 3 <= mostVoxels;
  let largest = 0;
  const [nx, ny] = volume.macrocells.dimensions;
  for (let cell = 0; cell < cells.length; cell++) {
    if (cells[cell] === 0) continue;
    const [a, b] = [volume.macrocells.low[cell], volume.macrocells.high[cell]].map((stored) => volume.slope * stored + volume.intercept);
    const [low, high] = a < b ? [a, b] : [b, a];
    // Whatever lies in the cell can make no more of a difference than its range: most cells need no closer look.
    const most = range.among(low, high, high - low);
    if (most <= largest) continue;
    if (!isMeasured) {
      largest = most;
      continue;
    }
    const first: Vector3 = [cell % nx, Math.floor(cell / nx) % ny, Math.floor(cell / (nx * ny))].map((i) => i * cellSize) as unknown as Vector3;
    const roughness = Math.abs(volume.slope) * measureRoughness(volume.samples, volume.grid.dimensions, first, cellSize);
    largest = Math.max(largest, range.among(low, high, Math.min(high - low, (offLine * roughness) / samplesAVoxel)));
  }
  return -Math.expm1(-largest * length);
}
