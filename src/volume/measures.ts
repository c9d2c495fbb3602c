// Lengths, angles and volumes between points that a person set, and their uncertainty on a grid. Pure functions.
import { cross, dot, length, normalize, scale, subtract } from './matrix.ts';
import type { Vector3 } from './matrix.ts';

export const measureTypes = ['distance', 'angle', 'box', 'sphere'] as const;
export type MeasureType = (typeof measureTypes)[number];

/**
 * Number of points of each measurement. An angle's second point is its corner; a box has two opposite corners; a sphere
 * its centre and a point on it.
 */
export const pointCounts: Readonly<Record<MeasureType, number>> = { distance: 2, angle: 3, box: 2, sphere: 2 };

/** A number, and twice its standard uncertainty. */
export interface Measured {
  readonly value: number;
  readonly uncertainty: number;
}

/** The edges of the voxel at a place, three vectors. */
export type EdgesAt = (place: Vector3) => readonly Vector3[];

/** World length. */
export function measureDistance([from, to]: readonly Vector3[], edgesAt: EdgesAt): Measured {
  const apart = subtract(to, from);
  const value = length(apart);
  const u = unit(apart);
  return { value, uncertainty: spread([from, to], u ? [scale(u, -1), u] : [null, null], edgesAt) };
}

/** Degrees at the second of three points; 0 if it is equal to another one. */
export function measureAngle([first, corner, last]: readonly Vector3[], edgesAt: EdgesAt): Measured {
  const [a, b] = [subtract(first, corner), subtract(last, corner)];
  const [ua, ub] = [unit(a), unit(b)];
  if (!ua || !ub) return { value: 0, uncertainty: 180 };
  const normal = cross(ua, ub);
  const value = Math.atan2(length(normal), dot(ua, ub));
  const n = unit(normal) ?? normalize(cross(ua, Math.abs(ua[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0])); // For a straight angle, any perpendicular direction.
  // An arm's angle changes with the perpendicular displacement of its end, divided by its length.
  const [ga, gb] = [scale(cross(ua, n), 1 / length(a)), scale(cross(n, ub), 1 / length(b))];
  const corners = scale([ga[0] + gb[0], ga[1] + gb[1], ga[2] + gb[2]], -1);
  const degrees = 180 / Math.PI;
  return {
    value: value * degrees,
    uncertainty: Math.min(180, spread([first, corner, last], [ga, corners, gb], edgesAt) * degrees),
  };
}

/**
 * World volume of a box along the world's axes. If a box is smaller than the uncertainty of its edges, its volume may
 * be as large as that.
 */
export function measureBox([from, to]: readonly Vector3[], edgesAt: EdgesAt): Measured {
  const size = subtract(to, from);
  const [x, y, z] = size.map(Math.abs);
  const gradient = [y * z, x * z, x * y].map((area, axis) => area * Math.sign(size[axis])) as unknown as Vector3;
  const known = (along: Vector3): number => spread([from, to], [scale(along, -1), along], edgesAt);
  return {
    value: x * y * z,
    uncertainty: Math.max(known(gradient), known([1, 0, 0]) * known([0, 1, 0]) * known([0, 0, 1])),
  };
}

/** World volume of a sphere. The same rule applies to its radius. */
export function measureSphere(points: readonly Vector3[], edgesAt: EdgesAt): Measured {
  const radius = measureDistance(points, edgesAt);
  const ball = (r: number): number => (4 / 3) * Math.PI * r ** 3;
  return {
    value: ball(radius.value),
    uncertainty: Math.max(4 * Math.PI * radius.value ** 2 * radius.uncertainty, ball(radius.uncertainty)),
  };
}

function unit(v: Vector3): Vector3 | null {
  const l = length(v);
  return l > 0 ? scale(v, 1 / l) : null;
}

/**
 * Twice the standard uncertainty of a value that is computed from some points. Each point is known to lie somewhere in
 * its voxel: along an edge of the voxel its variance is a twelfth of the edge's square.
 * @param gradients - of the value, by each point; null if it has no direction: then its length is 1 in any direction
 */
function spread(places: readonly Vector3[], gradients: readonly (Vector3 | null)[], edgesAt: EdgesAt): number {
  let variance = 0;
  places.forEach((place, i) => {
    const gradient = gradients[i];
    for (const edge of edgesAt(place)) variance += (gradient ? dot(gradient, edge) ** 2 : dot(edge, edge) / 3) / 12;
  });
  return 2 * Math.sqrt(variance);
}
