import type { EarthPoint } from './place-on-earth.ts';
import { meanEarthRadius } from './polar-geometry.ts';

const radians = Math.PI / 180;

/**
 * Where a radar sees a point of a round Earth: the inverse of `placeOnEarth`.
 * @returns metres east and north of the radar along the ground's arc
 * Source: Snyder, *Map Projections: A Working Manual*, 1987, eq. 22-4, 22-5 and 25-2, azimuthal equidistant; the angle from its sine
 * and cosine, so that it is as exact near the radar
 */
export function placeFromEarth(
  radar: EarthPoint,
  { latitude, longitude }: EarthPoint,
): readonly [east: number, north: number] {
  const [sin, cos] = [Math.sin(latitude * radians), Math.cos(latitude * radians)];
  const [sinRadar, cosRadar] = [Math.sin(radar.latitude * radians), Math.cos(radar.latitude * radians)];
  const turn = (longitude - radar.longitude) * radians;
  // 1 - cos(turn), and the sine of the difference of latitudes, both without differences of large numbers.
  const bend = 2 * Math.sin(turn / 2) ** 2;
  const east = cos * Math.sin(turn);
  const north = Math.sin((latitude - radar.latitude) * radians) + sinRadar * cos * bend;
  const across = Math.hypot(east, north);
  if (across === 0) return [0, 0];
  const angle = Math.atan2(across, sinRadar * sin + cosRadar * cos * Math.cos(turn));
  const scale = (meanEarthRadius * angle) / across;
  return [east * scale, north * scale];
}
