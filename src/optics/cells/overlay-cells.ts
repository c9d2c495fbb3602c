import { finestSpacing, offLine } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { VolumeData } from '../../volume/volume.ts';
import { boxesIn, boxReader, countTouched, isOutside, reachesBeyond } from './boxes-in-layer.ts';
import type { UnitBox } from './boxes-in-layer.ts';
import type { SeenVolume } from './cell-detail.ts';
import { emission } from '../transfer/emission.ts';
import { rangeEmission } from '../transfer/emission-range.ts';
import { contributionOf } from './empty-space-distance.ts';
import { attenuate } from '../rays/segment.ts';
import type { Premultiplied, TransferFunction } from '../transfer/transfer-function.ts';
import { fullColor, overlayColors } from '../attachments/overlay.ts';
import type { ShownOverlay } from '../attachments/overlay.ts';

/** The values of a layer in each macrocell of the volume below it. */
export interface OverlayCells {
  /** Data values. If there are none, the smallest is above the largest. */
  readonly low: Float64Array;
  readonly high: Float64Array;
  /** See `Macrocells`, in data values. */
  readonly roughness: Float64Array;
  /** 1 where the layer ends in the cell. */
  readonly ends: Uint8Array;
  /** Smallest and largest data value at the layer's edge. If there are none, the smallest is above the largest. */
  readonly edge: readonly [number, number];
}

/**
 * Up to this many voxels of a layer are read one by one, which takes a tenth of a second. Beyond it, only the layer's macrocells are read:
 * they describe wider blocks.
 */
const maxReads = 2 ** 23;

/** The range of no values. */
const none: readonly [number, number] = [Infinity, -Infinity];

export function listOverlayCells(over: VolumeData, volume: VolumeData): OverlayCells {
  const {
    dimensions: [nx, ny, nz],
    low: { length },
  } = over.macrocells;
  const cells = {
    low: new Float64Array(length).fill(Infinity),
    high: new Float64Array(length).fill(-Infinity),
    roughness: new Float64Array(length),
    ends: new Uint8Array(length),
    edge: isPolar(over) ? none : measureEdge(volume),
  };
  const { macrocells, slope, intercept } = volume;
  const include = (cell: number, from: number): void => {
    if (!(macrocells.low[from] <= macrocells.high[from])) return;
    const ends = [slope * macrocells.low[from] + intercept, slope * macrocells.high[from] + intercept];
    cells.low[cell] = Math.min(cells.low[cell], ...ends);
    cells.high[cell] = Math.max(cells.high[cell], ...ends);
    cells.roughness[cell] = Math.max(cells.roughness[cell], Math.abs(slope) * macrocells.roughness[from]);
  };
  if (isPolar(over)) {
    // Both have the same gates in the same box.
    for (let cell = 0; cell < length; cell++) include(cell, cell);
    return cells;
  }
  const boxOf = boxesIn(over, volume.grid);
  if (!boxOf) return cells; // One of the two grids is flat.
  const read = boxReader(volume);
  const isFine = length * countTouched(boxOf([0, 0, 0]), volume.grid.dimensions) <= maxReads;
  const [mx, my] = macrocells.dimensions;
  for (let k = 0, cell = 0; k < nz; k++)
    for (let j = 0; j < ny; j++)
      for (let i = 0; i < nx; i++, cell++) {
        const box = boxOf([i, j, k]);
        if (isOutside(box)) continue;
        cells.ends[cell] = Number(reachesBeyond(box));
        const { first, last } = blocksOf(box, volume);
        for (let z = first[2]; z <= last[2]; z++)
          for (let y = first[1]; y <= last[1]; y++)
            for (let x = first[0]; x <= last[0]; x++) include(cell, x + mx * (y + my * z));
        if (!isFine || !(cells.low[cell] <= cells.high[cell])) continue;
        const [min, max] = read(box);
        cells.low[cell] = min;
        cells.high[cell] = max;
      }
  return cells;
}

