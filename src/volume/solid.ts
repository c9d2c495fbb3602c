import { add, dot, length, subtract } from './matrix.ts';
import type { Vector3 } from './matrix.ts';

/** A part of the world that is measured. Its surface belongs to it. */
export type Solid =
  | { readonly kind: 'box'; readonly low: Vector3; readonly high: Vector3 }
  | { readonly kind: 'sphere'; readonly center: Vector3; readonly radius: number };

/** The solid that two points set by a person define: opposite corners, or a centre and a point of the surface. */
export function solidOf(kind: Solid['kind'], [from, to]: readonly Vector3[]): Solid {
  if (kind === 'sphere') return { kind, center: from, radius: length(subtract(to, from)) };
  const [low, high] = [Math.min, Math.max].map(
    (choose) => from.map((x, axis) => choose(x, to[axis])) as unknown as Vector3,
  );
  return { kind, low, high };
}

/** Two opposite corners of the box around it. */
export function boundsOf(solid: Solid): readonly [low: Vector3, high: Vector3] {
  if (solid.kind === 'box') return [solid.low, solid.high];
  const { center, radius } = solid;
  return [subtract(center, [radius, radius, radius]), add(center, [radius, radius, radius])];
}

export function contains(solid: Solid, [x, y, z]: Vector3): boolean {
  if (solid.kind === 'box') {
    const { low, high } = solid;
    return x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1] && z >= low[2] && z <= high[2];
  }
  const { center, radius } = solid;
  return (x - center[0]) ** 2 + (y - center[1]) ** 2 + (z - center[2]) ** 2 <= radius * radius;
}

/** The part of a line inside a solid: steps from its first point; null if it does not enter. Up to rounding. */
export function cutLine(solid: Solid, from: Vector3, step: Vector3): readonly [first: number, last: number] | null {
  return solid.kind === 'box' ? cutBox(solid, from, step) : cutSphere(solid, from, step);
}

function cutBox(
  { low, high }: Extract<Solid, { kind: 'box' }>,
  from: Vector3,
  step: Vector3,
): readonly [number, number] | null {
  let [first, last] = [-Infinity, Infinity];
  for (let axis = 0; axis < 3; axis++) {
    const ends = [low[axis] - from[axis], high[axis] - from[axis]];
    if (step[axis] === 0) {
      if (ends[0] > 0 || ends[1] < 0) return null;
      continue;
    }
    const [one, other] = [ends[0] / step[axis], ends[1] / step[axis]];
    first = Math.max(first, Math.min(one, other));
    last = Math.min(last, Math.max(one, other));
  }
  return first <= last + rounding ? [first, last] : null;
}

/** Tolerance, so that a line that only touches is not lost. */
const rounding = 1e-6;

function cutSphere(
  { center, radius }: Extract<Solid, { kind: 'sphere' }>,
  from: Vector3,
  step: Vector3,
): readonly [number, number] | null {
  const to = subtract(center, from);
  const [a, b] = [dot(step, step), dot(step, to)];
  const nearest = b / a;
  const aside = subtract(to, [step[0] * nearest, step[1] * nearest, step[2] * nearest]);
  const left = (radius * radius - dot(aside, aside)) / a;
  if (!(left >= -rounding)) return null;
  const half = Math.sqrt(Math.max(0, left));
  return [nearest - half, nearest + half];
}
