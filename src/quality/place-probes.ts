import type { PixelLattice } from '../optics/rays/rays.ts';

/** Pixels of a picture: the first one across and up, and how many there are. */
export interface PixelRectangle {
  readonly left: number;
  readonly bottom: number;
  readonly width: number;
  readonly height: number;
}

/** One pixel in this many is probed. With its own step, half of it and a quarter, a probe takes a twelfth of the picture's own samples. */
const pixelsPerProbe = 85;

/** Smallest and largest number of probes of a picture: with few, nothing is known of one pixel in a thousand; many take long. */
const counts: readonly [number, number] = [1024, 4096];

/**
 * This many covered probes give the error of what they meet. If the volume covers few pixels, more probes are placed: those that miss it
 * cost little.
 */
const enoughCovered = 256;

/**
 * This many covered probes include one pixel in a thousand: with fewer, they miss all such pixels in more than one of twenty cases. If
 * matter is opaque, these pixels are much of the error.
 */
const enoughRare = 3000;

/** At most this many probes are placed. */
const maxProbes = 2 ** 16;

/** The factor by which the number of probes should grow, if so many of all met something; 1 if they are enough. */
export function moreProbes(covered: number, all: number, hasRare = false): number {
  return Math.max(1, Math.min((hasRare ? enoughRare : enoughCovered) / Math.max(1, covered), maxProbes / all));
}

/** A picture with at most this many pixels is probed at all of them if one may be much of the error. */
const allOf = 2 ** 14;

/** The second lattice's cells are longer by this many pixels. So no distance is a multiple of both, and no pattern is missed by both. */
const longer = 3;

/** Where in its first cell each lattice begins, across and up: any two different places. */
const begins: readonly (readonly [number, number])[] = [
  [0.31, 0.77],
  [0.83, 0.19],
];

/**
 * The pixels at which a picture is probed, all in a rectangle: two lattices with different distances, or every pixel.
 * @param hasRare - whether a few pixels may be much of the error: where a single voxel may hide what is behind it, a ray that grazes it is much of a small picture's
 *   error, and a lattice seldom meets it
 * @param times - factor of the usual number, see `moreProbes`
 */
export function placeProbes(
  { left, bottom, width, height }: PixelRectangle,
  hasRare: boolean,
  times = 1,
): PixelLattice[] {
  if (hasRare && width * height <= allOf) return [{ stride: 1, first: [left, bottom], width, height }];
  const count = times * Math.min(counts[1], Math.max(counts[0], (width * height) / pixelsPerProbe));
  const even = Math.sqrt((begins.length * width * height) / count) - longer / 2;
  const stride = times > 1 ? Math.ceil(even) : Math.round(even);
  if (stride < 2) return [{ stride: 1, first: [left, bottom], width, height }];
  return begins.map(([x, y], i) => {
    const distance = stride + longer * i;
    const along = (pixels: number, begin: number): { first: number; count: number } => {
      const first = Math.min(pixels - 1, Math.floor(begin * distance));
      return { first, count: Math.floor((pixels - 1 - first) / distance) + 1 };
    };
    const [across, up] = [along(width, x), along(height, y)];
    return { stride: distance, first: [left + across.first, bottom + up.first], width: across.count, height: up.count };
  });
}

/** If fewer probes than this met something, they may have met only one of several things. Then all pixels are tested. */
const fewCovered = 64;

/** The largest number of boxes of pixels that are probed one by one. */
const maxBoxes = 32;

/** Side in pixels of the squares by which boxes are found. It is doubled until there are few enough boxes. */
const minSquare = 16;

/**
 * Whether all pixels must be tested to find what is visible.
 * @param lattices - from `placeProbes`
 * @param covered - number of their probes that met something
 */
export function isWorthSearch(lattices: readonly PixelLattice[], covered: number): boolean {
  return covered < fewCovered && lattices.some(({ stride }) => stride > 1);
}

/**
 * Places probes at all visible pixels if there are few, or at as many of the pixels around them as the limit allows.
 * @param shown - pixels that show something, across and up
 */
export function placeAround(shown: readonly (readonly [x: number, y: number])[]): PixelLattice[] {
  let boxes: PixelRectangle[] = [];
  for (let square = minSquare; square === minSquare || boxes.length > maxBoxes; square *= 2)
    boxes = boxBySquares(shown, square);
  const area = boxes.reduce((sum, { width, height }) => sum + width * height, 0);
  const stride = Math.ceil(Math.sqrt(area / maxProbes));
  return boxes.map(({ left, bottom, width, height }) => ({
    stride,
    first: [left, bottom],
    width: Math.ceil(width / stride),
    height: Math.ceil(height / stride),
  }));
}

/** The bounds of the visible pixels in each square of a picture that has some. */
function boxBySquares(pixels: readonly (readonly [number, number])[], square: number): PixelRectangle[] {
  const boxes = new Map<string, [left: number, bottom: number, right: number, top: number]>();
  for (const [x, y] of pixels) {
    const key = `${Math.floor(x / square)} ${Math.floor(y / square)}`;
    const [left, bottom, right, top] = boxes.get(key) ?? [x, y, x, y];
    boxes.set(key, [Math.min(left, x), Math.min(bottom, y), Math.max(right, x), Math.max(top, y)]);
  }
  return [...boxes.values()].map(([left, bottom, right, top]) => ({
    left,
    bottom,
    width: right - left + 1,
    height: top - bottom + 1,
  }));
}
