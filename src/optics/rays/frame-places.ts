import { add, cross, dot, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { orbitCamera } from './camera.ts';
import type { Orbit } from './camera.ts';

/** The direction from which a camera looks, and its picture. */
export interface FramedView extends Omit<Orbit, 'radius'> {
  /** Vertical, radians. */
  readonly fieldOfView: number;
  /** The picture's width / height. */
  readonly aspect: number;
}

/** Share of the picture's width or height that the framed places fill. */
const framedShare = 0.86;

/**
 * The nearest camera in a given direction whose picture contains all places, with a margin.
 * @param places - at least one
 * @param fixed - what the camera looks at; if null, the point that puts the places in the middle of the picture, at half their depth
 */
export function framePlaces(
  places: readonly Vector3[],
  { theta, phi, fieldOfView, aspect }: FramedView,
  fixed: Vector3 | null = null,
): { target: Vector3; radius: number } {
  const { eye: back, up } = orbitCamera({ theta, phi, radius: 1 }, [0, 0, 0], fieldOfView);
  const depths = places.map((place) => dot(back, place));
  let target = scale(back, (farthest(depths, Math.max) + farthest(depths, Math.min)) / 2);
  let distance = -Infinity;
  const tangent = Math.tan(fieldOfView / 2) * framedShare;
  for (const [axis, slope] of [
    [cross(up, back), tangent * aspect],
    [up, tangent],
  ] as const) {
    // An eye at c, at distance d, has a place at x in its picture if |x - c| <= slope (d - depth).
    const toEnd = (sign: number): number =>
      farthest(
        places.map((place, i) => (sign * dot(axis, place)) / slope + depths[i]),
        Math.max,
      );
    const [right, left] = [toEnd(1), toEnd(-1)];
    const center = fixed ? dot(axis, fixed) / slope : (right - left) / 2;
    distance = Math.max(distance, right - center, left + center);
    target = add(target, scale(axis, center * slope));
  }
  return { target: fixed ?? target, radius: distance - dot(back, fixed ?? target) };
}

function farthest(numbers: readonly number[], max: (a: number, b: number) => number): number {
  return numbers.reduce((a, b) => max(a, b));
}
