import type { Sweep, SweepGeometry } from '../volume/polar-grid.ts';

/** The smallest and the largest of some elevations, degrees. */
export type ElevationSpan = readonly [low: number, high: number];

/** The elevation of a sweep at an azimuth, in degrees: linear from radial to radial. */
export function elevationAt({ azimuths, elevation, elevations }: Sweep, azimuth: number): number {
  if (!elevations) return elevation;
  const { radials, along } = radialsAround(azimuths, azimuth);
  return elevations[radials[0]] + along * (elevations[radials[1]] - elevations[radials[0]]);
}

/** The radials on both sides of an azimuth, and its place between the first and the second, 0..1. */
export function radialsAround(azimuths: Float64Array, azimuth: number): { radials: [number, number]; along: number } {
  const count = azimuths.length;
  const to = countUpTo(count, (radial) => azimuths[radial] <= azimuth);
  const before = (to + count - 1) % count;
  const after = to % count;
  const gap = azimuths[after] - azimuths[before];
  const turn = azimuth - azimuths[before];
  return { radials: [before, after], along: (turn < 0 ? turn + 360 : turn) / (gap > 0 ? gap : gap + 360) };
}

/** The elevations of a sweep's radials. */
export function spanOfSweep({ elevation, elevations }: Sweep): ElevationSpan {
  let [low, high] = elevations ? [Infinity, -Infinity] : [elevation, elevation];
  for (const one of elevations ?? []) {
    low = Math.min(low, one);
    high = Math.max(high, one);
  }
  return [low, high];
}

/**
 * The sweeps that may be next to a place with one of the elevations, at any azimuth: from the first to the last.
 * Radials go no farther than the next sweep's elevation. So of the sweeps below `from`, the second one lies below it at every
 * azimuth; of the sweeps above `to`, the fourth one lies above it.
 * @param spans - of each sweep, see `spanOfSweep`
 */
export function sweepsAround(
  sweeps: readonly Sweep[],
  spans: readonly ElevationSpan[],
  [from, to]: ElevationSpan,
): [number, number] {
  let first = Math.max(0, countUpTo(sweeps.length, (i) => sweeps[i].elevation <= from) - 3);
  let last = Math.min(sweeps.length - 1, countUpTo(sweeps.length, (i) => sweeps[i].elevation <= to) + 2);
  let [floor, ceiling] = [-Infinity, Infinity];
  for (let i = first; i <= last; i++) {
    if (spans[i][1] <= from) floor = Math.max(floor, spans[i][0]);
    if (spans[i][0] > to) ceiling = Math.min(ceiling, spans[i][1]);
  }
  while (spans[first][1] < floor) first++;
  while (spans[last][0] > ceiling) last--;
  return [first, last];
}

/**
 * If sweeps are farther apart than this many beam widths, what lies between them is not measured. National scans have gaps of up to 20
 * degrees below their highest sweep (24 to 40, 25 to 45), which everybody fills in. A sweep that looks straight up is 30 degrees or more
 * above all others.
 */
const widestGapInBeams = 25;

/** Degrees: the smallest limit, for a very narrow beam such as a lidar's. Its sweeps alone would be too thin to be visible. */
const widestGapAtLeast = 5;

/** Degrees: across wider gaps, between sweeps or between radials, nothing is interpolated. @param beamWidth - degrees */
export function widestGap(beamWidth: number): number {
  return Math.max(widestGapAtLeast, widestGapInBeams * beamWidth);
}

/** The elevations in which gates of a sweep are shown. */
export interface SweepReach {
  /** Degrees, the largest span: to the sweeps below and above, at any azimuth; or half a beam if there is none near enough. */
  readonly elevations: ElevationSpan;
  /** Whether it reaches the sweep above. Then the upper half of the gap belongs to that sweep. */
  readonly meetsAbove: boolean;
}

/** @param spans - of each sweep, see `spanOfSweep` */
export function reachOfSweeps(
  { beamWidth }: Pick<SweepGeometry, 'beamWidth'>,
  spans: readonly ElevationSpan[],
): SweepReach[] {
  const [widest, half] = [widestGap(beamWidth), beamWidth / 2];
  const [bottom, top] = reachOfAll(beamWidth, spans);
  return spans.map(([low, high], sweep) => {
    let [below, above] = [sweep - 1, sweep + 1];
    while (below >= 0 && spans[below][1] >= low) below--;
    while (above < spans.length && spans[above][0] <= high) above++;
    // Test the gap only to the next sweep. If sweeps in between cross this one, they are near it at some azimuth.
    const isAbove = above < spans.length && !(above === sweep + 1 && spans[above][0] - high > widest);
    const isBelow = below >= 0 && !(below === sweep - 1 && low - spans[below][1] > widest);
    return {
      elevations: [
        isBelow ? spans[below][0] : below < 0 ? bottom : low - half,
        isAbove ? spans[above][1] : above === spans.length ? top : high + half,
      ],
      meetsAbove: isAbove,
    };
  });
}

/** Half a beam below the lowest radial, but not below the nadir, and half a beam above the highest, but not above the zenith. */
export function reachOfAll(beamWidth: number, spans: readonly ElevationSpan[]): ElevationSpan {
  let [low, high] = [90, -90];
  for (const span of spans) {
    low = Math.min(low, span[0]);
    high = Math.max(high, span[1]);
  }
  return [Math.max(-90, low - beamWidth / 2), Math.min(90, high + beamWidth / 2)];
}

/** How many of ascending things, from the first on, fulfil a condition. */
export function countUpTo(length: number, holds: (index: number) => boolean): number {
  let [from, to] = [0, length];
  while (from < to) {
    const middle = (from + to) >> 1;
    if (holds(middle)) from = middle + 1;
    else to = middle;
  }
  return from;
}
