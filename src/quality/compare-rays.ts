import type { PixelLattice } from '../optics/rays/rays.ts';
import type { PixelRectangle } from './place-probes.ts';

/** The result of a comparison: rays of a picture at rest as the GPU drew them, and the same rays in float64 on the processor. */
export interface PictureCheck {
  /** Number of rays that were compared. They are spread over the visible volume, at other places each time. */
  readonly rays: number;
  /**
   * Of these, rays at an edge: if they move by a thousandth of a pixel, or values are rounded differently in the last digit, they show
   * something else. `off` and `max` do not include them.
   */
  readonly edges: number;
  /** Number of the other rays that differ by more than 2/255 in a channel. */
  readonly off: number;
  /** Largest difference of a channel, in 1/255, without edges. */
  readonly max: number;
  /** Whether the GPU draws correctly: at most one ray in twenty is off. */
  readonly agrees: boolean;
}

/** Differences up to this are rounding, in 1/255. */
const tolerance = 2;

/** Up to this share of rays may be off although the GPU draws correctly. */
const forgiven = 1 / 20;

/** About this many rays are drawn by the GPU, so that some of them meet something. */
const drawnRays = 400;

/** Number of rays that are cast on the processor: of those that show something, and of those that do not. */
const castRays = { shown: 20, empty: 4 } as const;

/** Places the rays that the GPU draws for a check: evenly over a rectangle of pixels, from a random place on. @param random - 0..1 */
export function placeChecks({ left, bottom, width, height }: PixelRectangle, random: () => number): PixelLattice {
  const stride = Math.max(1, Math.round(Math.sqrt((width * height) / drawnRays)));
  const along = (pixels: number): { first: number; count: number } => {
    const first = Math.floor(random() * Math.min(stride, pixels));
    return { first, count: Math.floor((pixels - 1 - first) / stride) + 1 };
  };
  const [across, up] = [along(width), along(height)];
  return { stride, first: [left + across.first, bottom + up.first], width: across.count, height: up.count };
}

/**
 * Chooses the drawn rays that are cast on the processor: some that show something and some that do not, each spread over all of its kind.
 * @param picture - RGBA of the rays, premultiplied
 * @returns the numbers of the rays
 */
export function chooseChecks(picture: Float32Array, random: () => number): number[] {
  const kinds = { shown: [] as number[], empty: [] as number[] };
  for (let ray = 0; 4 * ray < picture.length; ray++) (picture[4 * ray + 3] > 0 ? kinds.shown : kinds.empty).push(ray);
  return (['shown', 'empty'] as const).flatMap((kind) => {
    const all = kinds[kind];
    const count = Math.min(castRays[kind], all.length);
    const first = random();
    return Array.from({ length: count }, (_, i) => all[Math.floor(((i + first) * all.length) / count)]);
  });
}

/** A ray, or one that is almost the same. */
export interface RayVariant {
  /** The ray is moved by this, in pixels. */
  readonly shift: readonly [x: number, y: number];
  /** All values get other last digits: each number stands for one way to change them; 0 changes nothing. */
  readonly digits: number;
}

/** The unchanged ray. */
const itself: RayVariant = { shift: [0, 0], digits: 0 };

/** The ray moved by a thousandth of a pixel to each side, and eight ways to round values. */
const variants: readonly RayVariant[] = [
  ...(
    [
      [1e-3, 0],
      [-1e-3, 0],
      [0, 1e-3],
      [0, -1e-3],
    ] as const
  ).map((shift) => ({ shift, digits: 0 })),
  ...Array.from({ length: 8 }, (_, i) => ({ ...itself, digits: i + 1 })),
];

/** How one ray compares: its largest difference, in 1/255, and whether it lies at an edge. */
export interface RayDifference {
  readonly apart: number;
  readonly isEdge: boolean;
}

/**
 * Compares one ray.
 * @param drawn - RGBA, premultiplied, 0..1, by the GPU
 * @param cast - the ray in float64, or one of its variants
 */
export function compareRay(drawn: ArrayLike<number>, cast: (variant: RayVariant) => readonly number[]): RayDifference {
  const own = cast(itself);
  const apart = 255 * differ(own, drawn);
  // An edge cannot explain that a GPU draws NaN.
  if (apart <= tolerance || Number.isNaN(apart))
    return { apart: Number.isNaN(apart) ? Infinity : apart, isEdge: false };
  const isEdge = variants.some((variant) => 255 * differ(cast(variant), own) > tolerance / 2);
  return { apart, isEdge };
}

function differ(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.max(...[0, 1, 2, 3].map((c) => Math.abs(a[c] - b[c])));
}

export function sumUpChecks(differences: readonly RayDifference[]): PictureCheck {
  const others = differences.filter(({ isEdge }) => !isEdge);
  const off = others.filter(({ apart }) => apart > tolerance).length;
  return {
    rays: differences.length,
    edges: differences.length - others.length,
    off,
    max: others.reduce((max, { apart }) => Math.max(max, apart), 0),
    agrees: off <= forgiven * differences.length,
  };
}
