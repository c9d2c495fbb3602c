import { finestSpacing, offLine } from '../../volume/grid.ts';
import type { VolumeData } from '../../volume/volume.ts';
import { atOnce } from '../../core/waiting.ts';
import type { Waiting } from '../../core/waiting.ts';
import { rangeEmission } from '../transfer/emission-range.ts';
import type { EmissionRange, RangeKind } from '../transfer/emission-range.ts';
import type { JumpDepth } from '../transfer/jump-depth.ts';
import type { StyleRange } from './style-detail.ts';
import type { TransferFunction } from '../transfer/transfer-function.ts';

/** How a volume appears, as far as it matters for what samples could miss. */
export interface SeenVolume {
  readonly volume: Pick<
    VolumeData,
    'grid' | 'macrocells' | 'slope' | 'intercept' | 'range' | 'hasNoData' | 'channels' | 'finer'
  >;
  /** One byte per macrocell: 1 where something is visible. */
  readonly cells: Uint8Array;
  /** Already brightened. */
  readonly transferFunction: TransferFunction;
  /** Reference lengths per world length, times the opacity factor. */
  readonly opticalScale: number;
  /** Already brightened: the functions of labels, in addition to the volume's own. */
  readonly functions?: readonly TransferFunction[];
  /**
   * The optical depth that could be missed in a cell when labels and a layer are included, times the samples per voxel.
   * @param depthIn - that depth from a transfer function alone
   */
  readonly more?: (
    cell: number,
    depthIn: (range: EmissionRange) => number,
    kind: RangeKind,
    samplesAVoxel: number,
  ) => number;
  /** Whether an object may hide what is behind it, even if a ray's way through it is very short. */
  readonly hasSurfaces?: boolean;
  /** Optical depths of visible things between values, where the transfer function does not show them. */
  readonly jumps?: readonly JumpDepth[];
  /**
   * Data values at which the transfer function becomes opaque at once. Rays search for the places of these values, so no samples are
   * needed to find them.
   */
  readonly found?: readonly number[];
  /** How light and styles change the emission. */
  readonly style?: StyleRange;
}

/** The length in voxels of the smallest thing that may lie between the samples of a step: the tent that one voxel makes. */
const thingLength = 2;

const unstyled = { max: 1, apart: 0 };

/** Number of cells that are processed between two pauses. This takes a few milliseconds. */
export const cellsAtOnce = 2 ** 14;

/** Samples per voxel that a cell may need. */
export const detailCodes = [1, 2, 4, 8] as const;

/** Powers of two of the voxels in a step that is longer than one, the longest first. A macrocell has 4 or 8 along each edge. */
const longPowers = [2, 1] as const;

/**
 * Steps are cut for ten times `max-error`, and what stands out by eight times as much has to be kept: so a thing may lose this share of it in a step that is longer than a voxel, and no
 * more than this of a pixel. With more, as at a `max-error` of 16, pictures needed twice as many steps everywhere.
 */
const [keptShare, mostByLong] = [0.8, 0.25];

/**
 * What `measureMissable` may say of a thing between two samples of a step that is longer than a voxel: the thing is no longer than the step, and counts as twice as long.
 * @param lost - 0..1
 */
const sayableOf = (lost: number): number => 1 - (1 - Math.min(keptShare * lost, mostByLong)) ** 2;

/** How finely a macrocell has to be sampled. */
export interface CellDetail {
  /** One of `detailCodes`: samples for each voxel that is shown in it. */
  readonly samples: number;
  /** The length of these voxels, where the volume's own are 1: a power of two. More where bricks of coarser levels are shown, or where steps may be longer than a voxel. */
  readonly longer: number;
}

/** What the byte of a cell means: its lower two bits are the power of the samples, the other ones that of the length. */
export function readCode(code: number): CellDetail {
  return { samples: 2 ** (code & 3), longer: 2 ** (code >> 2) };
}

/**
 * How much brighter or darker, 0..1, a single thing in each cell could make a pixel than samples at a given number per voxel show.
 * It depends on how far values may be from the straight line between samples, and on how much the emission changes there.
 * @param kind - `among`: any change counts, which bounds the error; `offLine`: where the emission is linear in the value,
 * one sample has too little and the next too much, so nothing of the sum is lost
 * @returns with `isQuick` at least as much, and much faster: as if any two values of the cell could lie next to each other
 */
