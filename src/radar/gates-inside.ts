import type { Sweep } from '../volume/polar-grid.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { boundsOf, contains } from '../volume/solid.ts';
import type { Solid } from '../volume/solid.ts';
import { Tally } from '../volume/statistics.ts';
import type { Statistics } from '../volume/statistics.ts';
import type { PolarData } from '../volume/volume.ts';
import { beamToLocal } from './polar-geometry.ts';

/** The places of a radial's gates, in metres: along the ground's arc, and above the antenna. */
interface Profile {
  readonly arcs: Float64Array;
  readonly heights: Float64Array;
}

/**
 * Statistics of the gates whose middles lie inside a solid.
 * @param solid - in local metres: east, north, and above the antenna. The generator yields after each radial.
 */
export function* sumUpGates(
  { grid: { sweeps, earthRadius }, samples, slope, intercept }: PolarData,
  solid: Solid,
): Generator<void, Statistics> {
  const tally = new Tally();
  const noData = samples instanceof Float32Array ? NaN : 0;
  const [low, high] = boundsOf(solid);
  for (const sweep of sweeps) {
    const { azimuths, elevation, elevations, gates, offset } = sweep;
    let profile = profileOf(sweep, elevation, earthRadius);
    for (let radial = 0; radial < azimuths.length; radial++) {
      if (elevations) profile = profileOf(sweep, elevations[radial], earthRadius);
      const { arcs, heights } = profile;
      const angle = (azimuths[radial] * Math.PI) / 180;
      const [east, north] = [Math.sin(angle), Math.cos(angle)];
      const first = offset + radial * gates;
      for (let gate = 0; gate < gates; gate++) {
        if (heights[gate] < low[2] || heights[gate] > high[2]) continue;
        if (contains(solid, [arcs[gate] * east, arcs[gate] * north, heights[gate]]))
          tally.add(samples, first + gate, first + gate + 1, noData);
      }
      yield;
    }
  }
  return tally.finish({ slope, intercept });
}

function profileOf({ firstGate, gateLength, gates }: Sweep, elevation: number, earthRadius: number): Profile {
  const profile = { arcs: new Float64Array(gates), heights: new Float64Array(gates) };
  for (let gate = 0; gate < gates; gate++) {
    [, profile.arcs[gate], profile.heights[gate]] = beamToLocal(
      { range: firstGate + gate * gateLength, azimuth: 0, elevation },
      earthRadius,
    );
  }
  return profile;
}

/**
 * The three edges of the volume that a radar resolves at a place: a gate along the beam, the distance between radials around, and the beam's
 * width upward. Metres in local coordinates.
 */
export function edgesOfGate(
  { grid: { sweeps, beamWidth } }: Pick<PolarData, 'grid'>,
  [x, y, z]: Vector3,
): readonly Vector3[] {
  const arc = Math.hypot(x, y);
  const range = Math.hypot(arc, z);
  const [sin, cos] = arc > 0 ? [x / arc, y / arc] : [0, 1];
  const [out, up] = range > 0 ? [arc / range, z / range] : [1, 0];
  const { gateLength, azimuths } = sweeps[0];
  const around = (arc * spacingOf(azimuths, beamWidth) * Math.PI) / 180;
  const across = (range * beamWidth * Math.PI) / 180;
  return [
    [gateLength * out * sin, gateLength * out * cos, gateLength * up],
    [around * cos, -around * sin, 0],
    [-across * up * sin, -across * up * cos, across * out],
  ];
}

/**
 * Degrees between neighbouring radials. It is the median, because a sector has a gap and may cross north.
 * @param single - the result for a single radial
 */
function spacingOf(azimuths: Float64Array, single: number): number {
  const gaps = azimuths
    .map((azimuth, i) => (i + 1 < azimuths.length ? azimuths[i + 1] : azimuths[0] + 360) - azimuth)
    .filter((gap) => gap <= 180);
  gaps.sort();
  return gaps.length > 0 ? gaps[gaps.length >> 1] : single;
}
