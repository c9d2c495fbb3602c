import type { SeenVolume } from '../optics/cells/cell-detail.ts';
import { emission } from '../optics/transfer/emission.ts';
import type { rangeEmission } from '../optics/transfer/emission-range.ts';
import { maxSubsteps } from '../optics/transfer/substep-limits.ts';
import { evaluate } from '../optics/transfer/transfer-function.ts';
import type { Premultiplied, Stop, TransferFunction } from '../optics/transfer/transfer-function.ts';
import { finestSpacing, offLine } from '../volume/grid.ts';
import type { Waiting } from '../core/waiting.ts';

/** What this file needs of parts of the package that are loaded before it. */
export interface BetweenTools {
  readonly rangeEmission: typeof rangeEmission;
}

/** `maxHidden` and `maxHalvings` of optics/surfaces/jump-gather.ts, which another part of the package holds. */
export const jumpLimits = { hidden: 0.25, halvings: 10 } as const;

/** The length in voxels of the smallest thing that may lie between two samples: the tent that one voxel makes. */
const thingLength = 2;

/** A value changes by at most this many times the range of a voxel's corners over the length of a voxel. */
const steepest = Math.sqrt(3);

/** The light that is left when rays end, and when they stop looking closer, 0..1. */
const unseen = 2e-3;

/** Number of cells between two pauses. */
const cellsAtOnce = 2 ** 12;

/**
 * How much brighter or darker, 0..1, a single thing could make a pixel than rays show that search for the values at which matter becomes
 * opaque at once. Such a ray is cut at these values, and each of its pieces hides little or is very short. So what counts is how emission
 * differs among values on the same side of all of these values; and where matter hides much, how its colour differs within a piece.
 * It does not include rays that touch matter so shortly that the last digits of a value decide.
 * @param samplesAVoxel - the parts into which the way through a voxel is cut
 * @param codes - the samples per voxel of each cell, as a power of two; null where steps are not cut
 */
export function* seekBetweenJumps(
  { volume, transferFunction, opticalScale, cells, found = [] }: SeenVolume,
  samplesAVoxel: number,
  codes: Uint8Array | null,
  { rangeEmission }: BetweenTools,
): Waiting<number> {
  const {
    macrocells: { low, high, roughness },
    slope,
    intercept,
    grid,
  } = volume;
  const sides = cutAt(transferFunction, found).map((side) => ({
    ...side,
    all: rangeEmission(side.stops),
    extinction: rangeEmission(side.stops, (of, value) => [0, 0, 0, emission(of, value)[3]]),
    color: rangeEmission(side.stops, straightColor),
  }));
  const length = thingLength * finestSpacing(grid) * opticalScale;
  const hidden = jumpLimits.hidden / samplesAVoxel;
  let largest = 0;
  for (let cell = 0; cell < cells.length; cell++) {
    if (cell % cellsAtOnce === cellsAtOnce - 1) yield;
    if (!cells[cell]) continue;
    const ends = [slope * low[cell] + intercept, slope * high[cell] + intercept];
    const [min, max] = [Math.min(...ends), Math.max(...ends)];
    const samples = codes
      ? Math.max(samplesAVoxel, Math.min(2 ** codes[cell], maxSubsteps * samplesAVoxel))
      : samplesAVoxel;
    const bend = (offLine * Math.abs(slope) * roughness[cell]) / samples;
    for (const { from, to, all, extinction, color } of sides) {
      const [first, last] = [Math.max(min, from), Math.min(max, to)];
      if (!(first <= last)) continue;
      const apart = Math.min(last - first, bend);
      const missed = (depth: number): number => -Math.expm1((-depth * length) / samples);
      const plain = missed(all.among(first, last, apart));
      if (plain <= largest) continue;
      const shortest = (steepest * (max - min)) / (samples * 2 ** jumpLimits.halvings);
      const dense =
        missed(extinction.among(first, last, apart)) +
        hidden * color.among(first, last, last - first) +
        color.among(first, last, Math.min(last - first, shortest)) +
        unseen;
      largest = Math.max(largest, Math.min(plain, dense));
    }
  }
  return Math.min(1, largest);
}

/** A part of a transfer function in which nothing becomes opaque at once. */
interface Side {
  readonly from: number;
  readonly to: number;
  readonly stops: TransferFunction;
}

/** The parts of a transfer function between some values, which are ascending. */
function cutAt(transferFunction: TransferFunction, values: readonly number[]): Side[] {
  const edges = [-Infinity, ...values, Infinity];
  return edges.slice(1).map((to, i) => {
    const from = edges[i];
    const inner = transferFunction.filter(({ value }) => value > from && value < to);
    const first =
      from > -Infinity
        ? [transferFunction.filter(({ value }) => value === from).at(-1) ?? at(transferFunction, from)]
        : [];
    const last = to < Infinity ? [transferFunction.find(({ value }) => value === to) ?? at(transferFunction, to)] : [];
    return { from, to, stops: [...first, ...inner, ...last] };
  });
}

/** A stop where none is. */
function at(transferFunction: TransferFunction, value: number): Stop {
  const [red, green, blue, opacity] = evaluate(transferFunction, value);
  const scale = opacity > 0 ? 1 / opacity : 0;
  return { value, color: [red * scale, green * scale, blue * scale], opacity };
}

function straightColor(of: TransferFunction, value: number): Premultiplied {
  const [red, green, blue, opacity] = evaluate(of, value);
  const scale = opacity > 0 ? 1 / opacity : 0;
  return [red * scale, green * scale, blue * scale, 0];
}
