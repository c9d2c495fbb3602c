import { boundingSphere, unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import {
  add,
  identity,
  invertAffine,
  length,
  multiply,
  scale,
  subtract,
  transformDirection,
  transformPoint,
} from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';

/**
 * The rays of a picture in the unit cube of a grid, as functions that are linear in the pixel's normalised device
 * coordinates (x, y): point = p0 + x px + y py, direction = d0 + x dx + y dy. A ray's parameter t counts bounding
 * diameters of depth from the plane through the volume's centre (or, if the eye is close, a plane in front of the
 * eye), so that every number is of order one, however large, small or far the volume is. Float32 is then enough.
 */
export interface RaySetup {
  readonly point: readonly [Vector3, Vector3, Vector3];
  readonly direction: readonly [Vector3, Vector3, Vector3];
  /** t at the eye; rays start there at the earliest. -Infinity for a parallel projection. */
  readonly eyeT: number;
  /** Depth (world length in front of the eye) of t = 0. */
  readonly planeDepth: number;
  /** World length of one unit of t along the axis of view: the bounding diameter. */
  readonly diameter: number;
  /** Row-major 3 x 3: unit-cube direction to world direction in bounding diameters. */
  readonly unitToDiameters: readonly number[];
  /** Row-major 4 x 4: the grid's unit cube to that of the visible region; the identity if all is visible. */
  readonly unitToRegion: Matrix4;
  /** Left, bottom, right and top of the rectangle of the picture that can show the volume, in device coordinates. */
  readonly bounds: readonly [number, number, number, number];
}

/** Bounds that include the whole picture. */
export const wholePicture: RaySetup['bounds'] = [-1, -1, 1, 1];

/**
 * @param view - row-major world-to-eye matrix, rigid
 * @param projection - row-major, perspective or parallel, without off-axis terms in its last row
 * @param region - its bounds end the rays; null if only the grid's own bounds do
 * @returns null if the grid is singular: no ray can cross it
 */
export function setUpRays(
  grid: GridFrame,
  view: Matrix4,
  projection: Matrix4,
  region: GridFrame | null = null,
): RaySetup | null {
  const toWorld = unitToWorld(grid);
  const toRegion = region ? invertAffine(unitToWorld(region)) : null;
  const toUnit = invertAffine(toWorld);
  const eyeToWorld = invertAffine(view);
  if (!toUnit || !eyeToWorld) return null;
  const sphere = boundingSphere(grid);
  const diameter = 2 * sphere.radius;
  const perspective = projection[14] !== 0;
  const centerDepth = -transformPoint(view, sphere.center)[2];
  const planeDepth = perspective ? Math.max(centerDepth, sphere.radius * 0.1) : centerDepth;

  // A point at depth 1 (perspective) or anywhere (parallel) has eye coordinates linear in x and y.
  const reach = perspective ? planeDepth : 1;
  const pixelToEye = (x: number, y: number): Vector3 => [
    ((x + (perspective ? projection[2] : -projection[3])) / projection[0]) * reach,
    ((y + (perspective ? projection[6] : -projection[7])) / projection[5]) * reach,
    -planeDepth,
  ];
  const directionInEye = (p: Vector3): Vector3 => (perspective ? scale(p, diameter / planeDepth) : [0, 0, -diameter]);
  // Points are relative to the volume's centre, so that a far eye or a far world loses no digits.
  const centerInEye = transformPoint(view, sphere.center);
  const toUnitPoint = (p: Vector3): Vector3 =>
    add([0.5, 0.5, 0.5], transformDirection(toUnit, transformDirection(eyeToWorld, subtract(p, centerInEye))));
  const toUnitDirection = (d: Vector3): Vector3 => transformDirection(toUnit, transformDirection(eyeToWorld, d));

  const eyeToPixel = ([x, y, z]: Vector3): number[] =>
    perspective
      ? [(x * projection[0]) / -z - projection[2], (y * projection[5]) / -z - projection[6]]
      : [x * projection[0] + projection[3], y * projection[5] + projection[7]];
  const shown = region ? unitToWorld(region) : toWorld;
  const cornersInEye = unitCorners.map((corner) =>
    add(centerInEye, transformDirection(view, subtract(transformPoint(shown, corner), sphere.center))),
  );
  const isInFront = !perspective || cornersInEye.every(([, , z]) => -z > minDepth * diameter);

  const pixels = [pixelToEye(0, 0), pixelToEye(1, 0), pixelToEye(0, 1)];
  return {
    point: linearTerms(pixels.map(toUnitPoint)),
    direction: linearTerms(pixels.map(directionInEye).map(toUnitDirection)),
    eyeT: perspective ? -planeDepth / diameter : -Infinity,
    planeDepth,
    diameter,
    unitToDiameters: [0, 1, 2, 4, 5, 6, 8, 9, 10].map((i) => toWorld[i] / diameter),
    unitToRegion: toRegion ? multiply(toRegion, toWorld) : identity,
    bounds: isInFront ? boundsOf(cornersInEye.map(eyeToPixel)) : wholePicture,
  };
}

const unitCorners: readonly Vector3[] = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]);

/** Corners nearer to the eye than this share of the diameter may appear anywhere in the picture. */
const minDepth = 1e-3;