export function measureMissable(
  { volume, transferFunction, opticalScale, more, jumps = [], style }: SeenVolume,
  kind: RangeKind,
): (cell: number, samplesAVoxel: number, isQuick?: boolean) => number {
  const {
    macrocells: { low, high, roughness },
    slope,
    intercept,
    grid,
  } = volume;
  const emission = rangeEmission(transferFunction);
  const length = thingLength * finestSpacing(volume.finer?.grid ?? grid) * opticalScale;
  return (cell, samplesAVoxel, isQuick = false) => {
    const a = slope * low[cell] + intercept;
    const b = slope * high[cell] + intercept;
    const range = Math.abs(b - a);
    const apart = isQuick ? range : Math.min(range, (offLine * Math.abs(slope) * roughness[cell]) / samplesAVoxel);
    const min = Math.min(a, b);
    const max = Math.max(a, b);
    // Between two samples, a ray may pass through a surface, or through a visible gradient, that neither sample hits. No steps are added
    // for this, but the error reports it.
    const isBent = kind === 'among' && apart > 0;
    const styled = isBent && style ? style(min, max) : unstyled;
    // Between samples farther apart than a voxel there may be voxels without data.
    const hasHoles = volume.hasNoData && kind === 'among' && samplesAVoxel < 1;
    const depthIn = (of: EmissionRange): number =>
      (styled.max * (hasHoles ? of.largest(min, max) : of[kind](min, max, apart)) +
        (styled.apart > 0 ? styled.apart * of.largest(min, max) : 0)) *
      length;
    const jump = isBent ? jumps.reduce((sum, depth) => sum + depth(min, max, length / samplesAVoxel), 0) : 0;
    return -Math.expm1(-(more ? more(cell, depthIn, kind, samplesAVoxel) : depthIn(emission)) / samplesAVoxel - jump);
  };
}

/**
 * How finely each cell has to be sampled so that nothing in it is lost.
 * @param lost - how much of a thing may be lost, 0..1
 * @param isLong - steps may be longer than a voxel
 * @returns a byte per cell, see `readCode`
 */
export function* seekDetail(seen: SeenVolume, lost: number, isLong = false): Waiting<Uint8Array<ArrayBuffer>> {
  const missable = measureMissable(seen, 'offLine');
  const powerOf = isLong && canBeLong(seen) ? longSteps(seen, sayableOf(lost)) : () => 0;
  const found = findsIn(seen);
  // Labels and layers may have smaller voxels.
  const longer = seen.more || seen.functions ? undefined : seen.volume.macrocells.longer;
  const codes = new Uint8Array(seen.cells.length);
  for (let cell = 0; cell < codes.length; cell++) {
    if (cell % cellsAtOnce === cellsAtOnce - 1) yield;
    if (!seen.cells[cell]) continue;
    const long = powerOf(cell);
    if (long > 0) {
      codes[cell] = 4 * long;
      continue;
    }
    const power = longer?.[cell] ?? 0;
    const code = detailCodes.findIndex((samples) =>
      [true, false].some((isQuick) => missable(cell, samples / 2 ** power, isQuick) <= lost),
    );
    const most = found(cell) ? codeToAppearance : detailCodes.length - 1;
    codes[cell] = (code < 0 ? most : Math.min(code, most)) + 4 * power;
  }
  return codes;
}

/** Where something is met between two samples, or cells have several meanings, no step is longer than a voxel. */
function canBeLong({ volume, more, functions, hasSurfaces, jumps, found }: SeenVolume): boolean {
  const hasParts = more || functions || hasSurfaces || jumps?.length || found?.length;
  return !hasParts && !volume.channels && !volume.finer;
}

/** The power of two of the voxels in a step of a cell: 0 where they are no longer than one. */
function longSteps(seen: SeenVolume, lost: number): (cell: number) => number {
  const missable = measureMissable(seen, 'among');
  return (cell) =>
    longPowers.find((power) => [true, false].some((isQuick) => missable(cell, 2 ** -power, isQuick) <= lost)) ?? 0;
}

/** The code of a cell in which rays search for opaque values: two samples per voxel. */
const codeToAppearance = 1;

function findsIn({
  volume: {
    macrocells: { low, high },
    slope,
    intercept,
  },
  found = [],
}: SeenVolume): (cell: number) => boolean {
  const stored = found.map((value) => (value - intercept) / slope);
  return (cell) => stored.some((value) => value >= low[cell] && value <= high[cell]);
}

/** The same without pauses. */
export function findDetail(seen: SeenVolume, lost: number, isLong = false): Uint8Array<ArrayBuffer> {
  return atOnce(seekDetail(seen, lost, isLong));
}
