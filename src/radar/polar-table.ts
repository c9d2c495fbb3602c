import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { spanOfSweep, sweepsAround } from './sweep-elevations.ts';
import { radialAt, turnAt } from './polar-layout.ts';
import type { PolarLayout, SweepLayout } from './polar-layout.ts';

/** Number of texels in a row of the table; in the shader it is TABLE_WIDTH. */
export const tableWidth = 512;

/**
 * Bins of elevation are narrower than the narrowest gap by this factor, so that no two sweeps begin in the same bin,
 * whatever rounding does.
 */
const binsPerGap = 1.1;

/** Number of bins of azimuth per radial of the sweep with the most radials. */
const binsPerRadial = 1.1;

/** Largest number of radials that begin in a bin of azimuth: the shader passes two of them in each of its MAX_HOPS. */
const maxRadialsInBin = 2 * 8;

/** Degrees by which rounding may move an elevation out of its bin. */
const binMargin = 1e-3;

/** Largest number of texels for more bins of azimuth where radials crowd: 16 MB. */
const maxTexels = 2 ** 20;

/**
 * For each texel of additional bins there must be this many texels of gates. With more bins, the shader has no radials to pass, and they
 * take little room compared with the gates.
 */
const gatesPerTexel = 128;

/** Largest number of texels in all: 32 MB. They are made on the page's thread. The radars with the most radials need a thirtieth. */
const maxTableTexels = 2 ** 21;

/**
 * The table in which the shader finds sweeps and radials. It has bins of elevation, a texel for each sweep, a texel for each radial (by its
 * number), and bins of azimuth for each sweep.
 *
 * A bin of azimuth has the number of the last radial at or before its start, that radial's turn in degrees (see PolarLayout),
 * and the turns of the two radials after it. A radial's texel has its elevation, that of the radial after it, and the turns of the
 * two after it, for bins in which more than one radial begins. A sweep's texel has the range of the first gate in metres, 1 / gate
 * length, the number of gates, and what is added to (a radial's number / its sweep's radials per row) to get its row of texels.
 *
 * A bin of elevation has the same for sweeps, with elevations instead of turns. If radials have elevations of
 * their own, it has the numbers of the first and the last sweep that may be next to a place in it.
 */
export interface PolarTable {
  /** RGBA, `tableWidth` texels per row. */
  readonly texels: Float32Array<ArrayBuffer>;
  readonly height: number;
  /** Number of bins per degree of elevation, and of azimuth. */
  readonly elevationBinsPerDegree: number;
  readonly azimuthBinsPerDegree: number;
  /** Number of bins of azimuth for each sweep. */
  readonly azimuthBins: number;
  /** First texel of the sweeps, of the radials, and of the bins of azimuth. */
  readonly sweepsFrom: number;
  readonly radialsFrom: number;
  readonly azimuthsFrom: number;
  /** Whether more than one radial begins in some bin, so that the shader must pass some. */
  readonly crowds: boolean;
}

/**
 * @param maxSize - largest number of rows of texels on the device
 * @returns null if the table would be larger, or too large for a page; then nothing is allocated
 */
export function buildPolarTable({ sweeps }: PolarGrid, layout: PolarLayout, maxSize: number): PolarTable | null {
  const elevations = sweeps.map(({ elevation }) => elevation);
  const elevationBinsPerDegree = binsPerGap / narrowestGap(elevations);
  const sweepsFrom = Math.floor((elevations.at(-1)! - elevations[0]) * elevationBinsPerDegree) + 2;
  const radialsFrom = sweepsFrom + sweeps.length;
  const azimuthsFrom = radialsFrom + layout.numbers;
  const max = Math.min(maxTableTexels, tableWidth * maxSize);
  if (!(azimuthsFrom + sweeps.length * minBins(layout) <= max)) return null;
  const turns = sweeps.map(
    (sweep, i) =>
      (place: number): number =>
        turnAt(sweep, layout.sweeps[i], layout.from, place),
  );
  const azimuthBins = chooseAzimuthBins(layout, turns);
  const crowds = countCrowd(layout, turns, azimuthBins) > 1;
  const azimuthBinsPerDegree = azimuthBins / extentOf(layout);
  if (azimuthsFrom + sweeps.length * azimuthBins > max) return null;
  const height = Math.ceil((azimuthsFrom + sweeps.length * azimuthBins) / tableWidth);
  const texels = new Float32Array(tableWidth * height * 4);
  if (hasRadialElevations(sweeps)) writeSweepsAround(texels, sweeps, sweepsFrom, elevationBinsPerDegree);
  else writeElevations(texels, elevations, sweepsFrom, elevationBinsPerDegree);
  sweeps.forEach((sweep, i) => {
    const { firstRow, firstNumber, radialsPerRow, radials } = layout.sweeps[i];
    texels.set(
      [sweep.firstGate, 1 / sweep.gateLength, sweep.gates, firstRow - firstNumber / radialsPerRow],
      (sweepsFrom + i) * 4,
    );
    writeRadials(texels.subarray((radialsFrom + firstNumber) * 4), sweep, layout.sweeps[i], turns[i]);
    for (let bin = 0; bin < azimuthBins; bin++) {
      const [place, ...angles] = describeBin(bin / azimuthBinsPerDegree, radials - 1, turns[i]);
      texels.set([firstNumber + place, ...angles], (azimuthsFrom + i * azimuthBins + bin) * 4);
    }
  });
  return {
    texels,
    height,
    elevationBinsPerDegree,
    azimuthBinsPerDegree,
    azimuthBins,
    sweepsFrom,
    radialsFrom,
    azimuthsFrom,
    crowds,
  };
}

