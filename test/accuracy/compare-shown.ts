// How far a shown picture is from full rays, and which small things are left of them.
import { ErrorSum } from '../helpers/covered-error.ts';
import type { CoveredError } from '../helpers/covered-error.ts';

/**
 * Covered is a pixel that either picture does not leave empty. Where full rays are not sure of a pixel, as at the edge of what
 * is opaque, the nearer ones count.
 * @param shown - bytes @param fulls - floats of the same pixels, 0..1: full rays, and such with other steps
 */
export function measureTrueError(
  shown: Uint8Array,
  ...fulls: readonly [Float32Array, ...Float32Array[]]
): CoveredError {
  const sum = new ErrorSum(4);
  for (let i = 0; i < shown.length; i += 4) {
    if (shown[i + 3] === 0 && Math.round(fulls[0][i + 3] * 255) === 0) continue;
    sum.add(fulls.map((full) => comparePixel(shown, full, i)).reduce((a, b) => (b.max < a.max ? b : a)));
  }
  return sum.result();
}

/** The worst channel of a pixel, and the sum of all of its squares, 1/255. */
function comparePixel(shown: Uint8Array, full: Float32Array, at: number): { max: number; squares: number } {
  let [max, squares] = [0, 0];
  for (let c = at; c < at + 4; c++) {
    const off = Math.abs(shown[c] - full[c] * 255);
    squares += off ** 2;
    max = Math.max(max, off);
  }
  return { max, squares };
}

/** Three square pictures of a view, bottom row first. */
export interface ComparedPictures {
  /** 0..255. */
  readonly shown: ArrayLike<number>;
  /** 0..1. */
  readonly full: Float32Array;
  /** Of the scene without its small things, 0..1. */
  readonly bare: Float32Array;
  readonly size: number;
}

/** What is left of a small thing. */
export interface KeptThing {
  /** In full rays, 1/255. */
  readonly contrast: number;
  /** Share of the contrast that the shown picture has. */
  readonly kept: number;
}

/** Of a thing the channels count that have this share of its strongest contrast. */
const strong = 0.75;

/**
 * A thing's contrast is what it adds to or takes from the picture without it. It is looked for around a pixel, where full
 * rays show it strongest, in all channels with about as much; the kept share is that of the least squares over these.
 * @param around - where it is expected, pixels from the left and from the bottom
 * @param reach - pixels
 */
export function measureThing(
  { shown, full, bare, size }: ComparedPictures,
  around: readonly [number, number],
  reach: number,
): KeptThing | null {
  const [x, y] = around;
  if (x < reach || y < reach || x > size - reach || y > size - reach) return null;
  const contrasts: { at: number; contrast: number }[] = [];
  let strongest = 0;
  for (let row = Math.max(0, Math.floor(y - reach)); row <= Math.min(size - 1, y + reach); row++) {
    for (let column = Math.max(0, Math.floor(x - reach)); column <= Math.min(size - 1, x + reach); column++) {
      if (Math.hypot(column + 0.5 - x, row + 0.5 - y) > reach) continue;
      const pixel = 4 * (row * size + column);
      for (let c = 0; c < 4; c++) {
        const contrast = 255 * (full[pixel + c] - bare[pixel + c]);
        contrasts.push({ at: pixel + c, contrast });
        strongest = Math.max(strongest, Math.abs(contrast));
      }
    }
  }
  if (strongest === 0) return null;
  let [common, all] = [0, 0];
  for (const { at, contrast } of contrasts) {
    if (Math.abs(contrast) < strong * strongest) continue;
    common += (shown[at] - 255 * bare[at]) * contrast;
    all += contrast ** 2;
  }
  return { contrast: strongest, kept: common / all };
}
