import type { Sweep, SweepGeometry } from '../volume/polar-grid.ts';

/** The least and the greatest of some elevations, degrees. */
export type ElevationSpan = readonly [low: number, high: number];

/** Elevation of a sweep at an azimuth, degrees: linear from radial to radial. */
export function elevationAt({ azimuths, elevation, elevations }: Sweep, azimuth: number): number {
  if (!elevations) return elevation;
  const { radials, along } = radialsAround(azimuths, azimuth);
  return elevations[radials[0]] + along * (elevations[radials[1]] - elevations[radials[0]]);
}

/** The radials on both sides of an azimuth, and how far it is from the first to the second, 0..1. */
export function radialsAround(azimuths: Float64Array, azimuth: number): { radials: [number, number]; along: number } {
  const count = azimuths.length;
  const to = countUpTo(count, (radial) => azimuths[radial] <= azimuth);
  const before = (to + count - 1) % count;
  const after = to % count;
  const gap = azimuths[after] - azimuths[before];
  const turn = azimuth - azimuths[before];
  return { radials: [before, after], along: (turn < 0 ? turn + 360 : turn) / (gap > 0 ? gap : gap + 360) };
}

/** Elevations of a sweep's radials. */
export function spanOfSweep({ elevation, elevations }: Sweep): ElevationSpan {
  let [low, high] = elevations ? [Infinity, -Infinity] : [elevation, elevation];
  for (const one of elevations ?? []) {
    low = Math.min(low, one);
    high = Math.max(high, one);
  }
  return [low, high];
}

/**
 * The sweeps that may be next to a place of one of the elevations, whatever its azimuth: those from the first to the last.
 * Radials go no farther than the next sweep's elevation, so that of those below `from` the second one lies below it at every
 * azimuth, and above the fourth one.
 * @param spans - of each sweep, see `spanOfSweep`
 */
export function sweepsAround(sweeps: readonly Sweep[], spans: readonly ElevationSpan[], [from, to]: ElevationSpan): [number, number] {
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
 * Sweeps farther apart than so many beam widths see nothing of what is between them. National scans leave gaps of up to 20 degrees below their
 * highest sweep (24 to 40, 25 to 45), which everybody fills in; a sweep that looks straight up is 30 degrees or more above all others.
 */
const widestGapInBeams = 25;

/** Degrees: also of a very narrow beam, as of a lidar, whose sweeps alone would be too thin to be seen. */
const widestGapAtLeast = 5;

/** Degrees: across wider gaps, between sweeps and between radials, nothing is interpolated. @param beamWidth - degrees */
export function widestGap(beamWidth: number): number {
  return Math.max(widestGapAtLeast, widestGapInBeams * beamWidth);
}

/** Where gates of a sweep are shown. */
export interface SweepReach {
  /** Degrees, at most: to the sweeps below and above, at any azimuth, or half a beam where there is none near enough. */
  readonly elevations: ElevationSpan;
  /** Whether it reaches a sweep above, so that the upper half of the way is that one's. */
  readonly meetsAbove: boolean;
}

/** @param spans - of each sweep, see `spanOfSweep` */
export function reachOfSweeps({ beamWidth }: Pick<SweepGeometry, 'beamWidth'>, spans: readonly ElevationSpan[]): SweepReach[] {
  const [widest, half] = [widestGap(beamWidth), beamWidth / 2];
  const [bottom, top] = reachOfAll(beamWidth, spans);
  return spans.map(([low, high], sweep) => {
    let [below, above] = [sweep - 1, sweep + 1];
    while (below >= 0 && spans[below][1] >= low) below--;
    while (above < spans.length && spans[above][0] <= high) above++;
    // Only of the next one: those that cross this sweep are near it at some azimuth.
    const isAbove = above < spans.length && !(above === sweep + 1 && spans[above][0] - high > widest);
    const isBelow = below >= 0 && !(below === sweep - 1 && low - spans[below][1] > widest);
    return {
      elevations: [isBelow ? spans[below][0] : below < 0 ? bottom : low - half, isAbove ? spans[above][1] : above === spans.length ? top : high + half],
      meetsAbove: isAbove,
    };
  });
}

/** Half a beam below the lowest radial, down to the nadir, and half a beam above the highest one, up to the zenith. */
export function reachOfAll(beamWidth: number, spans: readonly ElevationSpan[]): ElevationSpan {
  let [low, high] = [90, -90];
  for (const span of spans) {
    low = Math.min(low, span[0]);
    high = Math.max(high, span[1]);
  }
  return [Math.max(-90, low - beamWidth / 2), Math.min(90, high + beamWidth / 2)];
}

/** How many of ascending things, from the first on, a condition holds for. */
export function countUpTo(length: number, holds: (index: number) => boolean): number {
  let [from, to] = [0, length];
  while (from < to) {
    const middle = (from + to) >> 1;
    if (holds(middle)) from = middle + 1;
    else to = middle;
  }
  return from;
}
