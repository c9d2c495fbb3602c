import type { Vector3 } from '../volume/matrix.ts';
import { localToBeam, unitToLocal } from './polar-geometry.ts';
import type { BeamPoint } from './polar-geometry.ts';
import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { countUpTo, elevationAt, radialsAround, widestGap } from './sweep-elevations.ts';
import type { PolarData, Samples } from '../volume/volume.ts';

/** Gates with a smaller weight do not count: a 0 that rounding has changed must not decide whether there is a fold. */
const minWeight = 1e-6;

/** A gate next to a point. */
interface Corner {
  /** Stored value; NaN if there is no data. */
  readonly value: number;
  readonly weight: number;
  /** Index of the gate among the samples. */
  readonly index: number;
}

/** Stored values of a polar volume at points of its unit cube; NaN if there is no data. */
export function polarSampler({ samples, grid }: Pick<PolarData, 'samples' | 'grid'>): (p: Vector3) => number {
  return (p) => interpolatePolar(samples, grid, unitToLocal(grid.box, p));
}

/**
 * Interpolates in range, azimuth and elevation between the eight gates around a point, linear in each. Gates without
 * data are left out, and the weights of the others are scaled up; if these make up less than half, there is no data. Across a
 * fold of the velocity, the gate with the largest weight counts alone.
 *
 * Data end half a gate before the first gate and after the last, and half a beam below the lowest sweep and above the highest.
 * Up to there, the outermost values continue. The same holds on both sides of a gap between sweeps that is wider than `widestGap`.
 * @param local - metres east and north along the ground, and above the antenna
 * @returns stored value, or NaN if there is no data
 */
export function interpolatePolar(samples: Samples, grid: PolarGrid, local: Vector3): number {
  return interpolateBeam(samples, grid, localToBeam(local, grid.earthRadius));
}

/** The same at a range, an azimuth and an elevation. */
export function interpolateBeam(samples: Samples, grid: PolarGrid, beam: BeamPoint): number {
  return blend(cornersAround(samples, grid, beam), grid.foldFrom ?? Infinity);
}

/** The same at a range and an azimuth of one sweep, without its neighbours. */
export function interpolateSweep(samples: Samples, grid: PolarGrid, sweep: number, beam: BeamPoint): number {
  return blend(cornersInSweep(samples, grid.sweeps[sweep], beam, 1), grid.foldFrom ?? Infinity);
}

function blend(corners: readonly Corner[], foldFrom: number): number {
  let [low, high, weights, sum] = [Infinity, -Infinity, 0, 0];
  let heaviest: Corner | null = null;
  for (const corner of corners) {
    const { value, weight } = corner;
    if (Number.isNaN(value) || weight < minWeight) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
    // Summed as differences from the heaviest gate so far, so that a constant stays exact to the last digit.
    const base = heaviest?.value ?? value;
    sum += weight * (value - base);
    weights += weight;
    if (!heaviest) {
      heaviest = corner;
    } else if (weight > heaviest.weight) {
      sum += weights * (base - value);
      heaviest = corner;
    }
  }
  if (!heaviest || weights < 0.5) return NaN;
  return high - low > foldFrom ? heaviest.value : heaviest.value + sum / weights;
}

/**
 * The gate with data that has the largest weight at a place.
 * @returns its index among the samples; -1 if there is none
 */
export function nearestGate(samples: Samples, grid: PolarGrid, beam: BeamPoint): number {
  let nearest: Corner | null = null;
  for (const corner of cornersAround(samples, grid, beam)) {
    if (!Number.isNaN(corner.value) && corner.weight > (nearest?.weight ?? 0)) nearest = corner;
  }
  return nearest?.index ?? -1;
}

function cornersAround(samples: Samples, grid: PolarGrid, beam: BeamPoint): Corner[] {
  const corners: Corner[] = [];
  for (const { sweep, weight } of weighSweeps(grid, beam))
    corners.push(...cornersInSweep(samples, sweep, beam, weight));
  return corners;
}

interface WeighedSweep {
  readonly sweep: Sweep;
  readonly weight: number;
}

/** A sweep, and its elevation at the azimuth of a place. */
interface Neighbour {
  readonly sweep: Sweep;
  readonly at: number;
}

/** The nearest sweeps below and above a place, by their elevations at its azimuth. */
function weighSweeps({ sweeps, beamWidth }: PolarGrid, { azimuth, elevation }: BeamPoint): WeighedSweep[] {
  let below: Neighbour | null = null;
  let above: Neighbour | null = null;
  for (const sweep of sweepsNear(sweeps, elevation)) {
    const at = elevationAt(sweep, azimuth);
    if (at <= elevation && (!below || at >= below.at)) below = { sweep, at };
    if (at > elevation && (!above || at < above.at)) above = { sweep, at };
  }
  const near: Neighbour[] = [below, above].filter((one) => one !== null);
  if (below && above && above.at - below.at <= widestGap(beamWidth)) {
    const share = (elevation - below.at) / (above.at - below.at);
    return [
      { sweep: below.sweep, weight: 1 - share },
      { sweep: above.sweep, weight: share },
    ];
  }
  return near.filter(({ at }) => Math.abs(elevation - at) <= beamWidth / 2).map(({ sweep }) => ({ sweep, weight: 1 }));
}

/** All sweeps that can be the next one below or above: see `sweepsAround`. */
function sweepsNear(sweeps: readonly Sweep[], elevation: number): readonly Sweep[] {
  const count = countUpTo(sweeps.length, (i) => sweeps[i].elevation <= elevation);
  return sweeps.slice(Math.max(0, count - 3), count + 3);
}

function cornersInSweep(samples: Samples, sweep: Sweep, beam: BeamPoint, share: number): Corner[] {
  const { firstGate, gateLength, gates, offset } = sweep;
  const place = (beam.range - firstGate) / gateLength;
  if (place < -0.5 || place > gates - 0.5) return [];
  const inside = Math.min(gates - 1, Math.max(0, place));
  const gate = Math.floor(inside);
  const { radials, along: turned } = radialsAround(sweep.azimuths, beam.azimuth);
  const along = inside - gate;
  const corner = (radial: number, index: number, weight: number): Corner => {
    const at = offset + radial * gates + Math.min(gates - 1, index);
    const value = samples[at];
    return { value: isData(samples, value) ? value : NaN, weight: share * weight, index: at };
  };
  return [
    corner(radials[0], gate, (1 - turned) * (1 - along)),
    corner(radials[0], gate + 1, (1 - turned) * along),
    corner(radials[1], gate, turned * (1 - along)),
    corner(radials[1], gate + 1, turned * along),
  ];
}

function isData(samples: Samples, value: number): boolean {
  return samples instanceof Float32Array ? Number.isFinite(value) : value !== 0;
}