/** Smallest and largest value of the outermost voxels. */
function measureEdge({
  samples,
  grid: {
    dimensions: [nx, ny, nz],
  },
  slope,
  intercept,
}: VolumeData): readonly [number, number] {
  let [low, high] = none;
  for (let k = 0; k < nz; k++)
    for (let j = 0; j < ny; j++) {
      const step = k === 0 || k === nz - 1 || j === 0 || j === ny - 1 ? 1 : Math.max(1, nx - 1);
      for (let i = 0; i < nx; i += step) {
        const value = slope * samples[i + nx * (j + ny * k)] + intercept;
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
  return [low, high];
}

/**
 * Macrocells share a voxel with their neighbours on each side. Within this distance (in voxels) beyond its edge, a cell still holds all
 * that counts.
 */
const shared = 0.25;

/** The macrocells of a layer that hold everything in a box: from the first to the last along each axis. */
function blocksOf(
  { low, high }: UnitBox,
  { grid: { dimensions }, macrocells }: VolumeData,
): { readonly first: Vector3; readonly last: Vector3 } {
  const toBlock = (position: number, axis: number): number =>
    Math.min(macrocells.dimensions[axis] - 1, Math.max(0, Math.floor(position / macrocells.size)));
  const from = low.map((x, axis) => toBlock(x * dimensions[axis] + shared, axis));
  const to = high.map((x, axis) => toBlock(x * dimensions[axis] - shared, axis));
  // A box may be smaller than the shared part.
  return {
    first: from.map((at, axis) => Math.min(at, to[axis])) as unknown as Vector3,
    last: to.map((at, axis) => Math.max(at, from[axis])) as unknown as Vector3,
  };
}

/** Where a layer itself is visible, whatever values the volume has there: a byte per macrocell. Null for a layer that only colours. */
export function shownByOverlay(
  { low, high }: OverlayCells,
  { blend, transferFunction }: ShownOverlay,
): Uint8Array | null {
  if (blend === 'color') return null;
  const shows = contributionOf(transferFunction);
  return Uint8Array.from(low, (min, cell) => Number(min <= high[cell] && shows(min, high[cell])));
}

/**
 * What a layer adds to the optical depth that could be missed in a cell: see `SeenVolume`. If the layer's voxels are larger than the
 * volume's, the layer is straighter between samples. If they are smaller, it may take any value between its smallest and its largest.
 */
export function overlaidDetail(
  cells: OverlayCells,
  overlay: ShownOverlay,
  {
    seen,
    lightFactor,
  }: {
    readonly seen: Omit<SeenVolume, 'cells'>;
    readonly lightFactor: number;
  },
): NonNullable<SeenVolume['more']> {
  const { grid, macrocells, slope, intercept } = seen.volume;
  const colors = overlayColors(overlay, lightFactor);
  const range = rangeEmission(colors);
  const own = rangeEmission(seen.transferFunction);
  const before: NonNullable<SeenVolume['more']> = seen.more ?? ((_, depthIn) => depthIn(own));
  const seenOf = rangeSeen(colors);
  const finest = finestSpacing(grid);
  const ratio = finest / finestSpacing(overlay.volume.grid);
  /**
   * How far values may be off a straight line between samples, as a share of the roughness. The samples are this many voxels
   * of the layer apart.
   */
  const straightOver = (voxels: number): number => offLine * (voxels > 1 ? voxels ** 2 : voxels);
  const length = 2 * finest * seen.opticalScale;
  return (cell, depthIn, kind, samplesAVoxel) => {
    const missed = before(cell, depthIn, kind, samplesAVoxel);
    const [low, high] = [cells.low[cell], cells.high[cell]];
    if (!(low <= high)) return missed;
    const isBound = kind === 'among';
    const apart = Math.min(high - low, straightOver(isBound ? ratio / samplesAVoxel : ratio) * cells.roughness[cell]);
    if (overlay.blend === 'mix' && isBound) {
      // Dense matter hides what is missed behind it.
      const reach = (length * overlay.opacityFactor) / samplesAVoxel;
      // Where a step leaves the layer, half of the step counts.
      const atEdge = cells.ends[cell] ? seenOf(reach / 4).largest(...cells.edge) : 0;
      return (
        missed - samplesAVoxel * Math.log1p(-Math.min(maxSeen, Math.max(atEdge, seenOf(reach).among(low, high, apart))))
      );
    }
    const largest = cells.ends[cell] ? Math.max(...emission(colors, low), ...emission(colors, high)) : 0;
    const change = Math.max(largest, range[kind](low, high, apart));
    if (overlay.blend === 'mix') return missed + change * length * overlay.opacityFactor;
    const ends = [slope * macrocells.low[cell] + intercept, slope * macrocells.high[cell] + intercept];
    const [from, to] = [Math.min(...ends), Math.max(...ends)];
    if (!Number.isFinite(to - from)) return missed;
    const max =
      Math.min(...ends.map((value) => emission(seen.transferFunction, value)[3])) + own.among(from, to, to - from);
    return missed + Math.min(1, change / fullColor) * max * length;
  };
}

/** Larger opacities count as this: an 8-bit picture cannot distinguish them. */
const maxSeen = 0.9999;

/** How much the visible effect of a length differs among values. */
interface SeenRange {
  /** See `EmissionRange`; results are in 0..1. */
  among(low: number, high: number, apart: number): number;
  /** The largest result for values between two; 0 if there are none. */
  largest(low: number, high: number): number;
}

/** @returns a function of a length in reference lengths; each length is prepared once */
function rangeSeen(colors: TransferFunction): (ratio: number) => SeenRange {
  const known = new Map<number, SeenRange>();
  return (ratio) => {
    const read = (of: TransferFunction, value: number): Premultiplied => attenuate(emission(of, value), ratio);
    const { among } = known.get(ratio) ?? rangeEmission(colors, read);
    const found = {
      among,
      largest: (low: number, high: number) => (low <= high ? read(colors, low)[3] + among(low, high, high - low) : 0),
    };
    known.set(ratio, found);
    return found;
  };
}
