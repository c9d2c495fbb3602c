// How much of the light of a place reaches the eye: 1 minus the opacity of the ray that ends at the place.
import { invertAffine, subtract, transformDirection } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { castRay } from './rays/cast-ray.ts';
import type { IntervalStage, RayStages } from './rays/ray-stages.ts';
import { rayThrough } from './rays/rays.ts';
import type { Ray, RaySetup } from './rays/rays.ts';

/** What stands at the place itself does not hide it: a slice, a cut, a mesh. In bounding diameters: 0.2 mm in a head of 300 mm. */
export const thickness = 7e-4;

/** The ray from the eye through a place. */
export interface RayToPlace {
  readonly ray: Ray;
  /** Where the ray reaches the place. */
  readonly t: number;
  /** Device coordinates of its pixel, -1..1 inside the picture. */
  readonly x: number;
  readonly y: number;
}

/**
 * @param place - in the unit cube, or outside of it
 * @returns null where the place is not in front of the eye
 */
export function rayToPlace(setup: RaySetup, place: Vector3): RayToPlace | null {
  const {
    point: [p, px, py],
    direction: [d, dx, dy],
    eyeT,
  } = setup;
  const isPerspective = Number.isFinite(eyeT);
  // In perspective all rays begin at the eye, p + eyeT d. Then place - eye = s d + s x dx + s y dy; else place - p = s d + x px + y py.
  const eye: Vector3 = isPerspective ? ([0, 1, 2].map((i) => p[i] + eyeT * d[i]) as unknown as Vector3) : p;
  const [across, up] = isPerspective ? [dx, dy] : [px, py];
  const toRay = invertAffine([0, 1, 2].flatMap((i) => [d[i], across[i], up[i], 0]).concat(0, 0, 0, 1));
  if (!toRay) return null;
  const [s, a, b] = transformDirection(toRay, subtract(place, eye));
  if (isPerspective && !(s > 0)) return null;
  const [x, y] = isPerspective ? [a / s, b / s] : [a, b];
  return { ray: rayThrough(setup, x, y), t: isPerspective ? eyeT + s : s, x, y };
}

/** Ends rays at `t`; what stood behind that place, or at it, is not seen. */
function endAt(t: number): IntervalStage {
  return (ray, interval) => {
    // Lengths along the ray are `lengthPerT` times t.
    if (interval.exit < t - thickness / ray.lengthPerT) return interval;
    return { ...interval, exit: Math.min(interval.exit, t), behind: null };
  };
}

/** The share of the light from a place at `t` that reaches the eye through everything in front of it, 0..1. */
export function transmittanceTo(stages: RayStages, ray: Ray, t: number): number {
  const [, , , alpha] = castRay({ ...stages, intervals: [...stages.intervals, endAt(t)] }, ray);
  return Math.min(1, Math.max(0, 1 - alpha));
}
