import { dot, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { heightOverCone, localToBeam, unitToLocal } from './polar-geometry.ts';
import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { elevationAt } from './sweep-elevations.ts';
import type { PolarVolume, Samples } from '../volume/volume.ts';
import { brighten } from '../optics/transfer/brighten.ts';
import { interpolatePolar, interpolateSweep } from './interpolate-polar.ts';
import type { HalfSpace, Plane } from '../optics/attachments/plane-outlines.ts';
import type { Ray } from '../optics/rays/rays.ts';
import { isCutOut } from '../optics/rays/clip-intervals.ts';
import type { Interval, IntervalStage } from '../optics/rays/ray-stages.ts';
import { slackOf } from '../optics/rays/slack.ts';
import { straightColor } from '../optics/attachments/plane-slices.ts';
import type { Color, TransferFunction } from '../optics/transfer/transfer-function.ts';

/** A surface in a radar volume on which its values are painted. */
export type Slice = ConeSlice | LevelSlice | UprightSlice;

/** The cone of one sweep, as a PPI shows it. */
export interface ConeSlice {
  readonly kind: 'cone';
  /** Its number among the volume's. */
  readonly sweep: number;
}

/** All that is at one height, as a CAPPI shows it. */
export interface LevelSlice {
  readonly kind: 'level';
  /** Metres above the antenna. */
  readonly height: number;
}

/** What stands above a line on the ground, as an RHI and a vertical section show it. */
export interface UprightSlice {
  readonly kind: 'upright';
  /** Metres east and north. */
  readonly from: readonly [number, number];
  /** East and north, of length 1. */
  readonly direction: readonly [number, number];
  /** Metres along the ground; Infinity for a line without an end. */
  readonly length: number;
}

/** Whether a slice lies in a plane. */
export function isFlat(slice: Slice): slice is LevelSlice | UprightSlice {
  return slice.kind !== 'cone';
}

/** A flat slice in the unit cube of a grid's box, with where it ends along the ground. */
export function planeOfSlice(slice: LevelSlice | UprightSlice, { low, high }: PolarGrid['box']): Plane & { readonly within: readonly HalfSpace[] } {
  /** normal . local = offset, of places in metres. */
  const inUnitCube = (normal: Vector3, offset: number): Plane => {
    const turned = normal.map((x, axis) => x * (high[axis] - low[axis])) as unknown as Vector3;
    const size = Math.max(...turned.map(Math.abs));
    return { normal: scale(turned, 1 / size), offset: (offset - dot(normal, low)) / size };
  };
  if (slice.kind === 'level') return { ...inUnitCube([0, 0, 1], slice.height), within: [] };
  const { from: [x, y], direction: [east, north], length } = slice;
  const begin = inUnitCube([east, north, 0], east * x + north * y);
  const end = Number.isFinite(length) ? [inUnitCube([-east, -north, 0], -(east * x + north * y + length))] : [];
  return { ...inUnitCube([north, -east, 0], north * x - east * y), within: [begin, ...end] };
}

/** Where a ray meets a slice, and what is painted there. */
export interface SliceHit {
  readonly t: number;
  /** Straight. */
  readonly color: Color;
}

/** A volume shows no more at a time. */
export const maxSlices = 4;

/**
 * What a cone is looked for with: intervals of a ray on each side of where it comes nearest to the radar's axis, the
 * nearer the shorter, and halvings of one in which the ray goes through the cone.
 */
export const coneSearch = { intervals: 24, halvings: 20 } as const;

/**
 * What rays see of a volume's slices: the nearest point at which one has data and the transfer function shows them.
 * @param optics - opacity says no more than whether a value is shown at all
 */
export function sliceMeeter(
  volume: Pick<PolarVolume, 'samples' | 'grid' | 'slope' | 'intercept'>,
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
        const stored = slice.kind === 'cone' ? valueOnCone(samples, grid, placeAt(t), slice.sweep) : interpolatePolar(samples, grid, placeAt(t));
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
 * The nearest slice ends a ray, and stands behind what is before it. One on a cut face is seen from both of its sides. Twin: shaders/chunks/radar/slices.glsl
 * @param meet - see sliceMeeter
 */
export function sliceInterval(meet: ReturnType<typeof sliceMeeter>): IntervalStage {
  return (ray, interval) => {
    const { entry, exit, gap } = interval;
    const hit = meet(ray, [entry, exit], gap);
    return hit ? { ...interval, exit: hit.t < entry + slackOf(ray) ? Math.min(entry, exit) : Math.min(exit, hit.t), behind: [...hit.color, 1] } : interval;
  };
}

/** Stored value on a sweep at a place of it: rounding brings nothing of its neighbours in. */
function valueOnCone(samples: Samples, grid: PolarGrid, place: Vector3, sweep: number): number {
  return interpolateSweep(samples, grid, sweep, localToBeam(place, grid.earthRadius));
}

function alongRay({ point, direction }: Ray, t: number): Vector3 {
  return [point[0] + t * direction[0], point[1] + t * direction[1], point[2] + t * direction[2]];
}

/** Where a straight line goes through a slice, nearest first, in its parameter. */
function crossSlice(
  slice: Slice,
  { sweeps, earthRadius }: PolarGrid,
  placeAt: (t: number) => Vector3,
  span: readonly [number, number],
): number[] {
  if (slice.kind === 'cone') return crossCone((t) => heightOverSweep(placeAt(t), sweeps[slice.sweep], earthRadius), nearestToAxis(placeAt), span);
  const [begin, one] = [placeAt(0), placeAt(1)];
  const over = (place: Vector3): number => (slice.kind === 'level' ? place[2] - slice.height : acrossOf(slice, place));
  const t = over(begin) / (over(begin) - over(one));
  if (!(t >= span[0] && t <= span[1])) return [];
  if (slice.kind === 'level') return [t];
  const place = placeAt(t);
  const along = (place[0] - slice.from[0]) * slice.direction[0] + (place[1] - slice.from[1]) * slice.direction[1];
  return along >= 0 && along <= slice.length ? [t] : [];
}

/** Metres above the beams of a sweep. */
function heightOverSweep(place: Vector3, sweep: Sweep, earthRadius: number): number {
  const elevation = sweep.elevations ? elevationAt(sweep, localToBeam(place, earthRadius).azimuth) : sweep.elevation;
  return heightOverCone(place, elevation, earthRadius);
}

/** Metres from an upright slice's plane. */
function acrossOf({ from, direction }: UprightSlice, place: Vector3): number {
  return (place[0] - from[0]) * direction[1] - (place[1] - from[1]) * direction[0];
}

/** Where a straight line comes nearest to the radar's axis; anywhere if it runs along it. */
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
