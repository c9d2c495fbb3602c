// Describes places in a radar's volume: loaded with the first pick in one.
import { nearestGate } from '../../radar/interpolate-polar.ts';
import { placeOnEarth } from '../../radar/place-on-earth.ts';
import { localToBeam, unitToLocal } from '../../radar/polar-geometry.ts';
import type { PolarGrid } from '../../volume/polar-grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { PolarVolume } from '../../volume/volume.ts';
import type { RadarGate, RadarPlace } from '../model/volume-pick.ts';

/**
 * A place as the radar sees it, and the value there.
 * @param place - in the unit cube
 * @returns null where no gate around it has data
 */
export function describeRadar(volume: PolarVolume, place: Vector3): { value: number; place: RadarPlace } | null {
  const { grid, samples, slope, intercept } = volume;
  const index = nearestGate(samples, grid, localToBeam(unitToLocal(grid.box, place), grid.earthRadius));
  return index < 0
    ? null
    : {
        value: slope * samples[index] + intercept,
        place: { ...describePlace(volume, place), gate: gateOf(grid, index) },
      };
}

/** A place as the radar sees it, whether it has data there or not. @param place - in the unit cube */
export function describePlace({ grid, radar }: PolarVolume, place: Vector3): Omit<RadarPlace, 'gate'> {
  const local = unitToLocal(grid.box, place);
  const { latitude, longitude, height } = radar?.site ?? {};
  const isPlaced = latitude !== undefined && longitude !== undefined;
  const below = isPlaced ? placeOnEarth({ latitude, longitude }, local) : { latitude: null, longitude: null };
  return {
    ...localToBeam(local, grid.earthRadius),
    heightAboveAntenna: local[2],
    heightAboveSea: height === undefined ? null : height + local[2],
    ...below,
  };
}

/** @param index - of a sample */
function gateOf({ sweeps }: PolarGrid, index: number): RadarGate {
  const sweep = sweeps.findIndex(
    ({ offset, azimuths, gates }) => index >= offset && index < offset + azimuths.length * gates,
  );
  const { offset, gates, azimuths, elevation, elevations, firstGate, gateLength } = sweeps[sweep];
  const radial = Math.floor((index - offset) / gates);
  const gate = (index - offset) % gates;
  return {
    sweep,
    radial,
    gate,
    range: firstGate + gate * gateLength,
    azimuth: azimuths[radial],
    elevation: elevations?.[radial] ?? elevation,
  };
}
