import { allocateLike } from '../volume/samples.ts';
import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import type { Samples } from '../volume/volume.ts';

/** Additional radials of a sweep on the GPU: the last one is repeated before the first, and the first one after the last. */
export const repeatedRadials = 2;

/**
 * Places of radials in their texture. A row of texels has as many radials of one sweep as fit, one after another, so that
 * short radials take no more room than they need. Each sweep begins a new row.
 */
export interface PolarLayout {
  /** Texels. */
  readonly width: number;
  readonly height: number;
  /** Azimuth, in degrees, after the widest gap between the radials of all sweeps. Turns are counted from here, clockwise. */
  readonly from: number;
  /** Largest turn of a radial, degrees. */
  readonly extent: number;
  readonly sweeps: readonly SweepLayout[];
  /** All numbers of radials are below this. */
  readonly numbers: number;
}

/** Radials of a sweep by their turn, including the repeated ones. */
export interface SweepLayout {
  readonly radials: number;
  /** Index in the sweep of the first one that is not repeated. */
  readonly firstRadial: number;
  readonly radialsPerRow: number;
  /** Row of texels. */
  readonly firstRow: number;
  readonly rows: number;
  /** Radials are numbered over all sweeps. The number of each sweep's first radial is a multiple of its radials per row. */
  readonly firstNumber: number;
}

/** @returns null if no texture of `maxSize` x `maxSize` texels is large enough */
export function layOutRadials({ sweeps }: PolarGrid, maxSize: number): PolarLayout | null {
  const width = chooseWidth(sweeps, maxSize);
  if (width === null) return null;
  const { from, extent } = findSector(sweeps);
  let [firstRow, numbers] = [0, 0];
  const placed = sweeps.map(({ azimuths, gates }): SweepLayout => {
    const radials = azimuths.length + repeatedRadials;
    const radialsPerRow = Math.floor(width / gates);
    const rows = Math.ceil(radials / radialsPerRow);
    const firstRadial = Math.max(
      0,
      azimuths.findIndex((azimuth) => azimuth >= from),
    );
    const sweep = {
      radials,
      firstRadial,
      radialsPerRow,
      firstRow,
      rows,
      firstNumber: Math.ceil(numbers / radialsPerRow) * radialsPerRow,
    };
    firstRow += rows;
    numbers = sweep.firstNumber + radials;
    return sweep;
  });
  return { width, height: firstRow, from, extent, sweeps: placed, numbers };
}

/**
 * Largest number of rounds of the loop that searches for a width. It runs on the page's thread. A radar's sweeps take some
 * thousand rounds.
 */
const maxRounds = 4_000_000;

/**
 * The width with the fewest texels in all. Between two multiples of a sweep's gates nothing fits better than at the lower
 * one, so only multiples are tried. If hundreds of sweeps all differ in length, only some of the multiples are tried.
 */
function chooseWidth(sweeps: readonly Sweep[], maxSize: number): number | null {
  const widths = listWidths(sweeps, maxSize);
  const step = Math.max(1, Math.ceil((widths.length * sweeps.length) / maxRounds));
  let [min, best] = [Infinity, null as number | null];
  for (let i = 0; i < widths.length; i += step) {
    const height = countRows(sweeps, widths[i]);
    if (height > maxSize || widths[i] * height >= min) continue;
    [min, best] = [widths[i] * height, widths[i]];
  }
  return best;
}

/** Multiples of the sweeps' gates, without duplicates. */
function listWidths(sweeps: readonly Sweep[], maxSize: number): number[] {
  const lengths = new Set(sweeps.map(({ gates }) => gates));
  const longest = sweeps.reduce((max, { gates }) => Math.max(max, gates), 0);
  const widths = new Set<number>();
  for (const length of lengths) {
    for (let width = Math.ceil(longest / length) * length; width <= maxSize; width += length) widths.add(width);
  }
  return [...widths];
}

function countRows(sweeps: readonly Sweep[], width: number): number {
  let rows = 0;
  for (const { azimuths, gates } of sweeps)
    rows += Math.ceil((azimuths.length + repeatedRadials) / Math.floor(width / gates));
  return rows;
}

/** The part of the circle that is left without the widest gap between the radials of all sweeps. */
function findSector(sweeps: readonly Sweep[]): { from: number; extent: number } {
  const all = Float64Array.from(sweeps.flatMap(({ azimuths }) => [...azimuths]));
  all.sort();
  let [widest, from] = [0, all[0]];
  all.forEach((azimuth, i) => {
    const gap = i === 0 ? azimuth + 360 - all[all.length - 1] : azimuth - all[i - 1];
    if (gap > widest) [widest, from] = [gap, azimuth];
  });
  return { from, extent: 360 - widest };
}

/** Index of a radial in its sweep. Place 0 is the first, repeated one. */
export function radialAt({ azimuths }: Sweep, { firstRadial }: SweepLayout, place: number): number {
  return (firstRadial + place - 1 + azimuths.length) % azimuths.length;
}

/** Degrees from where turns begin. Radials repeat after a whole turn. */
export function turnAt(sweep: Sweep, layout: SweepLayout, from: number, place: number): number {
  const radials = sweep.azimuths.length;
  const azimuth = sweep.azimuths[radialAt(sweep, layout, place)];
  return (azimuth < from ? azimuth + 360 : azimuth) - from + 360 * Math.floor((place - 1) / radials);
}

/** The texels of some rows, from `first` on. */
export function packRows(
  samples: Samples,
  { sweeps }: PolarGrid,
  layout: PolarLayout,
  { first, count }: { first: number; count: number },
): Samples {
  const packed = allocateLike(samples, layout.width * count);
  sweeps.forEach((sweep, i) => {
    const placed = layout.sweeps[i];
    const end = Math.min(first + count, placed.firstRow + placed.rows);
    for (let row = Math.max(first, placed.firstRow); row < end; row++) {
      const firstPlace = (row - placed.firstRow) * placed.radialsPerRow;
      const radials = Math.min(placed.radialsPerRow, placed.radials - firstPlace);
      for (let column = 0; column < radials; column++) {
        const start = sweep.offset + radialAt(sweep, placed, firstPlace + column) * sweep.gates;
        packed.set(samples.subarray(start, start + sweep.gates), (row - first) * layout.width + column * sweep.gates);
      }
    }
  });
  return packed;
}
