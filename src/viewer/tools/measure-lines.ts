import { cross, length, normalize, scale, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { MeasureType } from '../../volume/measures.ts';

/** Number of points around a circle. */
const circlePoints = 64;

/** Radius of an angle's arc, as a share of its shorter arm. */
const arcShare = 0.25;

/** The lines that show a measure, each from point to point; lines of points that are not placed yet are missing. */
export function linesOf(type: MeasureType, points: readonly Vector3[]): readonly (readonly Vector3[])[] {
  if (points.length < 2) return [];
  if (type === 'box') return linesOfBox(points);
  if (type === 'sphere') return linesOfSphere(points);
  return type === 'angle' && points.length === 3 ? [points, arcOf(points)] : [points];
}

/** The place of its number: the middle of a line, or the corner of an angle. */
export function textPlace(type: MeasureType, [from, to]: readonly Vector3[]): Vector3 {
  return type === 'angle'
    ? to
    : type === 'sphere'
      ? from
      : scale([from[0] + to[0], from[1] + to[1], from[2] + to[2]], 0.5);
}

function linesOfBox([from, to]: readonly Vector3[]): readonly (readonly Vector3[])[] {
  const corner = (c: number): Vector3 => [c & 1 ? to[0] : from[0], c & 2 ? to[1] : from[1], c & 4 ? to[2] : from[2]];
  return [
    ...[
      [0, 1, 3, 2, 0],
      [4, 5, 7, 6, 4],
    ],
    ...[0, 1, 2, 3].map((c) => [c, c + 4]),
  ].map((line) => line.map(corner));
}

/** Three circles along the world's axes, and the radius. */
function linesOfSphere([center, end]: readonly Vector3[]): readonly (readonly Vector3[])[] {
  const radius = length(subtract(end, center));
  const circles = [
    [0, 1],
    [1, 2],
    [2, 0],
  ].map(([one, other]) =>
    Array.from({ length: circlePoints + 1 }, (_, i): Vector3 => {
      const angle = (2 * Math.PI * i) / circlePoints;
      const place = [...center];
      place[one] += radius * Math.cos(angle);
      place[other] += radius * Math.sin(angle);
      return place as unknown as Vector3;
    }),
  );
  return [...circles, [center, end]];
}

function arcOf([first, corner, last]: readonly Vector3[]): readonly Vector3[] {
  const [a, b] = [subtract(first, corner), subtract(last, corner)];
  const normal = cross(a, b);
  if (!(length(normal) > 0)) return [];
  const radius = arcShare * Math.min(length(a), length(b));
  const along = normalize(a);
  const across = normalize(cross(normal, a));
  const angle = Math.atan2(length(normal), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  const steps = Math.max(2, Math.ceil((circlePoints * angle) / (2 * Math.PI)));
  return Array.from({ length: steps + 1 }, (_, i): Vector3 => {
    const [c, s] = [Math.cos((angle * i) / steps) * radius, Math.sin((angle * i) / steps) * radius];
    return corner.map((x, axis) => x + c * along[axis] + s * across[axis]) as unknown as Vector3;
  });
}
