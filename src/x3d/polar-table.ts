import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { spanOfSweep, sweepsAround } from '../volume/sweep-elevations.ts';
import { rayAt, turnAt } from './polar-layout.ts';
import type { PolarLayout, SweepLayout } from './polar-layout.ts';

/** Texels across the table; the shader knows it as TABLE_WIDTH. */
export const tableWidth = 512;

/** Bins of elevation are so much narrower than the narrowest gap that no two sweeps begin in one, whatever rounding does. */
const binsPerGap = 1.1;

/** Bins of azimuth, per ray of the sweep with the most. */
const binsPerRay = 1.1;

/** Most rays that begin in a bin of azimuth: the shader passes two of them in each of its MOST_HOPS. */
const mostRaysInBin = 2 * 8;

/** Degrees: how far rounding may bring an elevation out of its bin. */
const binMargin = 1e-3;

/** Most texels for more bins of azimuth where rays crowd: 16 MB. */
const mostTexels = 2 ** 20;

/**
 * What the shader looks up to find sweeps and rays: bins of elevation; a texel for each sweep; one for each ray, by its
 * number; bins of azimuth for each sweep.
 *
 * A bin of azimuth holds the number of the last ray at or before its begin, that ray's turn in degrees (see PolarLayout),
 * and the turns of the two after it. A ray's texel holds its elevation and that of the ray after it, and the turns of the
 * two after it, for bins in which more than one ray begins. A sweep's texel: range of the first gate in metres, 1 / gate
 * length, gates, and what is added to a ray's number / its sweep's rays per row to get its row of texels.
 *
 * A bin of elevation holds the same of sweeps as one of azimuth of rays, with elevations. Where rays have elevations of
 * their own it holds the numbers of the first and the last sweep that may be next to a place in it.
 */
export interface PolarTable {
  /** RGBA, `tableWidth` texels a row. */
  readonly texels: Float32Array<ArrayBuffer>;
  readonly height: number;
  /** Bins per degree of elevation, and of azimuth. */
  readonly elevationBinsPerDegree: number;
  readonly azimuthBinsPerDegree: number;
  /** Bins of azimuth of each sweep. */
  readonly azimuthBins: number;
  /** First texel of the sweeps, of the rays, and of the azimuths. */
  readonly sweepsFrom: number;
  readonly raysFrom: number;
  readonly azimuthsFrom: number;
}

export function buildPolarTable({ sweeps }: PolarGrid, layout: PolarLayout): PolarTable {
  const elevations = sweeps.map(({ elevation }) => elevation);
  const elevationBinsPerDegree = binsPerGap / narrowestGap(elevations);
  const sweepsFrom = Math.floor((elevations.at(-1)! - elevations[0]) * elevationBinsPerDegree) + 2;
  const raysFrom = sweepsFrom + sweeps.length;
  const azimuthsFrom = raysFrom + layout.numbers;
  const turns = sweeps.map((sweep, i) => (place: number): number => turnAt(sweep, layout.sweeps[i], layout.from, place));
  const azimuthBins = chooseAzimuthBins(layout, turns);
  const azimuthBinsPerDegree = azimuthBins / extentOf(layout);
  const height = Math.ceil((azimuthsFrom + sweeps.length * azimuthBins) / tableWidth);
  const texels = new Float32Array(tableWidth * height * 4);
  if (hasRayElevations(sweeps)) writeSweepsAround(texels, sweeps, sweepsFrom, elevationBinsPerDegree);
  else writeElevations(texels, elevations, sweepsFrom, elevationBinsPerDegree);
  sweeps.forEach((sweep, i) => {
    const { firstRow, firstNumber, raysPerRow, rays } = layout.sweeps[i];
    texels.set([sweep.firstGate, 1 / sweep.gateLength, sweep.gates, firstRow - firstNumber / raysPerRow], (sweepsFrom + i) * 4);
    writeRays(texels.subarray((raysFrom + firstNumber) * 4), sweep, layout.sweeps[i], turns[i]);
    for (let bin = 0; bin < azimuthBins; bin++) {
      const [place, ...angles] = describeBin(bin / azimuthBinsPerDegree, rays - 1, turns[i]);
      texels.set([firstNumber + place, ...angles], (azimuthsFrom + i * azimuthBins + bin) * 4);
    }
  });
  return { texels, height, elevationBinsPerDegree, azimuthBinsPerDegree, azimuthBins, sweepsFrom, raysFrom, azimuthsFrom };
}