/** Margin around the bounds, because numbers are rounded to 32 bits. */
const margin = 1e-4;

function boundsOf(places: readonly number[][]): RaySetup['bounds'] {
  const clamp = (x: number): number => Math.min(1, Math.max(-1, x));
  const [x, y] = [0, 1].map((axis) => places.map((place) => place[axis]));
  if (![...x, ...y].every(Number.isFinite)) return wholePicture;
  return [
    clamp(Math.min(...x) - margin),
    clamp(Math.min(...y) - margin),
    clamp(Math.max(...x) + margin),
    clamp(Math.max(...y) + margin),
  ];
}

/** Pixels of a picture at equal distances: every `stride`th along each axis, from `first` on, across and up. */
export interface PixelLattice {
  readonly stride: number;
  readonly first: readonly [number, number];
  readonly width: number;
  readonly height: number;
}

/** The rays of a lattice's pixels, as if they were a separate picture. @param picture - size of the whole picture in pixels */
export function raysOfLattice(
  rays: RaySetup,
  picture: { width: number; height: number },
  lattice: PixelLattice,
): RaySetup {
  const { stride, first } = lattice;
  // The middle of pixel i of n is at (2 i + 1) / n - 1.
  const span = (pixels: number, all: number, begin: number): { scale: number; shift: number } => ({
    scale: (stride * pixels) / all,
    shift: (stride * (pixels - 1) + 2 * begin + 1) / all - 1,
  });
  const x = span(lattice.width, picture.width, first[0]);
  const y = span(lattice.height, picture.height, first[1]);
  const place = ([c, dx, dy]: RaySetup['point']): RaySetup['point'] => [
    add(c, add(scale(dx, x.shift), scale(dy, y.shift))),
    scale(dx, x.scale),
    scale(dy, y.scale),
  ];
  const [left, bottom, right, top] = rays.bounds;
  // Round to whole pixels: an edge across a pixel would be antialiased, and rasterizers move corners to a grid of their own.
  const snap = (edge: number, along: typeof x, pixels: number, round: (pixel: number) => number): number => {
    const pixel = round((((edge - along.shift) / along.scale + 1) / 2) * pixels);
    return (2 * Math.min(pixels, Math.max(0, pixel))) / pixels - 1;
  };
  const { width, height } = lattice;
  return {
    ...rays,
    point: place(rays.point),
    direction: place(rays.direction),
    bounds: [
      snap(left, x, width, Math.floor),
      snap(bottom, y, height, Math.floor),
      snap(right, x, width, Math.ceil),
      snap(top, y, height, Math.ceil),
    ],
  };
}

/** One ray: its origin, its direction, and the length of a unit of t on it. */
export interface Ray {
  readonly point: Vector3;
  readonly direction: Vector3;
  /** World length of one unit of t along this ray, in bounding diameters. */
  readonly lengthPerT: number;
}

/** The ray through normalised device coordinates x and y, each -1..1. */
export function rayThrough(setup: RaySetup, x: number, y: number): Ray {
  const at = ([c, dx, dy]: RaySetup['point']): Vector3 => add(c, add(scale(dx, x), scale(dy, y)));
  const direction = at(setup.direction);
  const m = setup.unitToDiameters;
  const world: Vector3 = [0, 3, 6].map(
    (r) => m[r] * direction[0] + m[r + 1] * direction[1] + m[r + 2] * direction[2],
  ) as unknown as Vector3;
  return { point: at(setup.point), direction, lengthPerT: length(world) };
}

/**
 * Where a ray enters and leaves the visible volume: the unit cube, and the region in it.
 * @returns [entry, exit] in t; entry > exit if the ray misses it
 */
export function crossVolume({ unitToRegion }: RaySetup, { point, direction }: Ray): [number, number] {
  const whole = intersectUnitCube(point, direction);
  if (unitToRegion === identity) return whole;
  const part = intersectUnitCube(transformPoint(unitToRegion, point), transformDirection(unitToRegion, direction));
  return [Math.max(whole[0], part[0]), Math.min(whole[1], part[1])];
}

/** Below this, a direction's component counts as parallel to its axis: the ray then crosses the slab at +-1e9, not at 1/0. */
const parallel = 1e-9;

/**
 * Where a line crosses the unit cube: the slab method.
 * @returns [entry, exit] in t; entry > exit if the line misses it
 * Source: Kay and Kajiya, *Ray Tracing Complex Scenes*, 1986
 */
export function intersectUnitCube(point: Vector3, direction: Vector3): [number, number] {
  let entry = -Infinity;
  let exit = Infinity;
  for (let axis = 0; axis < 3; axis++) {
    const d = Math.abs(direction[axis]) < parallel ? parallel : direction[axis];
    const t0 = -point[axis] / d;
    const t1 = (1 - point[axis]) / d;
    entry = Math.max(entry, Math.min(t0, t1));
    exit = Math.min(exit, Math.max(t0, t1));
  }
  return [entry, exit];
}

function linearTerms(values: Vector3[]): [Vector3, Vector3, Vector3] {
  return [values[0], subtract(values[1], values[0]), subtract(values[2], values[0])];
}
