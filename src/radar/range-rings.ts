import { corners } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { PolarGrid } from '../volume/polar-grid.ts';
import { clipLine } from './clip-line.ts';
import type { Rectangle } from './clip-line.ts';
import { groundReach } from './polar-box.ts';

/** Circles around a radar at the height of its antenna, and the line to the north. */
export interface Rings {
  /** World coordinates. */
  readonly lines: readonly (readonly Vector3[])[];
  readonly labels: readonly RingLabel[];
}

export interface RingLabel {
  /** Metres; null for the mark of the north. */
  readonly radius: number | null;
  /** World coordinates. */
  readonly at: Vector3;
}

/** Which rings are drawn. Radii and distances are in metres along the ground. */
export interface RingPlan {
  /** Distance from ring to ring. */
  readonly spacing: number;
  /** Number of the first ring that is drawn, counted from the antenna; 1 is the nearest. */
  readonly first: number;
  /** How many rings are drawn; 0 or less if the region lies between two rings. */
  readonly count: number;
  /** Radius of the last ring within the radar's reach; 0 if there is none. */
  readonly outermost: number;
  /** Smallest and largest distance of the visible part. */
  readonly extent: readonly [number, number];
  /** The visible part, seen from above. */
  readonly shown: Rectangle;
  /** Whether rings are cut to the visible part. */
  readonly isCut: boolean;
}

/** Number of corners of a ring. */
const ringCorners = 180;

/** Largest number of rings if the distance is chosen automatically. */
const maxAutomatic = 6;

/** A ring beyond the reach by this share is still drawn: the reach is shorter along the ground than along the beam. */
const beyondReach = 0.01;

/** More rings would look like a gray disc. */
export const maxRings = 100;

/**
 * Plans the rings of a radar. The outermost ring is where the scan ends, or before that.
 * @param region - the visible part of the volume, if it is not all: the rings are cut to it
 * @param spacing - metres from ring to ring; null for a round distance
 */
export function planRings(grid: PolarGrid, region: GridFrame | null, spacing: number | null): RingPlan {
  const reach = groundReach(grid) * (1 + beyondReach);
  const shown = boundsOf(region ?? grid);
  const extent: [number, number] = region ? distancesOf(shown) : [0, reach];
  const every = spacing ?? roundDistance(region ? longestEdge(shown) : reach);
  const first = Math.max(1, Math.ceil(extent[0] / every));
  const outermost = Math.floor(reach / every) * every;
  const count = Math.floor(Math.min(extent[1], reach) / every) - first + 1;
  return { spacing: every, first, count, outermost, extent, shown, isCut: region !== null };
}

/** Whether at least one ring is within the radar's reach, and at most `maxRings` are visible. */
export function ringsFit({ outermost, count }: RingPlan): boolean {
  return outermost !== 0 && count <= maxRings;
}

/** @param plan - must fit, see `ringsFit` */
export function buildRings({ spacing, first, count, outermost, shown, isCut }: RingPlan): Rings {
  const radii = Array.from({ length: Math.max(0, count) }, (_, i) => (first + i) * spacing);
  const north: Vector3[] = [
    [0, 0, 0],
    [0, outermost * 1.04, 0],
  ];
  return isCut ? ringsInside(radii, north, shown) : wholeRings(radii, north, shown);
}

/** Lines from the first ring to the last one, every 30 degrees except to the north. With them, rings look like a ground. */
export function buildSpokes({ spacing, first, outermost }: RingPlan): Vector3[][] {
  return Array.from({ length: 11 }, (_, i) => {
    const angle = ((i + 1) * Math.PI) / 6;
    return [first * spacing, outermost].map((radius): Vector3 => [
      radius * Math.sin(angle),
      radius * Math.cos(angle),
      0,
    ]);
  });
}

function wholeRings(radii: readonly number[], north: readonly Vector3[], shown: Rectangle): Rings {
  const [east, northward] = labelDirection(shown, radii.at(-1)!);
  return {
    lines: [...radii.map(circle), north],
    labels: [
      ...radii.map((radius): RingLabel => ({ radius, at: [radius * east, radius * northward, 0] })),
      { radius: null, at: [0, north[1][1] * 1.03, 0] },
    ],
  };
}

/** The parts of the rings that lie in a region. Each ring's text is halfway along its longest part. */
function ringsInside(radii: readonly number[], north: readonly Vector3[], shown: Rectangle): Rings {
  const lines: Vector3[][] = [];
  const labels: RingLabel[] = [];
  for (const radius of radii) {
    const parts = clipLine(circle(radius), shown);
    if (parts.length === 0) continue;
    lines.push(...parts);
    const longest = parts.reduce((max, part) => (part.length > max.length ? part : max));
    labels.push({ radius, at: longest[Math.floor(longest.length / 2)] });
  }
  for (const part of clipLine(north, shown)) {
    lines.push(part);
    labels.push({ radius: null, at: part[1] });
  }
  return { lines, labels };
}

/** The direction in which ring texts are placed: to the east or, for a radar that scans a sector, towards the middle of the volume. */
function labelDirection([x, y]: Rectangle, reach: number): readonly [number, number] {
  const middle = [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2] as const;
  const distance = Math.hypot(...middle);
  return distance < reach / 4 ? [1, 0] : [middle[0] / distance, middle[1] / distance];
}

function boundsOf(grid: GridFrame): Rectangle {
  const all = corners(grid);
  const extent = (axis: number): [number, number] => [
    Math.min(...all.map((p) => p[axis])),
    Math.max(...all.map((p) => p[axis])),
  ];
  return [extent(0), extent(1)];
}

/** Smallest and largest distance of a rectangle's points from the antenna. */
function distancesOf(rectangle: Rectangle): [number, number] {
  const nearest = rectangle.map(([from, to]) => Math.max(0, from, -to));
  const farthest = rectangle.map(([from, to]) => Math.max(-from, to));
  return [Math.hypot(...nearest), Math.hypot(...farthest)];
}

function longestEdge([x, y]: Rectangle): number {
  return Math.max(x[1] - x[0], y[1] - y[0]);
}

/** A distance of 1, 2 or 5 times a power of ten metres. */
function roundDistance(reach: number): number {
  const min = reach / maxAutomatic;
  const power = 10 ** Math.floor(Math.log10(min));
  return [1, 2, 5, 10].map((factor) => factor * power).find((distance) => distance >= min * (1 - 1e-9))!;
}

function circle(radius: number): Vector3[] {
  return Array.from({ length: ringCorners + 1 }, (_, i) => {
    const angle = (2 * Math.PI * (i % ringCorners)) / ringCorners;
    return [radius * Math.sin(angle), radius * Math.cos(angle), 0];
  });
}
