import type { PixelLattice } from '../optics/rays/rays.ts';

/** Pixels of a picture: the first across and up, and how many. */
export interface PixelRectangle {
  readonly left: number;
  readonly bottom: number;
  readonly width: number;
  readonly height: number;
}

/** One pixel in so many is probed: with its step, half of it and a quarter that is a twelfth of the picture's own samples. */
const pixelsPerProbe = 85;

/** Probes of a picture, at least and at most: few tell nothing of one pixel in a thousand, many take long. */
const counts: readonly [number, number] = [1024, 4096];

/** So many probes tell the error of what they meet; where the volume covers few pixels more are placed, as those that miss it cost little. */
const enoughCovered = 256;

/** So many tell of one pixel in a thousand: with less, none of these is among them in more than one of twenty cases. Where things are opaque these are much of the error. */
const enoughOpaque = 3000;

/** More are not placed. */
const mostProbes = 2 ** 16;

/** How many times as many probes are wanted, if so many of all met something: 1 where they are enough. */
export function moreProbes(covered: number, all: number, isOpaque = false): number {
  return Math.max(1, Math.min((isOpaque ? enoughOpaque : enoughCovered) / Math.max(1, covered), mostProbes / all));
}

/** So few pixels are all probed where one of them may be much of the error. */
const allOf = 2 ** 14;

/** How much longer the second lattice's edges are: no distance is a multiple of both, so that no pattern hides from both. */
const longer = 3;

/** Where in its first cell each lattice begins, across and up: anywhere but at the same place. */
const begins: readonly (readonly [number, number])[] = [[0.31, 0.77], [0.83, 0.19]];

/**
 * The pixels by which a picture is probed, all in a rectangle: two lattices of different distances, or every pixel.
 * @param isOpaque - whether a single voxel may hide what is behind it: a ray that grazes it is much of a small picture's
 *   error, and a lattice seldom meets it
 * @param times - so many as usual, see `moreProbes`
 */
export function placeProbes({ left, bottom, width, height }: PixelRectangle, isOpaque: boolean, times = 1): PixelLattice[] {
  if (isOpaque && width * height <= allOf) return [{ stride: 1, first: [left, bottom], width, height }];
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

/** So few probes that met something may have met one thing of several: then all pixels are looked at. */
const fewCovered = 64;

/** Boxes of pixels that are probed one by one, at the most. */
const mostBoxes = 32;

/** Pixels along each side of the squares by which boxes are found; doubled until there are few enough. */
const leastSquare = 16;

/** Whether all pixels have to be looked at to find what there is to see. @param lattices - of `placeProbes` @param covered - of their probes, how many met something */
export function isWorthSearch(lattices: readonly PixelLattice[], covered: number): boolean {
  return covered < fewCovered && lattices.some(({ stride }) => stride > 1);
}

/**
 * Where few pixels show something, all of these are probed, or so many of those around them as there may be probes.
 * @param shown - pixels that show something, across and up
 */
export function placeAround(shown: readonly (readonly [x: number, y: number])[]): PixelLattice[] {
  let boxes: PixelRectangle[] = [];
  for (let square = leastSquare; square === leastSquare || boxes.length > mostBoxes; square *= 2) boxes = boxBySquares(shown, square);
  const area = boxes.reduce((sum, { width, height }) => sum + width * height, 0);
  const stride = Math.ceil(Math.sqrt(area / mostProbes));
  return boxes.map(({ left, bottom, width, height }) => ({ stride, first: [left, bottom], width: Math.ceil(width / stride), height: Math.ceil(height / stride) }));
}

/** The bounds of the pixels in each square of a picture that has some. */
function boxBySquares(pixels: readonly (readonly [number, number])[], square: number): PixelRectangle[] {
  const boxes = new Map<string, [left: number, bottom: number, right: number, top: number]>();
  for (const [x, y] of pixels) {
    const key = `${Math.floor(x / square)} ${Math.floor(y / square)}`;
    const [left, bottom, right, top] = boxes.get(key) ?? [x, y, x, y];
    boxes.set(key, [Math.min(left, x), Math.min(bottom, y), Math.max(right, x), Math.max(top, y)]);
  }
  return [...boxes.values()].map(([left, bottom, right, top]) => ({ left, bottom, width: right - left + 1, height: top - bottom + 1 }));
}
