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

/** The part of a plane that is nearer to the eye than this is cut off. In bounding diameters of depth. */
const nearest = 1e-3;

/**
 * The edges of planes as they appear in a picture. The picture jumps at these edges; if a plane is seen from its side, only its edges
 * are visible.
 * @param planes - each with the half-spaces that limit it, in addition to the bounds of the visible volume
 */
export function outlinesOf(
  planes: readonly (Plane & { readonly within?: readonly HalfSpace[] })[],
  rays: RaySetup,
): Outline[] {
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
 * @param middle - of the rectangle, in device coordinates
 * Twin: shaders/chunks/attachments/outlines.glsl
 */
export function meetsOutline(
  [fromX, fromY, toX, toY]: Outline,
  middle: readonly [number, number],
  reach: readonly [number, number],
): boolean {
  const [ax, ay, bx, by] = [fromX - middle[0], fromY - middle[1], toX - middle[0], toY - middle[1]];
  if (
    Math.min(ax, bx) > reach[0] ||
    Math.max(ax, bx) < -reach[0] ||
    Math.min(ay, by) > reach[1] ||
    Math.max(ay, by) < -reach[1]
  )
    return false;
  return Math.abs(ax * by - ay * bx) <= Math.abs(bx - ax) * reach[1] + Math.abs(by - ay) * reach[0];
}

/** The unit cube of the space that a matrix maps to, as half-spaces. */
function cube(m: Matrix4): HalfSpace[] {
  return [0, 1, 2].flatMap((axis): HalfSpace[] => {
    const normal: Vector3 = [m[4 * axis], m[4 * axis + 1], m[4 * axis + 2]];
    return [
      { normal, offset: -m[4 * axis + 3] },
      { normal: scale(normal, -1), offset: m[4 * axis + 3] - 1 },
    ];
  });
}

/** A square of the plane that is larger than the part that may lie in the unit cube. */
function largeSquare({ normal, offset }: Plane): Vector3[] {
  const along = normal.map(Math.abs);
  const axis = along.indexOf(Math.max(...along));
  const others = [(axis + 1) % 3, (axis + 2) % 3];
  return [
    [-1, -1],
    [2, -1],
    [2, 2],
    [-1, 2],
  ].map((place) => {
    const corner: [number, number, number] = [0, 0, 0];
    others.forEach((other, i) => (corner[other] = place[i]));
    corner[axis] = (offset - dot(normal, corner)) / normal[axis];
    return corner;
  });
}

/** The part of a convex polygon that lies in a half-space. Source: Sutherland and Hodgman 1974 */
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

/** Maps places of the unit cube to the picture. */
interface Projector {
  place(p: Vector3): readonly [x: number, y: number];
  /** The half-space that is farther from the eye than a depth, in bounding diameters. */
  before(depth: number): HalfSpace;
}

/** The inverse of the rays. The picture is spanned by their directions or, if all rays are parallel, by their points. */
function projector({ point: [p0, px, py], direction: [d0, dx, dy], eyeT }: RaySetup): Projector {
  const isParallel = eyeT === -Infinity;
  const eye = isParallel ? p0 : (p0.map((x, axis) => x + eyeT * d0[axis]) as unknown as Vector3);
  const [across, up] = isParallel ? [px, py] : [dx, dy];
  const m = invertAffine(
    [0, 1, 2].flatMap((axis) => [across[axis], up[axis], d0[axis], eye[axis]]).concat(0, 0, 0, 1),
  )!; // Rays are not all in a plane.
  const row = (r: number, p: Vector3): number =>
    m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
  return {
    place: (p) => (isParallel ? [row(0, p), row(1, p)] : [row(0, p) / row(2, p), row(1, p) / row(2, p)]),
    before: (depth) =>
      isParallel ? { normal: [0, 0, 0], offset: -1 } : { normal: [m[8], m[9], m[10]], offset: depth - m[11] },
  };
}
