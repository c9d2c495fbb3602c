import type { Vector3 } from '../volume/matrix.ts';
import { borders, coasts, mapUnit } from './map-data.ts';
import { placeFromEarth } from './place-from-earth.ts';
import type { EarthPoint } from './place-on-earth.ts';
import { meanEarthRadius } from './polar-geometry.ts';

/** Coasts and borders around a radar, at the height of its antenna: polylines in world coordinates. */
export interface GroundMap {
  readonly coasts: readonly (readonly Vector3[])[];
  readonly borders: readonly (readonly Vector3[])[];
}

const radians = Math.PI / 180;

/** Metres: a quarter of the way around the Earth. Beyond it, the map's straight pieces would cut through the area they should go around. */
const farthest = (Math.PI / 2) * meanEarthRadius;

/**
 * The map around a radar, up to its last ring. It is Natural Earth's map of 1:50 million, whose lines are some kilometres off.
 * @param reach - metres along the ground
 */
export function buildGroundMap(radar: EarthPoint, reach: number): GroundMap {
  const cut = (text: string): Vector3[][] => text.split(' ').flatMap((line) => cutLine(readLine(line), radar, reach));
  return { coasts: cut(coasts), borders: cut(borders) };
}

/** The points of a line, in degrees. The text is an "encoded polyline" of Google Maps. */
export function readLine(text: string): EarthPoint[] {
  const points: EarthPoint[] = [];
  let at = 0;
  const readNumber = (): number => {
    let [value, shift, bits] = [0, 0, 32];
    for (; bits & 32; shift += 5) {
      bits = text.charCodeAt(at++) - 63;
      value |= (bits & 31) << shift;
    }
    return value & 1 ? ~(value >> 1) : value >> 1;
  };
  let [longitude, latitude] = [0, 0];
  while (at < text.length) {
    longitude += readNumber();
    latitude += readNumber();
    points.push({ longitude: longitude * mapUnit, latitude: latitude * mapUnit });
  }
  return points;
}

/** The parts of a line that lie within a radar's reach. */
function cutLine(line: readonly EarthPoint[], radar: EarthPoint, reach: number): Vector3[][] {
  if (!comesNear(line, radar, reach)) return [];
  const parts: Vector3[][] = [];
  let isOpen = false;
  let before: readonly [number, number] | null = null;
  for (const point of line) {
    const place = placeFromEarth(radar, point);
    const span = before && spanInside(before, place, reach);
    if (before && span) {
      const [begin, end] = span.map((t): Vector3 => [
        before![0] + t * (place[0] - before![0]),
        before![1] + t * (place[1] - before![1]),
        0,
      ]);
      if (!isOpen || span[0] > 0) parts.push([begin]);
      parts.at(-1)!.push(end);
    }
    isOpen = span !== null && span[1] === 1;
    before = place;
  }
  return parts;
}

/** Whether a line's points lie in the zone of latitudes that the reach touches. Most lines do not, and this test needs no sine. */
function comesNear(line: readonly EarthPoint[], { latitude }: EarthPoint, reach: number): boolean {
  const zone = reach / meanEarthRadius / radians;
  let [low, high] = [Infinity, -Infinity];
  for (const point of line) [low, high] = [Math.min(low, point.latitude), Math.max(high, point.latitude)];
  return low <= latitude + zone && high >= latitude - zone;
}

/** The part of a straight piece that lies within a circle around 0, as shares of the piece; null if it is outside. */
function spanInside(
  [x, y]: readonly [number, number],
  [toX, toY]: readonly [number, number],
  radius: number,
): [number, number] | null {
  const [dx, dy] = [toX - x, toY - y];
  const a = dx * dx + dy * dy;
  if (a === 0 || Math.max(Math.hypot(x, y), Math.hypot(toX, toY)) > farthest) return null;
  const b = x * dx + y * dy;
  const root = b * b - a * (x * x + y * y - radius * radius);
  if (root <= 0) return null;
  const [enter, leave] = [Math.max(0, (-b - Math.sqrt(root)) / a), Math.min(1, (-b + Math.sqrt(root)) / a)];
  return enter < leave ? [enter, leave] : null;
}
