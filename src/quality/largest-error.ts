import { cellsAtOnce, detailCodes, measureMissable } from '../optics/cell-detail.ts';
import type { SeenVolume } from '../optics/cell-detail.ts';
import { maxSubsteps } from '../optics/substep-limits.ts';
import { atOnce } from '../waiting.ts';
import type { Waiting } from '../waiting.ts';
import { keptError } from './error-estimate.ts';
import type { ErrorEstimate, PictureError } from './error-estimate.ts';

/** The largest error of all pixels may be so many times that of the probed ones. */
const unseen = 2;

/** What is said of a picture's error. */
export interface StatedError {
  readonly error: PictureError;
  /** Whether it is within what is asked. */
  readonly isKept: boolean;
}

/**
 * The error that is stated: what probes found, and as the largest, what they could have missed. Where no probe met the
 * volume although something of it can be seen, nothing else is known: then the error is taken for as large as that, and kept only where that is.
 * @param bound - of `boundMissed`, 0..1; it holds for all views. 0 where nothing is in sight
 * @param maxError - 1/255, see `keptError`
 */
export function stateError(estimate: ErrorEstimate, bound: number, maxError: number): StatedError {
  const { rms, p99, max, covered } = estimate;
  const missed = 255 * bound;
  if (covered === 0) return { error: { rms: missed, p99: missed, max: missed }, isKept: missed <= maxError };
  return { error: { rms, p99, max: Math.min(255, Math.max(unseen * max, missed + 0.5)) }, isKept: keptError(estimate) <= maxError };
}

/**
 * How much brighter or darker, 0..1, a single thing between two samples could make a pixel: the most of all cells in which
 * something can be seen. It bounds what no probe has met.
 * @param codes - which of `detailCodes` each cell is sampled with; one sample a voxel where absent
 */
export function* seekMissed(seen: SeenVolume, samplesAVoxel: number, codes: Uint8Array | null): Waiting<number> {
  const missable = measureMissable(seen, 'among');
  const wanted = (cell: number): number => (codes ? Math.min(detailCodes[codes[cell]], maxSubsteps * samplesAVoxel) : 1);
  let most = 0;
  for (let cell = 0; cell < seen.cells.length; cell++) {
    if (cell % cellsAtOnce === cellsAtOnce - 1) yield;
    if (!seen.cells[cell]) continue;
    const samples = Math.max(samplesAVoxel, wanted(cell));
    if (missable(cell, samples, true) > most) most = Math.max(most, missable(cell, samples));
  }
  return most;
}

/** The same without pauses. */
export function boundMissed(seen: SeenVolume, samplesAVoxel: number, codes: Uint8Array | null = null): number {
  return atOnce(seekMissed(seen, samplesAVoxel, codes));
}
