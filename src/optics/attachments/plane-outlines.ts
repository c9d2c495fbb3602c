import { dot, identity, invertAffine, scale } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { RaySetup } from '../rays/rays.ts';

/** The places p of the grid's unit cube with normal . p = offset. */
export interface Plane {
  readonly normal: Vector3;
  readonly offset: number;
}

/** The places of the unit cube with normal . p >= offset. */
export type HalfSpace = Plane;

/** A straight edge in a picture: device coordinates of its ends. */
export type Outline = readonly [fromX: number, fromY: number, toX: number, toY: number];

/** A plane is cut where it comes nearer to the eye than this, in bounding diameters of depth. */
const nearest = 1e-3;

/**
 * The edges of planes as a picture shows them: a picture jumps there, and where a plane is seen from its side they are all
 * that is seen of it.
 * @param planes - each with what it ends at, beside the bounds of what is shown
 */
export function outlinesOf(planes: readonly (Plane & { readonly within?: readonly HalfSpace[] })[], rays: RaySetup): Outline[] {
  const project = projector(rays);
  const bounds = [...cube(identity), ...(rays.unitToRegion === identity ? [] : cube(rays.unitToRegion))];
  return planes.flatMap((plane) => {
    const ends = [...bounds, ...(plane.within ?? []), project.before(nearest)];
    const corners = ends.reduce((polygon, end) => clip(polygon, end), largeSquare(plane)).map(project.place);
    return corners.map((corner, i): Outline => [...corner, ...corners[(i + 1) % corners.length]]);
  });
}

/**
 * Whether an edge runs through a rectangle, by its separating axes.
 * @param middle - and half its sides, device coordinates
 * Twin: shaders/chunks/attachments/outlines.glsl
 */
export function meetsOutline([fromX, fromY, toX, toY]: Outline, middle: readonly [number, number], reach: readonly [number, number]): boolean {
  const [ax, ay, bx, by] = [fromX - middle[0], fromY - middle[1], toX - middle[0], toY - middle[1]];
  if (Math.min(ax, bx) > reach[0] || Math.max(ax, bx) < -reach[0] || Math.min(ay, by) > reach[1] || Math.max(ay, by) < -reach[1]) return false;
  return Math.abs(ax * by - ay * bx) <= Math.abs(bx - ax) * reach[1] + Math.abs(by - ay) * reach[0];
}

/** The unit cube of what a matrix leads to. */
function cube(m: Matrix4): HalfSpace[] {
  return [0, 1, 2].flatMap((axis): HalfSpace[] => {
    const normal: Vector3 = [m[4 * axis], m[4 * axis + 1], m[4 * axis + 2]];
    return [{ normal, offset: -m[4 * axis + 3] }, { normal: scale(normal, -1), offset: m[4 * axis + 3] - 1 }];
  });
}

/** Of a plane what may lie in the unit cube, and more. */
function largeSquare({ normal, offset }: Plane): Vector3[] {
  const along = normal.map(Math.abs);
  const axis = along.indexOf(Math.max(...along));
  const others = [(axis + 1) % 3, (axis + 2) % 3];
  return [[-1, -1], [2, -1], [2, 2], [-1, 2]].map((place) => {
    const corner: [number, number, number] = [0, 0, 0];
    others.forEach((other, i) => (corner[other] = place[i]));
    corner[axis] = (offset - dot(normal, corner)) / normal[axis];
    return corner;
  });
}

/** What of a convex polygon is in a half-space. Source: Sutherland and Hodgman 1974 */
function clip(polygon: readonly Vector3[], { normal, offset }: HalfSpace): Vector3[] {
  return polygon.flatMap((corner, i) => {
    const next = polygon[(i + 1) % polygon.length];
    const [here, there] = [dot(normal, corner) - offset, dot(normal, next) - offset];
    const kept = here >= 0 ? [corner] : [];
    if (here >= 0 === there >= 0) return kept;
    const share = here / (here - there);
    return [...kept, corner.map((x, axis) => x + share * (next[axis] - x)) as unknown as Vector3];
  });
}

/** Where places of the unit cube are in the picture. */
interface Projector {
  place(p: Vector3): readonly [x: number, y: number];
  /** What is farther from the eye than a depth, in bounding diameters. */
  before(depth: number): HalfSpace;
}

/** The inverse of rays: their directions, or points where all are parallel, span the picture. */
function projector({ point: [p0, px, py], direction: [d0, dx, dy], eyeT }: RaySetup): Projector {
  const isParallel = eyeT === -Infinity;
  const eye = isParallel ? p0 : (p0.map((x, axis) => x + eyeT * d0[axis]) as unknown as Vector3);
  const [across, up] = isParallel ? [px, py] : [dx, dy];
  const m = invertAffine([0, 1, 2].flatMap((axis) => [across[axis], up[axis], d0[axis], eye[axis]]).concat(0, 0, 0, 1))!; // Rays are not all in a plane.
  const row = (r: number, p: Vector3): number => m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
  return {
    place: (p) => (isParallel ? [row(0, p), row(1, p)] : [row(0, p) / row(2, p), row(1, p) / row(2, p)]),
    before: (depth) => (isParallel ? { normal: [0, 0, 0], offset: -1 } : { normal: [m[8], m[9], m[10]], offset: depth - m[11] }),
  };
}
