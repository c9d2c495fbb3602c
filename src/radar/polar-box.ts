import type { Vector3 } from '../volume/matrix.ts';
import { beamToLocal } from './polar-geometry.ts';
import type { LocalBox, Sweep, SweepGeometry } from '../volume/polar-grid.ts';
import { radialsAround, reachOfAll, reachOfSweeps, spanOfSweep } from './sweep-elevations.ts';
import type { ElevationSpan } from './sweep-elevations.ts';
import type { Samples } from '../volume/volume.ts';

/** Largest number of cells along x, y and z: as many as a texture of a cartesian volume of this kind would have. */
const maxCells: Vector3 = [1024, 1024, 128];

const degrees = 180 / Math.PI;

/** A share of the reach that is too small to be visible, but far larger than the rounding of places. */
const thread = 1e-4;

/** If a gap between radials is wider than this, in degrees, a sector ends there. A circle with a few missing radials is still a circle. */
const widestGap = 45;

/**
 * The box around everything that can be visible. Horizontally, it contains all gates (for a sector, those of the sector), so that scans of
 * one radar have the same width. Vertically, it ends above the highest gate with data: the sky that a radar scans is ten times as high
 * as any weather.
 * @param samples - no data is 0 (integers) or NaN (floats)
 */
export function boxAround(grid: SweepGeometry, samples: Samples): LocalBox {
  const { sweeps, earthRadius } = grid;
  const around = elevationsAround(grid);
  const [x, y] = [openInterval(), openInterval()];
  let [reach, top] = [0, -Infinity];
  sweeps.forEach((sweep, i) => {
    const between = around[i];
    const arcs = arcsOfSweep(sweep, between, earthRadius);
    for (const azimuth of azimuthsOfBounds(sweep.azimuths)) {
      for (const arc of arcs) {
        widen(x, arc * Math.sin(azimuth / degrees));
        widen(y, arc * Math.cos(azimuth / degrees));
      }
    }
    reach = Math.max(reach, rangeOfEnd(sweep, sweep.gates));
    const filled = countFilledGates(sweep, samples);
    if (filled > 0) top = Math.max(top, heightAt(rangeOfEnd(sweep, filled + 1), between[1], earthRadius));
  });
  const low = lowestHeight(lowestElevation(grid), reach, earthRadius);
  if (!Number.isFinite(top)) top = heightAt(reach, highestElevation(grid), earthRadius);
  const high = Math.max(top, low + sweeps[0].gateLength);
  return { low: [x[0], y[0], low], high: [x[1], y[1], high] };
}

/** Distance of the farthest gate along the ground, in metres. */
export function groundReach(grid: SweepGeometry): number {
  const around = elevationsAround(grid);
  return Math.max(...grid.sweeps.map((sweep, i) => arcsOfSweep(sweep, around[i], grid.earthRadius)[1]));
}

/** The largest span of elevations in which each sweep's gates are shown: down to the sweep below, and halfway up to the one above. */
function elevationsAround(grid: SweepGeometry): ElevationSpan[] {
  const spans = grid.sweeps.map(spanOfSweep);
  return reachOfSweeps(grid, spans).map(({ elevations: [low, high], meetsAbove }, sweep) => [
    low,
    meetsAbove ? (spans[sweep][1] + high) / 2 : high,
  ]);
}

/** Smallest and largest distance of a sweep's gates along the ground, metres. */
function arcsOfSweep(sweep: Sweep, [low, high]: ElevationSpan, earthRadius: number): [number, number] {
  const end = rangeOfEnd(sweep, sweep.gates);
  const arcAt = (range: number, elevation: number): number =>
    beamToLocal({ range, azimuth: 90, elevation }, earthRadius)[0];
  // On a round Earth, a beam reaches farthest along the ground if it points a little below the horizon.
  const flattest = Math.min(high, Math.max(low, -Math.asin(Math.min(1, end / earthRadius)) * degrees));
  const begin = Math.max(0, rangeOfEnd(sweep, 0));
  return [Math.min(arcAt(begin, low), arcAt(begin, high)), arcAt(end, flattest)];
}

/** Azimuths at which radials reach farthest to a side: the cardinal points that they cover, and the ends of sectors. */
function azimuthsOfBounds(azimuths: Float64Array): number[] {
  const found = cardinalPoints.filter((point) => {
    const [before, after] = radialsAround(azimuths, point).radials;
    return turnTo(azimuths[before], azimuths[after]) <= widestGap;
  });
  azimuths.forEach((azimuth, radial) => {
    const next = azimuths[(radial + 1) % azimuths.length];
    if (turnTo(azimuth, next) > widestGap) found.push(azimuth, next);
  });
  return found;
}

const cardinalPoints = [0, 90, 180, 270];

/** Degrees clockwise from one radial to the next one. */
function turnTo(from: number, to: number): number {
  return to > from ? to - from : to + 360 - from;
}

function openInterval(): [number, number] {
  return [Infinity, -Infinity];
}

function widen(interval: [number, number], value: number): void {
  interval[0] = Math.min(interval[0], value);
  interval[1] = Math.max(interval[1], value);
}

/**
 * The number of cells that the box is cut into: each is about a gate long and half a gate high.
 * @param gateLength - metres
 */
export function boxDimensions({ low, high }: LocalBox, gateLength: number): Vector3 {
  const cell = [gateLength, gateLength, gateLength / 2];
  return [0, 1, 2].map((axis) => {
    const cells = Math.ceil((high[axis] - low[axis]) / cell[axis]);
    return Math.min(maxCells[axis], Math.max(1, cells));
  }) as unknown as Vector3;
}

/** Degrees: half a beam below the lowest radial, down to the nadir. */
export function lowestElevation({ sweeps, beamWidth }: SweepGeometry): number {
  return reachOfAll(beamWidth, sweeps.map(spanOfSweep))[0];
}

/** Degrees: half a beam above the highest radial, up to the zenith. */
export function highestElevation({ sweeps, beamWidth }: SweepGeometry): number {
  return reachOfAll(beamWidth, sweeps.map(spanOfSweep))[1];
}

/** Metres to the far end of a number of gates, from the first on. */
function rangeOfEnd({ firstGate, gateLength, gates }: Sweep, count: number): number {
  return firstGate + (Math.min(count, gates) - 0.5) * gateLength;
}

function heightAt(range: number, elevation: number, earthRadius: number): number {
  return beamToLocal({ range, azimuth: 0, elevation }, earthRadius)[2];
}

/**
 * The lowest height of all beams. Beams that point down come nearest to the Earth on their way, where it bends away under them. A straight
 * beam along the ground would lie exactly in the box's floor, and rounding would decide whether rays leave through data. So the floor is
 * lowered a little.
 */
function lowestHeight(elevation: number, reach: number, earthRadius: number): number {
  if (elevation >= 0) return heightAt(reach, elevation, earthRadius) < thread * reach ? -thread * reach : 0;
  const nearest = Math.min(reach, Math.sin(-elevation / degrees) * earthRadius);
  return heightAt(nearest, elevation, earthRadius);
}

/** Number of gates up to the last one that has data in any radial. */
function countFilledGates({ azimuths, gates, offset }: Sweep, samples: Samples): number {
  const isFloat = samples instanceof Float32Array;
  let filled = 0;
  for (let radial = 0; radial < azimuths.length; radial++) {
    const first = offset + radial * gates;
    for (let gate = gates - 1; gate >= filled; gate--) {
      const value = samples[first + gate];
      if (isFloat ? Number.isFinite(value) : value !== 0) filled = gate + 1;
    }
  }
  return filled;
}
