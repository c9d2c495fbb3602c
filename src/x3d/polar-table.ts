import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';

/** Texels across the table; the shader knows it as TABLE_WIDTH. */
export const tableWidth = 1024;

/** Rows of padding after each sweep: its first two rays again, so that the shader need not wrap around north. */
export const repeatedRays = 2;

/** Bins are so much narrower than the narrowest gap that no two rays or sweeps begin in one, whatever rounding does. */
const binsPerGap = 1.1;

/** Most texels: 64 MB. Only of files with thousands of sweeps are some bins wider than they should be. */
const mostTexels = tableWidth * 4096;

/**
 * What the shader looks up to find sweeps and rays: bins of elevation; a texel for each sweep (range of the first gate in
 * metres, 1 / gate length, gates, 0); bins of azimuth for each sweep. A bin holds the number of the last sweep (the row
 * of the last ray) at or before it, its angle in degrees, and the angles of the two after it.
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
  const azimuthsFrom = sweepsFrom + sweeps.length;
  const narrowest = Math.min(...sweeps.map(({ azimuths }) => narrowestGap([...azimuths, azimuths[0] + 360])));
  const azimuthBins = Math.min(Math.ceil((360 * binsPerGap) / narrowest), Math.floor((mostTexels - azimuthsFrom) / sweeps.length));
  const height = Math.ceil((azimuthsFrom + sweeps.length * azimuthBins) / tableWidth);
  const texels = new Float32Array(tableWidth * height * 4);
  for (let bin = 0; bin < elevationBins; bin++) {
    const at = elevations[0] + bin / elevationBinsPerDegree;
    texels.set(describeBin(at, elevations.length, (i) => elevations[i] ?? elevations.at(-1)! + 90 * (i - elevations.length + 1)), bin * 4);
  }
  const firstRows: number[] = [];
  let row = 0;
  sweeps.forEach((sweep, i) => {
    texels.set([sweep.firstGate, 1 / sweep.gateLength, sweep.gates], (sweepsFrom + i) * 4);
    writeAzimuths(texels.subarray((azimuthsFrom + i * azimuthBins) * 4), sweep, row, azimuthBins);
    firstRows.push(row);
    row += sweep.azimuths.length + repeatedRays;
  });
  const azimuthBinsPerDegree = azimuthBins / 360;
  return { texels, height, elevationBinsPerDegree, azimuthBinsPerDegree, sweepsFrom, azimuthsFrom, azimuthBins, firstRows };
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
