import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { spanOfSweep, sweepsAround } from '../volume/sweep-elevations.ts';

/** Texels across the table; the shader knows it as TABLE_WIDTH. */
export const tableWidth = 1024;

/** Rows of padding after each sweep: its first two rays again, so that the shader need not wrap around north. */
export const repeatedRays = 2;

/** Bins are so much narrower than the narrowest gap that no two rays or sweeps begin in one, whatever rounding does. */
const binsPerGap = 1.1;

/** Degrees: how far rounding may bring an elevation out of its bin. */
const binMargin = 1e-3;

/** Most texels: 64 MB. Only of files with thousands of sweeps are some bins wider than they should be. */
const mostTexels = tableWidth * 4096;

/**
 * What the shader looks up to find sweeps and rays: bins of elevation; a texel for each sweep (range of the first gate in
 * metres, 1 / gate length, gates, 0); bins of azimuth for each sweep. A bin holds the number of the last sweep (the row
 * of the last ray) at or before it, its angle in degrees, and the angles of the two after it. Where rays have elevations
 * of their own a bin of elevation holds the numbers of the first and the last sweep that may be next to a place in it, and
 * there is a texel for each row of rays: its elevation and that of the next row.
 */
export interface PolarTable {
  /** RGBA, `tableWidth` texels a row. */
  readonly texels: Float32Array<ArrayBuffer>;
  readonly height: number;
  /** Bins per degree of elevation, and of azimuth. */
  readonly elevationBinsPerDegree: number;
  readonly azimuthBinsPerDegree: number;
  /** First texel of the sweeps, and of the azimuths. */
  readonly sweepsFrom: number;
  readonly azimuthsFrom: number;
  /** First texel of the rays' elevations; null where all rays have their sweep's. */
  readonly rayElevationsFrom: number | null;
  /** Bins of azimuth of each sweep. */
  readonly azimuthBins: number;
  /** Row of each sweep's first ray among all rays. */
  readonly firstRows: readonly number[];
}

export function buildPolarTable({ sweeps }: PolarGrid): PolarTable {
  const elevations = sweeps.map(({ elevation }) => elevation);
  const elevationBinsPerDegree = binsPerGap / narrowestGap(elevations);
  const elevationBins = Math.floor((elevations.at(-1)! - elevations[0]) * elevationBinsPerDegree) + 2;
  const sweepsFrom = elevationBins;
  const firstRows = countRows(sweeps);
  const rayElevationsFrom = sweeps.some((sweep) => sweep.elevations) ? sweepsFrom + sweeps.length : null;
  const azimuthsFrom = sweepsFrom + sweeps.length + (rayElevationsFrom === null ? 0 : firstRows.at(-1)!);
  const narrowest = Math.min(...sweeps.map(({ azimuths }) => narrowestGap([...azimuths, azimuths[0] + 360])));
  const azimuthBins = Math.min(Math.ceil((360 * binsPerGap) / narrowest), Math.floor((mostTexels - azimuthsFrom) / sweeps.length));
  const height = Math.ceil((azimuthsFrom + sweeps.length * azimuthBins) / tableWidth);
  const texels = new Float32Array(tableWidth * height * 4);
  if (rayElevationsFrom === null) writeElevations(texels, elevations, elevationBins, elevationBinsPerDegree);
  else writeSweepsAround(texels, sweeps, elevationBins, elevationBinsPerDegree);
  sweeps.forEach((sweep, i) => {
    texels.set([sweep.firstGate, 1 / sweep.gateLength, sweep.gates], (sweepsFrom + i) * 4);
    if (rayElevationsFrom !== null) writeRayElevations(texels.subarray((rayElevationsFrom + firstRows[i]) * 4), sweep);
    writeAzimuths(texels.subarray((azimuthsFrom + i * azimuthBins) * 4), sweep, firstRows[i], azimuthBins);
  });
  const azimuthBinsPerDegree = azimuthBins / 360;
  return {
    texels, height, elevationBinsPerDegree, azimuthBinsPerDegree, sweepsFrom, azimuthsFrom, rayElevationsFrom, azimuthBins,
    firstRows: firstRows.slice(0, -1),
  };
}

/** Row of each sweep's first ray, and how many rows there are. */
function countRows(sweeps: readonly Sweep[]): number[] {
  const rows = [0];
  for (const { azimuths } of sweeps) rows.push(rows.at(-1)! + azimuths.length + repeatedRays);
  return rows;
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

function writeRayElevations(texels: Float32Array, { azimuths, elevation, elevations }: Sweep): void {
  const rays = azimuths.length;
  const at = (ray: number): number => elevations?.[ray % rays] ?? elevation;
  for (let ray = 0; ray < rays + repeatedRays; ray++) texels.set([at(ray), at(ray + 1)], ray * 4);
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

/** Rays are numbered on around the circle, from the last one before north. */
function writeAzimuths(texels: Float32Array, { azimuths }: Sweep, firstRow: number, bins: number): void {
  const rays = azimuths.length;
  const angleOf = (i: number): number => azimuths[(i + rays - 1) % rays] + 360 * Math.floor((i - 1) / rays);
  for (let bin = 0; bin < bins; bin++) {
    const [i, ...angles] = describeBin((bin * 360) / bins, rays + 1, angleOf);
    texels.set([firstRow + ((i + rays - 1) % rays), ...angles], bin * 4);
  }
}
