import { meanEarthRadius } from './polar-geometry.ts';

const radians = Math.PI / 180;

/** Degrees north and east. */
export interface EarthPoint {
  readonly latitude: number;
  readonly longitude: number;
}

/**
 * The point of a round Earth below a place that a radar sees.
 * @param east - metres from the radar along the ground's arc; `north` alike
 * @returns longitude from -180 up to 180
 * Source: Snyder, *Map Projections: A Working Manual*, 1987, eq. 20-14 and 20-15, azimuthal equidistant
 */
export function placeOnEarth(
  radar: EarthPoint,
  [east, north]: readonly [east: number, north: number, ...rest: number[]],
): EarthPoint {
  const distance = Math.hypot(east, north);
  if (distance === 0) return radar;
  const angle = distance / meanEarthRadius;
  const [sin, cos] = [Math.sin(radar.latitude * radians), Math.cos(radar.latitude * radians)];
  const latitude = Math.asin(Math.cos(angle) * sin + (north / distance) * Math.sin(angle) * cos) / radians;
  const turn =
    Math.atan2(east * Math.sin(angle), distance * cos * Math.cos(angle) - north * sin * Math.sin(angle)) / radians;
  const longitude = radar.longitude + turn;
  return { latitude, longitude: longitude - 360 * Math.floor((longitude + 180) / 360) };
}
