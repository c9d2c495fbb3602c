import { dot, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { heightOverCone, localToBeam, unitToLocal } from './polar-geometry.ts';
import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { elevationAt } from './sweep-elevations.ts';
import type { PolarData, Samples } from '../volume/volume.ts';
import { brighten } from '../optics/transfer/brighten.ts';
import { interpolatePolar, interpolateSweep } from './interpolate-polar.ts';
import type { HalfSpace, Plane } from '../optics/attachments/plane-outlines.ts';
import type { Ray } from '../optics/rays/rays.ts';
import { isCutOut } from '../optics/rays/clip-intervals.ts';
import type { Interval, IntervalStage } from '../optics/rays/ray-stages.ts';
import { slackOf } from '../optics/rays/slack.ts';
import { straightColor } from '../optics/attachments/plane-slices.ts';
import type { Color, TransferFunction } from '../optics/transfer/transfer-function.ts';

/** A surface in a radar volume that is painted with the volume's values. */
export type Slice = ConeSlice | LevelSlice | UprightSlice;

/** The cone of one sweep, as in a PPI. */
export interface ConeSlice {
  readonly kind: 'cone';
  /** The sweep's number in the volume. */
  readonly sweep: number;
}

/** Everything at one height, as in a CAPPI. */
export interface LevelSlice {
  readonly kind: 'level';
  /** Metres above the antenna. */
  readonly height: number;
}

/** Everything above a line on the ground, as in an RHI or a vertical section. */
export interface UprightSlice {
  readonly kind: 'upright';
  /** Metres east and north. */
  readonly from: readonly [number, number];
  /** East and north, of length 1. */
  readonly direction: readonly [number, number];
  /** Metres along the ground; Infinity for a line without end. */
  readonly length: number;
}

/** Whether a slice lies in a plane. */
export function isFlat(slice: Slice): slice is LevelSlice | UprightSlice {
  return slice.kind !== 'cone';
}

/** A flat slice as a plane in the unit cube of a grid's box, with the half-spaces that limit it along the ground. */
export function planeOfSlice(
  slice: LevelSlice | UprightSlice,
  { low, high }: PolarGrid['box'],
): Plane & { readonly within: readonly HalfSpace[] } {
  /** Converts the plane normal . local = offset, for places in metres. */
  const inUnitCube = (normal: Vector3, offset: number): Plane => {
    const turned = normal.map((x, axis) => x * (high[axis] - low[axis])) as unknown as Vector3;
    const size = Math.max(...turned.map(Math.abs));
    return { normal: scale(turned, 1 / size), offset: (offset - dot(normal, low)) / size };
  };
  if (slice.kind === 'level') return { ...inUnitCube([0, 0, 1], slice.height), within: [] };
  const {
    from: [x, y],
    direction: [east, north],
    length,
  } = slice;
  const begin = inUnitCube([east, north, 0], east * x + north * y);
  const end = Number.isFinite(length) ? [inUnitCube([-east, -north, 0], -(east * x + north * y + length))] : [];
  return { ...inUnitCube([north, -east, 0], north * x - east * y), within: [begin, ...end] };
}

/** Where a ray meets a slice, and the colour there. */
export interface SliceHit {
  readonly t: number;
  /** Straight, not premultiplied. */
  readonly color: Color;
}

/** The largest number of slices that a volume shows at a time. */
export const maxSlices = 4;

/**
 * How the crossings of a ray with a cone are searched: the number of intervals on each side of the place where the ray is nearest to the
 * radar's axis (nearer intervals are shorter), and of halvings of an interval in which the ray passes through the cone.
 */
export const coneSearch = { intervals: 24, halvings: 20 } as const;

/**
 * Finds what rays meet of a volume's slices: the nearest point where a slice has data that the transfer function makes visible.
 * @param optics - opacity only decides whether a value is visible at all
 */
export function sliceMeeter(
  volume: Pick<PolarData, 'samples' | 'grid' | 'slope' | 'intercept'>,
  slices: readonly Slice[],
  optics: { readonly transferFunction: TransferFunction; readonly lightFactor: number },
): (ray: Ray, span: readonly [number, number], gap?: Interval['gap']) => SliceHit | null {
  const { grid, samples, slope, intercept } = volume;
  const colors = brighten(optics.transferFunction, optics.lightFactor);
  return (ray, span, gap) => {
    const slack = slackOf(ray);
    if (!(span[0] < span[1] + slack)) return null;
    const near = [span[0] - slack, span[1] + slack] as const;
    const placeAt = (t: number): Vector3 => unitToLocal(grid.box, alongRay(ray, t));
    let nearest: SliceHit | null = null;
    for (const slice of slices) {
      for (const t of crossSlice(slice, grid, placeAt, near)) {
        if (nearest && t >= nearest.t) break;
        if (isCutOut(gap, t, slack)) continue;
        const stored =
          slice.kind === 'cone'
            ? valueOnCone(samples, grid, placeAt(t), slice.sweep)
            : interpolatePolar(samples, grid, placeAt(t));
        const color = straightColor(colors, slope * stored + intercept);
        if (!color) continue;
        nearest = { t, color };
        break;
      }
    }
    return nearest;
  };
}

/**
 * The nearest slice ends a ray, and its colour stands behind everything in front of it. A slice on a cut face is visible from both sides.
 * Twin: shaders/chunks/radar/slices.glsl
 * @param meet - see sliceMeeter
 */
export function sliceInterval(meet: ReturnType<typeof sliceMeeter>): IntervalStage {
  return (ray, interval) => {
    const { entry, exit, gap } = interval;
    const hit = meet(ray, [entry, exit], gap);
    return hit
      ? {
          ...interval,
          exit: hit.t < entry + slackOf(ray) ? Math.min(entry, exit) : Math.min(exit, hit.t),
          behind: [...hit.color, 1],
        }
      : interval;
  };
}

/** Stored value on a sweep at one of its places. With this sweep alone, rounding cannot mix in values of its neighbours. */
function valueOnCone(samples: Samples, grid: PolarGrid, place: Vector3, sweep: number): number {
  return interpolateSweep(samples, grid, sweep, localToBeam(place, grid.earthRadius));
}

function alongRay({ point, direction }: Ray, t: number): Vector3 {
  return [point[0] + t * direction[0], point[1] + t * direction[1], point[2] + t * direction[2]];
}

/** Where a straight line passes through a slice, nearest first, in the line's parameter. */
function crossSlice(
  slice: Slice,
  { sweeps, earthRadius }: PolarGrid,
  placeAt: (t: number) => Vector3,
  span: readonly [number, number],
): number[] {
  if (slice.kind === 'cone')
    return crossCone(
      (t) => heightOverSweep(placeAt(t), sweeps[slice.sweep], earthRadius),
      nearestToAxis(placeAt),
      span,
    );
  const [begin, one] = [placeAt(0), placeAt(1)];
  const over = (place: Vector3): number => (slice.kind === 'level' ? place[2] - slice.height : acrossOf(slice, place));
  const t = over(begin) / (over(begin) - over(one));
  if (!(t >= span[0] && t <= span[1])) return [];
  if (slice.kind === 'level') return [t];
  const place = placeAt(t);
  const along = (place[0] - slice.from[0]) * slice.direction[0] + (place[1] - slice.from[1]) * slice.direction[1];
  return along >= 0 && along <= slice.length ? [t] : [];
}

/** Height in metres above the beams of a sweep. */
function heightOverSweep(place: Vector3, sweep: Sweep, earthRadius: number): number {
  const elevation = sweep.elevations ? elevationAt(sweep, localToBeam(place, earthRadius).azimuth) : sweep.elevation;
  return heightOverCone(place, elevation, earthRadius);
}

/** Distance in metres from an upright slice's plane. */
function acrossOf({ from, direction }: UprightSlice, place: Vector3): number {
  return (place[0] - from[0]) * direction[1] - (place[1] - from[1]) * direction[0];
}

/** Where a straight line is nearest to the radar's axis; any place if it is parallel to the axis. */
function nearestToAxis(placeAt: (t: number) => Vector3): number {
  const [begin, one] = [placeAt(0), placeAt(1)];
  const [x, y] = [one[0] - begin[0], one[1] - begin[1]];
  return -(begin[0] * x + begin[1] * y) / Math.max(x * x + y * y, 1e-20);
}

/** Where a function changes its sign, in ascending order. */
function crossCone(over: (t: number) => number, middle: number, [from, to]: readonly [number, number]): number[] {
  const { intervals, halvings } = coneSearch;
  const nearest = Math.min(to, Math.max(from, middle));
  const crossings: number[] = [];
  let [before, wasAbove] = [from, over(from) >= 0];
  for (let i = 1 - intervals; i <= intervals; i++) {
    const share = i / intervals;
    const t = nearest + share * Math.abs(share) * (share < 0 ? nearest - from : to - nearest);
    const isAbove = over(t) >= 0;
    if (isAbove !== wasAbove) {
      let [low, high] = [before, t];
      for (let halving = 0; halving < halvings; halving++) {
        const half = (low + high) / 2;
        if (over(half) >= 0 === wasAbove) low = half;
        else high = half;
      }
      crossings.push((low + high) / 2);
    }
    [before, wasAbove] = [t, isAbove];
  }
  return crossings;
}
