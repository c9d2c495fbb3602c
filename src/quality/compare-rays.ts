import type { PixelLattice } from '../optics/rays/rays.ts';
import type { PixelRectangle } from './place-probes.ts';

/** Rays of a picture at rest, as the GPU drew them and in float64 on the processor: how far they are apart. */
export interface PictureCheck {
  /** How many were compared, spread over what can be seen, each time elsewhere. */
  readonly rays: number;
  /** Of these, rays at an edge: moved by a thousandth of a pixel, or with values rounded in the last digit, they show something else. They are not counted in `off` and `max`. */
  readonly edges: number;
  /** Of the others, those that differ by more than 2/255 in a channel. */
  readonly off: number;
  /** Largest difference of a channel, 1/255, edges left out. */
  readonly max: number;
  /** Whether the GPU draws as it should: at most one ray in twenty is off. */
  readonly agrees: boolean;
}

/** Differences that are rounding, 1/255. */
const tolerance = 2;

/** Of rays that are off, the share that says nothing of the GPU. */
const forgiven = 1 / 20;

/** Rays that the GPU draws so that some of them meet something. */
const drawnRays = 400;

/** Rays that are cast on the processor, where they meet something and where they do not. */
const castRays = { shown: 20, empty: 4 } as const;

/** The rays that the GPU draws for a check: evenly over a rectangle of pixels, beginning anywhere. @param random - 0..1 */
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
 * Which of the drawn rays are cast on the processor: some of those that show something, some of the others, each spread over all of its kind.
 * @param picture - RGBA of the rays, premultiplied
 * @returns their numbers
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

/** A ray, or one that is all but the same. */
export interface RayVariant {
  /** It runs so many pixels beside. */
  readonly shift: readonly [x: number, y: number];
  /** Other last digits of all values: one way for each number, none for 0. */
  readonly digits: number;
}

/** The ray itself. */
const itself: RayVariant = { shift: [0, 0], digits: 0 };

/** A thousandth of a pixel to each side, and eight ways to round values. */
const variants: readonly RayVariant[] = [
  ...([[1e-3, 0], [-1e-3, 0], [0, 1e-3], [0, -1e-3]] as const).map((shift) => ({ shift, digits: 0 })),
  ...Array.from({ length: 8 }, (_, i) => ({ ...itself, digits: i + 1 })),
];

/** How one ray compares: its largest difference, 1/255, and whether it hangs by a thread. */
export interface RayDifference {
  readonly apart: number;
  readonly isEdge: boolean;
}

/**
 * Compare one ray.
 * @param drawn - RGBA, premultiplied, 0..1, by the GPU
 * @param cast - the ray in float64, or one of its variants
 */
export function compareRay(drawn: ArrayLike<number>, cast: (variant: RayVariant) => readonly number[]): RayDifference {
  const own = cast(itself);
  const apart = 255 * differ(own, drawn);
  // That a GPU draws no number at all is nothing that an edge explains.
  if (apart <= tolerance || Number.isNaN(apart)) return { apart: Number.isNaN(apart) ? Infinity : apart, isEdge: false };
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
    max: others.reduce((most, { apart }) => Math.max(most, apart), 0),
    agrees: off <= forgiven * differences.length,
  };
}
