import { add, cross, dot, normalize, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';

/** The direction of a slice: one of a patient's, or any. */
export const sliceTypes = ['axial', 'coronal', 'sagittal', 'oblique'] as const;
export type SliceType = (typeof sliceTypes)[number];

/**
 * Directions of a slice's picture, unit vectors of the world that are orthogonal to each other. A point of the world is
 * `u` to the right, `v` up and `d` along the normal: its dot products with them, world units.
 */
export interface SlicePlane {
  readonly right: Vector3;
  readonly up: Vector3;
  /** Slices are counted along it. It is the world axis that increases, so it does not always point towards the viewer. */
  readonly normal: Vector3;
}

/** A point in a plane's coordinates. */
export interface PlanePlace {
  readonly u: number;
  readonly v: number;
  readonly d: number;
}

/**
 * As radiologists hang them: axial from the feet, coronal from the front, sagittal from the patient's left. So the
 * patient's left is on the right of axial and coronal pictures, and in sagittal ones the patient looks to the left.
 * World: x right, y anterior, z superior.
 */
const planes: Readonly<Record<Exclude<SliceType, 'oblique'>, SlicePlane>> = {
  axial: { right: [-1, 0, 0], up: [0, 1, 0], normal: [0, 0, 1] },
  coronal: { right: [-1, 0, 0], up: [0, 0, 1], normal: [0, 1, 0] },
  sagittal: { right: [0, -1, 0], up: [0, 0, 1], normal: [1, 0, 0] },
};

/**
 * A normal that is nearer than this to the vertical has no up direction of its own: then the front is up, as in axial
 * slices.
 */
const steep = Math.cos((20 * Math.PI) / 180);

/**
 * The directions of a slice.
 * @param normal - of an oblique one, of any length except zero; the direction in which a person looks
 */
export function planeOf(type: SliceType, normal: Vector3 = [0, 0, 1]): SlicePlane {
  if (type !== 'oblique') return planes[type];
  const along = normalize(scale(normal, 1 / Math.max(...normal.map(Math.abs)))); // Scaled first, because its square may overflow.
  const upward: Vector3 = Math.abs(along[2]) > steep ? [0, 1, 0] : [0, 0, 1];
  const up = normalize(add(upward, scale(along, -dot(upward, along))));
  return { right: normalize(cross(along, up)), up, normal: along };
}

export function toPlane({ right, up, normal }: SlicePlane, place: Vector3): PlanePlace {
  return { u: dot(right, place), v: dot(up, place), d: dot(normal, place) };
}

export function toWorld({ right, up, normal }: SlicePlane, { u, v, d }: PlanePlace): Vector3 {
  return add(add(scale(right, u), scale(up, v)), scale(normal, d));
}

/** A component of a direction that is less than this gets no letter. */
const minPart = 0.2;

/**
 * The letters of the patient's sides to which a direction points, the largest component first: `L`, `AR`, `SPL`.
 * Source: DICOM PS3.3 C.7.6.1.1.1, with S and I for its H and F
 */
export function sideLetters(direction: Vector3): string {
  const letters = [
    ['R', 'L'],
    ['A', 'P'],
    ['S', 'I'],
  ];
  const parts = direction
    .map((part, axis) => ({ size: Math.abs(part), letter: letters[axis][part > 0 ? 0 : 1] }))
    .filter(({ size }) => size >= minPart);
  parts.sort((a, b) => b.size - a.size);
  return parts.map(({ letter }) => letter).join('');
}
