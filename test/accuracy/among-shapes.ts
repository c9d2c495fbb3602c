// Shapes of an author among small things, and where rays meet them in float64.
import { add, dot, subtract } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';

/** A shape of one colour, without light. */
export interface LoneShape {
  readonly kind: 'ball' | 'box';
  readonly center: Vector3;
  /** Edges of a box; of a ball its radius, three times. World lengths. */
  readonly size: Vector3;
  /** Of a box, around the world's z, radians. */
  readonly turn: number;
  readonly opacity: number;
}

/** Of all shapes, as x3dom draws them without light. */
export const shapeColor: Vector3 = [0, 0, 1];

/** The same as X3D. */
export function writeShape({ kind, center, size, turn, opacity }: LoneShape): string {
  const appearance = `<material diffuseColor="0 0 0" specularColor="0 0 0" emissiveColor="${shapeColor.join(' ')}" transparency="${1 - opacity}"></material>`;
  const geometry =
    kind === 'ball'
      ? `<sphere radius="${size[0]}" subdivision="96 96"></sphere>`
      : `<box size="${size.join(' ')}"></box>`;
  return `<transform translation="${center.join(' ')}" rotation="0 0 1 ${turn}"><shape><appearance>${appearance}</appearance>${geometry}</shape></transform>`;
}

/** How far along a ray it meets a shape, as a multiple of the direction; Infinity where it misses. */
export function meetShape(shape: LoneShape, origin: Vector3, direction: Vector3): number {
  const from = turnBack(subtract(origin, shape.center), shape.turn);
  const along = turnBack(direction, shape.turn);
  return shape.kind === 'ball' ? meetBall(from, along, shape.size[0]) : meetSides(from, along, shape.size);
}

function meetBall(from: Vector3, along: Vector3, radius: number): number {
  const [a, b, c] = [dot(along, along), dot(from, along), dot(from, from) - radius ** 2];
  const inner = b * b - a * c;
  return inner < 0 ? Infinity : (-b - Math.sqrt(inner)) / a;
}

function meetSides(from: Vector3, along: Vector3, size: Vector3): number {
  const ends = size.map((edge, axis) => [-0.5, 0.5].map((side) => (side * edge - from[axis]) / along[axis]));
  const entry = Math.max(...ends.map((both) => Math.min(...both)));
  const exit = Math.min(...ends.map((both) => Math.max(...both)));
  return entry < exit ? entry : Infinity;
}

function turnBack([x, y, z]: Vector3, turn: number): Vector3 {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return [c * x + s * y, c * y - s * x, z];
}

/** Brings a place onto a surface. */
export type Snap = (place: Vector3) => Vector3;

/** @param normal - of any length but zero @param at - normal . place */
export function ontoPlane(normal: Vector3, at: number): Snap {
  return (place) => {
    const by = (at - dot(normal, place)) / dot(normal, normal);
    return add(place, normal.map((x) => x * by) as unknown as Vector3);
  };
}

/** A shape's surface: a ball's, or the larger two faces of a box. */
export function ontoShape({ kind, center, size, turn }: LoneShape): Snap[] {
  if (kind === 'ball') {
    return [
      (place) => {
        const way = subtract(place, center);
        return add(center, way.map((x) => (x * size[0]) / Math.hypot(...way)) as unknown as Vector3);
      },
    ];
  }
  const axis = size.indexOf(Math.min(...size));
  const normal = turnBack([0, 1, 2].map((n) => Number(n === axis)) as unknown as Vector3, -turn);
  return [-0.5, 0.5].map((side) => ontoPlane(normal, dot(normal, center) + side * size[axis]));
}

/** The twelve edges of a box, each as long as it is. */
export function alongEdges({ center, size, turn }: LoneShape): Snap[] {
  return Array.from({ length: 12 }, (_, edge): Snap => (place) => {
    const along = edge % 3;
    const local = turnBack(subtract(place, center), turn).map((x, axis) => {
      const half = size[axis] / 2;
      return axis === along
        ? Math.min(half, Math.max(-half, x))
        : half * ((Math.floor(edge / 3) >> Number(axis === (along + 1) % 3)) & 1 ? 1 : -1);
    }) as unknown as Vector3;
    return add(center, turnBack(local, -turn));
  });
}
