import { dot } from './matrix.ts';
import type { Vector3 } from './matrix.ts';

/** A half of the world: the points p with normal . p >= at. The normal has any length except zero. */
export interface HalfWorld {
  readonly normal: Vector3;
  readonly at: number;
}

/** A box along the world's axes: its lowest and highest coordinate on each. */
export type Bounds = readonly (readonly [low: number, high: number])[];

/** What is cut away of the world; for a radar, with heights as they are shown. */
export interface WorldCut {
  /** What lies in all of these halves is kept. */
  readonly kept: readonly HalfWorld[];
  /** What lies inside this box is cut away, and what lies on its sides is kept; null for no box. */
  readonly removed: Bounds | null;
}

/**
 * The box between two opposite corners.
 * @param box - x0 y0 z0 x1 y1 z1, world units; for a radar, heights before exaggeration
 * @param stretch - factor by which heights are shown
 */
export function boundsBetween(box: readonly number[], stretch: number): Bounds {
  return [1, 1, stretch].map((factor, axis) => {
    const ends = [factor * box[axis], factor * box[axis + 3]];
    return [Math.min(...ends), Math.max(...ends)];
  });
}

/**
 * The halves whose intersection is the inside of all boxes: two for each axis, from its low and its high end. If the
 * boxes do not overlap, the result is a box turned inside out, which is empty.
 */
export function sidesOf(boxes: readonly Bounds[]): HalfWorld[] {
  return (boxes.length > 0 ? [0, 1, 2] : []).flatMap((axis) => {
    const low = Math.max(...boxes.map((bounds) => bounds[axis][0]));
    const high = Math.min(...boxes.map((bounds) => bounds[axis][1]));
    const normal = [0, 1, 2].map((one) => Number(one === axis)) as unknown as Vector3;
    return [
      { normal, at: low },
      { normal: normal.map((x) => -x) as unknown as Vector3, at: -high },
    ];
  });
}

/** Whether a point remains after a cut. */
export function isKept({ kept, removed }: WorldCut, place: Vector3): boolean {
  return (
    kept.every(({ normal, at }) => dot(normal, place) >= at) &&
    !removed?.every(([low, high], axis) => place[axis] > low && place[axis] < high)
  );
}
