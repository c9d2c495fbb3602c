import { finestSpacing } from '../../volume/grid.ts';
import { offLine } from '../../volume/cell-size.ts';
import type { Volume } from '../../volume/volume.ts';
import { atOnce } from '../../core/waiting.ts';
import type { Waiting } from '../../core/waiting.ts';
import { rangeEmission } from '../transfer/emission-range.ts';
import type { EmissionRange, RangeKind } from '../transfer/emission-range.ts';
import type { JumpDepth } from '../transfer/jump-depth.ts';
import type { StyleRange } from './style-detail.ts';
import type { TransferFunction } from '../transfer/transfer-function.ts';

/** What a volume looks like, as far as it matters to what could be missed. */
export interface SeenVolume {
  readonly volume: Pick<Volume, 'grid' | 'macrocells' | 'slope' | 'intercept'>;
  /** A byte a macrocell: 1 where something can be seen. */
  readonly cells: Uint8Array;
  /** Brightened. */
  readonly transferFunction: TransferFunction;
  /** Reference lengths per world length, times the opacity factor. */
  readonly opticalScale: number;
  /** Brightened: those that labels have beside the volume's own. */
  readonly functions?: readonly TransferFunction[];
  /**
   * What labels and a layer make of the optical depth that could be missed in a cell, times the samples a voxel.
   * @param depthIn - that depth, as far as a transfer function makes it
   */
  readonly more?: (cell: number, depthIn: (range: EmissionRange) => number, kind: RangeKind, samplesAVoxel: number) => number;
  /** Whether something may hide what is behind it, however short the way through it. */
  readonly hasSurfaces?: boolean;
  /** Optical depths of what shows amid values where a transfer function does not tell that it does. */
  readonly jumps?: readonly JumpDepth[];
  /** Values at which it becomes opaque at once and rays look for the places where they touch that, data values: no samples are needed to find them. */
  readonly found?: readonly number[];
  /** What light and styles make of it. */
  readonly style?: StyleRange;
}

/** Voxels that a thing may be long which lies between the samples of a step: the tent that one voxel makes. */
const thingLength = 2;

const unstyled = { most: 1, apart: 0 };

/** Cells that are looked at between two pauses: they take a few milliseconds. */
export const cellsAtOnce = 2 ** 14;

/** Samples a voxel that a cell may need; the code of a cell is the power of two. */
export const detailCodes = [1, 2, 4, 8] as const;

/**
 * How much brighter or darker, 0..1, a single thing in each cell could make a pixel than the samples of so many a voxel tell:
 * by how far values may be from the straight line between samples, and how much the emission changes there.
 * @param kind - `among`: any change counts, which bounds the error; `offLine`: where the emission is linear in the value,
 * what one sample loses the next one has too much, and nothing is lost of the whole
 * @returns with `isQuick` no less than without, and much sooner: as if any value of the cell might lie next to any other
 */
export function measureMissable(
  { volume, transferFunction, opticalScale, more, jumps = [], style }: SeenVolume, kind: RangeKind,
): (cell: number, samplesAVoxel: number, isQuick?: boolean) => number {
  const { macrocells: { low, high, roughness }, slope, intercept, grid } = volume;
  const emission = rangeEmission(transferFunction);
  const length = thingLength * finestSpacing(grid) * opticalScale;
  return (cell, samplesAVoxel, isQuick = false) => {
    const [a, b] = [slope * low[cell] + intercept, slope * high[cell] + intercept];
    const range = Math.abs(b - a);
    const apart = isQuick ? range : Math.min(range, (offLine * Math.abs(slope) * roughness[cell]) / samplesAVoxel);
    const [least, most] = [Math.min(a, b), Math.max(a, b)];
    // A ray may pass a surface, or a gradient that shows, between two samples that are not on it: no steps are spent on that, but it is told.
    const isBent = kind === 'among' && apart > 0;
    const styled = isBent && style ? style(least, most) : unstyled;
    const depthIn = (of: EmissionRange): number => (styled.most * of[kind](least, most, apart) + (styled.apart > 0 ? styled.apart * of.largest(least, most) : 0)) * length;
    const jump = isBent ? jumps.reduce((sum, depth) => sum + depth(least, most, length / samplesAVoxel), 0) : 0;
    return -Math.expm1(-(more ? more(cell, depthIn, kind, samplesAVoxel) : depthIn(emission)) / samplesAVoxel - jump);
  };
}

/**
 * How finely each cell has to be sampled so that nothing in it is lost.
 * @param lost - what may be lost of a thing, 0..1
 * @returns a byte a cell: which of `detailCodes` it needs
 */
export function* seekDetail(seen: SeenVolume, lost: number): Waiting<Uint8Array<ArrayBuffer>> {
  const missable = measureMissable(seen, 'offLine');
  const found = findsIn(seen);
  const codes = new Uint8Array(seen.cells.length);
  for (let cell = 0; cell < codes.length; cell++) {
    if (cell % cellsAtOnce === cellsAtOnce - 1) yield;
    if (!seen.cells[cell]) continue;
    const code = detailCodes.findIndex((samples) => missable(cell, samples, true) <= lost || missable(cell, samples) <= lost);
    codes[cell] = Math.min(code < 0 ? detailCodes.length - 1 : code, found(cell) ? codeToLook : detailCodes.length - 1);
  }
  return codes;
}

/** Of a cell in which rays look for where they touch what is opaque: two samples a voxel. */
const codeToLook = 1;

function findsIn({ volume: { macrocells: { low, high }, slope, intercept }, found = [] }: SeenVolume): (cell: number) => boolean {
  const stored = found.map((value) => (value - intercept) / slope);
  return (cell) => stored.some((value) => value >= low[cell] && value <= high[cell]);
}

/** The same without pauses. */
export function findDetail(seen: SeenVolume, lost: number): Uint8Array<ArrayBuffer> {
  return atOnce(seekDetail(seen, lost));
}