export function hasRayElevations(sweeps: readonly Sweep[]): boolean {
  return sweeps.some((sweep) => sweep.elevations);
}

/** Degrees that the bins of azimuth cover; the last one goes on around the circle. */
function extentOf({ extent }: PolarLayout): number {
  return Math.max(extent, 1);
}

/** Turn of a sweep's ray, by its place: see `turnAt`. */
type Turn = (place: number) => number;

/** About as many as the sweep with the most rays has, and more where rays crowd. */
function chooseAzimuthBins(layout: PolarLayout, turns: readonly Turn[]): number {
  let bins = Math.ceil(binsPerRay * Math.max(...layout.sweeps.map(({ rays }) => rays)));
  while (2 * bins * turns.length <= mostTexels && countCrowd(layout, turns, bins) > mostRaysInBin) bins *= 2;
  return bins;
}

/** Most rays of a sweep that begin in one of its bins. */
function countCrowd(layout: PolarLayout, turns: readonly Turn[], bins: number): number {
  let most = 0;
  layout.sweeps.forEach(({ rays }, i) => {
    let [last, crowd] = [-1, 0];
    for (let place = 1; place < rays; place++) {
      const bin = Math.min(bins - 1, Math.floor((turns[i](place) / extentOf(layout)) * bins));
      crowd = bin === last ? crowd + 1 : 1;
      last = bin;
      most = Math.max(most, crowd);
    }
  });
  return most;
}

function writeElevations(texels: Float32Array, elevations: readonly number[], bins: number, binsPerDegree: number): void {
  const last = elevations.length - 1;
  const angleOf = (i: number): number => elevations[i] ?? elevations[last] + 90 * (i - last);
  for (let bin = 0; bin < bins; bin++) {
    texels.set(describeBin(elevations[0] + bin / binsPerDegree, elevations.length, angleOf), bin * 4);
  }
}

/** The outermost bins hold all that is farther down and up, too. */
function writeSweepsAround(texels: Float32Array, sweeps: readonly Sweep[], bins: number, binsPerDegree: number): void {
  const spans = sweeps.map(spanOfSweep);
  for (let bin = 0; bin < bins; bin++) {
    const from = bin === 0 ? -90 : sweeps[0].elevation + bin / binsPerDegree - binMargin;
    const to = bin >= bins - 2 ? 90 : sweeps[0].elevation + (bin + 1) / binsPerDegree + binMargin;
    texels.set(sweepsAround(sweeps, spans, [from, to]), bin * 4);
  }
}

function writeRays(texels: Float32Array, sweep: Sweep, layout: SweepLayout, turnOf: Turn): void {
  const elevationOf = (place: number): number => sweep.elevations?.[rayAt(sweep, layout, place)] ?? sweep.elevation;
  for (let place = 0; place < layout.rays; place++) {
    texels.set([elevationOf(place), elevationOf(place + 1), turnOf(place + 1), turnOf(place + 2)], place * 4);
  }
}

function narrowestGap(ascending: readonly number[]): number {
  let least = 360;
  for (let i = 1; i < ascending.length; i++) least = Math.min(least, ascending[i] - ascending[i - 1]);
  return least;
}

/** @param angleOf - of the first `count` neighbours and the two after them, ascending */
function describeBin(at: number, count: number, angleOf: (i: number) => number): [number, number, number, number] {
  let [from, to] = [0, count];
  while (from < to) {
    const middle = (from + to) >> 1;
    if (angleOf(middle) <= at) from = middle + 1;
    else to = middle;
  }
  const last = Math.max(0, from - 1);
  return [last, angleOf(last), angleOf(last + 1), angleOf(last + 2)];
}
