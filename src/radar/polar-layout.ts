import { allocateLike } from '../volume/samples.ts';
import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import type { Samples } from '../volume/volume.ts';

/** A sweep has so many radials more on the GPU: its last one before the first and its first one after the last, once more. */
export const repeatedRadials = 2;

/**
 * Where radials lie in their texture: a row of texels holds as many radials of one sweep as fit it, one after another, so that
 * short radials take no more room than they need. Each sweep begins a row.
 */
export interface PolarLayout {
  /** Texels. */
  readonly width: number;
  readonly height: number;
  /** Azimuth, degrees, after the widest gap between the radials of all sweeps: turns begin there, clockwise. */
  readonly from: number;
  /** Largest turn of a radial, degrees. */
  readonly extent: number;
  readonly sweeps: readonly SweepLayout[];
  /** What the numbers of radials stay below. */
  readonly numbers: number;
}

/** Radials of a sweep by their turn; the repeated ones count. */
export interface SweepLayout {
  readonly radials: number;
  /** Index in the sweep of the first one that is not repeated. */
  readonly firstRadial: number;
  readonly radialsPerRow: number;
  /** Row of texels. */
  readonly firstRow: number;
  readonly rows: number;
  /** Radials are numbered over all sweeps; the first one of each has a multiple of its radials per row. */
  readonly firstNumber: number;
}

/** @returns null where no texture of `maxSize` x `maxSize` texels holds so many */
export function layOutRadials({ sweeps }: PolarGrid, maxSize: number): PolarLayout | null {
  const width = chooseWidth(sweeps, maxSize);
  if (width === null) return null;
  const { from, extent } = findSector(sweeps);
  let [firstRow, numbers] = [0, 0];
  const placed = sweeps.map(({ azimuths, gates }): SweepLayout => {
    const radials = azimuths.length + repeatedRadials;
    const radialsPerRow = Math.floor(width / gates);
    const rows = Math.ceil(radials / radialsPerRow);
    const firstRadial = Math.max(0, azimuths.findIndex((azimuth) => azimuth >= from));
    const sweep = { radials, firstRadial, radialsPerRow, firstRow, rows, firstNumber: Math.ceil(numbers / radialsPerRow) * radialsPerRow };
    firstRow += rows;
    numbers = sweep.firstNumber + radials;
    return sweep;
  });
  return { width, height: firstRow, from, extent, sweeps: placed, numbers };
}

/** Most rounds of the loop that looks for a width, which runs on the page's thread: a radar's sweeps take some thousand. */
const maxRounds = 4_000_000;

/**
 * The width with the fewest texels in all. Between two multiples of a sweep's gates nothing fits better than in the lower
 * one, so that only those are tried; of sweeps by the hundred that all differ in length, some of those.
 */
function chooseWidth(sweeps: readonly Sweep[], maxSize: number): number | null {
  const widths = listWidths(sweeps, maxSize);
  const step = Math.max(1, Math.ceil((widths.length * sweeps.length) / maxRounds));
  let [least, best] = [Infinity, null as number | null];
  for (let i = 0; i < widths.length; i += step) {
    const height = countRows(sweeps, widths[i]);
    if (height > maxSize || widths[i] * height >= least) continue;
    [least, best] = [widths[i] * height, widths[i]];
  }
  return best;
}

/** Multiples of the sweeps' gates, each once. */
function listWidths(sweeps: readonly Sweep[], maxSize: number): number[] {
  const lengths = new Set(sweeps.map(({ gates }) => gates));
  const longest = sweeps.reduce((most, { gates }) => Math.max(most, gates), 0);
  const widths = new Set<number>();
  for (const length of lengths) {
    for (let width = Math.ceil(longest / length) * length; width <= maxSize; width += length) widths.add(width);
  }
  return [...widths];
}

function countRows(sweeps: readonly Sweep[], width: number): number {
  let rows = 0;
  for (const { azimuths, gates } of sweeps) rows += Math.ceil((azimuths.length + repeatedRadials) / Math.floor(width / gates));
  return rows;
}

/** What is left of the circle when the widest gap between the radials of all sweeps is taken out. */
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

/** Index in its sweep of a radial; place: 0 for the first, repeated one. */
export function radialAt({ azimuths }: Sweep, { firstRadial }: SweepLayout, place: number): number {
  return (firstRadial + place - 1 + azimuths.length) % azimuths.length;
}

/** Degrees from where turns begin; radials repeat themselves after a whole turn. */
export function turnAt(sweep: Sweep, layout: SweepLayout, from: number, place: number): number {
  const radials = sweep.azimuths.length;
  const azimuth = sweep.azimuths[radialAt(sweep, layout, place)];
  return (azimuth < from ? azimuth + 360 : azimuth) - from + 360 * Math.floor((place - 1) / radials);
}

/** Texels of some rows, from the first. */
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
