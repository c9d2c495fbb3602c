import { dot, transformDirection, transformPoint } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { Interval, IntervalStage } from './ray-stages.ts';
import { intersectUnitCube } from './rays.ts';
import type { Ray } from './rays.ts';
import { slackOf } from './slack.ts';

/** The part of a volume that stays: the places p of the grid's unit cube with normal . p >= offset. */
export interface HalfSpace {
  readonly kind: 'half-space';
  readonly normal: Vector3;
  readonly offset: number;
}

/** A box that is cut out of a volume. */
export interface Cutout {
  readonly kind: 'cutout';
  /** Row-major 4 x 4: the grid's unit cube to that of the box. */
  readonly unitToBox: Matrix4;
}

/** The largest number of half-spaces in a program: six planes, and the six sides of a box. */
export const maxHalfSpaces = 12;

/** Below this, a ray counts as parallel to a plane, as in `intersectUnitCube`. */
const parallel = 1e-9;

/** Limits rays to where all half-spaces overlap. Twin: shaders/chunks/walk/clip.glsl */
export function clipInterval(kept: readonly HalfSpace[]): IntervalStage {
  return (ray, interval) => {
    const left = kept.reduce((before, one) => keep(one, ray, before), interval);
    return left.exit < left.entry + slackOf(ray) ? { ...left, exit: Math.min(left.exit, left.entry) } : left;
  };
}

function keep({ normal, offset }: HalfSpace, { point, direction }: Ray, interval: Interval): Interval {
  const given = dot(normal, direction);
  const slope = Math.abs(given) < parallel ? parallel : given;
  const t = (offset - dot(normal, point)) / slope;
  return slope > 0
    ? { ...interval, entry: Math.max(interval.entry, t) }
    : { ...interval, exit: Math.min(interval.exit, t) };
}

/** Cuts a box out of rays: a ray begins behind it, ends in front of it, or has a gap. Twin: shaders/chunks/walk/cutout.glsl */
export function cutoutInterval({ unitToBox }: Cutout): IntervalStage {
  return (ray, interval) => {
    const { point, direction } = ray;
    const slack = slackOf(ray);
    const [from, to] = intersectUnitCube(transformPoint(unitToBox, point), transformDirection(unitToBox, direction));
    const { entry, exit } = interval;
    if (from >= to || to <= entry + slack || from >= exit - slack) return interval;
    const [isFront, isBack] = [from <= entry + slack, to >= exit - slack];
    if (isFront) return { ...interval, entry: to, exit: isBack ? Math.min(exit, to) : exit };
    return isBack ? { ...interval, exit: from } : { ...interval, gap: [from, to] };
  };
}

/** Whether a thing at t has been cut out. A thing on a cut face has not. */
export function isCutOut(gap: Interval['gap'], t: number, slack: number): boolean {
  return gap !== undefined && t > gap[0] + slack && t < gap[1] - slack;
}
