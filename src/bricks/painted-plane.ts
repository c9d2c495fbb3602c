// Opaque planes through a volume, on which its values are painted, for the estimate of what coarse bricks hide.
import { add, dot, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { DetailField } from './detail-field.ts';
import type { SpanSums } from './span-sums.ts';

/** Places p of the unit cube with normal . p = offset. */
export interface PaintedPlane {
  readonly normal: Vector3;
  readonly offset: number;
  /** What values look like on it. Where their opacity is 0, the plane is not there. */
  readonly sums: SpanSums;
}

/** Where a ray ends on a plane. */
export interface PlaneMeeting {
  readonly plane: PaintedPlane;
  /** The ray's parameter. */
  readonly t: number;
  /** The place, and one on each side of the plane next to it: unit cube. */
  readonly places: readonly Vector3[];
}

/** How far a place next to a plane is from it, in edges of the unit cube. Planes this far outside of the volume are on its face. */
const nearby = 1e-5;

/** The nearest plane that a ray meets; null for none. @param isShown - whether a plane has something to show at a place; places: as in `PlaneMeeting` */
export function meetPlane(
  planes: readonly PaintedPlane[],
  ray: {
    readonly point: readonly number[];
    readonly direction: readonly number[];
    readonly entry: number;
    readonly exit: number;
  },
  isShown: (plane: PaintedPlane, places: readonly Vector3[]) => boolean,
): PlaneMeeting | null {
  const [point, direction] = [ray.point, ray.direction] as unknown as readonly [Vector3, Vector3];
  const slack = nearby / Math.hypot(...direction);
  let nearest: PlaneMeeting | null = null;
  for (const plane of planes) {
    const { normal, offset } = plane;
    const t = (offset - dot(normal, point)) / dot(normal, direction);
    if (!(t >= ray.entry - slack && t <= ray.exit + slack && t < (nearest?.t ?? Infinity))) continue;
    const inside = Math.min(ray.exit, Math.max(ray.entry, t));
    const place = add(point, scale(direction, inside));
    const aside = scale(normal, nearby / Math.hypot(...normal));
    const places = [place, add(place, aside), add(place, scale(aside, -1))];
    if (isShown(plane, places)) nearest = { plane, t: inside, places };
  }
  return nearest;
}

/** Finds the plane on which a ray of an estimate ends, and where on it the coarser side is: where a plane lies between two cells, pixels may show either. Null for no planes. */
export function planeFinder(
  field: DetailField,
  planes: readonly PaintedPlane[],
  isAway?: (x: number, y: number, z: number) => boolean,
): ((ray: Parameters<typeof meetPlane>[1]) => (PlaneMeeting & { readonly coarsest: Vector3 }) | null) | null {
  if (planes.length === 0) return null;
  const isShown = (plane: PaintedPlane, places: readonly Vector3[]): boolean => {
    const value = field.valueAt(...places[0]);
    if (Number.isNaN(value)) return false;
    // A plane on the face of a cut is there.
    if (isAway && places.every((place) => isAway(...place))) return false;
    return plane.sums.meanOpacity(value, value) > 0.5;
  };
  const levelAt = (place: Vector3): number => field.levelOf(field.cellAt(...place));
  return (ray) => {
    const met = meetPlane(planes, ray, isShown);
    return (
      met && {
        ...met,
        coarsest: met.places.reduce((one, other) => (levelAt(other) > levelAt(one) ? other : one)),
      }
    );
  };
}