export function hasRadialElevations(sweeps: readonly Sweep[]): boolean {
  return sweeps.some((sweep) => sweep.elevations);
}

/** Degrees that the bins of azimuth cover. The last bin continues around the circle. */
function extentOf({ extent }: PolarLayout): number {
  return Math.max(extent, 1);
}

/** Turn of a sweep's radial, by its place: see `turnAt`. */
type Turn = (place: number) => number;

/** Number of bins of azimuth for each sweep if none of its radials crowd. */
function minBins({ sweeps }: PolarLayout): number {
  return Math.ceil(binsPerRadial * sweeps.reduce((max, { radials }) => Math.max(max, radials), 0));
}

/** About as many bins as the sweep with the most radials has radials, and more where radials crowd. */
function chooseAzimuthBins(layout: PolarLayout, turns: readonly Turn[]): number {
  let bins = minBins(layout);
  while (2 * bins * turns.length <= maxTexels && countCrowd(layout, turns, bins) > maxRadialsInBin) bins *= 2;
  if (countCrowd(layout, turns, bins) === 1) return bins;
  const max = (layout.width * layout.height) / gatesPerTexel;
  return (
    [2 * bins, 4 * bins].find((more) => more * turns.length <= max && countCrowd(layout, turns, more) === 1) ?? bins
  );
}

/** Largest number of radials of a sweep that begin in one of its bins, within the first whole turn. */
function countCrowd(layout: PolarLayout, turns: readonly Turn[], bins: number): number {
  let max = 0;
  layout.sweeps.forEach(({ radials }, i) => {
    let [last, crowd] = [-1, 0];
    for (let place = 1; place < radials; place++) {
      const turn = turns[i](place);
      if (turn >= 360) break;
      const bin = Math.min(bins - 1, Math.floor((turn / extentOf(layout)) * bins));
      crowd = bin === last ? crowd + 1 : 1;
      last = bin;
      max = Math.max(max, crowd);
    }
  });
  return max;
}

function writeElevations(
  texels: Float32Array,
  elevations: readonly number[],
  bins: number,
  binsPerDegree: number,
): void {
  const last = elevations.length - 1;
  const angleOf = (i: number): number => elevations[i] ?? elevations[last] + 90 * (i - last);
  for (let bin = 0; bin < bins; bin++) {
    texels.set(describeBin(elevations[0] + bin / binsPerDegree, elevations.length, angleOf), bin * 4);
  }
}

/** The outermost bins also cover everything that is farther down and up. */
function writeSweepsAround(texels: Float32Array, sweeps: readonly Sweep[], bins: number, binsPerDegree: number): void {
  const spans = sweeps.map(spanOfSweep);
  for (let bin = 0; bin < bins; bin++) {
    const from = bin === 0 ? -90 : sweeps[0].elevation + bin / binsPerDegree - binMargin;
    const to = bin >= bins - 2 ? 90 : sweeps[0].elevation + (bin + 1) / binsPerDegree + binMargin;
    texels.set(sweepsAround(sweeps, spans, [from, to]), bin * 4);
  }
}

function writeRadials(texels: Float32Array, sweep: Sweep, layout: SweepLayout, turnOf: Turn): void {
  const elevationOf = (place: number): number => sweep.elevations?.[radialAt(sweep, layout, place)] ?? sweep.elevation;
  for (let place = 0; place < layout.radials; place++) {
    texels.set([elevationOf(place), elevationOf(place + 1), turnOf(place + 1), turnOf(place + 2)], place * 4);
  }
}

function narrowestGap(ascending: readonly number[]): number {
  let min = 360;
  for (let i = 1; i < ascending.length; i++) min = Math.min(min, ascending[i] - ascending[i - 1]);
  return min;
}

/** @param angleOf - angles of the first `count` neighbours and of the two after them, ascending */
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
