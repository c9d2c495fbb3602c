import type { Vector3 } from '../volume/matrix.ts';

/** Smallest and largest x, and the same for y. */
export type Rectangle = readonly [x: readonly [number, number], y: readonly [number, number]];

/** The parts of a polyline that lie above a rectangle, in the polyline's order. */
export function clipLine(line: readonly Vector3[], rectangle: Rectangle): Vector3[][] {
  const parts: Vector3[][] = [];
  let isOpen = false;
  for (let i = 1; i < line.length; i++) {
    const span = spanInside(line[i - 1], line[i], rectangle);
    if (span) {
      const [begin, end] = span.map((t) => between(line[i - 1], line[i], t));
      if (!isOpen || span[0] > 0) parts.push([begin]);
      parts.at(-1)!.push(end);
    }
    isOpen = span !== null && span[1] === 1;
  }
  return parts;
}

/** Where a straight line enters and leaves a rectangle, as shares of the line: J. Liang and B. Barsky, 1984. Null if it stays outside. */
function spanInside(from: Vector3, to: Vector3, rectangle: Rectangle): [number, number] | null {
  let [enter, leave] = [0, 1];
  for (const axis of [0, 1] as const) {
    const way = to[axis] - from[axis];
    const ends = rectangle[axis].map((end) => end - from[axis]);
    if (way === 0 && (ends[0] > 0 || ends[1] < 0)) return null;
    if (way === 0) continue;
    enter = Math.max(enter, Math.min(ends[0] / way, ends[1] / way));
    leave = Math.min(leave, Math.max(ends[0] / way, ends[1] / way));
  }
  return enter < leave ? [enter, leave] : null;
}

function between(from: Vector3, to: Vector3, t: number): Vector3 {
  return [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), from[2] + t * (to[2] - from[2])];
}
